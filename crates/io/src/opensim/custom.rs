//! `CustomJoint`: axes that are functions of coordinates.

use super::axes::{Moves, Step};
use super::coordinate::Coordinate;
use super::couplers::Couplers;
use super::curves::{UNIT, beside_identity, constant, line};
use super::element::child_words;
use super::function;
use super::joint::JointAt;
use crate::xml::{Node, Reader, element, elements_called, shown, tag};
use solaris_model::{AxisKind, Curve, Vector3};

/// An axis of a `CustomJoint`.
struct Drive {
    kind: AxisKind,
    direction: Vector3<f64>,
    coordinate: Option<usize>,
    /// Over the coordinate; a constant without one.
    curve: Curve,
    /// Whether OpenSim takes the coordinate for the angle or the length itself: a linear function with slope ±1.
    pure: bool,
}

/// The axes of a `CustomJoint`, in the order in which they are read and in which a coordinate finds its own.
const AXES: [(&str, AxisKind); 6] = [
    ("rotation1", AxisKind::Rotation),
    ("rotation2", AxisKind::Rotation),
    ("rotation3", AxisKind::Rotation),
    ("translation1", AxisKind::Translation),
    ("translation2", AxisKind::Translation),
    ("translation3", AxisKind::Translation),
];

/// The steps of a `CustomJoint`.
///
/// ```text
/// X = T(f₄·a₄ + f₅·a₅ + f₆·a₆)·R(a₁, f₁)·R(a₂, f₂)·R(a₃, f₃)
/// ```
pub(super) fn steps(
    reader: &mut Reader,
    at: &JointAt,
    coordinates: &[Coordinate],
    couplers: &Couplers,
) -> Option<Vec<Step>> {
    let owner = format!("joint '{}'", at.name);
    let Some(transform) = element(at.node, "SpatialTransform") else {
        reader.fault(tag(at.node), format!("{owner} is a <CustomJoint> without a <SpatialTransform>"));
        return None;
    };
    let mut drives = Vec::new();
    let mut whole = true;
    for (name, kind) in AXES {
        let named = |axis: &Node| axis.attribute("name") == Some(name);
        let Some(axis) = elements_called(transform, "TransformAxis").find(named) else { continue };
        match drive(reader, axis, kind, coordinates, &format!("{owner}, {name}")) {
            Some(drive) => drives.push(drive),
            None => whole = false,
        }
    }
    for axis in elements_called(transform, "TransformAxis") {
        if !AXES.iter().any(|(name, _)| axis.attribute("name") == Some(*name)) {
            reader.unread_element(axis);
        }
    }
    reader.check_elements(transform, &["TransformAxis"], &[]);
    if !whole {
        return None;
    }
    let owns: Vec<Own> = (0..coordinates.len()).map(|c| own(&drives, c)).collect();
    for (c, coordinate) in coordinates.iter().enumerate() {
        if !couplers.contains_key(&coordinate.dof) {
            say(reader, coordinate, owns[c], &drives, c);
        }
    }
    Some(in_order(&drives, &owns))
}

/// What one axis says.
fn drive(
    reader: &mut Reader,
    axis: Node,
    kind: AxisKind,
    coordinates: &[Coordinate],
    owner: &str,
) -> Option<Drive> {
    let direction =
        element(axis, "axis").map_or(Some(vec![1.0, 0.0, 0.0]), |node| reader.text_numbers(node, 3..=3))?;
    let direction = Vector3::new(direction[0], direction[1], direction[2]);
    let Some(unit) = direction.try_normalize(1e-12).filter(|unit| unit.iter().all(|x| x.is_finite())) else {
        reader.fault(
            tag(axis),
            format!(
                "{owner}: its axis is ({}, {}, {}), which is no direction",
                direction.x, direction.y, direction.z
            ),
        );
        return None;
    };
    // A unit vector of the file keeps its bits.
    let direction = if (direction.norm() - 1.0).abs() < 1e-15 { direction } else { unit };
    let names: Vec<&str> = child_words(axis, "coordinates").unwrap_or_default().split_whitespace().collect();
    let function = function::held(axis, &["coordinates", "axis"]);
    let coordinate = match names[..] {
        [] => None,
        [name] => {
            let found = coordinates.iter().position(|coordinate| coordinate.name == name);
            if found.is_none() {
                let hint = reader.hint(name, coordinates.iter().map(|c| c.name.as_str()));
                let message = format!(
                    "{owner} is driven by '{}', which is no coordinate of this joint{hint}",
                    shown(name)
                );
                reader.fault(tag(axis), message);
                return None;
            }
            found
        }
        _ => {
            let message = format!(
                "{owner} is a function of {} coordinates ({}); only one is read",
                names.len(),
                shown(&names.join(" "))
            );
            reader.fault(tag(axis), message);
            return None;
        }
    };
    let curve = match (function, coordinate) {
        (Some(function), _) => function::read(reader, function, owner)?,
        (None, Some(_)) => Curve::linear(1.0, 0.0),
        (None, None) => Curve::Polynomial(Vec::new()),
    };
    if coordinate.is_none() && constant(&curve).is_none() {
        let message = format!(
            "{owner} has a function that is not constant, and no coordinate; name one in <coordinates>"
        );
        reader.fault(tag(axis), message);
        return None;
    }
    let is_linear = function.is_none_or(|function| function.tag_name().name() == "LinearFunction");
    let pure = is_linear && line(&curve).is_some_and(|(slope, _)| (slope.abs() - 1.0).abs() < f64::EPSILON);
    Some(Drive { kind, direction, coordinate, curve, pure })
}

/// How a coordinate is a degree of freedom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Own {
    /// It is the angle or the slide of the axis with this number.
    Whole(usize),
    /// It is a part of that angle or slide; what the function adds to it follows it.
    Part(usize),
    /// It is an angle by itself, which another one that follows it turns back.
    Alone,
}

/// What a coordinate has of the axes that it drives.
fn own(drives: &[Drive], index: usize) -> Own {
    let mut driven = drives.iter().enumerate().filter(|(_, drive)| drive.coordinate == Some(index));
    let one = |drive: &Drive| line(&drive.curve).is_some_and(|(slope, _)| (slope.abs() - 1.0).abs() < UNIT);
    if let Some((i, _)) = driven.clone().find(|(_, drive)| one(drive)) {
        return Own::Whole(i);
    }
    let part =
        driven.find(|(_, drive)| constant(&drive.curve).is_none() && beside_identity(&drive.curve).is_some());
    part.map_or(Own::Alone, |(i, _)| Own::Part(i))
}

/// Says what a free coordinate is here where OpenSim takes it for something else.
fn say(reader: &mut Reader, coordinate: &Coordinate, own: Own, drives: &[Drive], index: usize) {
    let subject = format!("coordinate '{}'", coordinate.name);
    if !drives.iter().any(|drive| drive.coordinate == Some(index) && constant(&drive.curve).is_none()) {
        let message = "it moves nothing: its force is zero, and any of its values is the same posture";
        reader.suspect(coordinate.span.clone(), subject, message);
        return;
    }
    let pure = drives.iter().any(|drive| drive.coordinate == Some(index) && drive.pure);
    let kind = match own {
        Own::Whole(i) | Own::Part(i) => drives[i].kind,
        Own::Alone => AxisKind::Rotation,
    };
    if !pure && kind == AxisKind::Rotation {
        let message = "its axes are functions of it, so that OpenSim 4 keeps it in radians in tables in degrees; here a column \
                       of it is in degrees there, as all angles";
        reader.note(coordinate.span.clone(), subject, message);
    }
}

/// Translations first, along axes that do not turn, then rotations.
///
/// ```text
/// T(f₄·a₄)·…·R(a₁, f₁)·…              R(a, f(x)) = R(a, x)·R(a, f(x) − x)
/// ```
///
/// where the angle `f(x)` is no degree of freedom by itself and `x` is to be one.
fn in_order(drives: &[Drive], owns: &[Own]) -> Vec<Step> {
    let mut steps = Vec::new();
    for kind in [AxisKind::Translation, AxisKind::Rotation] {
        for (i, drive) in drives.iter().enumerate().filter(|(_, drive)| drive.kind == kind) {
            let Drive { kind, direction, curve, .. } = drive;
            let mut step = |direction, moves| steps.push(Step { kind: *kind, direction, moves });
            let Some(c) = drive.coordinate.filter(|_| constant(curve).is_none()) else {
                step(*direction, Moves::By(constant(curve).unwrap_or(0.0)));
                continue;
            };
            match owns[c] {
                Own::Whole(at) if at == i => {
                    let (slope, offset) = line(curve).unwrap_or((1.0, 0.0));
                    step(direction * slope.signum(), Moves::With(c));
                    step(*direction, Moves::By(offset));
                }
                Own::Part(at) if at == i => {
                    step(*direction, Moves::With(c));
                    step(
                        *direction,
                        Moves::Along(c, beside_identity(curve).unwrap_or_else(|| curve.clone())),
                    );
                }
                _ => step(*direction, Moves::Along(c, curve.clone())),
            }
        }
    }
    for (c, _) in owns.iter().enumerate().filter(|(_, own)| **own == Own::Alone) {
        steps.push(Step::with(AxisKind::Rotation, Vector3::x(), c));
        steps.push(Step::along(AxisKind::Rotation, Vector3::x(), c, Curve::linear(-1.0, 0.0)));
    }
    steps
}
