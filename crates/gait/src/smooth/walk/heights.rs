//! Corrections of the body's height: how much each of them lowers the body, and when.
//!
//! One a contact in the middle of a walk, a partition of unity. Where a walk begins and ends a leg that stands goes through an arc that
//! no law of a steady stride has: there knots lie so near to each other that the body follows it, as cubic B-splines.

use super::course::Course;
use super::numbers::{CORRECTION_IN, KNOTS, KNOTS_FROM, WalkNumbers};
use solaris_profiles::step;

/// The corrections of a walk: those of the contacts 0 … n, then those at the knots.
pub(super) struct Heights {
    begin: f64,
    at: f64,
    /// First and last contact that has one of its own.
    contacts: (usize, usize),
    /// Number of contacts.
    count: usize,
    /// Clocks of the knots, and their distance.
    knots: Vec<f64>,
    spacing: f64,
}

impl Heights {
    /// Of a walk whose first stride would last `stride_time` (s, see [`WalkNumbers::knots`]).
    pub(super) fn new(course: &Course, numbers: &WalkNumbers, stride_time: f64) -> Self {
        let (begin, steps) = (course.begin, course.steps);
        let (mut knots, mut contacts, spacing) = (Vec::new(), (0, steps), numbers.knots / stride_time);
        if spacing > 0.0 {
            // A knot's spline reaches over two distances on either side.
            let first = (begin / spacing).ceil() as isize + 2;
            let last = (course.end / spacing).floor() as isize - 2;
            let start_ends = (KNOTS.0 / spacing).round() as isize;
            let end_begins = ((course.steps as f64 - 1.0) / 2.0 + KNOTS.1) / spacing;
            let end_begins = (end_begins.round() as isize).max(start_ends + 1);
            knots = (first..=last)
                .filter(|&j| j <= start_ends || j >= end_begins)
                .map(|j| j as f64 * spacing)
                .collect();
            contacts = (2, steps.saturating_sub(1));
        }
        Self { begin, at: numbers.correction_at, contacts, count: steps + 1, knots, spacing }
    }

    /// How many corrections there are.
    pub(super) fn count(&self) -> usize {
        self.count + self.knots.len()
    }

    /// What the passes begin with: where there are knots, so low that every leg reaches.
    pub(super) fn first_guess(&self) -> Vec<f64> {
        let mut guess = vec![0.0; self.count];
        guess.resize(self.count(), KNOTS_FROM);
        guess
    }

    /// Distance of the knots.
    pub(super) fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Number and clock of the knots.
    pub(super) fn knots(&self) -> impl Iterator<Item = (usize, f64)> {
        self.knots.iter().enumerate().map(|(j, &clock)| (self.count + j, clock))
    }

    /// Whether a contact has a correction of its own.
    pub(super) fn has(&self, contact: usize) -> bool {
        (self.contacts.0..=self.contacts.1).contains(&contact)
    }

    /// Weight of correction `k`.
    pub(super) fn weight(&self, u: f64, k: usize) -> f64 {
        if let Some(knot) = k.checked_sub(self.count) {
            return spline((u - self.knots[knot]) / self.spacing);
        }
        if !self.has(k) {
            return 0.0;
        }
        if k == 0 && u < self.at {
            return step::quintic((u - self.begin) / CORRECTION_IN).position;
        }
        let x = 2.0 * (u - 0.5 * k as f64 - self.at);
        if x < 0.0 { step::quintic(x + 1.0).position } else { 1.0 - step::quintic(x).position }
    }

    /// The corrections that are not zero anywhere in `u ± reach`.
    pub(super) fn near(&self, u: f64, reach: f64) -> impl Iterator<Item = usize> {
        let steps = self.count - 1;
        let number = |u: f64| (2.0 * (u - self.at)).floor().clamp(-1.0, steps as f64);
        let (from, to) = (number(u - reach).max(0.0), number(u + reach) + 1.0);
        let contacts = (from as usize..=(to as usize).min(steps)).filter(|&k| self.has(k));
        let reach = reach + 2.0 * self.spacing;
        let first = self.knots.partition_point(|knot| *knot <= u - reach);
        let end = self.knots.partition_point(|knot| *knot < u + reach);
        contacts.chain(self.count + first..self.count + end)
    }

    /// Gives knots at which no leg says anything (NaN) what lies between those of their neighbours, nothing where there is none.
    pub(super) fn bridge(&self, corrections: &mut [f64], told: &[bool]) {
        let near = |a: usize, b: usize| (self.knots[b] - self.knots[a]) < 1.5 * self.spacing;
        let known = |j: usize| told[self.count + j];
        for j in 0..self.knots.len() {
            if known(j) {
                continue;
            }
            let before = (0..j).rev().take_while(|&i| near(i, i + 1)).find(|&i| known(i));
            let after = (j + 1..self.knots.len()).take_while(|&i| near(i - 1, i)).find(|&i| known(i));
            let of = |i: Option<usize>| i.map_or(0.0, |i| corrections[self.count + i]);
            let at = |i: Option<usize>, end: f64| i.map_or(end, |i| self.knots[i]);
            let (from, to) = (
                at(before, self.knots[j] - 2.0 * self.spacing),
                at(after, self.knots[j] + 2.0 * self.spacing),
            );
            let part = (self.knots[j] - from) / (to - from);
            let between = of(before) + (of(after) - of(before)) * part;
            corrections[self.count + j] = between;
        }
    }
}

/// The cardinal cubic B-spline: integer shifts of it add up to 1.
fn spline(x: f64) -> f64 {
    let x = x.abs();
    let (inner, outer) = ((1.0 - x).max(0.0), (2.0 - x).max(0.0));
    (outer.powi(3) - 4.0 * inner.powi(3)) / 6.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::smooth::walk::course::Step;

    fn heights(steps: usize, numbers: &WalkNumbers) -> Heights {
        let steps = vec![Step { pace: 0, length: 0.7, turn: 0.0 }; steps];
        Heights::new(&Course::new(&steps, -0.5), numbers, 1.1)
    }

    #[test]
    fn what_is_not_near_has_no_weight() {
        for numbers in [WalkNumbers::recipe(), WalkNumbers::default()] {
            for steps in [1, 2, 3, 10] {
                let heights = heights(steps, &numbers);
                for i in -100..1000 {
                    let u = 0.01 * f64::from(i);
                    let near: Vec<usize> = heights.near(u, 0.03).collect();
                    for k in (0..heights.count()).filter(|k| !near.contains(k)) {
                        for v in [u - 0.03, u, u + 0.03] {
                            assert!(heights.weight(v, k).abs() < 1e-12, "{steps} steps, {u}: {k}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn weights_add_up_to_one_between_the_ends() {
        let heights = heights(10, &WalkNumbers::recipe());
        for i in 0..500 {
            let u = -0.1 + 0.01 * f64::from(i);
            let sum: f64 = (0..heights.count()).map(|k| heights.weight(u, k)).sum();
            assert!((sum - 1.0).abs() < 1e-12, "{u}: {sum}");
        }
    }
}
