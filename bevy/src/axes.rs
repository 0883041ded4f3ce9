//! Bevy's axes and ours.
//!
//! Both are right-handed, in metres, with y up. Ours look along z, with x to the left; Bevy's look along −z, with x to the right. Half a turn
//! about y takes one to the other, either way.

use bevy_math::{Quat, Vec3};
use bevy_transform::components::Transform;
use solaris::model::Placement;

/// Half a turn about y.
pub(crate) const TURNED: Quat = Quat::from_xyzw(0.0, 1.0, 0.0, 0.0);

/// Left and forward in our axes (m, m/s), of a vector in Bevy's.
pub(crate) fn level(v: Vec3) -> [f64; 2] {
    [-f64::from(v.x), -f64::from(v.z)]
}

/// A vector in Bevy's axes, of one to the left and forward in ours.
pub(crate) fn raised([left, forward]: [f64; 2]) -> Vec3 {
    Vec3::new(-left as f32, 0.0, -forward as f32)
}

/// The same place and turn, number by number: between two frames that both have our axes.
pub(crate) fn transform(place: &Placement) -> Transform {
    let [x, y, z] = place.translation.vector.map(|x| x as f32).into();
    let [i, j, k, w] = place.rotation.coords.map(|x| x as f32).into();
    Transform::from_xyz(x, y, z).with_rotation(Quat::from_xyzw(i, j, k, w))
}
