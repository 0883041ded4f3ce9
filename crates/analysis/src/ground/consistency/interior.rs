//! The least path within bounds, by an interior-point method.

use crate::ground::consistency::sweep::{Cost, Path, Sweep};
use nalgebra::{SMatrix, SVector};

/// Slacks and multipliers begin no smaller than this (m), nor than what is broken at first: from within, steps get further.
const START: f64 = 0.01;
/// What a metre beyond a limit costs, over what a metre of the path does: so much that a limit holds where it can, and, if
/// it cannot, so much that the sides still do.
const LIMIT_COSTS: [f64; 2] = [1e9, 1e3];
/// How much further (m) than asked the path may go: a limit yields by so much before it counts as not held.
pub(super) const YIELD: f64 = 1e-6;
/// Most rounds of finding where a limit matters.
const ROUNDS: usize = 12;
/// Beyond this share of its limit a place gets a bound, once any place is beyond the whole.
const NEAR_LIMIT: f64 = 0.5;
/// How much stiffer than the path itself a side may be in a step, so that the step stays defined: what is left is the next
/// step's.
const SIDE_COST: f64 = 1e12;
/// Where limits do not hold, how small the gap must be next to what that costs.
const GAP: f64 = 1e-14;
/// Share of the way to the nearest bound that a step goes.
const NEAR: f64 = 0.995;
/// An iteration that leaves both the gap and what is broken above this share of their least so far has got nowhere.
const PROGRESS: f64 = 0.9;
/// Part of the gap that a step aims at after an iteration that got nowhere.
const CENTRE: f64 = 0.3;

/// What a bound is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Of {
    /// A frame's second difference; it has to hold.
    Second,
    /// A frame's place; it gives way where it must.
    Place,
}

/// A bound of a frame: `along · x ≤ reach` (m).
#[derive(Clone, Copy, Debug)]
pub(super) struct Side<const D: usize> {
    pub(super) of: Of,
    pub(super) frame: usize,
    pub(super) along: SVector<f64, D>,
    pub(super) reach: f64,
}

impl<const D: usize> Side<D> {
    fn along(&self, path: &Path<D>) -> f64 {
        let of = if self.of == Of::Place { &path.place } else { &path.second };
        self.along.dot(&of[self.frame])
    }
}

/// `½ Σ (|δ_k|² + smooth·|a_k|²)` is to be least where every side holds and `|δ_k| ≤ limits[k]`.
#[derive(Clone, Debug)]
pub(super) struct Problem<const D: usize> {
    pub(super) frames: usize,
    pub(super) smooth: f64,
    pub(super) sides: Vec<Side<D>>,
    /// Lengths (m), one a frame, or none at all.
    pub(super) limits: Vec<f64>,
}

/// How a problem was solved.
#[derive(Clone, Debug)]
pub(super) struct Solution<const D: usize> {
    pub(super) path: Path<D>,
    pub(super) iterations: usize,
    pub(super) converged: bool,
}

impl<const D: usize> Problem<D> {
    /// The least path that keeps within the limits, or if there is none, that goes beyond them by as little as can be.
    ///
    /// A limit is the half-planes that touch its circle: wherever the path has gone too far it gets one, and the path is
    /// sought again, until none is missing. Where nothing needs to move the answer is exactly zero.
    pub(super) fn solve(&self, iterations: usize, tolerance: f64) -> Solution<D> {
        let mut solution = Solution { path: Path::still(self.frames), iterations: 0, converged: true };
        if self.sides.iter().all(|side| side.reach >= 0.0) {
            return solution;
        }
        let mut sides = self.sides.clone();
        for cost in LIMIT_COSTS {
            for _ in 0..ROUNDS {
                let before = solution.iterations;
                solution = self.minimise(&sides, cost, iterations, tolerance);
                solution.iterations += before;
                let mut reached = solution.path.place.iter().zip(&self.limits);
                if reached.all(|(place, limit)| place.norm() <= limit + YIELD) {
                    return solution;
                }
                let known = sides.len();
                self.touch(&solution.path, &mut sides);
                if sides.len() == known || !solution.converged {
                    break;
                }
            }
        }
        solution
    }

    /// Adds the bounds that the path shows to be missing.
    fn touch(&self, path: &Path<D>, sides: &mut Vec<Side<D>>) {
        let mut held = vec![f64::NEG_INFINITY; self.frames];
        for side in sides.iter().filter(|side| side.of == Of::Place) {
            held[side.frame] = held[side.frame].max(side.along(path));
        }
        for (frame, (place, limit)) in path.place.iter().zip(&self.limits).enumerate() {
            let length = place.norm();
            if length > NEAR_LIMIT * limit + YIELD && held[frame] < length - 0.5 * YIELD {
                sides.push(Side { of: Of::Place, frame, along: place / length, reach: *limit });
            }
        }
    }

    /// Mehrotra's predictor and corrector. With slacks `s` and multipliers `λ`, Newton's step on
    ///
    /// ```text
    /// ∇f + ∇gᵀλ = 0     g + s = λ/κ (places), 0 (second differences)     s·λ = σμ
    /// ```
    ///
    /// with `κ` = `cost`, comes down to a least path without bounds ([`Sweep`]) in which every bound weighs `λ/(s + λ/κ)`; in
    /// the step alone, second differences have a `κ` as well (`SIDE_COST`). It has
    /// converged when every bound holds within `tolerance` (m), the last step moved nothing by more, and `Σ s·λ`, which bounds
    /// what could still be gained, leaves no path further away than `tolerance` by root of the sum of squares. An iteration that gets nowhere is followed by a plain step towards the middle, since the corrector can go
    /// round in circles.
    fn minimise(&self, sides: &[Side<D>], cost: f64, iterations: usize, tolerance: f64) -> Solution<D> {
        let mut path = Path::still(self.frames);
        let count = sides.len();
        let give: Vec<f64> = sides.iter().map(|side| self.give(side, cost)).collect();
        let mut way = path.clone();
        let mut sweep = Sweep::new();
        let mut costs = Vec::with_capacity(self.frames);
        let start = sides.iter().fold(START, |worst, side| worst.max(-side.reach));
        let mut slack: Vec<f64> = sides.iter().map(|side| side.reach.max(start)).collect();
        let mut force = vec![start; count];
        let (mut rest, mut target) = (vec![0.0; count], vec![0.0; count]);
        let mut steps = vec![(0.0, 0.0); count];
        let (mut moved, mut least) = (f64::INFINITY, [f64::INFINITY; 2]);
        for iteration in 0..=iterations {
            for i in 0..count {
                let given = if sides[i].of == Of::Place { force[i] * give[i] } else { 0.0 };
                rest[i] = sides[i].along(&path) - sides[i].reach + slack[i] - given;
                target[i] = slack[i] * force[i];
            }
            let gap: f64 = target.iter().sum();
            let broken = rest.iter().fold(0.0, |worst: f64, rest| worst.max(rest.abs()));
            let beyond: f64 = (self.sides.len()..count).map(|i| 0.5 * force[i] * force[i] * give[i]).sum();
            let settled = broken.max(moved) <= tolerance && gap <= 0.5 * tolerance * tolerance + GAP * beyond;
            if settled || iteration == iterations || !gap.is_finite() {
                return Solution { path, iterations: iteration, converged: settled };
            }
            let progress = gap < PROGRESS * least[0] || broken < PROGRESS * least[1];
            least = [least[0].min(gap), least[1].min(broken)];
            self.weigh(sides, [&slack, &force, &give], &mut costs);
            if sweep.factor(&costs).is_none() {
                return Solution { path, iterations: iteration, converged: false };
            }
            let mut length = 0.0;
            for corrects in [false, true] {
                self.pull(sides, &path, [&slack, &force, &give, &rest, &target], &mut costs);
                sweep.solve(&costs, &mut way);
                for i in 0..count {
                    let along = sides[i].along(&way);
                    let push = (force[i] * (rest[i] + along) - target[i]) / (slack[i] + force[i] * give[i]);
                    steps[i] = (push * give[i] - rest[i] - along, push);
                }
                length = longest(&steps, &slack, &force);
                if !corrects && progress {
                    let ahead =
                        |i: usize| (slack[i] + length * steps[i].0) * (force[i] + length * steps[i].1);
                    let left = (0..count).map(ahead).sum::<f64>() / gap;
                    let centre = left.powi(3) * gap / count as f64;
                    for i in 0..count {
                        target[i] += steps[i].0 * steps[i].1 - centre;
                    }
                } else if !corrects {
                    let by = CENTRE * gap / count as f64;
                    for target in &mut target {
                        *target -= by;
                    }
                }
            }
            let length = (NEAR * length).min(1.0);
            moved = way.place.iter().fold(0.0, |worst: f64, way| worst.max(way.norm()));
            if !moved.is_finite() {
                return Solution { path, iterations: iteration, converged: false };
            }
            for i in 0..count {
                slack[i] += length * steps[i].0;
                force[i] += length * steps[i].1;
            }
            path.advance(length, &way);
        }
        Solution { path, iterations, converged: false }
    }

    /// How far (m) a bound gives way to a unit of its multiplier, within a step.
    fn give(&self, side: &Side<D>, cost: f64) -> f64 {
        match side.of {
            Of::Second => side.along.norm_squared() / (SIDE_COST * self.smooth),
            Of::Place => 1.0 / cost,
        }
    }

    /// The matrices of the step.
    fn weigh(&self, sides: &[Side<D>], [slack, force, give]: [&[f64]; 3], costs: &mut Vec<Cost<D>>) {
        let (one, none) = (SMatrix::identity(), SVector::zeros());
        let still = Cost { place: one, place_pull: none, second: one * self.smooth, second_pull: none };
        costs.clear();
        costs.resize(self.frames, still);
        for (i, side) in sides.iter().enumerate() {
            let cost = &mut costs[side.frame];
            let matrix = if side.of == Of::Place { &mut cost.place } else { &mut cost.second };
            *matrix += side.along * side.along.transpose() * (force[i] / (slack[i] + force[i] * give[i]));
        }
    }

    /// The linear part of the step.
    fn pull(
        &self,
        sides: &[Side<D>],
        path: &Path<D>,
        [slack, force, give, rest, target]: [&[f64]; 5],
        costs: &mut [Cost<D>],
    ) {
        for (frame, cost) in costs.iter_mut().enumerate() {
            cost.place_pull = path.place[frame];
            cost.second_pull = path.second[frame] * self.smooth;
        }
        for (i, side) in sides.iter().enumerate() {
            let cost = &mut costs[side.frame];
            let pull = if side.of == Of::Place { &mut cost.place_pull } else { &mut cost.second_pull };
            let push = (force[i] * rest[i] - target[i]) / (slack[i] + force[i] * give[i]);
            *pull += side.along * (force[i] + push);
        }
    }
}

/// The longest part, at most the whole, of a step that keeps slacks and multipliers from turning negative.
fn longest(steps: &[(f64, f64)], slack: &[f64], force: &[f64]) -> f64 {
    let mut length = 1.0_f64;
    for ((step, slack), force) in steps.iter().zip(slack).zip(force) {
        for (step, from) in [(step.0, slack), (step.1, force)] {
            if step < 0.0 {
                length = length.min(-from / step);
            }
        }
    }
    length
}
