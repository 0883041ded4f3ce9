//! A motion to a table.

use super::heading;
use crate::error::{ContactProblem, IoError};
use crate::table::{CONTACT, TAU, TIME};
use solaris_model::{Contact, Figure, Motion};
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

fn headings(figure: &Figure, motion: &Motion) -> Vec<String> {
    let (q, v) = (figure.layout().q_names(), figure.layout().v_names());
    let tau = if has_tau(motion) { v } else { &[] };
    let dofs = [(q, "q"), (v, "v"), (v, "a"), (tau, TAU)];
    let dofs =
        dofs.into_iter().flat_map(|(names, ending)| names.iter().map(move |name| heading(name, ending)));
    let contacts =
        motion.contacts.iter().flat_map(|track| CONTACT.map(|ending| heading(&track.link, ending)));
    std::iter::once(TIME.to_owned()).chain(dofs).chain(contacts).collect()
}

/// The numbers of one sample, in the order of the headings.
fn row(motion: &Motion, sample: usize) -> impl Iterator<Item = f64> {
    let dofs = [motion.q(sample), motion.v(sample), motion.a(sample), motion.tau(sample).unwrap_or_default()];
    let contacts = motion.contacts.iter().flat_map(move |track| {
        let Contact { force: f, moment: m, cop: p } = track.samples[sample];
        [f.x, f.y, f.z, m.x, m.y, m.z, p.x, p.y, p.z]
    });
    std::iter::once(motion.time()[sample]).chain(dofs.into_iter().flatten().copied()).chain(contacts)
}

fn has_tau(motion: &Motion) -> bool {
    !motion.is_empty() && motion.tau(0).is_some()
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
