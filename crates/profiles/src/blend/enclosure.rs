//! Enclosures: bounds of a blend's derivatives within a span of time.

use super::curve::{Blend, Parts};
use super::fade::Side;
use super::interval::Interval;
use super::jet::{complement, constant, difference, product, quotient, sum, weighted};
use crate::answers::Answers;
use crate::clip::Clip;
use alloc::rc::Rc;
use alloc::vec::Vec;

/// A piece of a blend within which nothing jumps, and the motions and the factors of their weights, with their derivatives up
/// to the third, each only rise or only fall: their values at two times have all values between them.
pub(super) struct Piece<'a, C> {
    blend: &'a Blend<C>,
    pub(super) from: f64,
    pub(super) to: f64,
    /// Where, and on which side, the values at both ends are looked up.
    ends: [(f64, Side); 2],
    /// How great each of these is at most.
    largest: Rc<[Part]>,
}

/// One motion with the two factors of its weight.
#[derive(Clone, Copy)]
struct Part {
    curve: [f64; 4],
    factors: [[f64; 4]; 2],
}

/// The relative error that is allowed for in what is computed: relative to the greatest that a motion does, because errors
/// near its zeros are not smaller.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

impl<'a, C: Answers> Piece<'a, C> {
    /// The pieces between these times, which are right to within their [`resolution`].
    pub(super) fn all(blend: &'a Blend<C>, times: &[f64], late: f64) -> Vec<Self> {
        let mut pieces: Vec<Self> = times
            .windows(2)
            .map(|pair| Self {
                blend,
                from: pair[0],
                to: pair[1],
                ends: [(pair[0], Side::After), (pair[1], Side::Before)],
                largest: Rc::new([]),
            })
            .collect();
        let ends = pieces.iter().flat_map(|piece| piece.ends.map(|end| piece.parts(end)));
        let larger = |x: [f64; 4], y: [f64; 4]| core::array::from_fn(|i| f64::max(x[i].abs(), y[i].abs()));
        let larger_part = |(x, y): (Part, Part)| Part {
            curve: larger(x.curve, y.curve),
            factors: [larger(x.factors[0], y.factors[0]), larger(x.factors[1], y.factors[1])],
        };
        let largest = ends.reduce(|all, end| all.into_iter().zip(end).map(larger_part).collect());
        let largest: Rc<[Part]> = largest.unwrap_or_default().into();
        for piece in &mut pieces {
            piece.largest = Rc::clone(&largest);
            piece.settle(late);
        }
        pieces
    }

    /// An end at which a clip jumps is not exactly there in the clip's own time: what is looked up must be on this side of it.
    fn settle(&mut self, late: f64) {
        let inwards =
            [self.from + 2.0 * resolution(self.from, late), self.to - 2.0 * resolution(self.to, late)];
        if inwards[0] >= inwards[1] {
            return;
        }
        for i in 0..2 {
            let inside = (inwards[i], Side::After);
            let (at, beside) = (self.parts(self.ends[i]), self.parts(inside));
            let jumps = |x: &[f64; 4], y: &[f64; 4], largest: &[f64; 4]| {
                (0..4).any(|k| (x[k] - y[k]).abs() > 1e-9 * largest[k])
            };
            let part_jumps = |i: usize| {
                let (x, y, largest): (&Part, &Part, &Part) = (&at[i], &beside[i], &self.largest[i]);
                jumps(&x.curve, &y.curve, &largest.curve)
                    || (0..2).any(|k| jumps(&x.factors[k], &y.factors[k], &largest.factors[k]))
            };
            if (0..at.len()).any(part_jumps) {
                self.ends[i] = inside;
            }
        }
    }

    /// The times at which the values at both ends are looked up.
    pub(super) fn inner(&self) -> [f64; 2] {
        self.ends.map(|end| end.0)
    }

    fn place(&self, time: f64) -> (f64, Side) {
        if time <= self.from {
            self.ends[0]
        } else if time >= self.to {
            self.ends[1]
        } else {
            (time, Side::After)
        }
    }

    /// The derivative of some order at a time; what holds within the piece at its ends.
    pub(super) fn value(&self, order: usize, time: f64) -> f64 {
        let (time, side) = self.place(time);
        self.blend.sample(time, 0.0, side).to_array()[order]
    }

    fn parts(&self, (time, side): (f64, Side)) -> Vec<Part> {
        let curve = |clip: &Clip<C>| clip.sided(time, 0.0, side).to_array();
        match &self.blend.parts {
            Parts::Two([first, second], fade) => {
                let alpha = fade.jet(time, 0.0, side);
                let part = |clip, weight| Part { curve: curve(clip), factors: [weight, constant(1.0)] };
                alloc::vec![part(first, alpha), part(second, complement(alpha))]
            }
            Parts::Many(layers) => layers
                .iter()
                .map(|layer| Part { curve: curve(&layer.clip), factors: layer.factors(time, side) })
                .collect(),
        }
    }

    /// Position and its derivatives at a time, as far as they are known from what is computed.
    pub(super) fn point(&self, time: f64) -> [Interval; 4] {
        let parts = self.parts(self.place(time));
        self.natural(&parts, &parts)
    }

    /// Position and its derivatives within a span: what interval arithmetic gives, and for derivative n also
    ///
    /// ```text
    /// R⁽ⁿ⁾(m) + R⁽ⁿ⁺¹⁾(span)·(span − m)        m in the middle
    /// ```
    pub(super) fn within(&self, from: f64, to: f64) -> [Interval; 4] {
        let mut enclosure = self.natural(&self.parts(self.place(from)), &self.parts(self.place(to)));
        let middle = self.point(0.5 * (from + to));
        let half = 0.5 * (to - from);
        for n in (0..3).rev() {
            if !enclosure[n].is_zero() {
                let spread = enclosure[n + 1] * Interval::hull(-half, half);
                enclosure[n] = enclosure[n].and(middle[n] + spread);
            }
        }
        enclosure
    }

    fn natural(&self, from: &[Part], to: &[Part]) -> [Interval; 4] {
        let weights = self.weights(from, to);
        let zero = constant(Interval::ZERO);
        let mut reference = None;
        let mut blended = zero;
        for i in (0..weights.len()).filter(|&i| weights[i] != zero) {
            let (hull, largest) = (hulls(from[i].curve, to[i].curve), self.largest[i].curve);
            let apart = match reference {
                None => {
                    reference = Some((hull, largest));
                    zero
                }
                Some((other, others)) => {
                    widened(difference(hull, other), core::array::from_fn(|k| largest[k] + others[k]))
                }
            };
            blended = sum(blended, weighted(weights[i], widened(hull, largest), apart));
        }
        blended
    }

    /// The weights, which sum to one.
    fn weights(&self, from: &[Part], to: &[Part]) -> Vec<[Interval; 4]> {
        let factor = |i: usize, k: usize| {
            widened(hulls(from[i].factors[k], to[i].factors[k]), self.largest[i].factors[k])
        };
        match &self.blend.parts {
            Parts::Two(..) => alloc::vec![factor(0, 0), factor(1, 0)],
            Parts::Many(layers) => {
                let zero = constant(Interval::ZERO);
                let weight = |i: usize| {
                    let amount = layers[i].amount;
                    let amount = constant(Interval::hull(amount, amount));
                    product(amount, product(factor(i, 0), factor(i, 1)))
                };
                let weights: Vec<_> = (0..layers.len()).map(weight).collect();
                let total = weights.iter().fold(zero, |total, &weight| sum(total, weight));
                weights.iter().map(|&w| if w == zero { zero } else { quotient(w, total) }).collect()
            }
        }
    }
}

/// How far apart times must be to be told from each other, those of clips that begin as `late` as this among them.
pub(super) fn resolution(time: f64, late: f64) -> f64 {
    8.0 * f64::EPSILON * (time.abs() + late)
}

fn hulls(x: [f64; 4], y: [f64; 4]) -> [Interval; 4] {
    core::array::from_fn(|k| Interval::hull(x[k], y[k]))
}

/// Wider by the rounding errors of numbers that are at most so great; what is exactly zero stays so.
fn widened(x: [Interval; 4], largest: [f64; 4]) -> [Interval; 4] {
    core::array::from_fn(|k| if x[k].is_zero() { x[k] } else { x[k].widened(ROUNDING * largest[k]) })
}
