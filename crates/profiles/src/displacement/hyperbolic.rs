//! The curve that is a hyperbolic sine.

use super::{Place, between, check_motion};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary};
use crate::curve::Curve;
use crate::error::{ProfileError, check_overflow, check_range};
use crate::range::Range;
use crate::sample::Sample;
use alloc::vec::Vec;

/// Up to this stiffness the curve is the straight line to the last digit, and its own formula would underflow.
const STRAIGHT: f64 = 1e-30;

/// A motion from one position to another along a hyperbolic sine: slow at first, the more so the greater its stiffness.
///
/// ```text
/// x = x₀ + D·sinh(k·u)/sinh k        u = t/T,  D = x₁ − x₀
/// v = k·D/T·cosh(k·u)/sinh k
/// a = (k/T)²·(x − x₀)
/// j = (k/T)²·v
/// ```
///
/// The stiffness k is any number from 0 up; with k = 0 the curve is the straight line.
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.3.3 and §A.1.3, "without velocity constraints", where k = 1 always. Nothing overflows here
/// however great k is: e⁻ᵏ is taken out of all terms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hyperbolic<F = f64> {
    duration: F,
    from: F,
    to: F,
    stiffness: F,
    delta: F,
    /// sinh k, or 1 − e⁻²ᵏ where k > 1.
    whole: F,
    /// k/sinh k·D/T, or half the coefficient of its exponentials.
    velocity: F,
    /// (k/T)²·D.
    acceleration: F,
    /// k/T.
    rate: F,
}

impl<F: Elementary> Hyperbolic<F> {
    /// Over `duration` > 0, between two positions, with `stiffness` ≥ 0.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, a stiffness below zero, numbers that are not finite or lead to such.
    pub fn new(duration: F, from: F, to: F, stiffness: F) -> Result<Self, ProfileError> {
        check_motion(duration, from, to)?;
        check_range("stiffness", stiffness, Range::NOT_NEGATIVE)?;
        let delta = to - from;
        let gentle = stiffness.value() <= 1.0;
        let whole = if gentle { stiffness.sinh() } else { -(F::from_f64(-2.0) * stiffness).exp_m1() };
        // k/sinh k = 1 − k²/6 + …
        let share = if stiffness.value() > STRAIGHT { stiffness / whole } else { F::from_f64(1.0) };
        let velocity = share * (delta / duration);
        let rate = stiffness / duration;
        let acceleration = delta * rate * rate;
        check_overflow("distance", &[delta])?;
        check_overflow("largest jerk", &[velocity, acceleration, (velocity + velocity) * rate * rate])?;
        Ok(Self { duration, from, to, stiffness, delta, whole, velocity, acceleration, rate })
    }
}

impl<F: Elementary> Curve<F> for Hyperbolic<F> {
    fn duration(&self) -> F {
        self.duration
    }

    #[inline]
    fn at(&self, t: F) -> Sample<F> {
        let (u, left) = Place::new(t, self.duration).elapsed_and_left();
        // The ways of sinh(k·u)/sinh k and cosh(k·u)/sinh k that are exact, also in their derivatives, for each k.
        let (f, velocity) = if self.stiffness.value() <= STRAIGHT {
            (u, self.velocity)
        } else if self.stiffness.value() <= 1.0 {
            let angle = self.stiffness * u;
            (angle.sinh() / self.whole, self.velocity * angle.cosh())
        } else {
            let decay = (-self.stiffness * left).exp();
            let part = -(F::from_f64(-2.0) * self.stiffness * u).exp_m1();
            (decay * (part / self.whole), self.velocity * decay * (F::from_f64(2.0) - part))
        };
        Sample {
            position: between(self.from, self.to, self.delta, f),
            velocity,
            acceleration: self.acceleration * f,
            jerk: self.rate * self.rate * velocity,
        }
    }
}

impl Answers for Hyperbolic {
    fn stationary(&self) -> Stationary {
        if self.delta.abs() > 0.0 { Stationary::NONE } else { Stationary::everywhere(self.duration) }
    }

    fn critical(&self, _: Quantity) -> Vec<f64> {
        Vec::new()
    }
}
