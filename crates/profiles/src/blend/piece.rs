//! Pieces of a blend within which nothing jumps.

use super::curve::{Blend, Parts};
use super::fade::Side;
use super::jet::{complement, sum, weighted};
use crate::answers::Answers;
use crate::clip::Clip;
use alloc::rc::Rc;
use alloc::vec::Vec;

/// A piece of a blend within which nothing jumps, and the motions and the factors of their weights, with their derivatives up
/// to the third, each only rise or only fall.
pub(super) struct Piece<'a, C> {
    blend: &'a Blend<C>,
    pub(super) from: f64,
    pub(super) to: f64,
    /// Where, and on which side, the values at both ends are looked up.
    ends: [(f64, Side); 2],
    /// How great each motion is at most, with its derivatives.
    largest: Rc<[[f64; 4]]>,
}

/// One motion with its weight before weights are divided by their sum.
type Part = [[f64; 4]; 2];

/// The relative error that is allowed for in what is computed: relative to the greatest that a motion does, because errors
/// near its zeros are not smaller.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

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
        let larger = |x: Part, y: Part| {
            core::array::from_fn(|i| core::array::from_fn(|k| f64::max(x[i][k].abs(), y[i][k].abs())))
        };
        let largest: Vec<Part> = ends
            .reduce(|all, end| all.into_iter().zip(end).map(|(x, y)| larger(x, y)).collect())
            .unwrap_or_default();
        // What is infinite somewhere says nothing of the rest.
        let finite = |x: f64| if x.is_finite() { x } else { 0.0 };
        let curves: Rc<[[f64; 4]]> = largest.iter().map(|part| part[0].map(finite)).collect();
        for piece in &mut pieces {
            piece.largest = Rc::clone(&curves);
            piece.settle(late, &largest);
        }
        pieces
    }

    /// An end at which a clip jumps is not exactly there in the clip's own time: what is looked up must be on this side of it.
    fn settle(&mut self, late: f64, largest: &[Part]) {
        let inwards =
            [self.from + 2.0 * resolution(self.from, late), self.to - 2.0 * resolution(self.to, late)];
        if inwards[0] >= inwards[1] {
            return;
        }
        for i in 0..2 {
            let inside = (inwards[i], Side::After);
            let (at, beside) = (self.parts(self.ends[i]), self.parts(inside));
            let jumps = |part: usize, which: usize| {
                let (x, y, largest) = (at[part][which], beside[part][which], largest[part][which]);
                (0..4).any(|k| (x[k] - y[k]).abs() > 1e-9 * largest[k])
            };
            if (0..at.len()).any(|part| jumps(part, 0) || jumps(part, 1)) {
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

    /// Whether its ends are apart by more than breaks that should be one.
    pub(super) fn is_long(&self) -> bool {
        self.to - self.from > 1e-6 * self.blend.duration
    }

    /// The sign of the derivative of some order at a time, if it can be told from zero.
    pub(super) fn sign(&self, order: usize, time: f64) -> Option<bool> {
        let value = self.value(order, time);
        (value.abs() > self.noise(order, time)).then_some(value > 0.0)
    }

    /// How far the derivative of some order may be off at a time by rounding: what its terms come to, added up.
    pub(super) fn noise(&self, order: usize, time: f64) -> f64 {
        let parts = self.parts(self.place(time));
        let total = parts.iter().fold([0.0; 4], |total, part| sum(total, part[1].map(f64::abs)));
        let all = self.largest.iter().fold([0.0; 4], |all, &one| sum(all, one));
        let terms = parts.iter().zip(self.largest.iter()).map(|(part, &largest)| {
            // Two weights are 1 in sum, and others have their rates and those of their sum.
            let own = part[1].map(f64::abs);
            let weight = match self.blend.parts {
                Parts::Two(..) => own,
                Parts::Many(_) => {
                    core::array::from_fn(|k| (own[k] + own[0] / total[0] * total[k]) / total[0])
                }
            };
            let is_absent = own.iter().all(|&x| x <= 0.0);
            if is_absent { 0.0 } else { weighted(weight, largest, all)[order] }
        });
        ROUNDING * terms.sum::<f64>()
    }

    fn parts(&self, (time, side): (f64, Side)) -> Vec<Part> {
        let curve = |clip: &Clip<C>| clip.sided(time, 0.0, side).to_array();
        match &self.blend.parts {
            Parts::Two([first, second], fade) => {
                let alpha = fade.jet(time, 0.0, side);
                alloc::vec![[curve(first), alpha], [curve(second), complement(alpha)]]
            }
            Parts::Many(layers) => {
                layers.iter().map(|layer| [curve(&layer.clip), layer.weight(time, 0.0, side)]).collect()
            }
        }
    }
}

/// How far apart times must be to be told from each other, those of clips that begin as `late` as this among them.
pub(super) fn resolution(time: f64, late: f64) -> f64 {
    8.0 * f64::EPSILON * (time.abs() + late)
}
