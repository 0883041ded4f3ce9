//! Twice the digits of double precision.

mod decimal;
mod trigonometry;

use crate::Scalar;
use crate::scalar::assignments;
use num_traits::{One, Zero};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The unevaluated sum of two numbers of double precision, the second at most half a unit in the last place of the
/// first: about 32 digits, in the range of `f64`. The reference that the other scalars' accuracy is measured against.
///
/// Sums and products are right to 5·2⁻¹⁰⁶ of themselves, quotients to 10·2⁻¹⁰⁶, sines and cosines to 1e-31 for angles to
/// 1e15 rad. Products below 1e-290 lose digits as they come nearer to the smallest numbers of `f64`. What is beyond the
/// largest comes out as infinity or NaN, and [`Scalar::is_finite`] tells.
///
/// `from_f64` is exact: a constant that was rounded to double precision stays so.
///
/// # Examples
///
/// ```
/// use solaris_scalar::DoubleDouble;
///
/// let third = DoubleDouble::from(1.0) / DoubleDouble::from(3.0);
/// assert!(third.to_string().starts_with("3.33333333333333333333333333333"));
/// // What 1/3 lacks in double precision.
/// assert_eq!((third - DoubleDouble::from(1.0 / 3.0)).to_f64(), 1.0 / 3.0 / 2.0_f64.powi(54));
/// ```
///
/// # Source
///
/// T. J. Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18 (1971) 224–242; the
/// operations and their bounds are those of M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds for
/// basic building blocks of double-word arithmetic", ACM Trans. Math. Softw. 44 (2017) 15: their algorithms 6, 12 and 17.
#[derive(Clone, Copy, Default, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    /// The sum, rounded to double precision.
    high: f64,
    /// What the rounding took away.
    low: f64,
}

impl DoubleDouble {
    /// The number `x`, exactly.
    pub const fn from_f64(x: f64) -> Self {
        Self { high: x, low: 0.0 }
    }

    /// The sum of two numbers, exactly, as far as 32 digits reach: a long constant is given as its nearest `f64` and what
    /// is left of it.
    pub const fn from_parts(a: f64, b: f64) -> Self {
        let (high, low) = two_sum(a, b);
        Self { high, low }
    }

    /// The nearest number of double precision.
    pub const fn to_f64(self) -> f64 {
        self.high
    }

    /// The nearest number of double precision, and what is left.
    pub const fn to_parts(self) -> (f64, f64) {
        (self.high, self.low)
    }

    /// Without its sign.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    /// `a + b` where `a` is the greater by magnitude or their bits do not overlap.
    #[inline]
    const fn from_ordered(a: f64, b: f64) -> Self {
        let high = a + b;
        Self { high, low: b - (high - a) }
    }
}

/// `(s, e)`: `a + b` rounded, and what the rounding took away: `s + e = a + b` exactly (Møller, Knuth).
#[inline]
const fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    let of_a = sum - of_b;
    (sum, (a - of_a) + (b - of_b))
}

/// `(p, e)`: `a·b` rounded, and what the rounding took away: `p + e = a·b` exactly.
#[inline]
fn two_prod(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    (product, a.mul_add(b, -product))
}

impl From<f64> for DoubleDouble {
    fn from(x: f64) -> Self {
        Self::from_f64(x)
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    /// Right to 3·2⁻¹⁰⁶ of the sum, even where the terms cancel.
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn add(self, other: Self) -> Self {
        let (high, rest) = two_sum(self.high, other.high);
        let (low, least) = two_sum(self.low, other.low);
        let Self { high, low } = Self::from_ordered(high, rest + low);
        Self::from_ordered(high, least + low)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn mul(self, other: Self) -> Self {
        let (high, rest) = two_prod(self.high, other.high);
        let across = self.low.mul_add(other.high, self.high.mul_add(other.low, self.low * other.low));
        Self::from_ordered(high, rest + across)
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    /// One step of long division: the quotient of the high parts, then that of what it leaves.
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn div(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        let taken = other * Self::from_f64(quotient);
        let left = (self.high - taken.high) + (self.low - taken.low);
        Self::from_ordered(quotient, left / other.high)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

assignments!(DoubleDouble);

impl Zero for DoubleDouble {
    fn zero() -> Self {
        Self::from_f64(0.0)
    }

    fn is_zero(&self) -> bool {
        self.high.is_zero()
    }
}

impl One for DoubleDouble {
    fn one() -> Self {
        Self::from_f64(1.0)
    }
}

impl Scalar for DoubleDouble {
    const EPSILON: f64 = f64::EPSILON * f64::EPSILON;

    fn from_f64(x: f64) -> Self {
        Self::from_f64(x)
    }

    fn sin_cos(self) -> (Self, Self) {
        trigonometry::sin_cos(self)
    }

    fn is_finite(self) -> bool {
        self.high.is_finite() & self.low.is_finite()
    }

    fn greatest(self) -> f64 {
        self.to_f64().greatest()
    }

    fn all_within(self, lower: f64, upper: f64) -> bool {
        (Self::from_f64(lower)..=Self::from_f64(upper)).contains(&self)
    }

    fn recip_above(self, threshold: Self) -> Self {
        if self > threshold { Self::one() / self } else { Self::zero() }
    }

    fn recip_or_nan(self, threshold: Self) -> Self {
        let above = self > threshold && self > Self::zero();
        if above { Self::one() / self } else { Self::from_f64(f64::NAN) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 2⁻⁶⁰: far below the last digit of 1 in double precision.
    const TINY: f64 = 1.0 / (1_u64 << 60) as f64;

    #[test]
    fn digits_beyond_double_precision_are_kept() {
        let x = DoubleDouble::from_parts(TINY, 1.0);
        assert_eq!(x.to_parts(), (1.0, TINY));
        assert_eq!((x - DoubleDouble::one()).to_parts(), (TINY, 0.0));
        // (1 + t)·(1 − t) = 1 − t²
        let product = x * DoubleDouble::from_parts(1.0, -TINY);
        assert!((product - DoubleDouble::one()).abs().to_f64() < 5.0 * 2.0_f64.powi(-106));
        // (1 + t)² = 1 + 2·t + t²
        assert_eq!(x * x - x - x + DoubleDouble::one(), DoubleDouble::zero());
        // 1/(1 + t) = 1 − t + t²
        let reciprocal = DoubleDouble::one() / x;
        assert_eq!(reciprocal, DoubleDouble::from_parts(1.0, -TINY));
    }

    #[test]
    fn sums_that_cancel_keep_what_is_left() {
        let (a, b) = (DoubleDouble::from_parts(1e16, 0.3), DoubleDouble::from_parts(1e16, 0.1));
        assert_eq!(a - b, DoubleDouble::from_f64(0.3) - DoubleDouble::from_f64(0.1));
        let (c, d) = (DoubleDouble::from_parts(1.0, TINY), DoubleDouble::from_parts(-1.0, TINY * TINY));
        assert_eq!((c + d).to_parts(), (TINY, TINY * TINY));
    }

    #[test]
    fn the_low_part_decides_where_the_high_parts_are_equal() {
        let (x, y) = (DoubleDouble::from_parts(1.0, TINY), DoubleDouble::one());
        assert!(x > y && -x < -y && x != y);
        assert!(x.all_within(1.0, 2.0) && !x.all_within(0.0, 1.0));
        assert!(!DoubleDouble::from_f64(f64::NAN).all_within(-1.0, 1.0));
        assert_eq!((x.recip_above(y).to_f64(), y.recip_above(x).to_f64()), (1.0, 0.0));
        assert!((x.recip_or_nan(y).to_f64() - 1.0).abs() <= 0.0 && y.recip_or_nan(x).to_f64().is_nan());
    }

    #[test]
    fn what_overflows_is_not_finite() {
        let huge = DoubleDouble::from_f64(1e300);
        assert!(huge.is_finite());
        assert!(!(huge * huge).is_finite() && !(huge / DoubleDouble::zero()).is_finite());
    }
}
