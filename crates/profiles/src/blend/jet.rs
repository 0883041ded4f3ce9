//! Sums, products and quotients of functions with their first three derivatives.

use crate::Elementary;

/// The product, of which a factor that is exactly zero leaves nothing, be the other infinite.
#[inline]
fn of<F: Elementary>(x: F, y: F) -> F {
    let zero = F::from_f64(0.0);
    if x == zero || y == zero { zero } else { x * y }
}

/// A function that is `x` everywhere.
pub(super) fn constant<F: Elementary>(x: F) -> [F; 4] {
    [x, F::from_f64(0.0), F::from_f64(0.0), F::from_f64(0.0)]
}

/// 1 − x.
pub(super) fn complement<F: Elementary>(x: [F; 4]) -> [F; 4] {
    let zero = F::from_f64(0.0);
    [F::from_f64(1.0) - x[0], zero - x[1], zero - x[2], zero - x[3]]
}

/// x + y.
pub(super) fn sum<F: Elementary>(x: [F; 4], y: [F; 4]) -> [F; 4] {
    core::array::from_fn(|i| x[i] + y[i])
}

/// x − y.
pub(super) fn difference<F: Elementary>(x: [F; 4], y: [F; 4]) -> [F; 4] {
    core::array::from_fn(|i| x[i] - y[i])
}

/// x·y, by Leibniz' rule.
pub(super) fn product<F: Elementary>(x: [F; 4], y: [F; 4]) -> [F; 4] {
    weighted(x, y, y)
}

/// W·f where f stands beside other functions of which the weights sum to one: derivatives of W then fall on the difference
/// g = f − h to any one function h.
///
/// ```text
/// W·f    W·f′ + W′·g    W·f″ + 2·W′·g′ + W″·g    W·f‴ + 3·W′·g″ + 3·W″·g′ + W‴·g
/// ```
pub(super) fn weighted<F: Elementary>(w: [F; 4], f: [F; 4], g: [F; 4]) -> [F; 4] {
    let (two, three) = (F::from_f64(2.0), F::from_f64(3.0));
    [
        of(w[0], f[0]),
        of(w[0], f[1]) + of(w[1], g[0]),
        of(w[0], f[2]) + two * of(w[1], g[1]) + of(w[2], g[0]),
        of(w[0], f[3]) + three * (of(w[1], g[2]) + of(w[2], g[1])) + of(w[3], g[0]),
    ]
}

/// W = w/S.
///
/// ```text
/// W′ = (w′ − W·S′)/S    W″ = (w″ − 2·W′·S′ − W·S″)/S    W‴ = (w‴ − 3·W″·S′ − 3·W′·S″ − W·S‴)/S
/// ```
pub(super) fn quotient<F: Elementary>(w: [F; 4], s: [F; 4]) -> [F; 4] {
    let (two, three) = (F::from_f64(2.0), F::from_f64(3.0));
    let value = w[0] / s[0];
    let first = (w[1] - value * s[1]) / s[0];
    let second = (w[2] - two * first * s[1] - value * s[2]) / s[0];
    let third = (w[3] - three * (second * s[1] + first * s[2]) - value * s[3]) / s[0];
    [value, first, second, third]
}
