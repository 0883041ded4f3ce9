//! Profiles as text.

use crate::error::CliError;
use crate::input;
use ron::error::{Error, Position, SpannedError};
use ron::extensions::Extensions;
use ron::ser::PrettyConfig;
use serde::de::DeserializeOwned;
use solaris::model::{TextError, nearest};
use solaris::profiles::Profile;
use std::ops::Range;
use std::path::Path;

fn options() -> ron::Options {
    ron::Options::default().with_default_extension(Extensions::IMPLICIT_SOME)
}

/// A profile or layer that is written in `text`; `path` is what it is called.
pub(super) fn read<T: DeserializeOwned>(path: &Path, text: &str) -> Result<T, CliError> {
    options().from_str(text).map_err(|SpannedError { code, span }| {
        let bytes = offset(text, span.start)..offset(text, span.end);
        fault(path, text, word(text, bytes), message(&code))
    })
}

/// The error of a text with one fault.
pub(super) fn fault(path: &Path, text: &str, span: Range<usize>, message: String) -> CliError {
    input::faulty(path, text, TextError::one(text, span, message))
}

/// The text of a profile, for a file.
pub(super) fn write(profile: &Profile) -> String {
    let config = PrettyConfig::new().struct_names(true).depth_limit(3);
    // Every profile has a text: there is nothing in it but numbers, lists and names.
    options().to_string_pretty(profile, config).unwrap_or_default() + "\n"
}

/// The same in one line.
pub(super) fn short(profile: &Profile) -> String {
    options().to_string(profile).unwrap_or_default()
}

fn message(error: &Error) -> String {
    match error {
        Error::NoSuchEnumVariant { expected, found, outer } if outer.as_deref() == Some("Profile") => {
            let near = nearest(found, expected.iter().copied());
            let near = near.map_or_else(String::new, |name| format!("; did you mean '{name}'?"));
            format!("there is no kind '{found}'{near}")
        }
        other => other.to_string(),
    }
}

/// The byte of a place that is counted in lines and characters.
fn offset(text: &str, Position { line, col }: Position) -> usize {
    let before: usize = text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    let rest = &text[before.min(text.len())..];
    before + rest.chars().take(col.saturating_sub(1)).map(char::len_utf8).sum::<usize>()
}

/// A span without the blanks and commas at its ends; at least one character of the text, where there is one.
fn word(text: &str, Range { start, end }: Range<usize>) -> Range<usize> {
    let end = end.clamp(start, text.len());
    let inner = &text[start..end];
    let trimmed = inner.trim_matches(|c: char| c.is_whitespace() || c == ',');
    if trimmed.is_empty() {
        return start..end;
    }
    let start = start + inner.find(trimmed).unwrap_or(0);
    start..start + trimmed.len()
}

/// Where a text gives a parameter of this name its value, if it does so once.
pub(super) fn value(text: &str, name: &str) -> Option<Range<usize>> {
    let field = format!("{}:", name.replace(' ', "_"));
    let mut places = text
        .match_indices(&field)
        .filter(|(at, _)| !text[..*at].ends_with(|c: char| c.is_alphanumeric() || c == '_'));
    let (at, found) = places.next().filter(|_| places.next().is_none())?;
    let start = at + found.len();
    let end = start + text[start..].find([',', ')', '\n']).unwrap_or(text.len() - start);
    Some(word(text, start..end))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_have_places_where_they_stand_once() {
        let text = "Tension(from: 0, start_velocity: 2.5 ,\n to: 1)";
        assert_eq!(value(text, "start velocity").map(|span| &text[span]), Some("2.5"));
        // Part of another name, and twice there.
        assert_eq!(value(text, "velocity"), None);
        assert_eq!(value("(to: 1), (to: 2)", "to"), None);
        assert_eq!(value("Line(to: ", "to"), Some(8..9));
    }

    #[test]
    fn faults_have_places() {
        let text = "// é\nLine(from: 0,\n  too: 1)";
        let Err(CliError::Text { faults, .. }) = read::<Profile>(Path::new("x"), text) else {
            panic!("it cannot be read");
        };
        let place = &faults.faults[0].place;
        assert_eq!((place.line, place.column, &text[place.span.clone()]), (3, 3, "too"));
    }

    #[test]
    fn what_is_written_is_read() {
        let profile = Profile::MonotoneCubic { keys: vec![(0.0, 1.0), (0.1, -1.0 / 3.0)] };
        for text in [write(&profile), short(&profile)] {
            assert_eq!(read::<Profile>(Path::new("x"), &text).ok(), Some(profile.clone()), "{text}");
        }
    }
}
