//! The positions of a motion between the two ways of heading them: `DOF.q` in CSV, `DOF` in OpenSim's tables.

use crate::error::IoError;
use crate::table::Table;
use solaris_model::{AxisKind, Figure, JointKind};
use std::collections::HashMap;

/// Ending of the columns of positions in CSV.
const POSITION: &str = ".q";
/// What `OpenSim`'s headings of forces end with.
const FORCES: [&str; 2] = ["_moment", "_force"];
/// Heading of the column of times.
const TIME: &str = "time";

/// A table for OpenSim from one headed as CSV: times and positions, as they are (rad, m). Also the headings of what is no
/// position and was left out.
pub fn to_opensim(table: &Table) -> (Table, Vec<String>) {
    let rename = |name: &str| {
        let bare = name.strip_suffix(POSITION).map(str::to_owned);
        bare.or_else(|| (name == TIME).then(|| name.to_owned())).map(|name| (name, 1.0))
    };
    let (table, left_out) = renamed(table, rename);
    (Table { in_degrees: Some(false), ..table }, left_out)
}

/// A table headed as CSV from one of OpenSim: times and positions in rad and m. Also the headings of what the figure has no
/// coordinate for and was left out; without a figure every column is a position.
///
/// # Errors
///
/// [`IoError::Forces`] for a table of forces without a figure; [`IoError::DuplicateColumn`] for a coordinate that stands twice; [`IoError::DegreesWithoutFigure`] where the table is in degrees and no figure says which coordinates turn.
pub fn from_opensim(table: &Table, figure: Option<&Figure>) -> Result<(Table, Vec<String>), IoError> {
    let in_degrees = table.in_degrees == Some(true);
    let turns = figure.map(coordinates);
    let is_force =
        |name: &&String| name.contains("ground_force_") || FORCES.iter().any(|end| name.ends_with(end));
    if let (None, Some(name)) = (&turns, table.columns.iter().find(is_force)) {
        return Err(IoError::Forces { name: name.clone() });
    }
    if turns.is_none() && in_degrees {
        return Err(IoError::DegreesWithoutFigure);
    }
    let unit = |turns: bool| if turns && in_degrees { 1f64.to_radians() } else { 1.0 };
    let rename = |name: &str| {
        if name == TIME {
            return Some((name.to_owned(), 1.0));
        }
        let turns = turns.as_ref().map_or(Some(&false), |turns| turns.get(name))?;
        Some((format!("{name}{POSITION}"), unit(*turns)))
    };
    let (table, left_out) = renamed(table, rename);
    // One that stands twice may be left out, not kept.
    table.check_headings()?;
    Ok((Table { in_degrees: None, title: String::new(), ..table }, left_out))
}

/// The names of the coordinates, each with whether it is an angle.
fn coordinates(figure: &Figure) -> HashMap<&str, bool> {
    let mut turns = HashMap::new();
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        let (kind, names) = (link.joint().kind(), &figure.layout().q_names()[at.q..at.q + at.nq]);
        if let (JointKind::Axes(dofs), [_]) = (kind, names) {
            turns.insert(link.joint().name(), dofs[0].axis.kind == AxisKind::Rotation);
        }
        for (i, name) in names.iter().enumerate() {
            let angle = kind.axes().get(i).is_some_and(|dof| dof.axis.kind == AxisKind::Rotation);
            turns.insert(name, angle);
        }
    }
    turns
}

/// The table of those columns that get a new name, each with the factor of its numbers, and the names of the others.
fn renamed(table: &Table, rename: impl Fn(&str) -> Option<(String, f64)>) -> (Table, Vec<String>) {
    let (mut kept, mut columns, mut left_out) = (Vec::new(), Vec::new(), Vec::new());
    for (place, name) in table.columns.iter().enumerate() {
        if let Some((new, factor)) = rename(name) {
            kept.push((place, factor));
            columns.push(new);
        } else {
            left_out.push(name.clone());
        }
    }
    let mut values = Vec::with_capacity(table.len() * kept.len());
    for row in 0..table.len() {
        let row = table.row(row);
        // A factor of one changes no bit.
        values.extend(kept.iter().map(|&(place, factor)| row[place] * factor));
    }
    (Table { columns, values, ..table.clone() }, left_out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris_model::{FigureBuilder, Joint, LinkSpec};

    fn table(columns: &[&str], values: &[f64], in_degrees: Option<bool>) -> Table {
        let lines = (2..).take(values.len() / columns.len()).collect();
        let columns = columns.iter().map(|name| (*name).to_owned()).collect();
        Table { columns, values: values.to_vec(), lines, in_degrees, header_line: 1, ..Table::default() }
    }

    #[test]
    fn only_what_turns_is_in_degrees() {
        let joint = Joint::new("root").tx().named("pelvis_tx").rz().named("pelvis_tilt");
        let figure =
            FigureBuilder::new("f").link(LinkSpec::root("pelvis", joint).mass(1.0)).build().expect("valid");
        let given = table(&["time", "pelvis_tilt", "pelvis_tx", "emg"], &[0.5, 90.0, 1.5, 7.0], Some(true));
        let (found, left_out) = from_opensim(&given, Some(&figure)).expect("a figure");
        assert_eq!(found.columns, ["time", "pelvis_tilt.q", "pelvis_tx.q"]);
        assert_eq!(found.values, [0.5, 90f64.to_radians(), 1.5]);
        assert_eq!(left_out, ["emg"]);
        let error = from_opensim(&given, None).expect_err("degrees of what?");
        assert!(error.to_string().contains("--figure"), "{error}");
    }

    #[test]
    fn there_and_back_is_the_same_table() {
        let given = table(&["time", "a", "b"], &[0.0, 0.1, -1.0 / 3.0, 1.0, 2e-300, 4.0], Some(false));
        let (csv, left_out) = from_opensim(&given, None).expect("radians");
        assert!(left_out.is_empty());
        assert_eq!(csv.columns, ["time", "a.q", "b.q"]);
        assert_eq!(to_opensim(&csv), (given, Vec::new()));
        let walk = table(&["time", "a.q", "a.v", "foot.fx"], &[0.0, 1.0, 2.0, 3.0], None);
        assert_eq!(to_opensim(&walk).1, ["a.v", "foot.fx"]);
    }
}
