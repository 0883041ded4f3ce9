//! Orientations that turn into each other: between two ([`Slerp`]) and through many ([`Squad`]).
//!
//! Both answer orientation, angular velocity and angular acceleration; the two vectors are in the turning frame, as a body that
//! turns with it feels them, and `orientation * vector` gives them in the frame in which the orientation is given.
//!
//! An orientation q and −q are the same one: the signs of what is given do not matter.

mod motion;
mod slerp;
mod squad;

pub use slerp::Slerp;
pub use squad::Squad;

use crate::error::{ProfileError, check_finite, check_range};
use crate::range::Range;
use nalgebra::{UnitQuaternion, Vector3};

/// An orientation with its angular velocity and acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turning {
    /// The orientation.
    pub orientation: UnitQuaternion<f64>,
    /// Angular velocity (rad/s) in the turning frame.
    pub velocity: Vector3<f64>,
    /// Angular acceleration (rad/s²) in the turning frame.
    pub acceleration: Vector3<f64>,
}

/// A quaternion that has length 1 but for rounding, made to have it.
fn checked(orientation: &UnitQuaternion<f64>) -> Result<UnitQuaternion<f64>, ProfileError> {
    let coordinates = orientation.coords;
    check_finite("orientation", coordinates.as_slice())?;
    check_range(
        "length of an orientation's quaternion",
        coordinates.norm(),
        Range::closed(1.0 - 1e-6, 1.0 + 1e-6),
    )?;
    Ok(UnitQuaternion::new_normalize(orientation.into_inner()))
}
