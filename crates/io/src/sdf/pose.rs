//! `<pose>`.

use crate::xml::{Node, Reader, element, text_of};
use solaris_model::{Placement, UnitQuaternion, Vector3};
use std::ops::Range;

/// What a `<pose>` says: a place, and in which frame.
pub(super) struct Pose {
    pub(super) place: Placement,
    /// The frame's name, where one is named, and where it stands.
    pub(super) relative_to: Option<(String, Range<usize>)>,
}

/// The `<pose>` of an element; nowhere without it.
pub(super) fn of(reader: &mut Reader, node: Node, version: u32) -> Pose {
    let none = Pose { place: Placement::identity(), relative_to: None };
    let Some(pose) = element(node, "pose") else { return none };
    // The older name did nothing before it was given a meaning.
    let attribute = if version < 7 { "frame" } else { "relative_to" };
    reader.check_attributes(pose, &["relative_to", "frame", "degrees", "rotation_format"]);
    let named = pose.attribute(attribute).or_else(|| pose.attribute("relative_to"));
    let relative_to = named.map(str::trim).filter(|name| !name.is_empty());
    let relative_to = relative_to.map(|name| (name.to_owned(), crate::xml::value_span(pose, attribute)));
    Pose { place: place(reader, pose).unwrap_or_else(Placement::identity), relative_to }
}

/// The place that the text of a pose says.
///
/// ```text
/// x y z roll pitch yaw: R = Rz(yaw)·Ry(pitch)·Rx(roll)          x y z qx qy qz qw
/// ```
fn place(reader: &mut Reader, pose: Node) -> Option<Placement> {
    if text_of(pose).0.is_empty() {
        return None;
    }
    let formats = [("euler_rpy", false), ("quat_xyzw", true)];
    let is_quaternion = reader.choice(pose, "rotation_format", &formats).unwrap_or(false);
    let count = if is_quaternion { 7 } else { 6 };
    let numbers = reader.text_numbers(pose, count..=count)?;
    let turn = if is_quaternion {
        let turn = quaternion([numbers[3], numbers[4], numbers[5], numbers[6]]);
        if turn.is_none() {
            reader.fault(
                text_of(pose).1,
                "its quaternion (x y z w) has no length; a rotation's has the length 1",
            );
        }
        turn?
    } else {
        let degrees =
            reader.choice(pose, "degrees", &[("true", true), ("false", false), ("1", true), ("0", false)]);
        let unit = if degrees == Some(true) { std::f64::consts::PI / 180.0 } else { 1.0 };
        let [roll, pitch, yaw] = [numbers[3] * unit, numbers[4] * unit, numbers[5] * unit];
        if [roll, pitch, yaw].iter().all(|angle| *angle == 0.0) {
            UnitQuaternion::identity()
        } else {
            UnitQuaternion::from_euler_angles(roll, pitch, yaw)
        }
    };
    Some(Placement::from_parts(Vector3::new(numbers[0], numbers[1], numbers[2]).into(), turn))
}

/// A quaternion of any length but zero.
fn quaternion(parts: [f64; 4]) -> Option<UnitQuaternion<f64>> {
    let length = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
    (length > 1e-9).then(|| UnitQuaternion::new_unchecked(parts.map(|part| part / length).into()))
}
