//! The floating-point numbers of the machine as scalars. Functions are the standard library's where there is one and those
//! of `libm` elsewhere; sines and cosines of moderate angles are those of [`sine`] in either case.

use crate::{Elementary, Scalar, sine};

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

#[inline(always)]
fn sin_cos_single(angle: f32) -> (f32, f32) {
    let (sine, cosine) = sine::sin_cos_single(f64::from(angle));
    (sine as f32, cosine as f32)
}

/// One width: its functions in `libm`, and its sine and cosine of a moderate angle.
macro_rules! float {
    ($float:ident, $sin_cos_moderate:path,
     $sqrt:ident, $exp:ident, $exp_m1:ident, $ln:ident, $ln_1p:ident, $sin_cos:ident, $sinh:ident, $cosh:ident,
     $tanh:ident, $asin:ident, $atan:ident, $pow:ident) => {
        #[allow(clippy::cast_lossless, reason = "one text for both widths")]
        impl Scalar for $float {
            const EPSILON: f64 = Self::EPSILON as f64;
            const IS_FLOAT: bool = true;

            #[inline]
            fn from_f64(x: f64) -> Self {
                x as Self
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                if sine::is_moderate(self as f64) {
                    $sin_cos_moderate(self)
                } else {
                    call!(self, sin_cos, $sin_cos)
                }
            }

            // So that it is written in the instructions of whoever asks.
            #[inline(always)]
            fn sin_cos_all(angles: &[Self], pairs: &mut [(Self, Self)]) {
                let mut are_moderate = true;
                for angle in angles {
                    are_moderate &= sine::is_moderate(*angle as f64);
                }
                if are_moderate {
                    for (angle, pair) in angles.iter().zip(pairs) {
                        *pair = $sin_cos_moderate(*angle);
                    }
                } else {
                    for (angle, pair) in angles.iter().zip(pairs) {
                        *pair = Scalar::sin_cos(*angle);
                    }
                }
            }

            #[inline]
            fn is_finite(self) -> bool {
                self.is_finite()
            }

            #[inline]
            fn greatest(self) -> f64 {
                if self.is_nan() { f64::NEG_INFINITY } else { self as f64 }
            }

            #[inline]
            fn all_within(self, lower: f64, upper: f64) -> bool {
                (lower..=upper).contains(&(self as f64))
            }

            #[inline]
            fn recip_above(self, threshold: Self) -> Self {
                if self > threshold { 1.0 / self } else { 0.0 }
            }

            #[inline]
            fn recip_or_nan(self, threshold: Self) -> Self {
                if self > threshold && self > 0.0 { 1.0 / self } else { Self::NAN }
            }
        }

        #[allow(clippy::cast_lossless, reason = "one text for both widths")]
        impl Elementary for $float {
            #[inline]
            fn value(self) -> f64 {
                self as f64
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

float!(f64, sine::sin_cos, sqrt, exp, expm1, log, log1p, sincos, sinh, cosh, tanh, asin, atan, pow);
float!(
    f32,
    sin_cos_single,
    sqrtf,
    expf,
    expm1f,
    logf,
    log1pf,
    sincosf,
    sinhf,
    coshf,
    tanhf,
    asinf,
    atanf,
    powf
);
