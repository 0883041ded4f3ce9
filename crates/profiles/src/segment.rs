//! Circular segments: an angle less its sine, and what becomes of it when it is integrated.

use crate::Elementary;
use core::f64::consts::FRAC_PI_2;

/// z − sin z, for z from 0 to π, right to the last digits; `sine` is sin z.
///
/// It is twice the area between an arc of z (rad) of the unit circle and its chord. Near zero, where angle and sine
/// cancel, it is the series Σ (−1)ᵏ z²ᵏ⁺³/(2k+3)!.
#[inline]
pub(crate) fn segment<F: Elementary>(z: F, sine: F) -> F {
    if z.value().abs() < FRAC_PI_2 { z * z * z * series(z * z, &SEGMENT) } else { z - sine }
}

/// (z − sin z)/z³ for |z| < π/2, from the square of z.
#[inline]
pub(crate) fn segment_by_cube<F: Elementary>(square: F) -> F {
    series(square, &SEGMENT)
}

/// sin p − p·cos p − sin³p/3, for p from 0 to π/2, right to the last digits: how far something goes whose acceleration
/// follows an ellipse. It begins as 2p⁵/15.
#[inline]
pub(crate) fn ellipse<F: Elementary>(p: F, (sine, cosine): (F, F)) -> F {
    if p.value() < 1.125 {
        let square = p * p;
        square * square * p * series(square, &ELLIPSE)
    } else {
        sine - p * cosine - sine * sine * sine / F::from_f64(3.0)
    }
}

/// 1/3!, −1/5!, 1/7!, …: at π/2 what is left out is 2e-18 of the sum.
const SEGMENT: [f64; 10] = {
    let (mut terms, mut k, mut term) = ([0.0; 10], 0, 1.0 / 6.0);
    while k < 10 {
        terms[k] = term;
        k += 1;
        term /= -(((2 * k + 2) * (2 * k + 3)) as f64);
    }
    terms
};

/// (−1)ᵏ·(3/4 + 3²ᵏ⁺¹/12 − (2k+1))/(2k+1)! for k = 2, 3, …, from the series of sin p, p·cos p and sin³p = (3 sin p −
/// sin 3p)/4.
const ELLIPSE: [f64; 14] = {
    let (mut terms, mut k, mut power, mut factorial, mut sign) = ([0.0; 14], 2, 81.0 / 4.0, 120.0, 1.0);
    while k < 16 {
        let odd = (2 * k + 1) as f64;
        terms[k - 2] = sign * (0.75 + power - odd) / factorial;
        k += 1;
        power *= 9.0;
        factorial *= (odd + 1.0) * (odd + 2.0);
        sign = -sign;
    }
    terms
};

/// Σ cₖ·xᵏ.
#[inline]
fn series<F: Elementary>(x: F, coefficients: &[f64]) -> F {
    coefficients.iter().rev().fold(F::from_f64(0.0), |sum, &c| sum * x + F::from_f64(c))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn series_and_closed_form_agree_where_they_meet() {
        let z = FRAC_PI_2 * (1.0 - 1e-15);
        assert_relative_eq!(segment(z, z.sin()), z - z.sin(), max_relative = 1e-15);
        let p: f64 = 1.1249;
        let closed = p.sin() - p * p.cos() - p.sin().powi(3) / 3.0;
        assert_relative_eq!(ellipse(p, p.sin_cos()), closed, max_relative = 1e-14);
    }

    #[test]
    fn small_arguments_have_their_leading_term() {
        assert_relative_eq!(
            segment(1e-4, 1e-4_f64.sin()),
            1e-12 / 6.0 * (1.0 - 1e-8 / 20.0),
            max_relative = 4e-16
        );
        let leading = 2.0 / 15.0 * 1e-20 * (1.0 - 1e-8 * 11.0 / 42.0);
        assert_relative_eq!(ellipse(1e-4, 1e-4_f64.sin_cos()), leading, epsilon = 0.0, max_relative = 1e-15);
    }
}
