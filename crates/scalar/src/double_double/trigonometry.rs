//! Sine and cosine to twice the digits of double precision.

use super::{DoubleDouble, two_prod};
use num_traits::One;

/// Angles up to this (rad) are reduced to 32 digits.
const LARGEST: f64 = 1e15;

/// A quarter turn as the sum of three numbers of double precision: 161 bits.
const QUARTER_TURN: [f64; 3] =
    [std::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17, -1.497_384_904_859_169_8e-33];

/// Sine and cosine of an angle (rad), with errors below 1e-31; beyond 1e15 rad no better than those of `f64`.
pub(super) fn sin_cos(angle: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    if angle.high.abs() > LARGEST || !angle.high.is_finite() {
        return coarse(angle);
    }
    let (rest, turns) = reduce(angle);
    let (sine, cosine) = (sine_of_rest(rest), cosine_of_rest(rest));
    match turns & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// The angle less its nearest number of quarter turns, and that number.
///
/// Each product of the number with a part of the quarter turn is exact in two parts, so that what cancels leaves no error.
fn reduce(angle: DoubleDouble) -> (DoubleDouble, i64) {
    let turns = (angle.high * std::f64::consts::FRAC_2_PI).round();
    let rest = QUARTER_TURN.iter().fold(angle, |rest, part| {
        let (high, low) = two_prod(turns, *part);
        rest - DoubleDouble { high, low }
    });
    (rest, turns as i64)
}

/// Its own series, from the inside out:
///
/// ```text
/// sin r = r·(1 − r²/(2·3)·(1 − r²/(4·5)·(1 − …)))
/// ```
fn sine_of_rest(r: DoubleDouble) -> DoubleDouble {
    r * alternating(r * r, 2.0)
}

/// ```text
/// cos r = 1 − r²/(1·2)·(1 − r²/(3·4)·(1 − …))
/// ```
fn cosine_of_rest(r: DoubleDouble) -> DoubleDouble {
    alternating(r * r, 1.0)
}

/// `1 − z/(k·(k+1))·(1 − z/((k+2)·(k+3))·(1 − …))` for z up to 1, where 15 terms leave less than 1/31!.
fn alternating(z: DoubleDouble, first: f64) -> DoubleDouble {
    (0..15).rev().fold(DoubleDouble::one(), |sum, term| {
        let k = first + 2.0 * f64::from(term);
        DoubleDouble::one() - z * sum / DoubleDouble::from_f64(k * (k + 1.0))
    })
}

/// To double precision alone, with the low part by the sum of angles: `sin(h + l) ≈ sin h·cos l + cos h·sin l`.
fn coarse(angle: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let ((s, c), (sine, cosine)) = (angle.high.sin_cos(), angle.low.sin_cos());
    (DoubleDouble::from_f64(s * cosine + c * sine), DoubleDouble::from_f64(c * cosine - s * sine))
}
