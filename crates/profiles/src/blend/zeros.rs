//! The zeros of a derivative of a blend within a piece.

use super::enclosure::Piece;
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

/// More spans at once than this cannot be told from zero one by one.
const MANY: usize = 4096;

/// Finds the zeros of the derivative of some order (1 to 3) within a piece by interval arithmetic: spans in which it cannot be
/// zero are discarded, those in which it only rises or only falls hold one zero or none, the others are halved until they are
/// as small as rounding errors allow; what is left then touches zero, or crosses it with a derivative that is zero too.
pub(super) fn zeros<C: Answers>(piece: &Piece<'_, C>, order: usize) -> Zeros {
    Search {
        piece,
        order,
        points: Vec::new(),
        rests: Vec::new(),
        open: Vec::new(),
        ends: [piece.from, piece.to].map(|time| End {
            is_zero: piece.point(time)[order].contains_zero(),
            clear: time,
            positive: false,
        }),
    }
    .run()
}

struct Search<'a, 'b, C> {
    piece: &'a Piece<'b, C>,
    order: usize,
    points: Vec<(f64, Turn)>,
    rests: Vec<(f64, f64)>,
    /// Spans about which nothing more can be said.
    open: Vec<(f64, f64)>,
    ends: [End; 2],
}

impl<C: Answers> Search<'_, '_, C> {
    fn run(mut self) -> Zeros {
        let mut spans = alloc::vec![(self.piece.from, self.piece.to)];
        let mut is_crowded = false;
        while !spans.is_empty() {
            is_crowded = is_crowded || spans.len() > MANY;
            spans = spans.into_iter().flat_map(|span| self.look(span, is_crowded)).flatten().collect();
        }
        self.open.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut together: Vec<(f64, f64)> = Vec::new();
        for &(from, to) in &self.open {
            match together.last_mut() {
                Some(last) if last.1 >= from => last.1 = to,
                _ => together.push((from, to)),
            }
        }
        // What cannot be told from zero beside a rest is of the rest.
        let beside = |span: &(f64, f64), rests: &[(f64, f64)]| {
            rests.iter().any(|rest| rest.0 <= span.1 && span.0 <= rest.1)
        };
        for span in together {
            if beside(&span, &self.rests) {
                self.rests.push(span);
            } else {
                self.settle(span, is_crowded);
            }
        }
        self.points.sort_by(|a, b| a.0.total_cmp(&b.0));
        self.rests.sort_by(|a, b| a.0.total_cmp(&b.0));
        for i in 0..2 {
            self.ends[i].positive = self.is_positive(self.ends[i].clear);
        }
        Zeros { points: self.points, rests: self.rests, ends: self.ends }
    }

    /// Decides about a span, or halves it.
    fn look(&mut self, (from, to): (f64, f64), is_crowded: bool) -> [Option<(f64, f64)>; 2] {
        let enclosure = self.piece.within(from, to);
        let middle = 0.5 * (from + to);
        let found = enclosure[self.order];
        if !found.contains_zero() {
            return [None; 2];
        }
        if found.is_zero() {
            self.rests.push((from, to));
            return [None; 2];
        }
        if self.order < 3 && !enclosure[self.order + 1].contains_zero() {
            self.cross(from, to);
            return [None; 2];
        }
        let error = self.piece.point(middle)[self.order];
        let is_small = error.contains_zero() && found.width() <= 8.0 * error.width();
        let is_smallest = to - from <= 4.0 * f64::EPSILON * to.max(self.piece.to - self.piece.from);
        if is_small || is_smallest || is_crowded || middle <= from || middle >= to {
            self.open.push((from, to));
            return [None; 2];
        }
        [Some((from, middle)), Some((middle, to))]
    }

    /// A span in which the derivative only rises or only falls.
    fn cross(&mut self, from: f64, to: f64) {
        let at_start = from <= self.piece.from && self.ends[0].is_zero;
        let at_end = to >= self.piece.to && self.ends[1].is_zero;
        // A zero at the end of the piece is the one of the span.
        if at_start {
            self.ends[0].clear = to;
        }
        if at_end {
            self.ends[1].clear = from;
        }
        if !at_start && !at_end && self.is_positive(from) != self.is_positive(to) {
            self.points.push((self.zero(self.order, from, to), Turn::Reversal));
        }
    }

    /// A span in which the derivative and the next one may both be zero.
    fn settle(&mut self, (from, to): (f64, f64), is_crowded: bool) {
        if is_crowded {
            let nowhere = |i: u32| {
                let time = from + f64::from(i) / 16.0 * (to - from);
                self.piece.point(time)[self.order].contains_zero()
            };
            if (0..=16).all(nowhere) {
                self.rests.push((from, to));
                return;
            }
        }
        let (at_start, at_end) = (from <= self.piece.from, to >= self.piece.to);
        if at_start {
            self.ends[0] = End { is_zero: true, clear: to, positive: false };
        }
        if at_end {
            self.ends[1] = End { is_zero: true, clear: from, positive: false };
        }
        if !at_start && !at_end {
            self.points.push(self.point(from, to));
        }
    }

    fn point(&self, from: f64, to: f64) -> (f64, Turn) {
        if self.is_positive(from) != self.is_positive(to) {
            return (self.zero(self.order, from, to), Turn::Reversal);
        }
        let slope = |time| self.piece.value((self.order + 1).min(3), time);
        let turns = (slope(from) > 0.0) != (slope(to) > 0.0);
        let time = if turns { bracketed(slope, from, to) } else { 0.5 * (from + to) };
        (time, Turn::Touch)
    }

    fn is_positive(&self, time: f64) -> bool {
        self.piece.value(self.order, time) > 0.0
    }

    fn zero(&self, order: usize, from: f64, to: f64) -> f64 {
        bracketed(|time| self.piece.value(order, time), from, to)
    }
}
