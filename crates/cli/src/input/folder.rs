//! Files in the folder of a model.

use super::MOST_BYTES;
use solaris::io::Loader;
use std::fs::{self, File};
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};

/// The folder that a model's other files are in; nothing outside of it is opened, by no link.
pub(super) struct Folder {
    /// Where all links are resolved.
    root: Result<PathBuf, String>,
    /// That of the model, from the root.
    model: String,
}

impl Folder {
    /// That of a model's file.
    pub(super) fn of(path: &Path) -> Self {
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        Self { root: fs::canonicalize(folder).map_err(|error| error.to_string()), model: String::new() }
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
            return Err("it is a link that leads out of the model's folder".to_owned());
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
