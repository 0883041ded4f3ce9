//! Zeros of functions, with how they behave there.

mod bernstein;

pub(crate) use bernstein::bernstein;

use crate::Elementary;
use crate::answers::Turn;
use alloc::vec::Vec;

/// The real roots of a·x² + b·x + c = 0, rising. None where all three are zero.
///
/// ```text
/// Δ = b² − 4·a·c        q = −(b + sign(b)·√Δ)/2        x = q/a, c/q
/// ```
///
/// Nothing cancels but in Δ, which is computed with the rounding errors of its products: its sign is right, and Δ = 0, where
/// the quadratic touches zero, is found where it holds for the coefficients as given. Coefficients may be
/// of any size, as long as the roots are numbers.
pub(crate) fn quadratic(a: f64, b: f64, c: f64) -> Vec<(f64, Turn)> {
    if is_zero(a) {
        return if is_zero(b) { Vec::new() } else { alloc::vec![(-c / b, Turn::Reversal)] };
    }
    // x = λ·y makes the outer coefficients alike, and µ all of them at most 2; both are powers of two.
    let lambda = power_of_two((exponent(c) - exponent(a)) / 2);
    let (a, b) = if is_zero(c) { (a, b) } else { (a * lambda * lambda, b * lambda) };
    let lambda = if is_zero(c) { 1.0 } else { lambda };
    let mu = power_of_two(-exponent(a.abs().max(b.abs()).max(c.abs())));
    let (a, b, c) = (a * mu, b * mu, c * mu);
    let ((square, error), (product, product_error)) = (two_product(b, b), two_product(4.0 * a, c));
    let discriminant = (square - product) + (error - product_error);
    if discriminant < 0.0 {
        return Vec::new();
    }
    if is_zero(discriminant) {
        return alloc::vec![(-0.5 * b / a * lambda, Turn::Touch)];
    }
    let root = Elementary::sqrt(discriminant);
    let q = -0.5 * (b + if b < 0.0 { -root } else { root });
    let (x, y) = (q / a * lambda, c / q * lambda);
    if (x - y).abs() <= 0.0 {
        return alloc::vec![(x, Turn::Touch)];
    }
    alloc::vec![(x.min(y), Turn::Reversal), (x.max(y), Turn::Reversal)]
}

/// A zero of a function with a sign change between `low` and `high`, to the last digits; without a sign change, the end at
/// which the function is smaller.
///
/// # Source
///
/// T. R. Chandrupatla, "A new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function without using
/// derivatives", Advances in Engineering Software 28 (1997).
pub(crate) fn bracketed(f: impl Fn(f64) -> f64, low: f64, high: f64) -> f64 {
    // The zero is between a and b; c is the point before.
    let (mut a, mut b) = (high, low);
    let (mut fa, mut fb) = (f(a), f(b));
    let (mut c, mut fc);
    let mut fraction = 0.5;
    if is_zero(fa) || (fa > 0.0) == (fb > 0.0) {
        return if fa.abs() < fb.abs() { a } else { b };
    }
    for _ in 0..256 {
        let x = a + fraction * (b - a);
        let fx = f(x);
        if (fx > 0.0) == (fa > 0.0) {
            (c, fc) = (a, fa);
        } else {
            (c, fc, b, fb) = (b, fb, a, fa);
        }
        (a, fa) = (x, fx);
        let best = if fa.abs() < fb.abs() { a } else { b };
        let least = (f64::EPSILON * best.abs() + f64::MIN_POSITIVE) / (b - a).abs();
        if least > 0.5 || is_zero(fa) {
            return if is_zero(fa) { a } else { best };
        }
        // Through the three points goes a parabola x(f) without a turn in between, or else the span is halved.
        let (xi, phi) = ((a - b) / (c - b), (fa - fb) / (fc - fb));
        let parabola = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
        fraction = if parabola {
            fa / (fb - fa) * (fc / (fb - fc)) + (c - a) / (b - a) * (fa / (fc - fa)) * (fb / (fc - fb))
        } else {
            0.5
        };
        // Steps of less than the last digit would not end.
        fraction = fraction.clamp(least, 1.0 - least);
    }
    if fa.abs() < fb.abs() { a } else { b }
}

/// The zeros of a function in an open span, which the cuts, rising, divide into pieces on which the function is monotone. At a
/// cut at which it is zero, within `noise`, is a zero of higher order. A zero at an end of the span does not count.
pub(crate) fn pieces(
    f: impl Fn(f64) -> f64,
    noise: impl Fn(f64) -> f64,
    cuts: impl IntoIterator<Item = f64>,
    (low, high): (f64, f64),
) -> Vec<(f64, Turn)> {
    let sign = |x: f64| {
        let y = f(x);
        (y.abs() > noise(x)).then_some(y > 0.0)
    };
    let mut roots = Vec::new();
    // The last place that was looked at with the sign there or before it, and the cuts since then at which f is zero.
    let (mut last, mut positive) = (low, sign(low));
    let mut zeros: Vec<f64> = Vec::new();
    for x in cuts.into_iter().chain([high]) {
        match (sign(x), positive) {
            (None, _) => {
                zeros.push(x);
                continue;
            }
            (Some(now), Some(before)) => {
                if let (Some(first), Some(last)) = (zeros.first(), zeros.last()) {
                    let turn = if now == before { Turn::Touch } else { Turn::Reversal };
                    roots.push((0.5 * (first + last), turn));
                } else if now != before {
                    roots.push((bracketed(&f, last, x), Turn::Reversal));
                }
            }
            // From a zero at the beginning, f leaves to one side.
            (Some(_), None) => {}
        }
        zeros.clear();
        (last, positive) = (x, sign(x));
    }
    roots
}

/// Whether a number is 0 or −0.
fn is_zero(x: f64) -> bool {
    x.abs() <= 0.0
}

/// The power of two at or below |x|.
fn exponent(x: f64) -> i32 {
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023
}

/// 2ⁿ, for the n nearest to the given one that a normal number has.
fn power_of_two(n: i32) -> f64 {
    f64::from_bits(((n.clamp(-1022, 1023) + 1023) as u64) << 52)
}

/// x·y as its rounded value and the error of that.
///
/// # Source
///
/// T. J. Dekker, "A floating-point technique for extending the available precision", Numerische Mathematik 18 (1971).
fn two_product(x: f64, y: f64) -> (f64, f64) {
    // Halves of 26 bits each, whose products are exact.
    let split = |x: f64| {
        let shifted = 134_217_729.0 * x;
        let high = shifted - (shifted - x);
        (high, x - high)
    };
    let (product, (xh, xl), (yh, yl)) = (x * y, split(x), split(y));
    (product, ((xh * yh - product) + xh * yl + xl * yh) + xl * yl)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[track_caller]
    fn check(found: &[(f64, Turn)], wanted: &[(f64, Turn)]) {
        assert_eq!(found.len(), wanted.len(), "{found:?}, not {wanted:?}");
        for (found, wanted) in found.iter().zip(wanted) {
            assert_relative_eq!(found.0, wanted.0, max_relative = 4e-16);
            assert_eq!(found.1, wanted.1);
        }
    }

    #[test]
    fn quadratics_have_two_roots_or_a_double_one_or_none() {
        use Turn::{Reversal, Touch};
        check(&quadratic(1.0, -3.0, 2.0), &[(1.0, Reversal), (2.0, Reversal)]);
        check(&quadratic(-2.0, -4.0, 6.0), &[(-3.0, Reversal), (1.0, Reversal)]);
        check(&quadratic(4.0, -4.0, 1.0), &[(0.5, Touch)]);
        check(&quadratic(1.0, 1.0, 1.0), &[]);
        check(&quadratic(1.0, 0.0, -4.0), &[(-2.0, Reversal), (2.0, Reversal)]);
        check(&quadratic(1.0, -2.0, 0.0), &[(0.0, Reversal), (2.0, Reversal)]);
        check(&quadratic(1.0, 0.0, 0.0), &[(0.0, Touch)]);
        check(&quadratic(0.0, 2.0, -1.0), &[(0.5, Reversal)]);
        check(&quadratic(0.0, 0.0, 1.0), &[]);
        check(&quadratic(0.0, 0.0, 0.0), &[]);
    }

    #[test]
    fn quadratics_of_any_size_lose_nothing() {
        use Turn::Reversal;
        // x² − 10⁹ x + 1: the small root would be lost in −b − √Δ.
        check(&quadratic(1.0, -1e9, 1.0), &[(1e-9, Reversal), (1e9, Reversal)]);
        check(&quadratic(1e300, -3e300, 2e300), &[(1.0, Reversal), (2.0, Reversal)]);
        check(&quadratic(1e-300, -3e-300, 2e-300), &[(1.0, Reversal), (2.0, Reversal)]);
        check(&quadratic(1e150, -3.0, 2e-150), &[(1e-150, Reversal), (2e-150, Reversal)]);
        // Δ = 4·10⁻¹⁶·(1 + …) is not seen without the errors of the products: (x − 1)(x − 1 − 2⁻⁵⁰).
        let e = power_of_two(-50);
        check(&quadratic(1.0, -2.0 - e, 1.0 + e), &[(1.0, Reversal), (1.0 + e, Reversal)]);
    }

    #[test]
    fn a_bracket_closes_to_the_last_digit() {
        let evaluations = core::cell::Cell::new(0);
        let f = |x: f64| {
            evaluations.set(evaluations.get() + 1);
            x * x * x - 2.0
        };
        assert_relative_eq!(
            bracketed(f, 0.0, 2.0),
            Elementary::powf(2.0_f64, 1.0 / 3.0),
            max_relative = 3e-16
        );
        assert!(evaluations.get() < 16, "{} evaluations", evaluations.get());
        assert_relative_eq!(
            bracketed(Elementary::cos, 3.0, 0.0),
            core::f64::consts::FRAC_PI_2,
            max_relative = 3e-16
        );
        // Steep, flat, next to zero, at an end.
        assert_relative_eq!(
            bracketed(|x| Elementary::exp(1e3 * x) - 1e100, 0.0, 0.5),
            0.1 * 10_f64.ln(),
            max_relative = 1e-15
        );
        assert_relative_eq!(bracketed(|x| Elementary::powi(x - 0.3, 9), 0.0, 1.0), 0.3, max_relative = 1e-15);
        assert_relative_eq!(bracketed(|x| x - 1e-200, -1.0, 1.0), 1e-200, max_relative = 1e-15);
        assert!(
            bracketed(|x| x, 0.0, 1.0).abs() < 1e-300
                && (bracketed(|x| x - 1.0, 0.0, 1.0) - 1.0).abs() < 1e-300
        );
    }

    #[test]
    fn pieces_are_searched_one_by_one() {
        let noise = |_: f64| 1e-14;
        let full = core::f64::consts::PI;
        let found = pieces(Elementary::sin, noise, [0.5 * full, 1.5 * full], (0.0, 2.0 * full));
        check(&found, &[(full, Turn::Reversal)]);
        let found =
            pieces(|x| Elementary::cos(x) - 1.0, noise, [full, 2.0 * full, 3.0 * full], (0.0, 4.0 * full));
        check(&found, &[(2.0 * full, Turn::Touch)]);
        let found = pieces(|x| Elementary::powi(x, 3), noise, [0.0], (-1.0, 1.0));
        check(&found, &[(0.0, Turn::Reversal)]);
        check(&pieces(|x| x - 1e-20, noise, [], (0.0, 1.0)), &[]);
    }

    #[test]
    fn without_a_sign_change_the_smaller_end_is_taken() {
        let valley = |x: f64| (x - 0.3) * (x - 0.3) + 0.01;
        assert!(bracketed(valley, 0.0, 1.0).abs() < 1e-300);
        assert!((bracketed(valley, -1.0, 0.5) - 0.5).abs() < 1e-300);
        assert!((bracketed(|x| x - 0.25, 0.0, 1.0) - 0.25).abs() < 1e-15);
    }
}
