//! Products of 4×4 matrices: in full, or without the entries that are zero or one in every state.

use crate::scalar::Scalar;
use nalgebra::{Matrix4, Vector3, Vector4};
use std::fmt::Debug;

/// The way in which products of 4×4 matrices are taken: [`Short`] or [`Full`].
pub trait Products: sealed::Sealed + Copy + Debug + Default {
    /// Whether zeros and ones take part like any other entries.
    const FULL: bool;
}

/// Products that leave out what every state has zero or one: the last rows of the matrices, the third rows of the
/// derivatives of a turn, all but one entry of the derivative of a slide.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Short;

/// Products of all entries, 64 multiplications each, as the thesis counts them in §4.6. The results are the same; it is
/// there to be counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Full;

impl Products for Short {
    const FULL: bool = false;
}

impl Products for Full {
    const FULL: bool = true;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Short {}
    impl Sealed for super::Full {}
}

/// Where a right factor may differ from zero.
pub(super) trait Pattern {
    /// How many of the first rows, by column.
    const ROWS: [usize; 4];
    /// Whether its last row is (0 0 0 1) and not (0 0 0 0).
    const MOTION: bool;
}

/// Any rigid motion: a base `B`.
pub(super) struct Placement;

/// A Denavit-Hartenberg matrix `A`.
pub(super) struct Transform;

/// The derivatives `A'` and `A''` of a turn.
pub(super) struct TurnDerivative;

impl Pattern for Placement {
    const ROWS: [usize; 4] = [3, 3, 3, 3];
    const MOTION: bool = true;
}

impl Pattern for Transform {
    const ROWS: [usize; 4] = [2, 3, 3, 3];
    const MOTION: bool = true;
}

impl Pattern for TurnDerivative {
    const ROWS: [usize; 4] = [2, 2, 2, 2];
    const MOTION: bool = false;
}

/// `left·right`. The last row of a short product is not computed.
#[inline]
pub(super) fn product<P: Products, R: Pattern, T: Scalar>(
    left: &Matrix4<T>,
    right: &Matrix4<T>,
) -> Matrix4<T> {
    let mut out = Matrix4::zeros();
    let height = if P::FULL { 4 } else { 3 };
    for column in 0..4 {
        let rows = if P::FULL { 4 } else { R::ROWS[column] };
        for row in 0..height {
            out[(row, column)] = sum(rows, |k| left[(row, k)] * right[(k, column)]);
        }
    }
    if R::MOTION && !P::FULL {
        for row in 0..3 {
            out[(row, 3)] += left[(row, 3)];
        }
    }
    out
}

/// `J·Mᵀ` with a symmetric `J` and an `M` whose last row is zero, so that the last column of the product is.
#[inline]
pub(super) fn by_transposed<P: Products, T: Scalar>(j: &Matrix4<T>, m: &Matrix4<T>) -> Matrix4<T> {
    let mut out = Matrix4::zeros();
    for column in 0..if P::FULL { 4 } else { 3 } {
        for row in 0..4 {
            out[(row, column)] = sum(4, |k| j[(row, k)] * m[(column, k)]);
        }
    }
    out
}

/// `M·D` with a rigid motion `M` and a `D` whose last column is zero.
#[inline]
pub(super) fn by_inertial<P: Products, R: Pattern, T: Scalar>(m: &Matrix4<T>, d: &Matrix4<T>) -> Matrix4<T> {
    if P::FULL {
        return product::<P, R, T>(m, d);
    }
    let mut out = Matrix4::zeros();
    for column in 0..3 {
        for row in 0..3 {
            let first = first_column::<R>(row);
            out[(row, column)] = sum(4 - first, |k| m[(row, first + k)] * d[(first + k, column)]);
        }
        out[(3, column)] = d[(3, column)];
    }
    out
}

/// `M·c` with a rigid motion `M`.
#[inline]
pub(super) fn by_moment<P: Products, R: Pattern, T: Scalar>(m: &Matrix4<T>, c: &Vector4<T>) -> Vector4<T> {
    let mut out = *c;
    for row in 0..if P::FULL { 4 } else { 3 } {
        let first = if P::FULL { 0 } else { first_column::<R>(row) };
        out[row] = sum(4 - first, |k| m[(row, first + k)] * c[first + k]);
    }
    out
}

/// The first column that may differ from zero in a row of the left factor: in the third row of an `A` the second.
fn first_column<R: Pattern>(row: usize) -> usize {
    usize::from(R::ROWS[0] <= row)
}

/// `tr(M·D)`, summed over the columns of `M` from `first` on.
#[inline]
pub(super) fn trace_of_product<P: Products, T: Scalar>(m: &Matrix4<T>, d: &Matrix4<T>, first: usize) -> T {
    let (rows, first) = if P::FULL { (4, 0) } else { (3, first) };
    sum(rows, |i| sum(4 - first, |k| m[(i, first + k)] * d[(first + k, i)]))
}

/// `gᵀ·M·c`, summed over the columns of `M` from `first` on.
#[inline]
pub(super) fn component<P: Products, T: Scalar>(
    g: &Vector3<T>,
    m: &Matrix4<T>,
    c: &Vector4<T>,
    first: usize,
) -> T {
    let (rows, first) = if P::FULL { (4, 0) } else { (3, first) };
    let g = Vector4::new(g.x, g.y, g.z, T::zero());
    sum(rows, |i| g[i] * sum(4 - first, |k| m[(i, first + k)] * c[first + k]))
}

/// `to += k·m` in the columns from `first` on.
#[inline]
pub(super) fn add_scaled<P: Products, T: Scalar>(to: &mut Matrix4<T>, k: T, m: &Matrix4<T>, first: usize) {
    let (rows, first) = if P::FULL { (4, 0) } else { (3, first) };
    for column in first..4 {
        for row in 0..rows {
            to[(row, column)] += m[(row, column)] * k;
        }
    }
}

/// `term(0) + … + term(n − 1)`; zero terms make zero.
#[inline]
fn sum<T: Scalar>(n: usize, term: impl Fn(usize) -> T) -> T {
    if n == 0 { T::zero() } else { (1..n).fold(term(0), |sum, k| sum + term(k)) }
}
