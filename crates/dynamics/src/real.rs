//! The scalar that the recursions are written over.

use crate::sine;
use nalgebra::Scalar;
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// What the recursions ask of a number, and no more: lanes of a vector register, dual numbers or a scalar that counts
/// its operations can be one.
///
/// There is no order and no square root: no recursion branches on a value, and everything that has to be normalised is
/// normalised in double precision when the [`crate::Tree`] is built.
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
}

impl Real for f64 {
    fn from_f64(x: f64) -> Self {
        x
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        if sine::is_moderate(self) { sine::sin_cos(self) } else { self.sin_cos() }
    }

    #[inline]
    fn sin_cos_all(angles: &[Self], pairs: &mut [(Self, Self)]) {
        if angles.iter().fold(true, |moderate, angle| moderate & sine::is_moderate(*angle)) {
            angles.iter().zip(pairs).for_each(|(angle, pair)| *pair = sine::sin_cos(*angle));
        } else {
            angles.iter().zip(pairs).for_each(|(angle, pair)| *pair = Real::sin_cos(*angle));
        }
    }

    fn is_finite(self) -> bool {
        self.is_finite()
    }
}

impl Real for f32 {
    fn from_f64(x: f64) -> Self {
        x as Self
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        if sine::is_moderate(f64::from(self)) { sine::sin_cos_single(self) } else { self.sin_cos() }
    }

    #[inline]
    fn sin_cos_all(angles: &[Self], pairs: &mut [(Self, Self)]) {
        if angles.iter().fold(true, |moderate, angle| moderate & sine::is_moderate(f64::from(*angle))) {
            angles.iter().zip(pairs).for_each(|(angle, pair)| *pair = sine::sin_cos_single(*angle));
        } else {
            angles.iter().zip(pairs).for_each(|(angle, pair)| *pair = Real::sin_cos(*angle));
        }
    }

    fn is_finite(self) -> bool {
        self.is_finite()
    }
}
