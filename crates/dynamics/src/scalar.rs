//! The scalars that the recursions are written over: [`Real`] says what one has to do, and each of the others answers one
//! question through the very same code.
//!
//! | scalar | holds | for |
//! |---|---|---|
//! | `f64`, `f32` | itself | the answer |
//! | [`Dual`] | a value and its derivatives along several directions | exact derivatives of any operation |
//! | [`Lanes`] | several states | several answers in one pass |
//! | [`Counted`] | a value, with a count beside it | how many operations an answer takes |
//! | [`DoubleDouble`] | 32 digits | how many digits of an answer are right |

mod counted;
mod double_double;
mod dual;
mod float;
mod lanes;
mod sine;

pub use counted::{Counted, Operations};
pub use double_double::DoubleDouble;
pub use dual::Dual;
pub use lanes::Lanes;

use nalgebra::Scalar;
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// What the recursions ask of a number, and no more: lanes of a vector register, dual numbers or a scalar that counts
/// its operations can be one.
///
/// There is no order and no square root: no recursion branches on a value, because lanes may disagree, and everything
/// that has to be normalised is normalised in double precision when the [`crate::Tree`] is built. What has to be decided
/// is decided in every lane on its own ([`recip_above`](Self::recip_above)) or for all of them
/// ([`all_within`](Self::all_within)).
pub trait Real:
    Scalar
    + Copy
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
{
    /// The distance from 1 to the next number.
    const EPSILON: f64;

    /// The nearest number to `x`; in every lane, and without derivatives, where there are such.
    fn from_f64(x: f64) -> Self;

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

    /// 1/x in the lanes whose value x is above the threshold, and NaN in the others.
    ///
    /// Where nothing but rounding is left of a number that has to be positive, its reciprocal means nothing: whoever looks at
    /// the result has to see that.
    fn recip_or_nan(self, threshold: Self) -> Self;
}

/// `+=`, `-=`, `*=` by way of `+`, `-`, `*`.
macro_rules! assignments {
    ($scalar:ty $(, const $n:ident)?) => {
        impl $(<const $n: usize>)? std::ops::AddAssign for $scalar {
            #[inline]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl $(<const $n: usize>)? std::ops::SubAssign for $scalar {
            #[inline]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }

        impl $(<const $n: usize>)? std::ops::MulAssign for $scalar {
            #[inline]
            fn mul_assign(&mut self, other: Self) {
                *self = *self * other;
            }
        }
    };
}
use assignments;
