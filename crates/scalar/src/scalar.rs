//! The trait that every number of the kernel implements.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{One, Zero};

/// A number of the recursions: the four operations, sines and cosines, and no more, so that lanes of a vector register,
/// dual numbers or a scalar that counts its operations can be one.
///
/// There is no order and no square root: no recursion branches on a value, because lanes may disagree. What has to be
/// decided is decided in every lane on its own ([`recip_above`](Self::recip_above)) or for all of them
/// ([`all_within`](Self::all_within)). [`Elementary`](crate::Elementary) is a scalar with one value to decide by.
///
/// Every scalar is one of nalgebra's too, so vectors and matrices of it are those of nalgebra.
#[doc(alias = "Real")]
#[doc(alias = "Float")]
#[doc(alias = "Num")]
pub trait Scalar:
    Copy
    + Debug
    + PartialEq
    + Zero
    + One
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + 'static
{
    /// The distance from 1 to the next number.
    const EPSILON: f64;

    /// Whether it is a number of the machine's own, which vector instructions know.
    const IS_FLOAT: bool = false;

    /// The nearest number to `x`; in every lane, and without derivatives, where there are such.
    fn from_f64(x: f64) -> Self;

    /// `self·a + b`: rounded once where an instruction does both, twice elsewhere.
    #[inline]
    fn times_plus(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    /// `b − self·a`, rounded as [`times_plus`](Self::times_plus) is.
    #[inline]
    fn times_from(self, a: Self, b: Self) -> Self {
        b - self * a
    }

    /// Sine and cosine of an angle (rad).
    fn sin_cos(self) -> (Self, Self);

    /// Sine and cosine of many angles (rad), as pairs in the same order. The slices have the same length.
    ///
    /// A scalar whose `sin_cos` branches can do better than one by one.
    fn sin_cos_all(angles: &[Self], pairs: &mut [(Self, Self)]) {
        for (angle, pair) in angles.iter().zip(pairs) {
            *pair = angle.sin_cos();
        }
    }

    /// Whether the number, with all its lanes and parts, is neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// Whether the value of every lane is between `lower` and `upper`, both included; a NaN is not.
    ///
    /// Derivatives are not looked at.
    fn all_within(self, lower: f64, upper: f64) -> bool;

    /// The greatest value of its lanes, to put numbers in an order that all lanes share; a NaN comes last.
    fn greatest(self) -> f64;

    /// 1/x in the lanes whose value x is above the threshold, and zero in the others (a NaN among them).
    ///
    /// A solve skips a dependent row by it, in some lanes and not in others, without a branch of its own. A dual number
    /// has the derivatives of the side that its value is on; those of the threshold do not count.
    fn recip_above(self, threshold: Self) -> Self;

    /// 1/x in the lanes whose value x is above both the threshold and zero, and NaN in the others.
    ///
    /// Where nothing but rounding is left of a number that has to be positive, its reciprocal means nothing: whoever looks at
    /// the result has to see that.
    fn recip_or_nan(self, threshold: Self) -> Self;
}

/// `+=`, `-=`, `*=` by way of `+`, `-`, `*`.
#[cfg(any(feature = "counted", feature = "double-double"))]
macro_rules! assignments {
    ($scalar:ty) => {
        impl core::ops::AddAssign for $scalar {
            #[inline]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl core::ops::SubAssign for $scalar {
            #[inline]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }

        impl core::ops::MulAssign for $scalar {
            #[inline]
            fn mul_assign(&mut self, other: Self) {
                *self = *self * other;
            }
        }
    };
}
#[cfg(any(feature = "counted", feature = "double-double"))]
pub(crate) use assignments;
