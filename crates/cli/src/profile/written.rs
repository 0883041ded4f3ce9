//! Profiles as text.

use crate::error::CliError;
use crate::input;
use solaris::model::TextError;
use solaris::profiles::{Profile, ProfileError, ProfileLayer, text};
use std::path::Path;

/// The profile that is written in `text`; `path` is what it is called.
pub(super) fn read(path: &Path, text: &str) -> Result<Profile, CliError> {
    text::read(text).map_err(|faults| input::faulty(path, text, faults))
}

/// A motion of a blend, by itself or with when it begins.
pub(super) fn read_layer(text: &str) -> Result<ProfileLayer, CliError> {
    text::read_layer(text).map_err(|faults| input::faulty(Path::new("--curve"), text, faults))
}

/// Why there is no such curve, under the number that is at fault where it can be told.
pub(super) fn refuse(path: &Path, text: &str, error: &ProfileError) -> CliError {
    match text::place(text, error) {
        Some(span) => input::faulty(path, text, TextError::one(text, span, error.to_string())),
        None => CliError::input(path, error),
    }
}
