//! The curve that is half a period of a sine, from rest to rest.

use super::{Place, check_motion};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary};
use crate::curve::Curve;
use crate::error::{ProfileError, check_overflow};
use crate::sample::Sample;
use alloc::vec::Vec;
use core::f64::consts::PI;

/// A motion from rest to rest along half a period of a sine.
///
/// ```text
/// x = x₀ + D·sin²(π·u/2)        u = t/T,  D = x₁ − x₀
/// v = π/2·D/T·sin π·u
/// a = π²/2·D/T²·cos π·u
/// j = −π³/2·D/T³·sin π·u
/// ```
///
/// The acceleration jumps at both ends, where the curve joins rest.
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.3.1 and §A.1.1, "without velocity constraints", where the way is D·(1 + sin(π·u − π/2))/2:
/// the same function, but close to the start its two terms cancel, and a displacement of 10⁻¹⁵ D or less is lost.
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, displacement::Trigonometric};
///
/// let middle = Trigonometric::new(2.0, 1.0, 4.0)?.at(1.0);
/// assert!((middle.position - 2.5_f64).abs() < 1e-15);
/// assert!((middle.velocity - 0.75 * std::f64::consts::PI).abs() < 1e-15);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[doc(alias = "cosine easing")]
#[doc(alias = "ease in out")]
#[doc(alias = "harmonic")]
#[doc(alias = "cycloid")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trigonometric<F = f64> {
    duration: F,
    from: F,
    to: F,
    delta: F,
    // Of the sine and the cosine of π·u.
    velocity: F,
    acceleration: F,
    jerk: F,
}

impl<F: Elementary> Trigonometric<F> {
    /// Over `duration` > 0, between two positions.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, numbers that are not finite or lead to such.
    pub fn new(duration: F, from: F, to: F) -> Result<Self, ProfileError> {
        check_motion(duration, from, to)?;
        let delta = to - from;
        let omega = F::from_f64(PI) / duration;
        let velocity = F::from_f64(0.5 * PI) * delta / duration;
        let acceleration = velocity * omega;
        let jerk = acceleration * omega;
        check_overflow("distance", &[delta])?;
        check_overflow("largest jerk", &[jerk])?;
        Ok(Self { duration, from, to, delta, velocity, acceleration, jerk })
    }
}

impl<F: Elementary> Curve<F> for Trigonometric<F> {
    fn duration(&self) -> F {
        self.duration
    }

    #[inline]
    fn at(&self, t: F) -> Sample<F> {
        let place = Place::new(t, self.duration);
        let base = if place.from_end { self.to } else { self.from };
        // Of half the angle π·u from the nearer end.
        let (sine, cosine) = (F::from_f64(0.5 * PI) * place.near).sin_cos();
        let whole_sine = F::from_f64(2.0) * sine * cosine;
        let whole_cosine = place.forward((cosine - sine) * (cosine + sine));
        Sample {
            position: base + place.forward(self.delta * sine * sine),
            velocity: self.velocity * whole_sine,
            acceleration: self.acceleration * whole_cosine,
            jerk: -self.jerk * whole_sine,
        }
    }
}

impl Answers for Trigonometric {
    fn stationary(&self) -> Stationary {
        if self.delta.abs() > 0.0 { Stationary::NONE } else { Stationary::everywhere(self.duration) }
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        match quantity {
            Quantity::Velocity | Quantity::Jerk => alloc::vec![0.5 * self.duration],
            Quantity::Position | Quantity::Acceleration => Vec::new(),
        }
    }
}
