//! Files in the folder of a model.

use crate::error::FileError;
use crate::read::MOST_BYTES;
use solaris_io::Loader;
use std::fs::{self, File};
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};

/// The folder that a model's other files are in; nothing outside of it is opened, by no link.
pub(crate) struct Folder {
    /// Where all links are resolved.
    root: Result<PathBuf, String>,
    /// That of the model, from the root.
    model: String,
}

impl Folder {
    /// That of a model's file, or `files`, which must hold the model.
    pub(crate) fn of(path: &Path, files: Option<&Path>) -> Result<Self, FileError> {
        let own = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let resolved = |folder: &Path| fs::canonicalize(folder).map_err(|error| error.to_string());
        let Some(files) = files else { return Ok(Self { root: resolved(own), model: String::new() }) };
        let refuse = |why: String| FileError::Folder { folder: files.to_owned(), why };
        let root = resolved(files).map_err(refuse)?;
        let own = resolved(own).map_err(refuse)?;
        let within =
            own.strip_prefix(&root).map_err(|_| refuse(format!("{} is not in it", path.display())))?;
        let parts: Vec<_> = within.iter().map(|part| part.to_string_lossy()).collect();
        Ok(Self { root: Ok(root), model: parts.join("/") })
    }
}

impl Loader for Folder {
    fn folder(&self) -> String {
        self.model.clone()
    }

    fn load(&mut self, path: &str) -> Result<Vec<u8>, String> {
        let root = self.root.as_ref().map_err(String::clone)?;
        let why = |error: &std::io::Error| match error.kind() {
            ErrorKind::NotFound => "there is no such file".to_owned(),
            _ => error.to_string(),
        };
        let file = fs::canonicalize(root.join(path)).map_err(|error| why(&error))?;
        if !file.starts_with(root) {
            return Err("it is a link that leads out of the folder of the model's files; name one that holds both (--files)".to_owned());
        }
        let found = fs::metadata(&file).map_err(|error| why(&error))?;
        if !found.is_file() {
            return Err("it is no file".to_owned());
        }
        if found.len() > MOST_BYTES {
            return Err(format!("it has more than {MOST_BYTES} bytes, the most that is read"));
        }
        let mut bytes = Vec::new();
        let opened = File::open(&file).map_err(|error| why(&error))?;
        opened.take(MOST_BYTES).read_to_end(&mut bytes).map_err(|error| why(&error))?;
        Ok(bytes)
    }
}
