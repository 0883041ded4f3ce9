//! Forces to a table, the way back of [`forces`](super::forces()).

use super::forces::OPENSIM;
use crate::error::{ContactProblem, IoError};
use crate::table::{CONTACT, TIME, Table};
use solaris_model::ContactTrack;

/// What the columns of forces are called; the [module](super) has both conventions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ForceHeadings {
    /// `NAME.fx …`, with the moment about the world's origin.
    Solaris,
    /// `NAME_ground_force_vx …`, with the moment about the point of application.
    OpenSim,
}

/// A table of forces: a row for each of the times (s), nine columns for each track.
///
/// In `OpenSim`'s convention the prefix is the track's name and `_`, and the torque is `T = M − p × F`, so that
/// [`forces`](super::forces()) finds the same contacts again, to the rounding of that product; in ours, bit for bit.
///
/// # Errors
///
/// Tracks of the same name, tracks of another number of contacts than there are times, numbers that are not finite.
///
/// # Examples
///
/// ```
/// use solaris_io::record::{ForceHeadings, force_table, forces};
/// use solaris_model::{Contact, ContactTrack, Vector3};
///
/// let force = Vector3::new(0.0, 700.0, 0.0);
/// let cop = Vector3::new(0.1, 0.0, 0.2);
/// let contact = Contact { force, moment: cop.cross(&force), cop };
/// let track = ContactTrack { link: "left".to_owned(), samples: vec![contact] };
/// let table = force_table(ForceHeadings::OpenSim, &[0.0], &[track])?;
/// assert_eq!(table.columns[1], "left_ground_force_vx");
/// let read = forces(&table, &["foot".to_owned()], "left_")?;
/// assert_eq!(read.samples, [contact]);
/// # Ok::<(), solaris_io::IoError>(())
/// ```
pub fn force_table(headings: ForceHeadings, time: &[f64], tracks: &[ContactTrack]) -> Result<Table, IoError> {
    for (i, track) in tracks.iter().enumerate() {
        let (found, samples) = (track.samples.len(), time.len());
        let problem = if tracks[..i].iter().any(|other| other.link == track.link) {
            ContactProblem::Duplicate
        } else if found != samples {
            ContactProblem::Length { found, samples }
        } else {
            continue;
        };
        return Err(IoError::Contacts { link: track.link.clone(), problem });
    }
    let of = |track: &ContactTrack| match headings {
        ForceHeadings::Solaris => CONTACT.map(|ending| format!("{}.{ending}", track.link)),
        ForceHeadings::OpenSim => OPENSIM.map(|ending| format!("{}_{ending}", track.link)),
    };
    let columns: Vec<String> = std::iter::once(TIME.to_owned()).chain(tracks.iter().flat_map(of)).collect();
    let mut values = Vec::with_capacity(columns.len() * time.len());
    for (row, &time) in time.iter().enumerate() {
        values.push(time);
        for track in tracks {
            let contact = &track.samples[row];
            let parts = match headings {
                ForceHeadings::Solaris => [contact.force, contact.moment, contact.cop],
                ForceHeadings::OpenSim => {
                    let torque = contact.moment - contact.cop.cross(&contact.force);
                    [contact.force, contact.cop, torque]
                }
            };
            values.extend(parts.iter().flat_map(|part| part.iter().copied()));
        }
    }
    if let Some(place) = values.iter().position(|value| !value.is_finite()) {
        let (row, column) = (place / columns.len(), columns[place % columns.len()].clone());
        return Err(IoError::NotFinite { column, time: time[row], value: values[place] });
    }
    let (title, in_degrees) = match headings {
        ForceHeadings::Solaris => (String::new(), None),
        ForceHeadings::OpenSim => ("Ground reaction forces".to_owned(), Some(false)),
    };
    let lines = (1..).take(time.len()).collect();
    Ok(Table { title, in_degrees, columns, values, lines, header_line: 1, ..Table::default() })
}
