//! Worlds in which y is not up, turned for formats in which it is.

use solaris_model::{UnitQuaternion, Vector3};
use std::f64::consts::FRAC_PI_3;

/// The turn of a world with this `gravity` after which y is up, or nearest to it as it is.
///
/// Where z was, x, y, z become z, x, y: a robot that looks along x then looks along z, as figures do where y is up.
pub(crate) fn upright(gravity: &Vector3<f64>) -> UnitQuaternion<f64> {
    // Of a slope, y is up enough.
    let Some(down) = gravity.try_normalize(0.0).filter(|down| -down.y < down.amax()) else {
        return UnitQuaternion::identity();
    };
    if -down.z > 1.0 - 1e-12 {
        let diagonal = Vector3::repeat(-1.0).normalize();
        return UnitQuaternion::from_scaled_axis(diagonal * (2.0 * FRAC_PI_3));
    }
    let half_turn = || UnitQuaternion::from_scaled_axis(Vector3::x() * std::f64::consts::PI);
    UnitQuaternion::rotation_between(&-down, &Vector3::y()).unwrap_or_else(half_turn)
}
