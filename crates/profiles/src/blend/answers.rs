//! The answers about a whole blend: stationary points, peaks.

use super::breaks::breaks;
use super::curve::Blend;
use super::fade::{Fade, Side};
use super::piece::{Piece, resolution};
use super::zeros::{End, Zeros, zeros};
use crate::answers::{Answers, Quantity, Stationary, Turn};
use crate::roots::bracketed;
use alloc::vec::Vec;

/// Blends have no closed forms: their velocity and acceleration are looked at at some instants of each piece within which nothing
/// jumps, at more of them near its ends, and where the next derivative is zero; each change of sign is brought to the last digits.
/// Two zeros between neighbouring instants at which no derivative shows them are missed. Where velocity and acceleration vanish
/// together, or nearly so that rounding hides the difference, one [`Turn::Touch`] or one [`Turn::Reversal`] is reported; and where
/// the velocity cannot be told from zero over a span, that span is a rest. A motion that turns round across a rest has a reversal
/// where the rest begins.
///
/// Answers about the jerk come from a search among 64 instants in each piece, refined.
impl<C: Answers> Answers for Blend<C> {
    fn stationary(&self) -> Stationary {
        let pieces = self.pieces();
        let found: Vec<_> = pieces.iter().map(|piece| zeros(piece, 1)).collect();
        let mut points = Vec::new();
        let mut rests: Vec<(f64, f64)> = Vec::new();
        for zeros in &found {
            points.extend(zeros.points.iter().copied());
            for &(from, to) in &zeros.rests {
                match rests.last_mut() {
                    Some(last) if last.1 >= from => last.1 = to,
                    _ => rests.push((from, to)),
                }
            }
        }
        // Where two breaks should be one but for rounding, what is between them says nothing.
        let clear = |&i: &usize| !found[i].is_unclear(pieces[i].to);
        let clear: Vec<usize> = (0..pieces.len()).filter(clear).collect();
        for pair in clear.windows(2) {
            let (left, right) = (pair[0], pair[1]);
            let time = pieces[right].from;
            // Rests rise and are apart.
            let rest = rests.partition_point(|rest| rest.1 < time);
            if rests.get(rest).is_none_or(|rest| rest.0 > time) {
                let ends = (found[left].ends[1], found[right].ends[0]);
                points.extend(knot((&pieces[left], ends.0), (&pieces[right], ends.1)));
            }
        }
        for &(from, to) in rests.iter().filter(|rest| rest.0 > 0.0 && rest.1 < self.duration) {
            let before = clear.partition_point(|&i| pieces[i].from < from).checked_sub(1);
            let before = before.map(|i| found[clear[i]].ends[1].positive);
            let after = clear.get(clear.partition_point(|&i| pieces[i].to <= to));
            let after = after.map(|&i| found[i].ends[0].positive);
            if before != after {
                points.push((from, Turn::Reversal));
            }
        }
        Stationary { rests, ..Stationary::at(points, self.duration) }
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        let order = match quantity {
            Quantity::Position => 1,
            Quantity::Velocity => 2,
            Quantity::Acceleration => 3,
            Quantity::Jerk => {
                let ends = |piece: &Piece<'_, C>| extremes(piece).into_iter().chain(near_ends(piece));
                return self.pieces().iter().flat_map(ends).collect();
            }
        };
        let mut times = Vec::new();
        for piece in self.pieces() {
            let Zeros { points, rests, ends } = zeros(&piece, order);
            times.extend([piece.from, ends[0].clear, ends[1].clear]);
            times.extend(piece.inner());
            times.extend(points.into_iter().map(|(time, _)| time));
            times.extend(rests.into_iter().flat_map(|(from, to)| [from, to]));
        }
        times.retain(|&time| time > 0.0 && time < self.duration);
        times.sort_by(f64::total_cmp);
        times.dedup_by(|a, b| *a <= *b);
        times
    }

    /// Where pieces meet, and where derivatives are zero within them: not the times beside these at which values are looked up, nor
    /// where only rounding makes something turn, since each would be a break of whatever this blend is a part of, and of its pieces
    /// there would be a multiple at each depth.
    fn breaks(&self) -> Vec<f64> {
        let mut times = Vec::new();
        for piece in self.pieces() {
            times.push(piece.from);
            for order in 1..=3 {
                let Zeros { points, rests, .. } = zeros(&piece, order);
                times.extend(points.into_iter().map(|(time, _)| time));
                times.extend(rests.into_iter().flat_map(|(from, to)| [from, to]));
            }
            times.extend(extremes(&piece));
        }
        times.retain(|&time| time > 0.0 && time < self.duration);
        times.sort_by(f64::total_cmp);
        times.dedup_by(|a, b| *a <= *b);
        times
    }
}

impl<C: Answers> Blend<C> {
    fn pieces(&self) -> Vec<Piece<'_, C>> {
        let mut times: Vec<f64> = self.fades().flat_map(Fade::breaks).collect();
        for clip in self.clips() {
            breaks(clip, self.duration, &mut times);
        }
        times.retain(|&time| time > 0.0 && time < self.duration);
        times.extend([0.0, self.duration]);
        times.sort_by(f64::total_cmp);
        let late = self.clips().fold(0.0, |late, clip| f64::max(late, clip.start().abs()));
        // Of times that should be one but for rounding, the one at which more jumps.
        let sample = |time, side| self.sample(time, 0.0, side).to_array();
        let jump = |time: f64| -> f64 {
            let (before, after) = (sample(time, Side::Before), sample(time, Side::After));
            before.iter().zip(after).map(|(before, after)| (before - after).abs()).sum()
        };
        times.dedup_by(|next, kept| {
            let same = *next - *kept <= resolution(*next, late);
            if same && *kept > 0.0 && jump(*next) > jump(*kept) {
                *kept = *next;
            }
            same
        });
        if let Some(last) = times.last_mut() {
            *last = self.duration;
        }
        Piece::all(self, &times, late)
    }
}

/// The stationary point at the time at which two pieces meet, if there is one, from what is before and after.
fn knot<C: Answers>(
    (left, before): (&Piece<'_, C>, End),
    (right, after): (&Piece<'_, C>, End),
) -> Option<(f64, Turn)> {
    let (time, turns) = (right.from, before.positive != after.positive);
    if !before.is_zero && !after.is_zero {
        return turns.then_some((time, Turn::Reversal));
    }
    // The zero may lie beside the time, by as much as could not be told from zero.
    let order = if turns { 1 } else { 2 };
    let value = |t: f64| if t < time { left.value(order, t) } else { right.value(order, t) };
    let changes = (value(before.clear) > 0.0) != (value(after.clear) > 0.0);
    let time = if changes { bracketed(value, before.clear, after.clear) } else { time };
    Some((time, if turns { Turn::Reversal } else { Turn::Touch }))
}

/// Instants at which the jerk is looked at in a piece.
const STEPS: usize = 64;

/// Where the jerk is greatest or smallest within a piece, as far as a search finds.
fn extremes<C: Answers>(piece: &Piece<'_, C>) -> Vec<f64> {
    let length = piece.to - piece.from;
    let time = |i: usize| piece.from + i as f64 / STEPS as f64 * length;
    let jerk = |time| piece.value(3, time);
    let jerks: Vec<f64> = (0..=STEPS).map(|i| jerk(time(i))).collect();
    let mut times = Vec::new();
    for i in 1..STEPS {
        let (rises, falls) = (jerks[i] - jerks[i - 1], jerks[i] - jerks[i + 1]);
        // A jerk that stays the same but for rounding has no greatest.
        let clear = |change: f64| change.abs() > piece.noise(3, time(i));
        if rises * falls >= 0.0 && (clear(rises) || clear(falls)) {
            let sign = if rises + falls > 0.0 { 1.0 } else { -1.0 };
            times.push(golden(|time| sign * jerk(time), time(i - 1), time(i + 1)));
        }
    }
    times
}

/// Where the jerk is greatest or smallest near the ends of a piece: it may turn unseen beside them.
fn near_ends<C: Answers>(piece: &Piece<'_, C>) -> Vec<f64> {
    let time = |i: usize| piece.from + i as f64 / STEPS as f64 * (piece.to - piece.from);
    let jerk = |time| piece.value(3, time);
    let mut times: Vec<f64> = piece.inner().into();
    times.extend([piece.from, piece.to]);
    for (from, to) in [(time(0), time(1)), (time(STEPS - 1), time(STEPS))] {
        times.extend([1.0, -1.0].map(|sign| golden(|time| sign * jerk(time), from, to)));
    }
    times
}

/// Where a function is greatest between two times, if it rises first and falls then.
fn golden(f: impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> f64 {
    const RATIO: f64 = 0.618_033_988_749_894_8;
    for _ in 0..80 {
        let reach = RATIO * (to - from);
        let (left, right) = (to - reach, from + reach);
        if f(left) < f(right) {
            from = left;
        } else {
            to = right;
        }
    }
    0.5 * (from + to)
}
