//! The break points of a clip, between which nothing of it jumps or turns.

use crate::answers::Answers;
use crate::clip::{Clip, Outside};
use crate::float::floor;
use crate::sample::Sample;
use alloc::vec::Vec;

/// Adds the times from 0 to `until` between which position, velocity, acceleration and jerk of a clip each only rise or only
/// fall, and nothing jumps.
pub(super) fn breaks<C: Answers>(clip: &Clip<C>, until: f64, times: &mut Vec<f64>) {
    let (curve, start) = (clip.curve(), clip.start());
    let duration = curve.duration();
    let mut own = curve.breaks();
    own.extend([0.0, duration]);
    match clip.policy() {
        Outside::Repeat | Outside::Mirror if duration > 0.0 => {
            let mirror = clip.policy() == Outside::Mirror;
            let mut turn = floor(-start / duration) - 1.0;
            while start + turn * duration <= until {
                let (begin, backwards) = (start + turn * duration, mirror && turn % 2.0 != 0.0);
                let place = |&t: &f64| begin + if backwards { duration - t } else { t };
                // The end of a turn is the beginning of the next, in one rounding.
                times.push(begin);
                times.extend(own.iter().filter(|&&t| t > 0.0 && t < duration).map(place));
                turn += 1.0;
            }
        }
        Outside::Extrapolate => {
            times.extend(own.iter().map(|t| start + t));
            beyond(curve, -start, 0.0, start, times);
            beyond(curve, duration, until - start, start, times);
        }
        _ => times.extend(own.iter().map(|t| start + t)),
    }
}

/// Beyond its ends, a curve is a polynomial. From what it does at both ends of a span there, that polynomial is known up to
/// degree seven, and so is where its derivatives turn.
fn beyond<C: Answers>(curve: &C, from: f64, to: f64, start: f64, times: &mut Vec<f64>) {
    let h = to - from;
    if h.is_nan() || h <= 0.0 {
        return;
    }
    // A hair inside, so that it is the formula beyond the ends.
    let (low, high) = (curve.extrapolated(from.next_up()), curve.extrapolated(to.next_down()));
    let mut bernstein: Vec<f64> = septic(&low, &high, h).into();
    for _ in 0..5 {
        bernstein = bernstein.windows(2).map(|pair| pair[1] - pair[0]).collect();
        times.extend(crate::roots::bernstein(&bernstein).into_iter().map(|(u, _)| start + from + u * h));
    }
}

/// The Bernstein coefficients of the polynomial of degree seven that meets two samples `h` apart.
fn septic(low: &Sample, high: &Sample, h: f64) -> [f64; 8] {
    // b_k = Σ_j (k over j)·(7 − j)!/7!·hʲ·f⁽ʲ⁾, from either end.
    let half = |sample: &Sample, h: f64| {
        let [x, v, a, j] = sample.to_array();
        let (v, a, j) = (v * h / 7.0, a * h * h / 42.0, j * h * h * h / 210.0);
        [x, x + v, x + 2.0 * v + a, x + 3.0 * (v + a) + j]
    };
    let ([b0, b1, b2, b3], [b7, b6, b5, b4]) = (half(low, h), half(high, -h));
    [b0, b1, b2, b3, b4, b5, b6, b7]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_is_known_from_its_ends() {
        // f = t³ from 1 to 3: symmetric in its blossoms, b_k from 1 to 27.
        let cube =
            |t: f64| Sample { position: t * t * t, velocity: 3.0 * t * t, acceleration: 6.0 * t, jerk: 6.0 };
        let found = septic(&cube(1.0), &cube(3.0), 2.0);
        // In the middle, 8 = Σ (7 over k)·b_k/2⁷.
        let middle: f64 =
            found.iter().zip([1.0, 7.0, 21.0, 35.0, 35.0, 21.0, 7.0, 1.0]).map(|(b, n)| b * n / 128.0).sum();
        assert!((middle - 8.0).abs() < 1e-13, "{middle}");
    }
}
