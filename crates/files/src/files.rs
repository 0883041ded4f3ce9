//! Where files come from: the disk, or names and bytes that somebody gave.

use crate::error::FileError;
use crate::folder::Folder;
use crate::read::MOST_BYTES;
use solaris_io::Loader;
use std::fmt;
use std::fs::{self, File};
use std::io::Read as _;
use std::path::Path;

/// Where files are read from.
pub trait Files {
    /// A file's bytes.
    ///
    /// # Errors
    ///
    /// Files that are not there or cannot be read, and those of more than [`MOST_BYTES`].
    fn bytes(&self, path: &Path) -> Result<Vec<u8>, FileError>;

    /// Whether there is such a file.
    fn exists(&self, path: &Path) -> bool;

    /// What opens the files that a model names: those in the folder `files`, which holds the model, or else in the model's own.
    ///
    /// # Errors
    ///
    /// A folder that does not hold the model.
    fn beside<'f>(&'f self, model: &Path, files: Option<&Path>) -> Result<Box<dyn Loader + 'f>, FileError>;
}

/// The files of the file system.
#[derive(Clone, Copy, Debug, Default)]
pub struct Disk;

impl Files for Disk {
    fn bytes(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        let refuse = |why: &dyn ToString| FileError::input(path, why);
        if fs::metadata(path).is_ok_and(|found| found.is_dir()) {
            return Err(refuse(&"it is a folder; name a file"));
        }
        let mut bytes = Vec::new();
        let file = File::open(path).map_err(|error| match error.kind() {
            std::io::ErrorKind::NotFound => refuse(&"there is no such file"),
            _ => refuse(&error),
        })?;
        file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(|error| refuse(&error))?;
        if bytes.len() as u64 > MOST_BYTES {
            return Err(refuse(&format!("it has more than {MOST_BYTES} bytes, the most that is read")));
        }
        Ok(bytes)
    }

    fn exists(&self, path: &Path) -> bool {
        path.is_file()
    }

    fn beside<'f>(&'f self, model: &Path, files: Option<&Path>) -> Result<Box<dyn Loader + 'f>, FileError> {
        Ok(Box::new(Folder::of(model, files)?))
    }
}

/// Figures, motions, markers and scenes of some [`Files`]: what the functions of this crate read of the [`Disk`].
#[derive(Clone, Copy)]
pub struct Source<'f> {
    pub(crate) files: &'f dyn Files,
}

impl<'f> Source<'f> {
    /// Reads from these files.
    pub fn new(files: &'f dyn Files) -> Self {
        Self { files }
    }

    /// A file's bytes.
    ///
    /// # Errors
    ///
    /// As [`Files::bytes`].
    pub fn bytes(self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.files.bytes(path)
    }
}

impl Source<'static> {
    /// Reads from the [`Disk`].
    pub fn disk() -> Self {
        Self { files: &Disk }
    }
}

impl fmt::Debug for Source<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Source").finish_non_exhaustive()
    }
}
