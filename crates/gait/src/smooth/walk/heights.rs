//! Corrections of the body's height: how much each of them lowers the body, and when.
//!
//! One a contact in the middle of a walk, a partition of unity. Where a walk begins and ends a leg that stands goes through an arc that
//! no law of a steady stride has: there knots lie so near to each other that the body follows it, as cubic B-splines. On ground that is not
//! level they lie all along.

use super::course::Course;
use super::numbers::{
    BOUND_ATTEMPTS, BOUND_MISSED, BOUND_WEIGHT, CORRECTION, CORRECTION_IN, GROUND_BOUNDS, GROUND_CORRECTIONS,
    KNOT_SHARE, KNOTS, KNOTS_FROM, KNOTS_STEPS, SMOOTHING, WalkNumbers,
};
use crate::smooth::band::Band;
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
    /// Where a correction at a knot may lie (m).
    knot_range: (f64, f64),
    /// How often bounds are made to hold, each time so many times as much.
    bounds: (usize, f64),
}

impl Heights {
    /// Of a walk whose first stride would last `stride_time` (s, see [`WalkNumbers::knots`]).
    pub(super) fn new(course: &Course, numbers: &WalkNumbers, stride_time: f64) -> Self {
        let (begin, steps) = (course.begin, course.steps);
        let (mut knots, mut contacts, mut spacing) = (Vec::new(), (0, steps), numbers.knots / stride_time);
        if spacing > 0.0 {
            // A knot's spline reaches over two distances on either side. Knots fall on the first contact, and on the last one.
            let (start, end) = (0.5, 0.5 * steps as f64);
            let end_begins = end - 0.5 * (1.0 + KNOTS_STEPS as f64) + KNOTS.1;
            let meet = numbers.knots_throughout || end_begins < KNOTS.0 + spacing;
            if meet && steps > 1 {
                spacing = (end - start) / ((end - start) / spacing).round();
            }
            let reach = 2.0 * spacing;
            let first = ((begin + reach - start) / spacing).ceil() as isize;
            let last = ((course.end - reach - end) / spacing).floor() as isize;
            let until = if meet { end - 0.5 * spacing } else { KNOTS.0 };
            let from = if meet { end } else { end_begins };
            knots.extend((first..).map(|j| start + j as f64 * spacing).take_while(|&u| u <= until));
            let back = ((end - from) / spacing).floor() as isize;
            knots.extend((-back..=last).map(|j| end + j as f64 * spacing));
            contacts =
                if numbers.knots_throughout { (1, 0) } else { (2, steps.saturating_sub(1 + KNOTS_STEPS)) };
        }
        let (knot_range, bounds) = if numbers.knots_throughout {
            (GROUND_CORRECTIONS, GROUND_BOUNDS)
        } else {
            ((CORRECTION.2, CORRECTION.3), BOUND_ATTEMPTS)
        };
        let at = numbers.correction_at;
        Self { begin, at, contacts, count: steps + 1, knots, spacing, knot_range, bounds }
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

    /// Lowers and raises the body by what a pass has found: at the knots as smoothly as may be,
    ///
    /// ```text
    /// Σ wᵢ (cᵢ − tᵢ)² + λ Σ (cᵢ₋₁ − 2 cᵢ + cᵢ₊₁)²  least,  cᵢ ≥ lᵢ      nothing before and after the knots
    /// ```
    ///
    /// where a leg says `tᵢ` (w up to 1) or nothing (w 0), and must reach where it lands (l).
    pub(super) fn correct(&self, corrections: &mut [f64], needs: &Needs) {
        let (share, most, lower, upper) = CORRECTION;
        let corrected = |correction: f64, need: f64, share: f64, (lower, upper): (f64, f64)| {
            (correction + (share * need).clamp(-most, most)).clamp(lower, upper)
        };
        for contact in (0..self.count).filter(|&contact| self.has(contact)) {
            corrections[contact] =
                corrected(corrections[contact], needs.told[contact], share, (lower, upper));
        }
        let before = corrections[self.count..].to_vec();
        let wanted = |needs: &[f64]| -> Vec<Option<f64>> {
            let needs = needs[self.count..].iter().zip(&before);
            needs
                .map(|(need, at)| {
                    need.is_finite().then(|| corrected(*at, *need, KNOT_SHARE, self.knot_range))
                })
                .collect()
        };
        let least = wanted(&needs.least);
        let weights = needs.weight[self.count..].iter();
        let mut told: Vec<(f64, f64)> = wanted(&needs.told)
            .into_iter()
            .zip(weights)
            .map(|(told, weight)| told.map_or((0.0, 0.0), |told| (told, *weight)))
            .collect();
        let wishes = told.clone();
        let (attempts, growth) = self.bounds;
        let mut bound = BOUND_WEIGHT;
        for _ in 0..attempts {
            let smooth = self.smooth(&told);
            let mut held = true;
            for (knot, (value, least)) in smooth.iter().zip(&least).enumerate() {
                corrections[self.count + knot] = *value;
                if let Some(least) = least.filter(|least| *value < least - BOUND_MISSED) {
                    // Beside what is told: where the bound is just met, it changes nothing.
                    let (target, weight) = wishes[knot];
                    let sum = weight + bound;
                    told[knot] = ((target * weight + least * bound) / sum, sum);
                    held = false;
                }
            }
            bound *= growth;
            if held {
                break;
            }
        }
    }

    /// The smoothest corrections through what is told, each stretch of knots by itself.
    fn smooth(&self, told: &[(f64, f64)]) -> Vec<f64> {
        let mut all = Vec::with_capacity(told.len());
        while all.len() < told.len() {
            let from = all.len();
            let gap =
                (from + 1..told.len()).find(|&k| self.knots[k] - self.knots[k - 1] > 1.5 * self.spacing);
            let told = &told[from..gap.unwrap_or(told.len())];
            // DᵀD of second differences that also see the zeros beyond both ends.
            let rows = told.iter().enumerate().map(|(i, (_, weight))| {
                let of = |back: usize, value: f64| if i >= back { SMOOTHING * value } else { 0.0 };
                [0.0, of(2, 1.0), of(1, -4.0), SMOOTHING * 6.0 + weight]
            });
            let factor = Band::factor(rows.collect());
            let mut right: Vec<[f64; 1]> = told.iter().map(|(told, weight)| [told * weight]).collect();
            factor.solve(&mut right);
            all.extend(right.iter().map(|value| value[0]));
        }
        all
    }
}

/// How far the body is above what the legs reach, by correction: below zero where height is to spare, minus infinity where no leg says
/// anything.
pub(super) struct Needs {
    /// What is to become zero.
    pub(super) told: Vec<f64>,
    /// What must not be above zero.
    pub(super) least: Vec<f64>,
    /// How much what is told counts.
    pub(super) weight: Vec<f64>,
}

impl Needs {
    pub(super) fn new(corrections: usize) -> Self {
        let none = vec![f64::NEG_INFINITY; corrections];
        Self { told: none.clone(), least: none, weight: vec![1.0; corrections] }
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
        let steps = vec![Step::along_an_arc(0, 0.7, 0.0); steps];
        Heights::new(&Course::new(&steps, 0.05, 0.0, -0.5), numbers, 1.1)
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
