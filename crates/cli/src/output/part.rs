//! A file under construction.

use crate::error::CliError;
use std::fs::{self, File, OpenOptions};
use std::io::{BufWriter, Error, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Names that are tried for a file under construction: runs that were killed may have left some.
const TRIES: usize = 1000;

/// A file under construction; whatever of it is left is removed when it is dropped before it is kept.
pub(super) struct Part {
    path: PathBuf,
    file: File,
    place: PathBuf,
    /// What stood in the place, while the whole may still fail.
    before: Option<PathBuf>,
    kept: bool,
}

impl Part {
    /// Begins a file beside `place`, under a name of its own.
    pub(super) fn create(place: &Path) -> std::io::Result<Self> {
        let process = std::process::id();
        let mut last = Error::from(ErrorKind::AlreadyExists);
        for i in 0..TRIES {
            let path = place.with_file_name(format!(".solaris-{process}-{i}.part"));
            match OpenOptions::new().write(true).create_new(true).open(&path) {
                Ok(file) => {
                    let before = place.exists().then(|| path.with_extension("before"));
                    return Ok(Self { path, file, place: place.to_owned(), before, kept: false });
                }
                Err(error) if error.kind() == ErrorKind::AlreadyExists => last = error,
                Err(error) => return Err(error),
            }
        }
        Err(last)
    }

    /// Writes all of it to the disk.
    pub(super) fn fill(
        &self,
        write: impl FnOnce(&mut dyn Write) -> Result<(), CliError>,
    ) -> Result<(), CliError> {
        let mut writer = BufWriter::new(&self.file);
        write(&mut writer)?;
        writer.flush().map_err(CliError::other)?;
        self.file.sync_all().map_err(CliError::other)
    }

    /// Puts the file in its place, what was there beside it.
    pub(super) fn install(&self) -> std::io::Result<()> {
        if let Some(before) = &self.before {
            // With a second name for the old file there is no instant at which none stands in the place.
            fs::hard_link(&self.place, before).or_else(|_| fs::rename(&self.place, before))?;
        }
        fs::rename(&self.path, &self.place).inspect_err(|_| self.restore())
    }

    /// Takes the file from its place again.
    pub(super) fn withdraw(&self) {
        // The error that led here is told; one more says nothing new.
        let _ = fs::remove_file(&self.place);
        self.restore();
    }

    fn restore(&self) {
        if let Some(before) = &self.before {
            // Where both are names of one file, renaming does nothing and the second name stays.
            let _ = fs::rename(before, &self.place).and_then(|()| fs::remove_file(before));
        }
    }

    /// All is well: what was there before goes.
    pub(super) fn keep(&mut self) {
        if let Some(before) = &self.before {
            let _ = fs::remove_file(before);
        }
        self.kept = true;
    }
}

impl Drop for Part {
    fn drop(&mut self) {
        if !self.kept {
            let _ = fs::remove_file(&self.path);
        }
    }
}
