//! Velocities with which the acceleration does not jump.

use crate::Elementary;
use crate::spline::keys::Chord;
use alloc::vec::Vec;

/// Solves for the velocities at the keys: with those given at the ends, or with no acceleration there.
///
/// Each row is divided by h₋ + h₊, which leaves shares of one in place of durations:
///
/// ```text
/// λ vᵢ₋₁ + 2vᵢ + μ vᵢ₊₁ = 3(λ m₋ + μ m₊)        λ = h₊/(h₋ + h₊)   μ = h₋/(h₋ + h₊)
/// ```
///
/// The matrix depends on the times alone, so that it is eliminated in double precision whatever the positions are in.
pub(in crate::spline) fn continuous<F: Elementary>(chords: &[Chord<F>], ends: Option<(F, F)>) -> Vec<F> {
    let [first, .., last] = chords else {
        // Of one piece, where there is nothing to be solved.
        return chords.first().map_or_else(Vec::new, |only| {
            let (start, end) = ends.unwrap_or((only.slope, only.slope));
            [start, end].into()
        });
    };
    let number = F::from_f64;
    // vᵢ = right − upper·vᵢ₊₁, from the first row on.
    let mut rows: Vec<(f64, F)> = Vec::with_capacity(chords.len() + 1);
    rows.push(match ends {
        Some((start, _)) => (0.0, start),
        None => (0.5, number(1.5) * first.slope),
    });
    for (i, pair) in chords.windows(2).enumerate() {
        let (before, after) = (&pair[0], &pair[1]);
        let whole = before.duration + after.duration;
        let (lambda, mu) = (after.duration / whole, before.duration / whole);
        let (upper, right) = rows[i];
        let pivot = 2.0 - lambda * upper;
        let mean = number(lambda) * before.slope + number(mu) * after.slope;
        rows.push((mu / pivot, (number(3.0) * mean - number(lambda) * right) / number(pivot)));
    }
    let mut velocity = if let Some((_, end)) = ends {
        end
    } else {
        let (upper, right) = rows[chords.len() - 1];
        (number(3.0) * last.slope - right) / number(2.0 - upper)
    };
    let mut velocities = alloc::vec![velocity; chords.len() + 1];
    for (place, &(upper, right)) in velocities.iter_mut().zip(&rows).rev() {
        velocity = right - number(upper) * velocity;
        *place = velocity;
    }
    velocities
}
