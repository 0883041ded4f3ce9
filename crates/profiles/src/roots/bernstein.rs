//! Zeros of polynomials in Bernstein form.

use super::{bracketed, is_zero, pieces};
use crate::Elementary;
use crate::answers::Turn;
use alloc::vec::Vec;

/// The roots in the open span (0, 1) of the polynomial with these coefficients, rising; each once, as a reversal where the
/// polynomial changes its sign and as a touch where it does not. None where all coefficients are zero.
///
/// ```text
/// p(u) = Σ bₖ·C(n, k)·uᵏ·(1 − u)ⁿ⁻ᵏ        k = 0 … n
/// ```
///
/// The coefficients change their sign at least as often as p does, so that none or one change settles the matter at once.
/// Else the roots of p′ cut the span into pieces on which p is monotone; at a root of p′ where p is zero up to the rounding
/// of its own coefficients, p has a root of higher order. A simple root is right to its last digits, as well as the
/// coefficients determine it; so is the place of a touch, which is a simple root of p′.
///
/// # Source
///
/// The rule of signs in Bernstein form: J. M. Lane, R. F. Riesenfeld, "Bounds on a polynomial", BIT 21 (1981).
pub(crate) fn bernstein(b: &[f64]) -> Vec<(f64, Turn)> {
    let b = without_roots_at_ends(b);
    let changes = sign_changes(&b);
    if changes == 0 {
        return Vec::new();
    }
    if changes == 1 {
        return alloc::vec![(bracketed(|u| value(&b, u), 0.0, 1.0), Turn::Reversal)];
    }
    let slope: Vec<f64> = b.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let cuts = bernstein(&slope).into_iter().map(|(u, _)| u);
    pieces(|u| value(&b, u), |u| noise(&b, u), cuts, (0.0, 1.0))
}

/// The coefficients of p(u)/(uⁱ·(1 − u)ʲ), of which neither the first nor the last is zero; no coefficient if p is zero.
fn without_roots_at_ends(b: &[f64]) -> Vec<f64> {
    let mut b = b.to_vec();
    while b.first().is_some_and(|&first| is_zero(first)) {
        let n = (b.len() - 1) as f64;
        b.remove(0);
        b.iter_mut().enumerate().for_each(|(k, b)| *b *= n / (k + 1) as f64);
    }
    while b.last().is_some_and(|&last| is_zero(last)) {
        let n = (b.len() - 1) as f64;
        b.pop();
        b.iter_mut().enumerate().for_each(|(k, b)| *b *= n / (n - k as f64));
    }
    b
}

/// How often the sign changes, zeros left out.
fn sign_changes(b: &[f64]) -> usize {
    let mut signs = b.iter().filter(|&&b| !is_zero(b)).map(|&b| b > 0.0);
    let mut last = signs.next();
    signs.filter(|&sign| last.replace(sign) != Some(sign)).count()
}

/// p(u), as (1 − u)ⁿ times a polynomial in u/(1 − u) up to the middle, and the mirror of that beyond it: all the terms have
/// the sign of their coefficients.
fn value(b: &[f64], u: f64) -> f64 {
    let n = b.len() - 1;
    if u <= 0.5 { horner(b.iter().copied(), n, u) } else { horner(b.iter().rev().copied(), n, 1.0 - u) }
}

fn horner(b: impl Iterator<Item = f64>, n: usize, u: f64) -> f64 {
    let r = u / (1.0 - u);
    let (mut sum, mut term) = (0.0, 1.0);
    for (k, b) in b.enumerate() {
        sum += b * term;
        term *= r * (n - k) as f64 / (k + 1) as f64;
    }
    sum * Elementary::powi(1.0 - u, n as u32)
}

/// How wrong p(u) may be where each coefficient is wrong by some units of its last place.
fn noise(b: &[f64], u: f64) -> f64 {
    let sizes: Vec<f64> = b.iter().map(|b| b.abs()).collect();
    4.0 * b.len() as f64 * f64::EPSILON * value(&sizes, u)
}

#[cfg(test)]
mod tests {
    use super::*;
    use Turn::{Reversal, Touch};
    use approx::assert_relative_eq;

    /// Bernstein coefficients of Π (u − rᵢ), by multiplying the factors (−r, 1 − r).
    fn product(roots: &[f64]) -> Vec<f64> {
        let mut b = alloc::vec![1.0];
        for r in roots {
            let n = b.len() as f64;
            let left = |k: usize| if k < b.len() { (n - k as f64) / n * -r * b[k] } else { 0.0 };
            let right = |k: usize| if k > 0 { k as f64 / n * (1.0 - r) * b[k - 1] } else { 0.0 };
            b = (0..=b.len()).map(|k| left(k) + right(k)).collect();
        }
        b
    }

    #[track_caller]
    fn check(roots: &[f64], wanted: &[(f64, Turn)], tolerance: f64) {
        let found = bernstein(&product(roots));
        assert_eq!(found.len(), wanted.len(), "{found:?}, not {wanted:?}");
        for (found, wanted) in found.iter().zip(wanted) {
            assert_relative_eq!(found.0, wanted.0, epsilon = tolerance);
            assert_eq!(found.1, wanted.1, "{found:?}");
        }
    }

    #[test]
    fn simple_roots_are_reversals() {
        check(&[0.3], &[(0.3, Reversal)], 1e-16);
        check(&[0.2, 0.7], &[(0.2, Reversal), (0.7, Reversal)], 1e-15);
        check(
            &[0.1, 0.4, 0.5, 0.9],
            &[(0.1, Reversal), (0.4, Reversal), (0.5, Reversal), (0.9, Reversal)],
            1e-14,
        );
        check(&[0.5, 0.500_001], &[(0.5, Reversal), (0.500_001, Reversal)], 1e-9);
        check(&[-0.5, 1.5, 0.25], &[(0.25, Reversal)], 1e-15);
        check(&[-0.5, 1.5], &[], 0.0);
    }

    #[test]
    fn roots_of_higher_order_touch_or_reverse() {
        check(&[0.3, 0.3], &[(0.3, Touch)], 1e-15);
        check(&[0.3, 0.3, 0.8], &[(0.3, Touch), (0.8, Reversal)], 1e-14);
        check(&[0.7, 0.7, 0.7], &[(0.7, Reversal)], 1e-14);
        check(&[0.2, 0.2, 0.6, 0.6], &[(0.2, Touch), (0.6, Touch)], 1e-14);
        check(&[0.6, 0.6, 0.6, 0.6], &[(0.6, Touch)], 1e-13);
        check(&[0.5, 0.5, -1.0, 2.0, 3.0], &[(0.5, Touch)], 1e-14);
    }

    #[test]
    fn roots_at_the_ends_do_not_count() {
        check(&[0.0, 0.0, 1.0, 1.0], &[], 0.0);
        check(&[0.0, 0.0, 0.4, 1.0], &[(0.4, Reversal)], 1e-15);
        check(&[0.0, 0.25, 0.25, 1.0], &[(0.25, Touch)], 1e-14);
        assert!(bernstein(&[0.0; 5]).is_empty() && bernstein(&[]).is_empty() && bernstein(&[2.0]).is_empty());
    }

    #[test]
    fn coefficients_may_be_of_any_size() {
        for scale in [1e-290, 1e290] {
            let b: Vec<f64> = product(&[0.2, 0.7]).iter().map(|b| b * scale).collect();
            let found = bernstein(&b);
            assert_eq!(found.len(), 2);
            assert_relative_eq!(found[0].0, 0.2, epsilon = 1e-15);
        }
        // A root close to the beginning: u ≈ 10⁻²⁰.
        assert_relative_eq!(bernstein(&[-1e-20, 0.5, 1.0])[0].0, 1e-20, max_relative = 1e-15);
    }
}
