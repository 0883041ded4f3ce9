//! The numbers that curves are written over.

mod dual;
mod float;

pub use dual::Dual;
pub(crate) use float::{floor, rem_euclid};

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// What a curve asks of a number: `f64` and `f32` are such, and [`Dual`] with exact derivatives by time or by any
/// parameter.
///
/// There is no order: what has to be decided is decided by [`value`](Self::value), so that a number with derivatives takes
/// the way of its value.
pub trait Scalar:
    Copy
    + Debug
    + PartialEq
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// The distance from 1 to the next number.
    const EPSILON: f64;

    /// The nearest number to `x`, without derivatives.
    fn from_f64(x: f64) -> Self;

    /// The number in double precision, without its derivatives.
    fn value(self) -> f64;

    /// Whether the number, with all its parts, is neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// √x.
    fn sqrt(self) -> Self;

    /// eˣ.
    fn exp(self) -> Self;

    /// eˣ − 1, right to the last digits near zero.
    fn exp_m1(self) -> Self;

    /// ln x.
    fn ln(self) -> Self;

    /// ln(1 + x), right to the last digits near zero.
    fn ln_1p(self) -> Self;

    /// Sine and cosine of an angle (rad).
    fn sin_cos(self) -> (Self, Self);

    /// Hyperbolic sine.
    fn sinh(self) -> Self;

    /// Hyperbolic cosine.
    fn cosh(self) -> Self;

    /// Hyperbolic tangent.
    fn tanh(self) -> Self;

    /// Arc sine (rad).
    fn asin(self) -> Self;

    /// Arc tangent (rad).
    fn atan(self) -> Self;

    /// xⁿ for a real n; x is not negative.
    fn powf(self, n: Self) -> Self;

    /// xⁿ by repeated squaring; `x⁰ = 1`.
    #[inline]
    fn powi(self, n: u32) -> Self {
        let (mut square, mut rest, mut power) = (self, n, Self::from_f64(1.0));
        while rest > 0 {
            if rest & 1 == 1 {
                power = power * square;
            }
            rest >>= 1;
            if rest > 0 {
                square = square * square;
            }
        }
        power
    }

    /// Sine of an angle (rad).
    #[inline]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// Cosine of an angle (rad).
    #[inline]
    fn cos(self) -> Self {
        self.sin_cos().1
    }

    /// |x|.
    #[inline]
    fn abs(self) -> Self {
        if self.value() < 0.0 { -self } else { self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_powers_are_products() {
        assert!((Scalar::powi(1.5_f64, 7) - 17.085_937_5).abs() < 1e-14);
        assert!((Scalar::powi(0.0_f64, 0) - 1.0).abs() < 1e-300);
        assert!((Scalar::powi(-2.0_f32, 3) + 8.0).abs() < 1e-30);
    }
}
