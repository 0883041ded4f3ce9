//! What a file does not say, guessed from its skeleton: which axis is up, and the unit of lengths.

use super::body::lengths;
use super::parse::{Channel, Text};
use super::pose::origins;
use super::unit::Unit;
use crate::clip::Up;
use crate::clip::bones::Said;
use crate::clip::masses::{self, Length};
use solaris_model::rig::{Bone, Segment};
use solaris_model::{FindingKind, Vector3};

/// The axis along which a person's head is above the feet, over twenty frames; y where that cannot be told.
pub(super) fn up(file: &Text, segments: &[Option<Bone>], said: &mut Said) -> Up {
    let of = |segment: Segment| -> Vec<usize> {
        let is = |bone: &Option<Bone>| bone.is_some_and(|bone| bone.segment == segment);
        (0..segments.len()).filter(|i| is(&segments[*i])).collect()
    };
    let (heads, feet) = (of(Segment::Head), of(Segment::Foot));
    if heads.is_empty() || feet.is_empty() || file.count == 0 {
        return Up::Y;
    }
    let mut way = Vector3::zeros();
    for k in 0..20 {
        let places = origins(file, k * (file.count - 1) / 19);
        let middle = |of: &[usize]| of.iter().map(|i| places[*i]).sum::<Vector3<f64>>() / of.len() as f64;
        way += middle(&heads) - middle(&feet);
    }
    if way.z <= way.y.abs().max(way.x.abs()) {
        return Up::Y;
    }
    let message =
        "z points up in this file, as its head is above its feet along z; its y, z, x are x, y, z here";
    said.say(FindingKind::Note, "axes", message.to_owned(), None);
    Up::Z
}

/// Makes y of z: the file's y, z, x become x, y, z.
pub(super) fn turn(file: &mut Text) {
    let vector = |v: Vector3<f64>| Vector3::new(v.y, v.z, v.x);
    for joint in &mut file.joints {
        joint.offset = vector(joint.offset);
        joint.end = joint.end.map(vector);
        for channel in &mut joint.channels {
            *channel = match *channel {
                Channel::Position(axis) => Channel::Position((axis + 2) % 3),
                Channel::Rotation(axis) => Channel::Rotation((axis + 2) % 3),
            };
        }
    }
}

/// The unit in which the skeleton has a person's size.
pub(super) fn unit(file: &Text, segments: &[Option<Bone>], said: &mut Said) -> Unit {
    let lengths = lengths(file, segments, Unit::Metres);
    // From hand to foot along the bones people measure 1.25 of their height.
    let height = masses::stature(&lengths).unwrap_or_else(|| longest_way(&lengths) / 1.25);
    let is_cmu = file.joints.iter().any(|joint| joint.name == "LHipJoint");
    let unit = if height > 0.0 { Unit::of_person(height, is_cmu) } else { Unit::default() };
    let size = height / unit.per_metre();
    let whose = if segments.iter().any(Option::is_some) {
        "by its legs a person of"
    } else {
        "then its size is that of a person of"
    };
    let kind = if (0.9..2.6).contains(&size) { FindingKind::Note } else { FindingKind::Suspect };
    let message = format!("1 unit is taken for {unit}: {whose} {size:.2} m; the file does not say it");
    said.say(kind, "unit of lengths", message, None);
    unit
}

/// The longest way from one end of the skeleton to another.
fn longest_way(bones: &[Length]) -> f64 {
    let (mut reach, mut longest) = (vec![0.0_f64; bones.len()], 0.0_f64);
    for (i, bone) in bones.iter().enumerate().rev() {
        let Some(parent) = bone.parent else { continue };
        let own = reach[i] + bone.along.norm();
        longest = longest.max(reach[parent] + own);
        reach[parent] = reach[parent].max(own);
    }
    longest
}
