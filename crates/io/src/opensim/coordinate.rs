//! Coordinates of joints.

use super::element::{MadeUp, child_flag, child_number};
use crate::tree::Names;
use crate::xml::{Node, Reader, element, elements, elements_called, tag};
use solaris_model::{Part, SourceMap};
use std::ops::Range;

/// Where a range is none, on both sides (rad or m).
const UNBOUNDED: f64 = 9e4;

/// A coordinate of a joint.
pub(super) struct Coordinate {
    /// Its name in the file, which coordinates of other joints may have, too.
    pub(super) name: String,
    /// The name of its degree of freedom.
    pub(super) dof: String,
    pub(super) limits: Option<(f64, f64)>,
    pub(super) span: Range<usize>,
}

/// The coordinates of a joint, in the order of the file.
pub(super) fn of_joint(reader: &mut Reader, joint: Node, places: &mut SourceMap) -> Vec<Coordinate> {
    // Version 4 has them in `coordinates`, versions before in a set.
    let lists = elements_called(joint, "coordinates")
        .chain(elements_called(joint, "CoordinateSet").flat_map(|set| elements_called(set, "objects")));
    let nodes: Vec<Node> = lists.flat_map(elements).collect();
    let mut names = MadeUp::default();
    nodes.into_iter().filter_map(|node| read(reader, node, &mut names, places)).collect()
}

fn read(reader: &mut Reader, node: Node, names: &mut MadeUp, places: &mut SourceMap) -> Option<Coordinate> {
    if node.tag_name().name() != "Coordinate" {
        reader.unread_element(node);
        return None;
    }
    let name = names.name(reader, node);
    let range = element(node, "range").filter(|range| !super::words(*range).is_empty());
    let limits = range.and_then(|range| reader.text_numbers(range, 2..=2)).map(|pair| (pair[0], pair[1]));
    // ±99999.9, as many models have it, is no bound.
    let limits = limits.filter(|(lower, upper)| lower.abs().min(upper.abs()) < UNBOUNDED);
    let limits = limits.map(|(lower, upper)| {
        if lower <= upper {
            return (lower, upper);
        }
        let message = format!("its range is from {lower} down to {upper}; the two are exchanged");
        reader.suspect(range.map_or_else(|| tag(node), tag), format!("coordinate '{name}'"), message);
        (upper, lower)
    });
    places.put(Part::Dof, &name, tag(node));
    if let Some(range) = range {
        places.put_field(Part::Dof, &name, "limits", tag(range));
    }
    held(reader, node, &name);
    reader.check_elements(
        node,
        &["default_value", "range", "clamped", "locked", "prescribed", "prescribed_function", "motion_type"],
        &["default_speed_value", "is_free_to_satisfy_constraints"],
    );
    Some(Coordinate { dof: name.clone(), name, limits, span: tag(node) })
}

/// Gives coordinates whose names are taken by those of joints before the name `JOINT.NAME`; `joints` are their names.
pub(super) fn distinguish<'a>(
    reader: &mut Reader,
    joints: impl Iterator<Item = &'a str>,
    coordinates: &mut [Vec<Coordinate>],
) {
    let mut names = Names::default();
    for (joint, coordinates) in joints.zip(coordinates) {
        for coordinate in coordinates {
            if names.take(&coordinate.name) == coordinate.name {
                continue;
            }
            coordinate.dof = names.take(&format!("{joint}.{}", coordinate.name));
            let message = format!(
                "a coordinate of another joint has the name as well; that of joint '{joint}' is '{}' here",
                coordinate.dof
            );
            reader.note(coordinate.span.clone(), format!("coordinate '{}'", coordinate.name), message);
        }
    }
}

/// Lists what holds a coordinate in OpenSim and does not here.
fn held(reader: &mut Reader, node: Node, name: &str) {
    let at = child_number(reader, node, "default_value").unwrap_or(0.0);
    let mut list = |what: &str, message: String| {
        if child_flag(reader, node, what, false) {
            let span = element(node, what).map_or_else(|| tag(node), tag);
            reader.unsupported(span, format!("coordinate '{name}'"), message);
        }
    };
    list(
        "locked",
        format!(
            "it is locked at {at} in the file and free here; it has this value in a motion without a column for it"
        ),
    );
    list("prescribed", "its motion is prescribed in the file and free here".to_owned());
    // One line for all: models clamp every coordinate, and ranges are reported here.
    if child_flag(reader, node, "clamped", false) {
        let span = element(node, "clamped").map_or_else(|| tag(node), tag);
        reader.aside("<clamped> (ranges are reported, not enforced)".to_owned(), span);
    }
}
