//! The zeros of a derivative of a blend within a piece.

use super::piece::Piece;
use crate::answers::{Answers, Turn};
use crate::roots::bracketed;
use alloc::vec::Vec;

/// What is known about a derivative of a blend within a piece.
pub(super) struct Zeros {
    /// Its zeros within the open piece, rising.
    pub(super) points: Vec<(f64, Turn)>,
    /// Spans over which it is zero, or can't be told from zero.
    pub(super) rests: Vec<(f64, f64)>,
    /// Just inside of both ends of the piece.
    pub(super) ends: [End; 2],
}

impl Zeros {
    /// Whether the derivative can't be told from zero anywhere in the piece, which then is a very short one.
    pub(super) fn is_unclear(&self, to: f64) -> bool {
        self.ends[0].is_zero && self.ends[1].is_zero && self.ends[0].clear >= to
    }
}

/// A derivative near an end of a piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct End {
    /// Whether it is zero there, as far as can be told.
    pub(super) is_zero: bool,
    /// The nearest time at which, as far as can be told, it is not.
    pub(super) clear: f64,
    /// Whether it is positive from the end, or from just after it, to there.
    pub(super) positive: bool,
}

/// Spans of the same length in a piece.
const STEPS: usize = 16;
/// Ever shorter spans at both ends of a piece, where stiff fades do all that they do: each a quarter of the one before.
const SHORTER: i32 = 12;
/// More of a piece than this is no point.
const WIDE: f64 = 1.5 / STEPS as f64;

/// Finds the zeros of the derivative of some order (1 to 3) within a piece: it is looked at at instants in the piece and where the
/// next derivative is zero, so that between two of them it rises or falls and each change of its sign holds one zero. Where it
/// can't be told from zero between two that can, it touches zero or crosses it with a derivative that is zero too.
pub(super) fn zeros<C: Answers>(piece: &Piece<'_, C>, order: usize) -> Zeros {
    let instants = instants(piece, order);
    let signs: Vec<Option<bool>> = instants.iter().map(|&time| piece.sign(order, time)).collect();
    let value = |time| piece.value(order, time);
    let (mut points, mut rests) = (Vec::new(), Vec::new());
    // The last instant that was not zero.
    let mut last: Option<usize> = None;
    let clear = (0..instants.len()).filter(|&i| signs[i].is_some()).map(Some);
    for next in clear.chain([None]) {
        let (first, end) = (last.map_or(0, |last| last + 1), next.unwrap_or(instants.len()));
        if first < end {
            // Zero from one of these instants to the other.
            let (from, to) = (instants[first], instants[end - 1]);
            let is_whole = from <= piece.from && to >= piece.to;
            let is_exact = || instants[first..end].iter().all(|&time| value(time).abs() <= 0.0);
            let is_wide = to - from > WIDE * (piece.to - piece.from);
            if is_wide && (!is_whole || piece.is_long() || is_exact()) {
                let edge = |clear: usize, zero: f64| border(piece, order, instants[clear], zero);
                rests.push((last.map_or(from, |i| edge(i, from)), next.map_or(to, |i| edge(i, to))));
            } else if let (Some(last), Some(next)) = (last, next) {
                let (low, high) = (instants[last], instants[next]);
                let crosses = signs[last] != signs[next];
                let touch = || smallest(value, &instants[first..end]);
                points.push(if crosses {
                    (bracketed(value, low, high), Turn::Reversal)
                } else {
                    (touch(), Turn::Touch)
                });
            }
        } else if let (Some(last), Some(next)) = (last, next)
            && signs[last] != signs[next]
        {
            points.push((bracketed(value, instants[last], instants[next]), Turn::Reversal));
        }
        last = next;
    }
    let end = |is_zero, clear: Option<usize>, otherwise| End {
        is_zero,
        clear: clear.map_or(otherwise, |i| instants[i]),
        positive: clear.and_then(|i| signs[i]).unwrap_or(false),
    };
    let (first, final_) = (signs.iter().position(Option::is_some), signs.iter().rposition(Option::is_some));
    let ends =
        [end(first != Some(0), first, piece.to), end(final_ != Some(instants.len() - 1), final_, piece.from)];
    Zeros { points, rests, ends }
}

/// Instants of a piece, its ends among them, between which the derivative of some order only rises or only falls, as far as a
/// search finds.
fn instants<C: Answers>(piece: &Piece<'_, C>, order: usize) -> Vec<f64> {
    let length = piece.to - piece.from;
    let mut times: Vec<f64> = (1..STEPS).map(|i| piece.from + i as f64 / STEPS as f64 * length).collect();
    let mut short = length / STEPS as f64;
    for _ in 0..SHORTER {
        short *= 0.25;
        times.extend([piece.from + short, piece.to - short]);
    }
    if order < 3 {
        let slope = |time| piece.value(order + 1, time);
        let slopes = instants(piece, order + 1);
        let turns = slopes.windows(2).filter(|pair| (slope(pair[0]) > 0.0) != (slope(pair[1]) > 0.0));
        times.extend(turns.map(|pair| bracketed(slope, pair[0], pair[1])));
    }
    times.retain(|&time| time > piece.from && time < piece.to);
    times.extend([piece.from, piece.to]);
    times.sort_by(f64::total_cmp);
    times.dedup_by(|a, b| *a <= *b);
    times
}

/// Where, between a time at which the derivative is not zero and one at which it is, it becomes so.
fn border<C: Answers>(piece: &Piece<'_, C>, order: usize, mut clear: f64, mut zero: f64) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (clear + zero);
        if piece.sign(order, middle).is_some() {
            clear = middle;
        } else {
            zero = middle;
        }
    }
    zero
}

/// The one of these times at which a function is smallest.
fn smallest(f: impl Fn(f64) -> f64, times: &[f64]) -> f64 {
    let least = times.iter().copied().min_by(|&a, &b| f(a).abs().total_cmp(&f(b).abs()));
    least.unwrap_or_default()
}
