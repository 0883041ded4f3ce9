//! A motion to a table.

use super::table::FORMAT;
use crate::error::{ContactProblem, IoError};
use crate::record::{headings, row};
use crate::table::check_name;
use solaris_model::{Figure, Motion};
use std::io::{self, Write};

/// Writes `motion` as a table to `out`: a header and one row a sample.
///
/// The columns and their units stand in the [module's documentation](super). Nothing is written before the motion has
/// been checked against the figure, but a number that is not finite is found only when its row is due.
///
/// # Errors
///
/// A motion of another figure, contacts that do not fit it, a number that is not finite, and the writer's own errors.
pub fn write(figure: &Figure, motion: &Motion, out: &mut impl Write) -> Result<(), IoError> {
    motion.check_figure(figure)?;
    check_contacts(figure, motion)?;
    let columns = headings(figure, motion);
    columns.iter().try_for_each(|name| check_name(name, FORMAT))?;
    let mut table = csv::Writer::from_writer(out);
    table.write_record(&columns).map_err(writing)?;
    let mut text = Vec::new();
    for sample in 0..motion.len() {
        let time = motion.time()[sample];
        for (value, column) in row(motion, sample).zip(&columns) {
            if !value.is_finite() {
                return Err(IoError::NotFinite { column: column.clone(), time, value });
            }
            text.clear();
            number(value, &mut text)?;
            table.write_field(&text).map_err(writing)?;
        }
        table.write_record(None::<&[u8]>).map_err(writing)?;
    }
    Ok(table.flush()?)
}

fn check_contacts(figure: &Figure, motion: &Motion) -> Result<(), IoError> {
    for (i, track) in motion.contacts.iter().enumerate() {
        let (found, samples) = (track.samples.len(), motion.len());
        let problem = if figure.link_index(&track.link).is_none() {
            ContactProblem::UnknownLink { figure: figure.name().to_owned() }
        } else if motion.contacts[..i].iter().any(|other| other.link == track.link) {
            ContactProblem::Duplicate
        } else if found != samples {
            ContactProblem::Length { found, samples }
        } else {
            continue;
        };
        return Err(IoError::Contacts { link: track.link.clone(), problem });
    }
    Ok(())
}

/// The fewest digits that read back to the same bits; an exponent only where zeros would fill the field.
pub(super) fn number(value: f64, text: &mut Vec<u8>) -> io::Result<()> {
    let size = value.abs();
    if size == 0.0 || (1e-5..1e16).contains(&size) {
        write!(text, "{value}")
    } else {
        write!(text, "{value:e}")
    }
}

pub(super) fn writing(error: csv::Error) -> IoError {
    IoError::Write(error.into())
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_are_short_and_exact() {
        let print = |value| {
            let mut text = Vec::new();
            number(value, &mut text).expect("a vector takes all");
            String::from_utf8(text).expect("digits")
        };
        assert_eq!([0.0, -0.0, 0.1, 1.0, 1e16, 3e-7].map(print), ["0", "-0", "0.1", "1", "1e16", "3e-7"]);
        for value in [f64::MIN_POSITIVE, 5e-324, f64::MAX, -1.0 / 3.0, 0.1 + 0.2, 1e-5, 9.99e-6] {
            assert_eq!(print(value).parse().map(f64::to_bits), Ok(value.to_bits()));
        }
    }
}
