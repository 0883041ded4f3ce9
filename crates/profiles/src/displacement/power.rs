//! The curve that is a power of time.

use super::{between, check_motion};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_overflow, check_range};
use crate::range::Range;
use crate::sample::Sample;
use alloc::vec::Vec;

/// A motion from one position to another as a power of time: flat at first, then ever steeper.
///
/// ```text
/// x = x₀ + D·uⁿ                             u = t/T,  D = x₁ − x₀
/// v = n·D/T·uⁿ⁻¹
/// a = n·(n − 1)·D/T²·uⁿ⁻²
/// j = n·(n − 1)·(n − 2)·D/T³·uⁿ⁻³
/// ```
///
/// The exponent is any real number from 1 up. At the start the acceleration is infinite for 1 < n < 2, the jerk for
/// 1 < n < 2 and 2 < n < 3.
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.3.2 and §A.1.2, "simple exponential". As printed, velocity and acceleration there lack 1/T
/// and 1/T² (E3, E4).
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, displacement::Power};
///
/// let middle = Power::new(2.0, 0.0, 8.0, 3.0)?.at(1.0);
/// assert_eq!(middle.to_array(), [1.0, 3.0, 6.0, 6.0]);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[doc(alias = "ease in")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power<F = f64> {
    duration: F,
    from: F,
    to: F,
    exponent: F,
    /// D, D/T, D/T², D/T³.
    scales: [F; 4],
}

impl<F: Elementary> Power<F> {
    /// Over `duration` > 0, between two positions, with `exponent` ≥ 1.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, an exponent below 1, numbers that are not finite or lead to such.
    pub fn new(duration: F, from: F, to: F, exponent: F) -> Result<Self, ProfileError> {
        check_motion(duration, from, to)?;
        check_range("exponent", exponent, Range::at_least(1.0))?;
        let delta = to - from;
        let scales = scales(delta, duration);
        let [_, first, second, third] = falling(F::from_f64(1.0), exponent);
        check_overflow("distance", &[delta])?;
        check_overflow(
            "largest jerk",
            &[scales[3], scales[1] * first, scales[2] * second, scales[3] * third],
        )?;
        Ok(Self { duration, from, to, exponent, scales })
    }
}

impl<F: Elementary> Curve<F> for Power<F> {
    fn duration(&self) -> F {
        self.duration
    }

    #[inline]
    fn at(&self, t: F) -> Sample<F> {
        let u = within(t, self.duration) / self.duration;
        let f = falling(u, self.exponent);
        // No motion has no derivatives, not even infinite ones.
        let part = |i: usize| {
            let scale = self.scales[i];
            if scale.value().abs() > 0.0 || f[i].is_finite() { scale * f[i] } else { scale }
        };
        Sample {
            position: between(self.from, self.to, self.scales[0], f[0]),
            velocity: part(1),
            acceleration: part(2),
            jerk: part(3),
        }
    }
}

impl Answers for Power {
    fn stationary(&self) -> Stationary {
        if self.scales[0].abs() > 0.0 { Stationary::NONE } else { Stationary::everywhere(self.duration) }
    }

    fn critical(&self, _: Quantity) -> Vec<f64> {
        Vec::new()
    }
}

/// D, D/T, D/T², D/T³.
pub(super) fn scales<F: Elementary>(delta: F, duration: F) -> [F; 4] {
    let velocity = delta / duration;
    let acceleration = velocity / duration;
    [delta, velocity, acceleration, acceleration / duration]
}

/// zⁿ and its first three derivatives by z, for any n ≥ 1 where z ≥ 0, and for whole n where z < 0.
#[inline]
pub(super) fn falling<F: Elementary>(z: F, n: F) -> [F; 4] {
    let [one, two] = [1.0, 2.0].map(F::from_f64);
    let factors = [n, n * (n - one), n * (n - one) * (n - two)];
    // A whole number that does not depend on anything; a dual number with derivatives is not equal to its value alone.
    let whole = n.value() as u32;
    let is_whole = whole <= 1024 && n == F::from_f64(f64::from(whole));
    if n.value() >= 3.0 {
        let third =
            if is_whole || z.value() < 0.0 { z.powi(whole - 3) } else { z.powf(n - F::from_f64(3.0)) };
        let second = third * z;
        let first = second * z;
        return [first * z, factors[0] * first, factors[1] * second, factors[2] * third];
    }
    let power = |k: u32, factor: F| {
        if is_whole || z.value() < 0.0 {
            // The derivatives that are left over are zero.
            if whole >= k { factor * z.powi(whole - k) } else { F::from_f64(0.0) }
        } else {
            factor * z.powf(n - F::from_f64(f64::from(k)))
        }
    };
    [power(0, one), power(1, factors[0]), power(2, factors[1]), power(3, factors[2])]
}
