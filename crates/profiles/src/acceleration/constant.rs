//! The curve of constant acceleration, a parabola.

use super::{check, constant_to, feasible};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary, Turn};
use crate::curve::{Curve, within};
use crate::error::ProfileError;
use crate::range::Ranges;
use crate::sample::Sample;
use alloc::vec::Vec;

/// A motion of constant acceleration.
///
/// ```text
/// x = x₀ + t·(v₀ + a·t/2)        v = v₀ + a·t
/// ```
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.4.1 and A.2.1. It calls the displacement monotone; it turns round at −v₀/a where that
/// lies inside (E21). What A.2.1 calls velocity and acceleration are displacement and velocity (E33).
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, acceleration::Constant};
///
/// let fall = Constant::new(1.0_f64, (5.0, 0.0), -9.81)?;
/// assert!((fall.at(1.0).position - (5.0 - 9.81 / 2.0)).abs() < 1e-15);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant<F = f64> {
    duration: F,
    from: F,
    start_velocity: F,
    acceleration: F,
}

impl<F: Elementary> Constant<F> {
    /// Over `duration`, from position `from` with velocity `v0`.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, numbers that are not finite or lead to such.
    pub fn new(duration: F, (from, v0): (F, F), acceleration: F) -> Result<Self, ProfileError> {
        check(duration, (from, v0), "acceleration", acceleration)?;
        Ok(Self { duration, from, start_velocity: v0, acceleration })
    }

    /// With the acceleration that leads to `to`: a = 2·(D − v₀·T)/T².
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn reaching(duration: F, (from, v0): (F, F), to: F) -> Result<Self, ProfileError> {
        Self::new(duration, (from, v0), constant_to(duration, (from, v0), to)?)
    }

    /// The acceleration.
    pub fn acceleration(&self) -> F {
        self.acceleration
    }
}

impl Constant {
    /// The start velocities with which the motion never turns round: all but those strictly between −a·T and 0.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn feasible_start_velocity(duration: f64, acceleration: f64) -> Result<Ranges, ProfileError> {
        feasible(duration, "acceleration", acceleration, acceleration * duration)
    }
}

impl<F: Elementary> Curve<F> for Constant<F> {
    fn duration(&self) -> F {
        self.duration
    }

    #[inline]
    fn at(&self, t: F) -> Sample<F> {
        let t = within(t, self.duration);
        // NaN + 0·t: the acceleration does not depend on the time, but no time gives none.
        let zero = F::from_f64(0.0) * t;
        let gain = self.acceleration * t;
        Sample {
            position: self.from + t * (self.start_velocity + F::from_f64(0.5) * gain),
            velocity: self.start_velocity + gain,
            acceleration: self.acceleration + zero,
            jerk: zero,
        }
    }

    /// Goes on as the same parabola.
    fn extrapolated(&self, t: F) -> Sample<F> {
        let gain = self.acceleration * t;
        Sample {
            position: self.from + t * (self.start_velocity + F::from_f64(0.5) * gain),
            velocity: self.start_velocity + gain,
            acceleration: self.acceleration,
            jerk: F::from_f64(0.0),
        }
    }
}

impl Answers for Constant {
    /// −v₀/a.
    fn stationary(&self) -> Stationary {
        let (v0, a) = (self.start_velocity, self.acceleration);
        if a.abs() > 0.0 {
            Stationary::at([(-v0 / a, Turn::Reversal)], self.duration)
        } else if v0.abs() > 0.0 {
            Stationary::NONE
        } else {
            Stationary::everywhere(self.duration)
        }
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        match quantity {
            Quantity::Position => self.stationary().points.iter().map(|point| point.time).collect(),
            _ => Vec::new(),
        }
    }
}
