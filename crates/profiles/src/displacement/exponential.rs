//! The curve that is a power of a shifted time.

use super::power::{falling, scales};
use super::{Place, between, check_motion};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary, Turn};
use crate::curve::Curve;
use crate::error::{ProfileError, check_finite, check_overflow, check_range};
use crate::float::floor;
use crate::range::{Range, Ranges};
use crate::sample::Sample;
use alloc::vec::Vec;
use core::ops::Bound::{Excluded, Unbounded};

/// A motion from one position to another as a power of time that is shifted and turned round: the shape s leads from a slow start
/// (s < 0) over the straight line (s = 0) to a slow end (0 < s ≤ 1).
///
/// ```text
/// x = x₀ + D·(1 − yⁿ)/(1 − (1 − s)ⁿ)        u = t/T,  y = 1 − s·u,  D = x₁ − x₀
/// v = D/T·c·yⁿ⁻¹                            c = n·s/(1 − (1 − s)ⁿ)
/// a = −D/T²·c·(n − 1)·s·yⁿ⁻²
/// j = D/T³·c·(n − 1)·(n − 2)·s²·yⁿ⁻³
/// ```
///
/// For s ≤ 1 the exponent is any real number from 1 up. For s > 1 it is a whole number, and the motion stands still at
/// u = 1/s: there it turns round if n is even, and comes back or overshoots; the closer s is to 2, the farther. Where s = 1
/// and n < 3 is not whole, acceleration or jerk are infinite at the end.
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.3.2 and §A.1.2, "exponential without velocity constraints". The printed constant A is right
/// for odd n only (E5), and that the motion stands still inside for s > 1 is not said there (E22). For a small s the printed
/// formula loses all digits, and s = 0 does not exist.
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, displacement::Exponential};
///
/// // 1 − (1 − u)²: from 4 units/s to rest.
/// let curve = Exponential::new(0.5, 0.0, 1.0, 2.0, 1.0)?;
/// assert_eq!(curve.at(0.25).position, 0.75);
/// assert_eq!(curve.at(0.0).velocity, 4.0);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[doc(alias = "ease in out")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponential<F = f64> {
    duration: F,
    from: F,
    to: F,
    exponent: F,
    shape: F,
    delta: F,
    /// z = p·(1 − u) + q·u is y, divided by |1 − s| where that is greater than 1.
    z: (F, F),
    /// n where the way is a sum of n powers, else 0.
    terms: u32,
    /// What the way at the end is a fraction of.
    whole: F,
    /// Of the derivatives of zⁿ.
    factors: [F; 3],
}

impl<F: Elementary> Exponential<F> {
    /// Over `duration` > 0, between two positions, with `exponent` ≥ 1 and the `shape` s.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, an exponent below 1, for a shape above 1 an exponent that is not whole, or a shape
    /// of 2 with an even one (no such motion reaches its end); numbers that are not finite or lead to such.
    pub fn new(duration: F, from: F, to: F, exponent: F, shape: F) -> Result<Self, ProfileError> {
        check_motion(duration, from, to)?;
        check_range("exponent", exponent, Range::at_least(1.0))?;
        check_finite("shape", &[shape])?;
        check_shape(exponent.value(), shape.value())?;
        let one = F::from_f64(1.0);
        let (delta, rest) = (to - from, one - shape);
        let size = if rest.value().abs() > 1.0 { rest.abs() } else { one };
        let z = (one / size, rest / size);
        let terms = terms(exponent, shape);
        let mut curve =
            Self { duration, from, to, exponent, shape, delta, z, terms, whole: one, factors: [one; 3] };
        curve.whole = curve.part(one, F::from_f64(0.0));
        // The derivative of z by u is −s·p, and d(zⁿ) over `whole` must be 1 in all.
        let slope = shape * z.0;
        let share = if terms > 0 {
            one / curve.whole
        } else if is_straight(shape) {
            one / exponent + F::from_f64(0.5) * (exponent - one) / exponent * shape
        } else if shape.value() < 0.0 {
            -slope / curve.whole
        } else {
            slope / curve.whole
        };
        let [_, velocity, acceleration, jerk] = scales(delta, duration);
        curve.factors = [share * velocity, -share * slope * acceleration, share * slope * slope * jerk];
        let ends = [falling(z.0, exponent), falling(z.1, exponent)];
        check_overflow("distance", &[delta])?;
        for i in 0..3 {
            check_overflow("largest jerk", &[curve.factors[i]])?;
            // At the end, infinite derivatives are the curve's own where s = 1.
            check_overflow("largest jerk", &[curve.factors[i] * ends[0][i + 1]])?;
            if z.1.value().abs() > 0.0 {
                check_overflow("largest jerk", &[curve.factors[i] * ends[1][i + 1]])?;
            }
        }
        Ok(curve)
    }

    /// What the way at u is proportional to, without cancellation near the start.
    #[inline]
    fn part(&self, u: F, left: F) -> F {
        let (n, shape) = (self.exponent, self.shape);
        let one = F::from_f64(1.0);
        if self.terms > 0 {
            // (pⁿ − zⁿ)/(p − z) = Σ zᵏ·pⁿ⁻¹⁻ᵏ: positive terms, and no function is called.
            let (z, p) = (self.z(u, left), self.z.0);
            let (mut sum, mut power) = (one, one);
            for _ in 1..self.terms {
                power *= p;
                sum = sum * z + power;
            }
            u * sum
        } else if is_straight(shape) {
            // u + (n − 1)/2·s·u·(1 − u) + …
            u + F::from_f64(0.5) * (n - one) * shape * u * left
        } else if shape.value() < 0.0 {
            // (yⁿ − 1)/(1 − s)ⁿ, with y/(1 − s) = 1 + s·(1 − u)/(1 − s).
            let (grown, lacking) = ((-shape * u).ln_1p(), (shape * left / (one - shape)).ln_1p());
            -(n * lacking).exp() * (-n * grown).exp_m1()
        } else if shape.value() <= 1.0 {
            let gone = shape * u;
            if gone.value() <= 0.5 { -(n * (-gone).ln_1p()).exp_m1() } else { one - self.z(u, left).powf(n) }
        } else {
            let n = n.value() as u32;
            self.z.0.powi(n) - self.z(u, left).powi(n)
        }
    }

    /// z, without cancellation where s ≤ 1, also in its derivatives where s is small.
    #[inline]
    fn z(&self, u: F, left: F) -> F {
        if self.shape.value() <= 0.5 {
            self.z.0 * (F::from_f64(1.0) - self.shape * u)
        } else {
            self.z.0 * left + self.z.1 * u
        }
    }
}

impl<F: Elementary> Curve<F> for Exponential<F> {
    fn duration(&self) -> F {
        self.duration
    }

    #[inline]
    fn at(&self, t: F) -> Sample<F> {
        let (u, left) = Place::new(t, self.duration).elapsed_and_left();
        let f = falling(self.z(u, left), self.exponent);
        // No motion and a straight line have no derivatives, not even infinite ones.
        let part = |i: usize| {
            let factor = self.factors[i];
            if factor.value().abs() > 0.0 || f[i + 1].is_finite() { factor * f[i + 1] } else { factor }
        };
        Sample {
            position: between(self.from, self.to, self.delta, self.part(u, left) / self.whole),
            velocity: part(0),
            acceleration: part(1),
            jerk: part(2),
        }
    }
}

impl Answers for Exponential {
    fn stationary(&self) -> Stationary {
        if self.delta.abs() <= 0.0 {
            return Stationary::everywhere(self.duration);
        }
        if self.shape <= 1.0 || self.exponent < 2.0 {
            return Stationary::NONE;
        }
        let turn = if self.exponent % 2.0 > 0.5 { Turn::Touch } else { Turn::Reversal };
        Stationary::at([(self.duration / self.shape, turn)], self.duration)
    }

    fn critical(&self, _: Quantity) -> Vec<f64> {
        if self.shape > 1.0 { alloc::vec![self.duration / self.shape] } else { Vec::new() }
    }
}

/// The exponent where it is a small whole number that depends on nothing, and the root of the power is not inside.
fn terms<F: Elementary>(exponent: F, shape: F) -> u32 {
    const MOST: f64 = 16.0;
    let n = exponent.value();
    let is_whole = n <= MOST && exponent == F::from_f64(floor(n));
    if is_whole && shape.value() <= 1.0 { n as u32 } else { 0 }
}

/// Whether the curve is the straight line to the last digit: its own formula would underflow.
fn is_straight<F: Elementary>(shape: F) -> bool {
    shape.value().abs() < 1e-30
}

fn check_shape(exponent: f64, shape: f64) -> Result<(), ProfileError> {
    if shape <= 1.0 {
        return Ok(());
    }
    let infeasible = |why, feasible| ProfileError::Infeasible { what: "shape", value: shape, why, feasible };
    if (exponent - floor(exponent)).abs() > 0.0 || exponent > f64::from(u32::MAX) {
        let why = "with an exponent that is not whole, time must not pass the power's own zero";
        return Err(infeasible(why, Range::at_most(1.0).into()));
    }
    if exponent % 2.0 < 0.5 && (shape - 2.0).abs() <= 0.0 {
        let low = Range::new(Unbounded, Excluded(2.0));
        let high = Range::new(Excluded(2.0), Unbounded);
        let why = "with an even exponent the motion comes back to where it began";
        return Err(infeasible(why, Ranges::new([low, high])));
    }
    Ok(())
}
