//! A file's bytes and its text.

use crate::error::FileError;
use crate::files::Source;
use solaris_io::{Encoding, decode};
use std::path::Path;

/// The most bytes of a file that is read.
pub const MOST_BYTES: u64 = 1 << 30;

/// What is known of files that are not read yet, by their extensions.
const UNREAD: [(&str, &str); 5] = [
    ("c3d", "measured markers (C3D)"),
    ("trc", "measured markers (TRC)"),
    ("fbx", "a model of a 3-D program (FBX), which is not read yet"),
    ("usd", "a model of a 3-D program (USD), which is not read yet"),
    ("html", "a page, which a browser shows"),
];

/// Refuses a file of a format that is known and not read here; `known` says what is.
///
/// # Errors
///
/// Such a file.
pub fn refuse_unread(path: &Path, known: &str) -> Result<(), FileError> {
    let extension = extension(path);
    match UNREAD.iter().find(|(unread, _)| *unread == extension) {
        Some((_, what)) => Err(FileError::input(path, &format!("it is {what}; {known}"))),
        None => Ok(()),
    }
}

/// A path's extension in lower case, or nothing.
pub fn extension(path: &Path) -> String {
    path.extension().map(|extension| extension.to_string_lossy().to_lowercase()).unwrap_or_default()
}

impl Source<'_> {
    /// A file's text.
    ///
    /// # Errors
    ///
    /// Files that cannot be read, and bytes that are not UTF-8.
    pub fn text(self, path: &Path) -> Result<String, FileError> {
        String::from_utf8(self.bytes(path)?).map_err(|error| no_text(path, error.into_bytes()))
    }

    /// A file's text in any of the encodings that people's and other programs' editors write.
    ///
    /// # Errors
    ///
    /// Files that cannot be read, and bytes that are no text.
    pub fn decoded(self, path: &Path) -> Result<String, FileError> {
        let (text, _) = self.with_encoding(path)?;
        Ok(text)
    }

    /// The same, and which encoding it is.
    pub(crate) fn with_encoding(self, path: &Path) -> Result<(String, Encoding), FileError> {
        decode(self.bytes(path)?).map_err(|bytes| no_text(path, bytes))
    }
}

/// [`Source::text`] of the disk.
///
/// # Errors
///
/// As there.
pub fn text(path: &Path) -> Result<String, FileError> {
    Source::disk().text(path)
}

/// [`Source::decoded`] of the disk.
///
/// # Errors
///
/// As there.
pub fn decoded(path: &Path) -> Result<String, FileError> {
    Source::disk().decoded(path)
}

/// [`Source::bytes`] of the disk.
///
/// # Errors
///
/// As there.
pub fn bytes(path: &Path) -> Result<Vec<u8>, FileError> {
    Source::disk().bytes(path)
}

/// The error of bytes that are no text.
pub(crate) fn no_text(path: &Path, bytes: Vec<u8>) -> FileError {
    let at = String::from_utf8(bytes).err().map_or(0, |error| error.utf8_error().valid_up_to());
    FileError::input(path, &format!("it is no text: byte {at} is not UTF-8"))
}
