//! Measured forces of a table.

use super::{patterns, times};
use crate::error::IoError;
use crate::table::{CONTACT, TIME, Table};
use solaris_model::{Contact, MeasuredForce, Vector3, nearest};

/// Endings of force, point of application and torque in a table of `OpenSim`, as they are written.
pub(super) const OPENSIM: [&str; 9] = [
    "ground_force_vx",
    "ground_force_vy",
    "ground_force_vz",
    "ground_force_px",
    "ground_force_py",
    "ground_force_pz",
    "ground_torque_x",
    "ground_torque_y",
    "ground_torque_z",
];

/// How many headings an error shows.
const MOST_HEADINGS: usize = 12;

/// The forces on `links` (one, or a foot and its toes) that are called `prefix` in the table; the [module](super) has the names
/// of their columns.
///
/// Our own moments are about the world's origin; the torque of `OpenSim` is about the point of application, so that the
/// moment is `M = T + p × F`. In `OpenSim`'s convention the torque may be missing (it is zero then), in ours the centre
/// of pressure, as long as it need not decide between two links. The prefix is what stands before `.fx`, or before, after or
/// within `ground_force_vx`, and may be empty there; an underscore beside it may be left out.
///
/// # Errors
///
/// No column with that prefix, with the prefixes that there are; columns that are missing; no times, or times that do not
/// rise.
pub fn forces(table: &Table, links: &[String], prefix: &str) -> Result<MeasuredForce, IoError> {
    let line = table.header_line;
    let ours = CONTACT.map(|ending| format!("{prefix}.{ending}"));
    let is_there = |name: &String| table.column(name).is_some();
    let (names, optional, is_ours) = if is_there(&ours[0]) {
        let optional = if links.len() < 2 { 6..9 } else { 9..9 };
        (ours, optional, true)
    } else if let Some(theirs) = patterns::find(table, prefix) {
        (theirs, 6..9, false)
    } else {
        let headings =
            table.columns.iter().filter(|name| *name != TIME).take(MOST_HEADINGS).cloned().collect();
        let known = force_prefixes(table);
        return Err(IoError::NoForce { line, prefix: prefix.to_owned(), known, headings });
    };
    let absent = !names[optional.clone()].iter().any(is_there);
    let needed = |i: &usize| !(absent && optional.contains(i));
    let columns = || table.columns.iter().map(String::as_str);
    let missing = |name: &String| {
        (name.clone(), nearest(name, columns().filter(|near| !names.iter().any(|name| name == near))))
    };
    let mut missing: Vec<_> =
        (0..9).filter(needed).filter(|&i| !is_there(&names[i])).map(|i| missing(&names[i])).collect();
    let time = table.column(TIME);
    if time.is_none() {
        missing.insert(0, (TIME.to_owned(), None));
    }
    let (Some(time), true) = (time, missing.is_empty()) else {
        return Err(IoError::MissingColumns { line, columns: missing });
    };
    if table.is_empty() {
        return Err(IoError::NoRows { line });
    }
    for name in &names {
        let mut places = (0..table.columns.len()).filter(|place| table.columns[*place] == *name);
        if let (Some(first), Some(column)) = (places.next(), places.next()) {
            let (column, first) = (column + 1, first + 1);
            return Err(IoError::DuplicateColumn { line, column, name: name.clone(), first });
        }
    }
    let places = names.map(|name| table.column(&name));
    let samples = (0..table.len()).map(|row| {
        let row = table.row(row);
        let number = |i: usize| places[i].map_or(0.0, |place| row[place]);
        let vector = |i: usize| Vector3::new(number(i), number(i + 1), number(i + 2));
        let (force, second, third) = (vector(0), vector(3), vector(6));
        if is_ours {
            Contact { force, moment: second, cop: third }
        } else {
            Contact { force, moment: third + second.cross(&force), cop: second }
        }
    });
    let (links, time, samples) = (links.to_vec(), times(table, time)?, samples.collect());
    Ok(MeasuredForce { links, ball_and_tip: None, time, samples })
}

/// The prefixes of all forces of a table, in its order.
pub fn force_prefixes(table: &Table) -> Vec<String> {
    let headings = table.columns.iter().map(String::as_str).collect();
    let prefix = |name: &String| {
        name.strip_suffix(".fx").or_else(|| patterns::name_of(&headings, name)).map(str::to_owned)
    };
    table.columns.iter().filter_map(prefix).collect()
}
