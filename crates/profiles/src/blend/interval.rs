//! Intervals of numbers.

use super::jet::Ring;
use core::ops::{Add, Div, Mul, Sub};

/// All numbers from `low` to `high`; what an operation may give for any of its operands'.
///
/// Results are not rounded outward: who builds an interval from computed numbers widens it by their errors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Interval {
    pub(super) const ZERO: Self = Self { low: 0.0, high: 0.0 };
    const ALL: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// Between two numbers, in any order.
    pub(super) fn hull(x: f64, y: f64) -> Self {
        if x.is_nan() || y.is_nan() { Self::ALL } else { Self { low: x.min(y), high: x.max(y) } }
    }

    pub(super) fn contains_zero(self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }

    pub(super) fn is_zero(self) -> bool {
        self == Self::ZERO
    }

    pub(super) fn width(self) -> f64 {
        self.high - self.low
    }

    /// Wider by as much on both sides.
    pub(super) fn widened(self, by: f64) -> Self {
        if by.is_finite() { Self { low: self.low - by, high: self.high + by } } else { self }
    }

    /// What is in both of two intervals around the same numbers.
    pub(super) fn and(self, other: Self) -> Self {
        let both = Self { low: self.low.max(other.low), high: self.high.min(other.high) };
        if both.low <= both.high { both } else { self }
    }

    /// Of four products or quotients; where one is none, such as 0·∞, nothing is known.
    fn around(corners: [f64; 4]) -> Self {
        if corners.iter().any(|x| x.is_nan()) {
            return Self::ALL;
        }
        let low = corners.into_iter().fold(f64::INFINITY, f64::min);
        Self { low, high: corners.into_iter().fold(f64::NEG_INFINITY, f64::max) }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::hull(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::hull(self.low - other.high, self.high - other.low)
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        let product = |x: f64| [x * other.low, x * other.high];
        let ([a, b], [c, d]) = (product(self.low), product(self.high));
        Self::around([a, b, c, d])
    }
}

impl Div for Interval {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if other.contains_zero() {
            return Self::ALL;
        }
        let quotient = |x: f64| [x / other.low, x / other.high];
        let ([a, b], [c, d]) = (quotient(self.low), quotient(self.high));
        Self::around([a, b, c, d])
    }
}

impl Ring for Interval {
    fn real(x: f64) -> Self {
        Self { low: x, high: x }
    }

    fn of(self, other: Self) -> Self {
        self * other
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_operation_gives_all_that_its_operands_may() {
        let (x, y) = (Interval::hull(-1.0, 2.0), Interval::hull(4.0, 3.0));
        assert_eq!(x + y, Interval::hull(2.0, 6.0));
        assert_eq!(x - y, Interval::hull(-5.0, -1.0));
        assert_eq!(x * y, Interval::hull(-4.0, 8.0));
        assert_eq!(x / Interval::hull(2.0, 4.0), Interval::hull(-0.5, 1.0));
        assert_eq!(y / x, Interval::ALL);
        assert_eq!(x * Interval::hull(0.0, f64::INFINITY), Interval::ALL);
        assert_eq!(Interval::ALL * Interval::ZERO, Interval::ZERO);
    }

    #[test]
    fn intervals_around_the_same_number_are_cut() {
        assert_eq!(Interval::hull(0.0, 2.0).and(Interval::hull(1.0, 3.0)), Interval::hull(1.0, 2.0));
        assert_eq!(Interval::hull(0.0, 2.0).and(Interval::ALL), Interval::hull(0.0, 2.0));
    }
}
