//! Slerp: one orientation turned into another at a constant rate.

use super::motion::{exp, shortest};
use super::{Turning, checked};
use crate::curve::within;
use crate::error::{ProfileError, check_duration, check_overflow};
use nalgebra::{UnitQuaternion, Vector3};

/// The shortest turn from one orientation to another, about a fixed axis with constant angular velocity.
///
/// ```text
/// q(t) = q₀·e^(v·t/T)        v = log(q₀⁻¹·q₁)        ω = 2·v/T
/// ```
///
/// Written so, nothing is divided by the sine of an angle, and orientations that are nearly the same lose no digits. Where they
/// are half a turn apart, both ways are as short, and one of them is taken, the same for q and −q; near that, a small change of
/// an orientation may turn the way round.
///
/// # Examples
///
/// A quarter turn in two seconds:
///
/// ```
/// use nalgebra::{UnitQuaternion, Vector3};
/// use solaris_profiles::rotation::Slerp;
///
/// let quarter = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), std::f64::consts::FRAC_PI_2);
/// let slerp = Slerp::new(2.0, &UnitQuaternion::identity(), &quarter)?;
/// assert!((slerp.at(1.0).orientation.angle() - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
/// assert!((slerp.at(1.0).velocity.z - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
///
/// # Source
///
/// K. Shoemake, "Animating rotation with quaternion curves", Computer Graphics 19 (1985). The thesis has no orientations.
#[doc(alias = "spherical linear interpolation")]
#[doc(alias = "quaternion interpolation")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slerp {
    duration: f64,
    from: UnitQuaternion<f64>,
    /// v.
    turn: Vector3<f64>,
    velocity: Vector3<f64>,
}

impl Slerp {
    /// From `from` to `to` in `duration` (s).
    ///
    /// # Errors
    ///
    /// A duration that is not positive; an orientation that is not finite or whose quaternion is not of length 1 (to 1e-6); an
    /// angular velocity that overflows.
    pub fn new(
        duration: f64,
        from: &UnitQuaternion<f64>,
        to: &UnitQuaternion<f64>,
    ) -> Result<Self, ProfileError> {
        check_duration(duration)?;
        let (from, to) = (checked(from)?, checked(to)?);
        let turn = shortest(&from, &to);
        let velocity = turn * 2.0 / duration;
        check_overflow("angular velocity", velocity.as_slice())?;
        Ok(Self { duration, from, turn, velocity })
    }

    /// How long it takes (s).
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// The whole turn: its axis, times its angle (rad, at most π).
    pub fn turn(&self) -> Vector3<f64> {
        self.turn * 2.0
    }

    /// The orientation at a time since the beginning, held at the ends; a time that is NaN gives NaN.
    pub fn at(&self, t: f64) -> Turning {
        let u = within(t, self.duration) / self.duration;
        let turned = UnitQuaternion::new_unchecked(exp(self.turn * u));
        let rest = Vector3::repeat(0.0 * u);
        Turning { orientation: self.from * turned, velocity: self.velocity + rest, acceleration: rest }
    }
}
