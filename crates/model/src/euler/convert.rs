//! The conversion of states between a ball joint and three rotations.

use super::{EulerError, EulerOrder};
use crate::configuration::rotation::{read, unit};
use nalgebra::{UnitQuaternion, Vector3};

/// The state of a ball joint, as it stands in `q`, `v`, `a` and `tau`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallState {
    /// The quaternion (x, y, z, w); its direction counts.
    pub q: [f64; 4],
    /// Angular velocity along the link's axes (rad/s).
    pub v: [f64; 3],
    /// Its rate along the link's axes (rad/s²).
    pub a: [f64; 3],
    /// Moment along the link's axes (N m).
    pub tau: [f64; 3],
}

/// The state of a joint of three rotations in some [`EulerOrder`], as it stands in `q`, `v`, `a` and `tau`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerState {
    /// Angles in order (rad).
    pub q: [f64; 3],
    /// Their rates (rad/s).
    pub v: [f64; 3],
    /// The rates of these (rad/s²).
    pub a: [f64; 3],
    /// Moments about the three axes (N m).
    pub tau: [f64; 3],
}

impl EulerOrder {
    /// The state of the ball joint that does what three rotations in this order do.
    ///
    /// ```text
    /// ω = J·ṙ      ω̇ = J·r̈ + J̇·ṙ      τ_ball = J⁻ᵀ·τ
    /// ```
    ///
    /// An armature is left out on both sides: one about the axes of three rotations is none about those of the link.
    ///
    /// # Errors
    ///
    /// [`EulerError`] for numbers that are not finite, and in gimbal lock, where moments about the three axes (but zero) are none
    /// along the link's.
    pub fn ball_state(self, state: &EulerState) -> Result<BallState, EulerError> {
        check(&[
            ("an angle", &state.q),
            ("a rate", &state.v),
            ("an acceleration", &state.a),
            ("a moment", &state.tau),
        ])?;
        let moment = self.moment(&state.q, &state.tau)?;
        let (map, rate) = (self.velocity_map(&state.q), self.velocity_map_rate(&state.q, &state.v));
        let (v, a) = (Vector3::from(state.v), Vector3::from(state.a));
        Ok(BallState {
            q: self.rotation(&state.q).coords.into(),
            v: (map * v).into(),
            a: (map * a + rate * v).into(),
            tau: moment.into(),
        })
    }

    /// The state of three rotations in this order that do what a ball joint does, their angles as [`EulerOrder::angles`].
    ///
    /// ```text
    /// ṙ = J⁻¹·ω      r̈ = J⁻¹·(ω̇ − J̇·ṙ)      τ = Jᵀ·τ_ball
    /// ```
    ///
    /// # Errors
    ///
    /// [`EulerError`] for numbers that are not finite, a zero quaternion, and in gimbal lock.
    pub fn euler_state(self, state: &BallState) -> Result<EulerState, EulerError> {
        self.with_angles(state, |rotation| self.angles(rotation))
    }

    /// As [`EulerOrder::euler_state`], with the angles nearest to `near` (rad): [`EulerOrder::angles_near`].
    ///
    /// # Errors
    ///
    /// As [`EulerOrder::euler_state`].
    pub fn euler_state_near(self, state: &BallState, near: &[f64; 3]) -> Result<EulerState, EulerError> {
        check(&[("an angle to be near to", near)])?;
        self.with_angles(state, |rotation| self.angles_near(rotation, near))
    }

    fn with_angles(
        self,
        state: &BallState,
        angles: impl Fn(&UnitQuaternion<f64>) -> [f64; 3],
    ) -> Result<EulerState, EulerError> {
        check(&[
            ("a component of the quaternion", &state.q),
            ("an angular velocity", &state.v),
            ("an angular acceleration", &state.a),
            ("a moment", &state.tau),
        ])?;
        let rotation = unit(&read(&state.q)).ok_or(EulerError::ZeroQuaternion)?;
        let angles = angles(&UnitQuaternion::new_unchecked(rotation));
        let rates = self.rates(&angles, &Vector3::from(state.v))?;
        let bias = self.velocity_map_rate(&angles, &rates) * Vector3::from(rates);
        Ok(EulerState {
            q: angles,
            v: rates,
            a: self.rates(&angles, &(Vector3::from(state.a) - bias))?,
            tau: (self.velocity_map(&angles).transpose() * Vector3::from(state.tau)).into(),
        })
    }
}

fn check(parts: &[(&'static str, &[f64])]) -> Result<(), EulerError> {
    for (what, values) in parts {
        if let Some(value) = values.iter().find(|x| !x.is_finite()) {
            return Err(EulerError::NotFinite { what, value: *value });
        }
    }
    Ok(())
}
