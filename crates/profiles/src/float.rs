//! Whole parts and remainders of `f64`, with and without the standard library.

use num_traits::float::FloatCore;

/// The greatest whole number that is not above `x`.
#[inline]
pub(crate) fn floor(x: f64) -> f64 {
    FloatCore::floor(x)
}

/// `x` less the whole multiple of `period` that leaves it in [0, period], the period itself only where
/// what is below zero is less than can be told from it: exact but for the last rounding.
pub(crate) fn rem_euclid(x: f64, period: f64) -> f64 {
    let rest = x % period;
    if rest < 0.0 { rest + period } else { rest }
}
