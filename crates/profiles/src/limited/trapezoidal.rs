//! The trapezoidal profile: least time with limited velocity and acceleration.

use super::{at_most, inner, placed, stretch, way};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_overflow};
use crate::sample::Sample;
use alloc::vec::Vec;

/// A motion from rest to rest in the least time with a limited velocity V and a limited acceleration A: the velocity is a
/// trapezium, or a triangle where V is not reached.
///
/// ```text
/// D ≥ V²/A:  ramps of V/A, cruise of D/V − V/A        else:  ramps of √(D/A), no cruise        D = |to − from|
/// ```
///
/// The acceleration jumps at the ends and between the phases; the jerk, 0 within them, leaves these jumps out. No way
/// takes no time: with `from` = `to` the duration is 0.
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, limited::Trapezoidal};
///
/// let motion = Trapezoidal::new(0.0, 3.0, 1.0, 2.0)?;
/// assert_eq!(motion.phases(), [0.5, 2.5, 0.5]);
/// assert_eq!(motion.duration(), 3.5);
/// assert_eq!(motion.at(1.0).velocity, 1.0);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[doc(alias = "lspb")]
#[doc(alias = "bang-bang")]
#[doc(alias = "trapezoidal velocity")]
#[doc(alias = "time-optimal")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trapezoidal<F = f64> {
    ends: (F, F),
    /// 1 or −1.
    sign: F,
    /// How long a ramp and the cruise last.
    ramp: F,
    cruise: F,
    duration: F,
    velocity: F,
    acceleration: F,
}

impl<F: Elementary> Trapezoidal<F> {
    /// From `from` to `to`; the limits are magnitudes.
    ///
    /// # Errors
    ///
    /// A limit that is not positive; numbers that are not finite or lead to such.
    pub fn new(from: F, to: F, max_velocity: F, max_acceleration: F) -> Result<Self, ProfileError> {
        let (v, a) = (max_velocity, max_acceleration);
        let (way, sign) = way(from, to, &[("largest velocity", v), ("largest acceleration", a)])?;
        let zero = F::from_f64(0.0);
        let (ramp, cruise) = (v / a, way / v - v / a);
        let (velocity, ramp, cruise) = if way.value() <= 0.0 {
            (zero, zero, zero)
        } else if cruise.value() >= 0.0 {
            (v, ramp, cruise)
        } else {
            // √D·√A: neither product nor quotient of them need be a number.
            (way.sqrt() * a.sqrt(), way.sqrt() / a.sqrt(), zero)
        };
        let duration = ramp + cruise + ramp;
        check_overflow("duration", &[ramp, cruise, duration])?;
        check_overflow("velocity", &[velocity])?;
        Ok(Self { ends: (from, to), sign, ramp, cruise, duration, velocity, acceleration: a })
    }

    /// The same way, so much slower that it lasts `duration`: slower throughout, n times longer with 1/n of the
    /// velocities and 1/n² of the accelerations.
    ///
    /// # Errors
    ///
    /// A duration shorter than the motion's own, which is the least; the error tells it.
    pub fn lasting(self, duration: F) -> Result<Self, ProfileError> {
        let Some(n) = stretch(self.duration, duration)? else { return Ok(Self { duration, ..self }) };
        let (ramp, cruise) = (self.ramp * n, self.cruise * n);
        let (velocity, acceleration) = (self.velocity / n, self.acceleration / n / n);
        Ok(Self { ramp, cruise, duration, velocity, acceleration, ..self })
    }

    /// How long each phase lasts: speeding up, cruise, slowing down.
    pub fn phases(&self) -> [F; 3] {
        [self.ramp, self.cruise, self.ramp]
    }

    /// At what times the first two phases end.
    fn corners(&self) -> [F; 2] {
        [self.ramp, self.duration - self.ramp]
    }

    fn evaluate(&self, t: F, phase: usize) -> Sample<F> {
        if self.velocity.value() <= 0.0 {
            return Sample::rest(self.ends.0);
        }
        let backwards = phase > 1 || (phase == 1 && t.value() + t.value() > self.duration.value());
        let s = if backwards { self.duration - t } else { t };
        let (zero, half) = (F::from_f64(0.0), F::from_f64(0.5));
        let way = if phase == 1 {
            Sample { velocity: self.velocity, ..Sample::rest(self.velocity * (s - half * self.ramp)) }
        } else {
            let s = at_most(s, self.ramp);
            let velocity = self.acceleration * s;
            Sample { position: half * s * velocity, velocity, acceleration: self.acceleration, jerk: zero }
        };
        placed(way, self.ends, self.sign, backwards)
    }
}

impl<F: Elementary> Curve<F> for Trapezoidal<F> {
    /// How long it lasts; 0 where there is no way to go.
    fn duration(&self) -> F {
        self.duration
    }

    fn at(&self, t: F) -> Sample<F> {
        let t = within(t, self.duration);
        if t.value().is_nan() {
            return Sample::from_array([t; 4]);
        }
        let phase = self.corners().iter().filter(|corner| corner.value() <= t.value()).count();
        self.evaluate(t, phase)
    }

    fn before(&self, t: F) -> Sample<F> {
        if t.value() > 0.0 && t.value() <= self.duration.value() {
            let phase = self.corners().iter().filter(|corner| corner.value() < t.value()).count();
            self.evaluate(t, phase)
        } else {
            self.at(t)
        }
    }
}

impl Answers for Trapezoidal {
    /// None inside; all of a rest that was made to last.
    fn stationary(&self) -> Stationary {
        if self.velocity > 0.0 || self.duration <= 0.0 {
            Stationary::NONE
        } else {
            Stationary::everywhere(self.duration)
        }
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        match quantity {
            Quantity::Position | Quantity::Jerk => Vec::new(),
            Quantity::Velocity | Quantity::Acceleration => inner(self.corners(), self.duration),
        }
    }
}
