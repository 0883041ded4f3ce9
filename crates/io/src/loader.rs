//! Files that a model names: its reader asks for them, the caller opens them.

use std::fmt;

use solaris_model::TextError;

/// Opens the files that a model names. This crate opens none itself.
pub trait Loader {
    /// The folder of the model's own file, from the folder that all its files are in; the same where it is empty.
    fn folder(&self) -> String {
        String::new()
    }

    /// The bytes of a file; `path` is its way from the folder that all are in: names between `/`, none of them `..`, so
    /// that it cannot leave that folder (but for links, which are the loader's to judge).
    ///
    /// # Errors
    ///
    /// Why there are none, in a sentence that follows the path.
    fn load(&mut self, path: &str) -> Result<Vec<u8>, String>;
}

/// For models that stand in one text.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Loader for NoFiles {
    fn load(&mut self, _path: &str) -> Result<Vec<u8>, String> {
        Err("other files are not opened here: give the reader a loader, or put what the file holds into the text".to_owned())
    }
}

/// Every fault of a model that may stand in several files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FilesError {
    /// The files that have faults, at least one; the model's own comes first.
    pub files: Vec<FileError>,
}

/// The faults of one file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileError {
    /// The file's way from the folder of the model's own file; that one's is empty.
    pub path: String,
    /// What the file holds.
    pub text: String,
    /// Its faults.
    pub error: TextError,
}

impl fmt::Display for FilesError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, FileError { path, error, .. }) in self.files.iter().enumerate() {
            let newline = if i > 0 { "\n" } else { "" };
            let colon = if path.is_empty() { "" } else { ":\n" };
            write!(f, "{newline}{path}{colon}{error}")?;
        }
        Ok(())
    }
}

impl std::error::Error for FilesError {}

/// The way from the model's folder to a file that is named in one of its folders.
///
/// # Errors
///
/// Why there is none, in a sentence that follows the name: it leads out of the model's folder.
pub(crate) fn within(folder: &str, name: &str) -> Result<String, String> {
    let drive = name.chars().nth(1) == Some(':');
    if name.starts_with(['/', '\\']) || drive {
        return Err("it is no path from the model: files are read in one folder only; put it there and name it by a relative path".to_owned());
    }
    let mut parts: Vec<&str> = Vec::new();
    for part in folder.split('/').chain(name.split(['/', '\\'])) {
        match part {
            "" | "." => {}
            ".." => {
                if parts.pop().is_none() {
                    return Err(
                        "it leads out of the folder of the model's files; name one that holds both (--files)"
                            .to_owned(),
                    );
                }
            }
            part => parts.push(part),
        }
    }
    Ok(parts.join("/"))
}

/// The folder of a file.
pub(crate) fn folder_of(path: &str) -> &str {
    path.rsplit_once('/').map_or("", |(folder, _)| folder)
}

#[cfg(test)]
mod tests {
    use super::within;

    #[test]
    fn paths_stay_in_the_folder_of_the_model() {
        assert_eq!(within("", "./common/../a.xml").as_deref(), Ok("a.xml"));
        assert_eq!(within("suite/arm", "..\\a.xml").as_deref(), Ok("suite/a.xml"));
        for out in ["../a.xml", "/etc/passwd", "a/../../b", "C:\\a.xml", "\\\\server\\a"] {
            assert!(within("", out).is_err(), "{out}");
        }
    }
}
