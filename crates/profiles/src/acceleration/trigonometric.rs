//! The curve whose acceleration is half a period of a sine.

use super::{check, constant_to, feasible};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary, Turn};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_overflow};
use crate::range::Ranges;
use crate::sample::Sample;
use crate::segment::segment;
use alloc::vec::Vec;
use core::f64::consts::{FRAC_PI_2, PI};

/// A motion whose acceleration rises from zero to its peak in the middle and falls back to zero, as half a sine does.
///
/// ```text
/// x = x₀ + v₀·t + (aₘT²/π²)·(πu − sin πu)        a = aₘ·sin πu
/// v = v₀ + (2aₘT/π)·sin²(πu/2)                   j = (πaₘ/T)·cos πu        u = t/T
/// ```
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.4.2 and A.2.2, whose θ̈₁ is the peak at T/2, not the final acceleration, which is 0
/// (E33); the displacement may turn round (E21). Here z − sin z is a series where angle and sine cancel.
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, acceleration::Trigonometric};
///
/// let start = Trigonometric::new(1.0, (0.0, 0.0), 2.0)?;
/// assert_eq!(start.at(0.5).acceleration, 2.0);
/// assert!((start.at(1.0).velocity - 4.0 / std::f64::consts::PI).abs() < 1e-15);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trigonometric<F = f64> {
    duration: F,
    from: F,
    start_velocity: F,
    peak: F,
    /// aₘT²/π²
    reach: F,
    /// 2aₘT/π
    gain: F,
    /// πaₘ/T
    jerk: F,
}

impl<F: Elementary> Trigonometric<F> {
    /// Over `duration`, from position `from` with velocity `v0`; `peak` is the acceleration at half time, of either
    /// sign.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, numbers that are not finite or lead to such.
    pub fn new(duration: F, (from, v0): (F, F), peak: F) -> Result<Self, ProfileError> {
        check(duration, (from, v0), "peak acceleration", peak)?;
        let rate = peak * duration;
        let reach = rate * duration * F::from_f64(1.0 / (PI * PI));
        let jerk = F::from_f64(PI) * peak / duration;
        check_overflow("jerk", &[jerk])?;
        Ok(Self { duration, from, start_velocity: v0, peak, reach, gain: rate * F::from_f64(2.0 / PI), jerk })
    }

    /// With the peak acceleration that leads to `to`: aₘ = π·(D − v₀·T)/T².
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn reaching(duration: F, (from, v0): (F, F), to: F) -> Result<Self, ProfileError> {
        let peak = constant_to(duration, (from, v0), to)? * F::from_f64(FRAC_PI_2);
        Self::new(duration, (from, v0), peak)
    }

    /// The acceleration at half time.
    pub fn peak_acceleration(&self) -> F {
        self.peak
    }
}

impl Trigonometric {
    /// The start velocities with which the motion never turns round: all but those strictly between −2aₘT/π and 0.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn feasible_start_velocity(duration: f64, peak: f64) -> Result<Ranges, ProfileError> {
        feasible(duration, "peak acceleration", peak, 2.0 / PI * peak * duration)
    }
}

impl<F: Elementary> Curve<F> for Trigonometric<F> {
    fn duration(&self) -> F {
        self.duration
    }

    fn at(&self, t: F) -> Sample<F> {
        let t = within(t, self.duration);
        // Sine and cosine of πu/2, from the nearer end.
        let quarter = F::from_f64(FRAC_PI_2);
        let (s, c) = if t.value() + t.value() <= self.duration.value() {
            (quarter * (t / self.duration)).sin_cos()
        } else {
            let (c, s) = (quarter * ((self.duration - t) / self.duration)).sin_cos();
            (s, c)
        };
        let sine = F::from_f64(2.0) * s * c;
        let z = F::from_f64(PI) * (t / self.duration);
        Sample {
            position: self.from + t * self.start_velocity + self.reach * segment(z, sine),
            velocity: self.start_velocity + self.gain * s * s,
            acceleration: self.peak * sine,
            jerk: self.jerk * (c - s) * (c + s),
        }
    }
}

impl Answers for Trigonometric {
    /// (2T/π)·asin √q with q = −v₀/(2aₘT/π), through the tangent √(q/(1 − q)).
    fn stationary(&self) -> Stationary {
        let (v0, gain) = (self.start_velocity, self.gain);
        if v0.abs().max(gain.abs()) <= 0.0 {
            return Stationary::everywhere(self.duration);
        }
        let tangent = -v0 / (v0 + gain);
        if tangent > 0.0 && tangent.is_finite() {
            // Above 45° by the rest to 90°.
            let share = if tangent <= 1.0 {
                Elementary::atan(Elementary::sqrt(tangent)) / FRAC_PI_2
            } else {
                1.0 - Elementary::atan(Elementary::sqrt(1.0 / tangent)) / FRAC_PI_2
            };
            Stationary::at([(share * self.duration, Turn::Reversal)], self.duration)
        } else {
            Stationary::NONE
        }
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        match quantity {
            Quantity::Position => self.stationary().points.iter().map(|point| point.time).collect(),
            Quantity::Acceleration => alloc::vec![0.5 * self.duration],
            Quantity::Velocity | Quantity::Jerk => Vec::new(),
        }
    }
}
