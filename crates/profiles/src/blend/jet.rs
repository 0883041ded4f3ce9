//! Sums, products and quotients of functions with their first three derivatives.

use crate::Elementary;
use core::ops::{Add, Div, Mul, Sub};

/// Numbers, and intervals of them.
pub(super) trait Ring:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    fn real(x: f64) -> Self;

    /// The product, of which a factor that is exactly zero leaves nothing, be the other infinite.
    fn of(self, other: Self) -> Self;
}

impl<F: Elementary> Ring for F {
    #[inline]
    fn real(x: f64) -> Self {
        F::from_f64(x)
    }

    #[inline]
    fn of(self, other: Self) -> Self {
        let zero = F::from_f64(0.0);
        if self == zero || other == zero { zero } else { self * other }
    }
}

/// A function that is `x` everywhere.
pub(super) fn constant<T: Ring>(x: T) -> [T; 4] {
    [x, T::real(0.0), T::real(0.0), T::real(0.0)]
}

/// 1 − x.
pub(super) fn complement<T: Ring>(x: [T; 4]) -> [T; 4] {
    let zero = T::real(0.0);
    [T::real(1.0) - x[0], zero - x[1], zero - x[2], zero - x[3]]
}

/// x + y.
pub(super) fn sum<T: Ring>(x: [T; 4], y: [T; 4]) -> [T; 4] {
    core::array::from_fn(|i| x[i] + y[i])
}

/// x − y.
pub(super) fn difference<T: Ring>(x: [T; 4], y: [T; 4]) -> [T; 4] {
    core::array::from_fn(|i| x[i] - y[i])
}

/// x·y, by Leibniz' rule.
pub(super) fn product<T: Ring>(x: [T; 4], y: [T; 4]) -> [T; 4] {
    weighted(x, y, y)
}

/// W·f where f stands beside other functions of which the weights sum to one: derivatives of W then fall on the difference
/// g = f − h to any one function h.
///
/// ```text
/// W·f    W·f′ + W′·g    W·f″ + 2·W′·g′ + W″·g    W·f‴ + 3·W′·g″ + 3·W″·g′ + W‴·g
/// ```
pub(super) fn weighted<T: Ring>(w: [T; 4], f: [T; 4], g: [T; 4]) -> [T; 4] {
    let (two, three) = (T::real(2.0), T::real(3.0));
    [
        w[0].of(f[0]),
        w[0].of(f[1]) + w[1].of(g[0]),
        w[0].of(f[2]) + two * w[1].of(g[1]) + w[2].of(g[0]),
        w[0].of(f[3]) + three * (w[1].of(g[2]) + w[2].of(g[1])) + w[3].of(g[0]),
    ]
}

/// W = w/S.
///
/// ```text
/// W′ = (w′ − W·S′)/S    W″ = (w″ − 2·W′·S′ − W·S″)/S    W‴ = (w‴ − 3·W″·S′ − 3·W′·S″ − W·S‴)/S
/// ```
pub(super) fn quotient<T: Ring>(w: [T; 4], s: [T; 4]) -> [T; 4] {
    let (two, three) = (T::real(2.0), T::real(3.0));
    let value = w[0] / s[0];
    let first = (w[1] - value * s[1]) / s[0];
    let second = (w[2] - two * first * s[1] - value * s[2]) / s[0];
    let third = (w[3] - three * (second * s[1] + first * s[2]) - value * s[3]) / s[0];
    [value, first, second, third]
}
