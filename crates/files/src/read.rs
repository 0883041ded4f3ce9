//! A file's bytes and its text.

use crate::error::FileError;
use solaris_io::decode;
use std::fs::{self, File};
use std::io::Read;
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

/// A file's text.
///
/// # Errors
///
/// Files that cannot be read, and bytes that are not UTF-8.
pub fn text(path: &Path) -> Result<String, FileError> {
    String::from_utf8(bytes(path)?).map_err(|error| no_text(path, error.into_bytes()))
}

/// A file's text in any of the encodings that people's and other programs' editors write.
///
/// # Errors
///
/// Files that cannot be read, and bytes that are no text.
pub fn decoded(path: &Path) -> Result<String, FileError> {
    let (text, _) = decode(bytes(path)?).map_err(|bytes| no_text(path, bytes))?;
    Ok(text)
}

/// The error of bytes that are no text.
pub(crate) fn no_text(path: &Path, bytes: Vec<u8>) -> FileError {
    let at = String::from_utf8(bytes).err().map_or(0, |error| error.utf8_error().valid_up_to());
    FileError::input(path, &format!("it is no text: byte {at} is not UTF-8"))
}

/// A file's bytes.
///
/// # Errors
///
/// Files that cannot be read, and those of more than [`MOST_BYTES`].
pub fn bytes(path: &Path) -> Result<Vec<u8>, FileError> {
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
