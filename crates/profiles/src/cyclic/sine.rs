//! A sine.

use super::{check_times, laps};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary, Turn};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_finite, check_overflow, check_range};
use crate::float::floor;
use crate::range::Range;
use crate::sample::Sample;
use alloc::vec::Vec;
use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// The largest phase (rad), of either sign: of one far beyond, a whole turn is less than its last digit.
const LARGEST_PHASE: f64 = 1e6;

/// A sine about an offset.
///
/// ```text
/// x = x₀ + A·sin(ω·t + φ)        ω = 2π/T
/// v =  ω·A·cos(ω·t + φ)
/// a = −ω²·A·sin(ω·t + φ)
/// j = −ω³·A·cos(ω·t + φ)
/// ```
///
/// It begins at `x₀ + A·sin φ` with the velocity `ω·A·cos φ`: with a phase of ±π/2 at rest.
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, cyclic::Sine};
///
/// // 0.2 rad to either side of 0.5 rad, twice in 1.5 s.
/// let sine = Sine::new(0.2, 0.75, 2.0, 0.0, 0.5)?;
/// assert!((sine.duration() - 1.5_f64).abs() < 1e-15);
/// assert!((sine.at(0.1875).position - 0.7).abs() < 1e-15);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[doc(alias = "oscillation")]
#[doc(alias = "sinusoid")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sine<F = f64> {
    duration: F,
    period: f64,
    phase: F,
    offset: F,
    amplitude: F,
    omega: F,
}

impl<F: Elementary> Sine<F> {
    /// To `amplitude` on either side of `offset`, in a `period` > 0 (s), for some cycles, which need not be whole; `phase` (rad) is
    /// where in its cycle it begins.
    ///
    /// # Errors
    ///
    /// A period that is not positive, cycles that are not more than 0 and at most 1e6, a phase beyond ±1e6 rad, numbers that are not finite or lead to such.
    pub fn new(amplitude: F, period: F, cycles: f64, phase: F, offset: F) -> Result<Self, ProfileError> {
        check_finite("amplitude", &[amplitude])?;
        check_range("period", period, Range::POSITIVE)?;
        check_times("cycles", cycles, f64::MIN_POSITIVE)?;
        check_range("phase", phase, Range::closed(-LARGEST_PHASE, LARGEST_PHASE))?;
        check_finite("offset", &[offset])?;
        let omega = F::from_f64(TAU) / period;
        check_overflow("largest jerk", &[omega * omega * omega * amplitude])?;
        let duration = F::from_f64(cycles) * period;
        check_overflow("duration", &[duration])?;
        Ok(Self { duration, period: period.value(), phase, offset, amplitude, omega })
    }
}

impl<F: Elementary> Curve<F> for Sine<F> {
    fn duration(&self) -> F {
        self.duration
    }

    #[inline]
    fn at(&self, t: F) -> Sample<F> {
        let t = within(t, self.duration);
        // Whole cycles are taken off the time before it becomes an angle, whose digits they would cost.
        let (whole, _, _) = laps(t.value(), self.period);
        let (sine, cosine) = (self.omega * (t - F::from_f64(whole * self.period)) + self.phase).sin_cos();
        let (velocity, acceleration) =
            (self.omega * self.amplitude, self.omega * self.omega * self.amplitude);
        Sample {
            position: self.offset + self.amplitude * sine,
            velocity: velocity * cosine,
            acceleration: -acceleration * sine,
            jerk: -acceleration * self.omega * cosine,
        }
    }
}

impl Sine {
    /// The times inside of the span at which the angle is `first`, or that and a whole number of half turns.
    fn half_turns(&self, first: f64) -> Vec<f64> {
        let start = floor((self.phase - first) / PI);
        let time = |k: usize| (first + (start + k as f64) * PI - self.phase) / self.omega;
        (0..).map(time).skip_while(|t| *t <= 0.0).take_while(|t| *t < self.duration).collect()
    }
}

impl Answers for Sine {
    fn stationary(&self) -> Stationary {
        if self.amplitude.abs() > 0.0 {
            let turns = self.half_turns(FRAC_PI_2).into_iter().map(|t| (t, Turn::Reversal));
            Stationary::at(turns, self.duration)
        } else {
            Stationary::everywhere(self.duration)
        }
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        match quantity {
            Quantity::Position | Quantity::Acceleration => self.half_turns(FRAC_PI_2),
            Quantity::Velocity | Quantity::Jerk => self.half_turns(0.0),
        }
    }
}
