//! Velocities that depend on the nearest keys alone.

use crate::Elementary;
use crate::spline::keys::{Bend, Chord};
use alloc::vec::Vec;
use core::iter::once;

/// The slope from the key before to the key after; at the ends what makes the outermost way a parabola.
pub(in crate::spline) fn catmull_rom<F: Elementary>(chords: &[Chord<F>]) -> Vec<F> {
    let between = |a: &Chord<F>, b: &Chord<F>| (a.way + b.way) / F::from_f64(a.duration + b.duration);
    // v₀ + v₁ = 2·x⁄d: a chord that is short beside the end's has as small a part in its slope as it has in that of the key between.
    let end = |end: &Chord<F>, next: &Chord<F>| end.slope + end.slope - between(end, next);
    along(chords, between, end)
}

/// The mean of both slopes, each weighted with the root of the other way; chords at the ends.
pub(in crate::spline) fn centripetal<F: Elementary>(chords: &[Chord<F>]) -> Vec<F> {
    let between = |a: &Chord<F>, b: &Chord<F>| match (root(a.way), root(b.way)) {
        // From hold to hold.
        (a, b) if (a + b).value() <= 0.0 => F::from_f64(0.0),
        (before, after) => {
            let share = before / (before + after);
            a.slope * (F::from_f64(1.0) - share) + b.slope * share
        }
    };
    along(chords, between, |end, _| end.slope)
}

/// The weighted harmonic mean of both slopes, or none; limited parabolas at the ends.
pub(in crate::spline) fn monotone<F: Elementary>(chords: &[Chord<F>]) -> Vec<F> {
    let between = |a: &Chord<F>, b: &Chord<F>| {
        if sign(a.slope) * sign(b.slope) <= 0 {
            return F::from_f64(0.0);
        }
        let (w1, w2) = (2.0 * b.duration + a.duration, b.duration + 2.0 * a.duration);
        let sum = w1 + w2;
        // Of weights that add up to 1, so that they hold in any unit.
        F::from_f64(1.0) / (F::from_f64(w1 / sum) / a.slope + F::from_f64(w2 / sum) / b.slope)
    };
    let end = |end: &Chord<F>, next: &Chord<F>| {
        let slope = parabola(end, next);
        if sign(slope) * sign(end.slope) <= 0 {
            F::from_f64(0.0)
        } else if sign(end.slope) * sign(next.slope) <= 0
            && slope.value().abs() > 3.0 * end.slope.value().abs()
        {
            end.slope * F::from_f64(3.0)
        } else {
            slope
        }
    };
    along(chords, between, end)
}

/// With what velocity a key is come to and left, between the ways before and after it.
pub(in crate::spline) fn bent<F: Elementary>(before: &Chord<F>, after: &Chord<F>, bend: Bend<F>) -> [F; 2] {
    let one = F::from_f64(1.0);
    let Bend { tension, continuity, bias } = bend;
    let scale = (one - tension) / F::from_f64(before.duration + after.duration);
    let (from, to) = ((one + bias) * before.way, (one - bias) * after.way);
    [
        scale * ((one - continuity) * from + (one + continuity) * to),
        scale * ((one + continuity) * from + (one - continuity) * to),
    ]
}

/// `between` the ways at inner keys, `end` of the outermost way and its neighbour at the ends; the chord of two keys.
fn along<F: Elementary>(
    chords: &[Chord<F>],
    between: impl Fn(&Chord<F>, &Chord<F>) -> F,
    end: impl Fn(&Chord<F>, &Chord<F>) -> F,
) -> Vec<F> {
    match chords {
        [] => Vec::new(),
        [only] => [only.slope; 2].into(),
        [first, second, ..] => {
            let last = chords.len() - 1;
            once(end(first, second))
                .chain(chords.windows(2).map(|pair| between(&pair[0], &pair[1])))
                .chain(once(end(&chords[last], &chords[last - 1])))
                .collect()
        }
    }
}

/// The velocity at the free end of a way, of the parabola through its keys and the next one.
fn parabola<F: Elementary>(end: &Chord<F>, next: &Chord<F>) -> F {
    let share = F::from_f64(end.duration / (end.duration + next.duration));
    end.slope + share * (end.slope - next.slope)
}

/// √|x|, and a root of 0 that has no derivatives, for it would have infinite ones.
fn root<F: Elementary>(x: F) -> F {
    if x.value().abs() > 0.0 { x.abs().sqrt() } else { F::from_f64(0.0) }
}

fn sign<F: Elementary>(x: F) -> i8 {
    i8::from(x.value() > 0.0) - i8::from(x.value() < 0.0)
}
