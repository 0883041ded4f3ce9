//! Lanes, which hold several states at once.

use super::Scalar;
use num_traits::{One, Zero};
use std::array::from_fn;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// `N` numbers of double precision, one for each of `N` states: one call of an operation gives the results of all of
/// them, each with the very bits that it has alone in `f64`.
///
/// There is no order: lanes may disagree. Two of them are equal where all lanes are.
///
/// # Examples
///
/// ```
/// use solaris_dynamics::{Scalar, scalar::Lanes};
///
/// let x = Lanes::new([0.5, 2.0]);
/// assert_eq!((x * x + Lanes::splat(1.0)).to_array(), [1.25, 5.0]);
/// assert_eq!(x.recip_above(Lanes::splat(1.0)).to_array(), [0.0, 0.5]);
/// ```
#[doc(alias = "simd")]
#[doc(alias = "vectorized")]
#[doc(alias = "batch")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes<const N: usize>([f64; N]);

impl<const N: usize> Lanes<N> {
    /// The numbers of all lanes.
    pub const fn new(lanes: [f64; N]) -> Self {
        Self(lanes)
    }

    /// `x` in every lane.
    pub const fn splat(x: f64) -> Self {
        Self([x; N])
    }

    /// The numbers of all lanes.
    pub const fn to_array(self) -> [f64; N] {
        self.0
    }

    /// The number of one lane.
    ///
    /// # Panics
    ///
    /// Where there is no such lane.
    pub const fn lane(self, lane: usize) -> f64 {
        self.0[lane]
    }

    /// Whether something holds in every lane. Without an early exit the loop runs in vector registers.
    #[inline]
    fn all(self, holds: impl Fn(f64) -> bool) -> bool {
        self.0.iter().fold(true, |all, &x| all & holds(x))
    }
}

impl<const N: usize> From<[f64; N]> for Lanes<N> {
    fn from(lanes: [f64; N]) -> Self {
        Self(lanes)
    }
}

impl<const N: usize> From<Lanes<N>> for [f64; N] {
    fn from(lanes: Lanes<N>) -> Self {
        lanes.0
    }
}

macro_rules! lane_wise {
    ($operation:ident, $method:ident) => {
        impl<const N: usize> $operation for Lanes<N> {
            type Output = Self;

            #[cfg_attr(debug_assertions, inline(never))]
            #[cfg_attr(not(debug_assertions), inline)]
            fn $method(self, other: Self) -> Self {
                Self(from_fn(|i| self.0[i].$method(other.0[i])))
            }
        }
    };
    ($operation:ident, $method:ident, $assignment:ident, $assign:ident) => {
        lane_wise!($operation, $method);

        impl<const N: usize> $assignment for Lanes<N> {
            #[inline]
            fn $assign(&mut self, other: Self) {
                *self = (*self).$method(other);
            }
        }
    };
}
lane_wise!(Add, add, AddAssign, add_assign);
lane_wise!(Sub, sub, SubAssign, sub_assign);
lane_wise!(Mul, mul, MulAssign, mul_assign);
lane_wise!(Div, div);

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn neg(self) -> Self {
        Self(self.0.map(Neg::neg))
    }
}

impl<const N: usize> Zero for Lanes<N> {
    #[inline]
    fn zero() -> Self {
        Self::splat(0.0)
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.all(|x| x.is_zero())
    }
}

impl<const N: usize> One for Lanes<N> {
    #[inline]
    fn one() -> Self {
        Self::splat(1.0)
    }
}

impl<const N: usize> Scalar for Lanes<N> {
    const EPSILON: f64 = f64::EPSILON;

    #[inline]
    fn from_f64(x: f64) -> Self {
        Self::splat(x)
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let mut pairs = [(0.0, 0.0); N];
        Scalar::sin_cos_all(&self.0, &mut pairs);
        (Self(pairs.map(|pair| pair.0)), Self(pairs.map(|pair| pair.1)))
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.all(f64::is_finite)
    }

    #[inline]
    fn greatest(self) -> f64 {
        self.to_array().iter().fold(f64::NEG_INFINITY, |greatest, lane| greatest.max(lane.greatest()))
    }

    fn all_within(self, lower: f64, upper: f64) -> bool {
        self.all(|x| x.all_within(lower, upper))
    }

    #[inline]
    fn recip_above(self, threshold: Self) -> Self {
        Self(from_fn(|i| self.0[i].recip_above(threshold.0[i])))
    }

    #[inline]
    fn recip_or_nan(self, threshold: Self) -> Self {
        Self(from_fn(|i| self.0[i].recip_or_nan(threshold.0[i])))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_lane_decides_for_itself() {
        let x = Lanes::new([2.0, 1.0, f64::NAN, -4.0]);
        assert_eq!(x.recip_above(Lanes::splat(1.0)), Lanes::new([0.5, 0.0, 0.0, 0.0]));
        let thresholds = Lanes::new([1.0, 0.5, 0.0, -8.0]);
        assert_eq!(x.recip_above(thresholds), Lanes::new([0.5, 1.0, 0.0, -0.25]));
    }

    #[test]
    fn one_lane_speaks_for_all() {
        assert!(Lanes::new([1.0, 2.0]).all_within(1.0, 2.0));
        assert!(!Lanes::new([1.0, 2.1]).all_within(1.0, 2.0));
        assert!(!Lanes::new([f64::NAN, 2.0]).all_within(1.0, 2.0));
        assert!(Lanes::new([1.0, 2.0]).is_finite() && !Lanes::new([1.0, f64::INFINITY]).is_finite());
        assert_eq!((Lanes::new([-3.0, -2.0]).greatest(), Lanes::new([5.0, 2.0]).greatest()), (-2.0, 5.0));
        assert!(Lanes::new([0.0, -0.0]).is_zero() && !Lanes::new([0.0, 1e-300]).is_zero());
    }

    #[test]
    fn sines_are_those_of_one_lane_alone() {
        for lanes in [[0.3, -2.0, 1e5, 7.0], [0.3, -2.0, 1e9, 7.0]] {
            let (sines, cosines) = Lanes::new(lanes).sin_cos();
            for (i, x) in lanes.into_iter().enumerate() {
                let (sine, cosine) = Scalar::sin_cos(x);
                assert_eq!(sines.lane(i).to_bits(), sine.to_bits(), "{x}");
                assert_eq!(cosines.lane(i).to_bits(), cosine.to_bits(), "{x}");
            }
        }
    }
}
