//! The trait of numbers that have one value, with roots, powers and exponentials.

use crate::Scalar;

/// A scalar with one value to decide by, and with the elementary functions: what curves and laws of force ask beyond
/// [`Scalar`]. `f64` and `f32` are such, and [`Dual`](crate::Dual) with exact derivatives by time or by any parameter.
///
/// There is no order: what has to be decided is decided by [`value`](Self::value), so that a number with derivatives takes
/// the way of its value.
pub trait Elementary: Scalar {
    /// The number in double precision, without its derivatives.
    #[doc(alias = "to_f64")]
    fn value(self) -> f64;

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
                power *= square;
            }
            rest >>= 1;
            if rest > 0 {
                square *= square;
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
        assert!((Elementary::powi(1.5_f64, 7) - 17.085_937_5).abs() < 1e-14);
        assert!((Elementary::powi(0.0_f64, 0) - 1.0).abs() < 1e-300);
        assert!((Elementary::powi(-2.0_f32, 3) + 8.0).abs() < 1e-30);
    }
}
