//! Joints by their kinds.

use super::axes::{Chain, Moves, Step};
use super::coordinate::Coordinate;
use super::couplers::Couplers;
use super::curves::{UNIT, constant, line};
use super::element::child_words;
use super::frames::Anchor;
use super::function;
use crate::xml::{Node, Reader, element, elements_called, shown, tag};
use solaris_model::{AxisKind, Curve, Joint, Placement, Vector3};
use std::ops::Range;

/// A joint, and where the body's frame stands in the frame that it moves.
pub(super) type Built = (Joint, Placement);

/// A joint and what it joins.
pub(super) struct JointAt<'a> {
    pub(super) name: &'a str,
    pub(super) node: Node<'a>,
    pub(super) parent: Anchor,
    pub(super) child: Anchor,
}

/// The joint of a joint's element; nothing where it cannot be one, which is a fault.
pub(super) fn build(
    reader: &mut Reader,
    at: &JointAt,
    mut coordinates: Vec<Coordinate>,
    couplers: &Couplers,
) -> Option<Built> {
    let (name, node) = (at.name, at.node);
    let kind = node.tag_name().name();
    let known = [
        "socket_parent_frame",
        "socket_child_frame",
        "coordinates",
        "frames",
        "CoordinateSet",
        "SpatialTransform",
        "parent_body",
        "location_in_parent",
        "orientation_in_parent",
        "location",
        "orientation",
        "reverse",
    ];
    reader.check_elements(node, &known, &[]);
    let steps = match plain(kind) {
        Some((count, steps)) => {
            complete(reader, at, &mut coordinates, count)?;
            steps
        }
        None if kind == "CustomJoint" => custom(reader, at, &coordinates)?,
        None => {
            let message = format!(
                "joint '{name}' is a <{}>, which is not read; put a <CustomJoint> or another joint in its place",
                shown(kind)
            );
            reader.fault(tag(node), message);
            return None;
        }
    };
    if matches!(kind, "BallJoint" | "FreeJoint") {
        let message = format!(
            "its coordinates are three angles, and its moments those about their axes; OpenSim's moments of a <{kind}> are \
             about the axes of the parent frame"
        );
        reader.note(tag(node), format!("joint '{name}'"), message);
    }
    let (from, to, span) = (at.parent.within, at.child.within, tag(node));
    let chain = Chain { name, span, from, steps, to, coordinates: &coordinates };
    Some(chain.joint(reader, couplers))
}

/// The number of coordinates and the steps of a joint whose kind says it all.
fn plain(kind: &str) -> Option<(usize, Vec<Step>)> {
    let axis = |i: usize| Vector3::ith(i, 1.0);
    let turn = |i: usize, coordinate| Step::with(AxisKind::Rotation, axis(i), coordinate);
    let slide = |i: usize, coordinate| Step::with(AxisKind::Translation, axis(i), coordinate);
    let steps = match kind {
        "WeldJoint" => vec![],
        "PinJoint" => vec![turn(2, 0)],
        "SliderJoint" => vec![slide(0, 0)],
        "UniversalJoint" => vec![turn(0, 0), turn(1, 1)],
        "BallJoint" | "GimbalJoint" => vec![turn(0, 0), turn(1, 1), turn(2, 2)],
        // The angle is the first coordinate, but the slides are along axes that it does not turn.
        "PlanarJoint" => vec![slide(0, 1), slide(1, 2), turn(2, 0)],
        "FreeJoint" => {
            vec![slide(0, 3), slide(1, 4), slide(2, 5), turn(0, 0), turn(1, 1), turn(2, 2)]
        }
        _ => return None,
    };
    Some((steps.len(), steps))
}

/// Gives a joint the coordinates that its kind asks for, under OpenSim's names where the file has none.
fn complete(
    reader: &mut Reader,
    at: &JointAt,
    coordinates: &mut Vec<Coordinate>,
    count: usize,
) -> Option<()> {
    if coordinates.len() > count {
        let (name, kind, found) = (at.name, at.node.tag_name().name(), coordinates.len());
        reader.fault(tag(at.node), format!("joint '{name}' has {found} coordinates; a <{kind}> has {count}"));
        return None;
    }
    for i in coordinates.len()..count {
        let name = format!("{}_coord_{i}", at.name);
        coordinates.push(Coordinate { name, limits: None, span: tag(at.node) });
    }
    Some(())
}

/// An axis of a `CustomJoint`.
struct Drive {
    kind: AxisKind,
    direction: Vector3<f64>,
    coordinate: Option<usize>,
    /// Over the coordinate; a constant without one.
    curve: Curve,
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
fn custom(reader: &mut Reader, at: &JointAt, coordinates: &[Coordinate]) -> Option<Vec<Step>> {
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
    let leaders: Vec<Option<usize>> = (0..coordinates.len())
        .map(|c| leader(reader, &drives, c, &coordinates[c], &owner, &coordinates[c].span))
        .collect();
    leaders.iter().all(Option::is_some).then(|| steps(&drives, &leaders))
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
    Some(Drive { kind, direction, coordinate, curve })
}

/// The axis that a coordinate drives one to one.
fn leader(
    reader: &mut Reader,
    drives: &[Drive],
    index: usize,
    coordinate: &Coordinate,
    owner: &str,
    span: &Range<usize>,
) -> Option<usize> {
    let driven = || drives.iter().enumerate().filter(|(_, drive)| drive.coordinate == Some(index));
    let one = |drive: &Drive| line(&drive.curve).is_some_and(|(slope, _)| (slope.abs() - 1.0).abs() < UNIT);
    let found = driven().find(|(_, drive)| one(drive)).map(|(i, _)| i);
    if found.is_none() {
        let name = &coordinate.name;
        let message = if driven().next().is_none() {
            format!(
                "{owner}: coordinate '{name}' drives no axis; remove it, or name it in the <coordinates> of one"
            )
        } else {
            format!(
                "{owner}: coordinate '{name}' drives no axis with slope 1 or -1, so that it is no degree of freedom by itself; \
                 let it be the angle (or the slide) of one axis"
            )
        };
        reader.fault(span.clone(), message);
    }
    found
}

/// Translations first, along axes that do not turn, then rotations.
fn steps(drives: &[Drive], leaders: &[Option<usize>]) -> Vec<Step> {
    let mut steps = Vec::new();
    for kind in [AxisKind::Translation, AxisKind::Rotation] {
        for (i, drive) in drives.iter().enumerate().filter(|(_, drive)| drive.kind == kind) {
            let Drive { kind, direction, .. } = *drive;
            let step = |direction, moves| Step { kind, direction, moves };
            match (drive.coordinate, constant(&drive.curve)) {
                (Some(c), None) if leaders[c] == Some(i) => {
                    let (slope, offset) = line(&drive.curve).unwrap_or((1.0, 0.0));
                    steps.push(step(direction * slope.signum(), Moves::With(c)));
                    steps.push(step(direction, Moves::By(offset)));
                }
                (Some(c), None) => steps.push(step(direction, Moves::Along(c, drive.curve.clone()))),
                (_, value) => steps.push(step(direction, Moves::By(value.unwrap_or(0.0)))),
            }
        }
    }
    steps
}
