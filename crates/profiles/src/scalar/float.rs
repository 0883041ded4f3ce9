//! The floating-point numbers of the machine. Functions are the standard library's where there is one and those of `libm`
//! elsewhere.

use super::Scalar;

/// Calls `$std` of the standard library, or `libm`'s function.
macro_rules! call {
    ($x:expr, $method:ident, $libm:ident $(, $n:expr)?) => {{
        #[cfg(feature = "std")]
        let y = $x.$method($($n)?);
        #[cfg(not(feature = "std"))]
        let y = libm::$libm($x $(, $n)?);
        y
    }};
}

macro_rules! float {
    ($float:ident, $sqrt:ident, $exp:ident, $exp_m1:ident, $ln:ident, $ln_1p:ident, $sin_cos:ident, $sinh:ident, $cosh:ident,
     $tanh:ident, $asin:ident, $atan:ident, $pow:ident) => {
        #[allow(clippy::cast_lossless, reason = "one text for both widths")]
        impl Scalar for $float {
            const EPSILON: f64 = Self::EPSILON as f64;

            #[inline]
            fn from_f64(x: f64) -> Self {
                x as Self
            }

            #[inline]
            fn value(self) -> f64 {
                self as f64
            }

            #[inline]
            fn is_finite(self) -> bool {
                self.is_finite()
            }

            #[inline]
            fn sqrt(self) -> Self {
                call!(self, sqrt, $sqrt)
            }

            #[inline]
            fn exp(self) -> Self {
                call!(self, exp, $exp)
            }

            #[inline]
            fn exp_m1(self) -> Self {
                call!(self, exp_m1, $exp_m1)
            }

            #[inline]
            fn ln(self) -> Self {
                call!(self, ln, $ln)
            }

            #[inline]
            fn ln_1p(self) -> Self {
                call!(self, ln_1p, $ln_1p)
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                call!(self, sin_cos, $sin_cos)
            }

            #[inline]
            fn sinh(self) -> Self {
                call!(self, sinh, $sinh)
            }

            #[inline]
            fn cosh(self) -> Self {
                call!(self, cosh, $cosh)
            }

            #[inline]
            fn tanh(self) -> Self {
                call!(self, tanh, $tanh)
            }

            #[inline]
            fn asin(self) -> Self {
                call!(self, asin, $asin)
            }

            #[inline]
            fn atan(self) -> Self {
                call!(self, atan, $atan)
            }

            #[inline]
            fn powf(self, n: Self) -> Self {
                call!(self, powf, $pow, n)
            }
        }
    };
}

float!(f64, sqrt, exp, expm1, log, log1p, sincos, sinh, cosh, tanh, asin, atan, pow);
float!(f32, sqrtf, expf, expm1f, logf, log1pf, sincosf, sinhf, coshf, tanhf, asinf, atanf, powf);

/// The greatest whole number that is not above `x`.
#[inline]
pub(crate) fn floor(x: f64) -> f64 {
    call!(x, floor, floor)
}

/// `x` less the whole multiple of `period` that leaves it in [0, period], the period itself only where
/// what is below zero is less than can be told from it: exact but for the last rounding.
pub(crate) fn rem_euclid(x: f64, period: f64) -> f64 {
    let rest = x % period;
    if rest < 0.0 { rest + period } else { rest }
}
