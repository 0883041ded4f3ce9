//! The figure of a file: bones with masses, joints with the file's channels.

use super::parse::{Channel, Node, Text};
use super::unit::Unit;
use crate::clip::bones;
use crate::clip::masses::{Length, Weight};
use solaris_model::rig::Bone;
use solaris_model::{Axis, Figure, FigureBuilder, FigureError, Joint, LinkSpec, Part, SourceMap, Vector3};

/// Gravity (m/s²): down, y is up.
pub(super) const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);
/// How far (of the skeleton's size) positions may be from a constant that they are printed from.
const STILL: f64 = 1e-6;

/// The figure; where it cannot be one, with the places of its joints.
pub(super) fn figure(
    file: &Text,
    names: &[String],
    slides: &[bool],
    unit: Unit,
    weights: Vec<Weight>,
) -> Result<Figure, (SourceMap, FigureError)> {
    let mut places = SourceMap::default();
    let mut builder = FigureBuilder::new(names[0].clone()).gravity(GRAVITY);
    for (i, (node, weight)) in file.joints.iter().zip(weights).enumerate() {
        let mut joint = Joint::new(names[i].clone()).at(origin(file, i, slides[i]) / unit.per_metre());
        for (_, channel) in freedoms(node, slides[i]) {
            joint = joint.axis(match channel {
                Channel::Position(axis) => Axis::translation(Vector3::ith(axis, 1.0)),
                Channel::Rotation(axis) => Axis::rotation(Vector3::ith(axis, 1.0)),
            });
        }
        let mut link = match node.parent {
            Some(parent) => LinkSpec::child(names[i].clone(), names[parent].clone(), joint),
            None => LinkSpec::root(names[i].clone(), joint),
        };
        link = link.mass(weight.mass).inertia(weight.inertia).com(weight.com);
        if let Some(shape) = weight.shape {
            link = link.shape(shape);
        }
        if let Some(end) = node.end {
            link = link.tip(end / unit.per_metre());
        }
        builder = builder.link(link);
        places.put(Part::Link, &names[i], node.span.clone());
        places.put(Part::Joint, &names[i], node.span.clone());
    }
    builder.build().map_err(|error| (places, error))
}

/// The bones, in metres.
pub(super) fn lengths(file: &Text, segments: &[Option<Bone>], unit: Unit) -> Vec<Length> {
    let metres = |v: Vector3<f64>| v / unit.per_metre();
    let joints = file.joints.iter();
    let joints = joints.map(|joint| (joint.parent, metres(joint.offset), joint.end.map(metres)));
    bones::lengths(&joints.collect::<Vec<_>>(), segments)
}

/// For each joint, whether its positions are degrees of freedom: the root's are, others' where they change.
pub(super) fn slides(file: &Text) -> Vec<bool> {
    let size = file.joints.iter().map(|joint| joint.offset.norm()).fold(0.0, f64::max);
    let moves = |(i, first): (usize, usize)| {
        let start = file.row(0)[i];
        (first..file.count).any(|row| (file.row(row)[i] - start).abs() > STILL * size)
    };
    let any = |joint: &Node| {
        let positions =
            joint.channels.iter().enumerate().filter(|(_, channel)| matches!(channel, Channel::Position(_)));
        let mut places = positions.map(|(k, _)| joint.first + k);
        joint.parent.is_none() || (file.count > 0 && places.any(|i| moves((i, 1))))
    };
    file.joints.iter().map(any).collect()
}

/// Where a joint is in its parent (in the file's unit) with all its degrees of freedom at zero.
pub(super) fn origin(file: &Text, joint: usize, slides: bool) -> Vector3<f64> {
    let node = &file.joints[joint];
    let mut at = node.offset;
    for (k, channel) in node.channels.iter().enumerate() {
        if let Channel::Position(axis) = *channel {
            // The root's position is a place in the world; others' is taken from the offset on.
            at[axis] = match (slides, node.parent) {
                (true, None) => 0.0,
                (false, _) if file.count > 0 => file.row(0)[node.first + k],
                _ => node.offset[axis],
            };
        }
    }
    at
}

/// The channels of a joint that are degrees of freedom, in their order: where in a row, and what; positions first.
pub(super) fn freedoms(node: &Node, slides: bool) -> Vec<(usize, Channel)> {
    let all = || node.channels.iter().enumerate().map(|(k, channel)| (node.first + k, *channel));
    let positions = all().filter(|(_, channel)| slides && matches!(channel, Channel::Position(_)));
    positions.chain(all().filter(|(_, channel)| matches!(channel, Channel::Rotation(_)))).collect()
}
