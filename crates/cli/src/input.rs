//! Files that are read: the library's readers, and the program's error of a text.

pub(crate) use solaris::files::{
    Body, Language, body, body_in, body_with, bytes, clip, decoded, extension, is_clip, is_motion, motion,
    refuse_unread, table, text,
};

use crate::error::CliError;
use solaris::files::FileError;
use solaris::model::TextError;
use std::path::Path;

/// The error of a text with faults.
pub(crate) fn faulty(path: &Path, text: &str, faults: TextError) -> CliError {
    FileError::faulty(path, text, faults).into()
}
