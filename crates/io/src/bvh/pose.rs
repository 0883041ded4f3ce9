//! Where the joints of a file are in one of its rows, in the file's own unit and axes.

use super::parse::{Channel, Text};
use solaris_model::{Isometry3, UnitQuaternion, Vector3};

/// The origins of all joints in a row.
pub(super) fn origins(text: &Text, row: usize) -> Vec<Vector3<f64>> {
    let values = text.row(row);
    let mut places: Vec<Isometry3<f64>> = Vec::with_capacity(text.joints.len());
    for joint in &text.joints {
        let (mut at, mut turn) = (joint.offset, UnitQuaternion::identity());
        for (channel, value) in joint.channels.iter().zip(&values[joint.first..]) {
            match *channel {
                // A position is where the joint is in its parent; the offset is where it is without one.
                Channel::Position(axis) => at[axis] = *value,
                Channel::Rotation(axis) => {
                    let mut vector = Vector3::zeros();
                    vector[axis] = value.to_radians();
                    turn *= UnitQuaternion::from_scaled_axis(vector);
                }
            }
        }
        let own = Isometry3::from_parts(at.into(), turn);
        places.push(joint.parent.map_or(own, |parent| places[parent] * own));
    }
    places.iter().map(|place| place.translation.vector).collect()
}
