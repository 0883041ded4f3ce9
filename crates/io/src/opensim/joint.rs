//! Joints by their kinds.

use super::axes::{Built, Chain, Step};
use super::coordinate::Coordinate;
use super::couplers::Couplers;
use super::custom;
use super::ellipsoid;
use super::frames::Anchor;
use crate::xml::{Node, Reader, shown, tag};
use solaris_model::{AxisKind, Placement, Vector3};
use std::ops::Range;

/// A joint and what it joins.
pub(super) struct JointAt<'a> {
    pub(super) name: String,
    pub(super) node: Node<'a>,
    pub(super) parent: Anchor,
    pub(super) child: Anchor,
}

/// The joint of a joint's element; nothing where it cannot be one, which is a fault. Where it is `turned`, the one that
/// moves its parent against its child.
pub(super) fn build(
    reader: &mut Reader,
    at: &JointAt,
    mut coordinates: Vec<Coordinate>,
    couplers: &Couplers,
    turned: bool,
) -> Option<Built> {
    let (name, node) = (at.name.as_str(), at.node);
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
        "location_in_child",
        "orientation_in_child",
        "location",
        "orientation",
        "connectors",
        "reverse",
    ];
    reader.check_elements(node, &known, &[]);
    let mut steps = match (plain(kind), kind) {
        (Some((count, steps)), _) => {
            complete(reader, at, &mut coordinates, count)?;
            steps
        }
        (None, "EllipsoidJoint") => {
            complete(reader, at, &mut coordinates, 3)?;
            ellipsoid::joint(reader, at)?
        }
        (None, "ScapulothoracicJoint") => {
            complete(reader, at, &mut coordinates, 4)?;
            ellipsoid::scapulothoracic(reader, at)?
        }
        (None, "CustomJoint") => custom::steps(reader, at, &coordinates, couplers)?,
        _ => {
            let what = match kind {
                "ConstantCurvatureJoint" => {
                    " (an arc whose bend is a function of two angles at once), which is not read; put a <BallJoint> in the \
                     middle of its length in its place, or several"
                }
                _ => ", which is not read; put a <CustomJoint> or another joint in its place",
            };
            reader.fault(tag(node), format!("joint '{name}' is a <{}>{what}", shown(kind)));
            return None;
        }
    };
    if matches!(kind, "BallJoint" | "FreeJoint" | "EllipsoidJoint" | "ScapulothoracicJoint") {
        let message = format!(
            "its coordinates are three angles, and its moments those about their axes; OpenSim's moments of a <{kind}> are \
             about the axes of the parent frame"
        );
        reader.note(tag(node), format!("joint '{name}'"), message);
    }
    let (mut from, mut to) = (at.parent.within, at.child.within);
    if turned {
        (from, to) = (to, from);
        steps.reverse();
        for step in &mut steps {
            step.direction = -step.direction;
        }
        let message = "its child is nearer to ground than its parent: the joint is turned round, and its coordinates keep \
                       their meaning";
        reader.note(tag(node), format!("joint '{name}'"), message);
    }
    Some(Chain { name, from, steps, to, coordinates: &coordinates }.joint(couplers))
}

/// The free joint of a body that has none, as OpenSim names it.
pub(super) fn free(body: &str) -> Built {
    let name = format!("free_{body}");
    let coordinates: Vec<Coordinate> = (0..6).map(|i| unnamed(&name, i, 0..0)).collect();
    let steps = plain("FreeJoint").map(|(_, steps)| steps).unwrap_or_default();
    let identity = Placement::identity();
    Chain { name: &name, from: identity, steps, to: identity, coordinates: &coordinates }
        .joint(&Couplers::new())
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
        let (name, kind, found) = (&at.name, at.node.tag_name().name(), coordinates.len());
        reader.fault(tag(at.node), format!("joint '{name}' has {found} coordinates; a <{kind}> has {count}"));
        return None;
    }
    for i in coordinates.len()..count {
        coordinates.push(unnamed(&at.name, i, tag(at.node)));
    }
    Some(())
}

/// A coordinate that the file does not name.
fn unnamed(joint: &str, index: usize, span: Range<usize>) -> Coordinate {
    let name = format!("{joint}_coord_{index}");
    Coordinate { dof: name.clone(), name, limits: None, span }
}
