//! The explicit method that chooses its steps, with ever smaller tolerances, until two of them agree within one of the whole run.

use super::super::pass::{Passed, pass};
use super::super::passes::Passes;
use super::super::{Chosen, compare, describe};
use super::ladder::Ladder;
use super::{LEAST, is_of_the_step};
use crate::failure::RunError;
use crate::report::{Counts, ErrorEstimate, Remark};
use crate::settings::{Rule, Settings};
use crate::simulation::Simulation;
use crate::time::Stepping;
use std::sync::Arc;

/// The tolerance of a step, beside that of the whole, to begin with: most scenes need no less.
pub(super) const FIRST: f64 = 0.1;

/// The tolerance after it, beside it. Work grows with its eighth root, by a sixth.
pub(super) const FINER: f64 = 0.3;

/// The part of the tolerance that the next difference is to come to.
const AIM: f64 = 0.25 / UNEVEN;

/// Errors do not fall evenly with the tolerance: a pass may be farther off than its difference from the one before, of random scenes
/// 2.6 times as far.
const UNEVEN: f64 = 3.0;

/// The least part of the last tolerance that is taken next.
const BOLD: f64 = 1e-4;

/// The most passes.
const MOST_PASSES: usize = 10;

/// So many evaluations in a frame, and steps of a fixed rule may be cheaper.
const DEAR: f64 = 6.0;

/// The last pass with the tolerance of its steps, and what led to it.
pub(super) struct Search<'a> {
    simulation: &'a Arc<Simulation>,
    settings: &'a Settings,
    tolerance: f64,
    own: f64,
    last: Passed,
    /// What other passes took.
    beside: Counts,
}

impl<'a> Search<'a> {
    /// `first` is a pass that came to the end, with the tolerance of its steps.
    pub(super) fn new(
        simulation: &'a Arc<Simulation>,
        settings: &'a Settings,
        tolerance: f64,
        (own, last): (f64, Passed),
    ) -> Self {
        Self { simulation, settings, tolerance, own, last, beside: Counts::default() }
    }

    pub(super) fn go(mut self, passes: &mut Passes<'_>, remarks: Vec<Remark>) -> Result<Chosen, RunError> {
        if let Some((passed, error, stepping)) = self.by_fixed_steps(passes)? {
            self.beside.add(&self.last.counts);
            let why = format!(
                "it takes fewer evaluations than the method that chooses its steps, and is within {:.1e} of it, where the tolerance \
                 is {:e}",
                error.position, self.tolerance
            );
            return Ok(self.chosen(passed, error, (stepping, why), remarks));
        }
        // The difference before, and how many times as large the tolerance was then.
        let mut before: Option<(f64, f64)> = None;
        let (mut next, mut stalls) = (one_digit(FINER * self.own), 0);
        for _ in 0..MOST_PASSES {
            let spent = self.beside.evaluations + self.last.counts.evaluations;
            if next < LEAST || spent + 2 * self.last.counts.evaluations > self.settings.guard.evaluations {
                break;
            }
            let stepping = Stepping::Adaptive { tolerance: next };
            let passed = match pass(self.simulation, self.settings, stepping, &mut passes.next(stepping)) {
                Ok(passed) => passed,
                Err(RunError::Failed(failure)) if is_of_the_step(&failure) => break,
                Err(error) => return Err(error),
            };
            let finer = self.own / next;
            let apart = compare::difference(&self.simulation.figure, &passed.record, &self.last.record)?;
            let part = share(before, apart.position, (finer, passed.jumps));
            let error = compare::estimate(&self.simulation.figure, &passed, &self.last, UNEVEN * part)?;
            self.beside.add(&self.last.counts);
            (self.last, self.own) = (passed, next);
            if error.position <= self.tolerance {
                let why = format!(
                    "its error estimate {:.1e} is the first of ever smaller tolerances of a step to meet the tolerance {:e}",
                    error.position, self.tolerance
                );
                let passed = self.last.clone();
                return Ok(self.chosen(passed, error, (stepping, why), remarks));
            }
            stalls =
                if before.is_some_and(|(before, _)| apart.position > 0.5 * before) { stalls + 1 } else { 0 };
            if stalls >= 2 {
                break;
            }
            before = Some((apart.position, finer));
            // Errors fall with the tolerance: this one is smaller than the difference by as much.
            let left = apart.position / finer;
            next = one_digit(self.own * (AIM * self.tolerance / left).clamp(BOLD, FINER));
        }
        self.beside.add(&self.last.counts);
        Ladder::new(self.simulation, self.settings, self.tolerance, self.beside).climb(passes, remarks)
    }

    /// Steps of a fixed rule, where these may be cheaper, as when drives change in every frame: good enough where they are within the
    /// tolerance of the pass there is.
    fn by_fixed_steps(
        &mut self,
        passes: &mut Passes<'_>,
    ) -> Result<Option<(Passed, ErrorEstimate, Stepping)>, RunError> {
        let (rule, frames) = (Rule::RungeKutta4, self.settings.duration * self.settings.rate);
        let spent = self.last.counts.evaluations as f64;
        let mut steps = 1.0;
        for dear in [DEAR, 3.0 * DEAR] {
            if spent < dear * steps * frames {
                return Ok(None);
            }
            let stepping = Stepping::Fixed { rule, step: (self.settings.rate * steps).recip() };
            let passed = match pass(self.simulation, self.settings, stepping, &mut passes.next(stepping)) {
                Ok(passed) => passed,
                Err(RunError::Cancelled) => return Err(RunError::Cancelled),
                Err(_) => return Ok(None),
            };
            let apart = compare::difference(&self.simulation.figure, &passed.record, &self.last.record)?;
            // Neither is exact.
            let off = ErrorEstimate {
                position: apart.position + self.last.errors,
                velocity: apart.velocity + self.last.errors,
            };
            if off.position <= self.tolerance {
                return Ok(Some((passed, off, stepping)));
            }
            self.beside.add(&passed.counts);
            // So many steps more would do, were the error that of a smooth motion.
            steps = (2.0 * apart.position / self.tolerance).powf(0.25).ceil();
        }
        Ok(None)
    }

    fn chosen(
        self,
        passed: Passed,
        error: ErrorEstimate,
        (stepping, why): (Stepping, String),
        remarks: Vec<Remark>,
    ) -> Chosen {
        let method = describe(stepping, self.settings.rate);
        Chosen { passed, error: Some(error), method, why, beside: self.beside, remarks }
    }
}

/// A number that is read easily, near to another.
pub(super) fn one_digit(x: f64) -> f64 {
    format!("{x:.0e}").parse().unwrap_or(x)
}

/// The error of a pass as a part of its difference from the one whose tolerance was `finer` times as large: the whole, unless the
/// difference `before`, and the tolerances then, tell how errors fall, and fast enough.
///
/// ```text
/// e(τ) ≈ |x(τ) − x(c·τ)| / (cᵖ − 1)        p = ln(|x(cτ) − x(bcτ)| / |x(τ) − x(cτ)|) / ln b, at most ¾
/// ```
///
/// They fall with the tolerance itself, but not evenly.
fn share(before: Option<(f64, f64)>, difference: f64, (finer, jumps): (f64, bool)) -> f64 {
    let Some((before, then)) = before.filter(|_| !jumps) else { return 1.0 };
    let power = (before / difference).ln() / then.ln();
    // NaN where there is no difference.
    let falls = if power.is_nan() { 1.0 } else { finer.powf(power.min(0.75)) };
    if falls < 4.0 { 1.0 } else { (falls - 1.0).recip() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_of_a_difference_is_believed_where_differences_fall() {
        let whole = |part: f64| approx::assert_abs_diff_eq!(part, 1.0);
        whole(share(None, 1e-6, (3.0, false)));
        // They fall by 10 with the tolerance: 10^¾ less 1.
        let part = share(Some((1e-5, 10.0)), 1e-6, (10.0, false));
        approx::assert_relative_eq!(part, (10_f64.powf(0.75) - 1.0).recip(), max_relative = 1e-12);
        // Not where something jumps, where they do not fall, or are nothing.
        whole(share(Some((1e-5, 10.0)), 1e-6, (10.0, true)));
        whole(share(Some((1e-6, 10.0)), 1e-6, (10.0, false)));
        whole(share(Some((0.0, 10.0)), 0.0, (10.0, false)));
        whole(share(Some((1e-9, 10.0)), 1e-6, (10.0, false)));
    }

    #[test]
    fn tolerances_are_short() {
        approx::assert_relative_eq!(one_digit(0.3 * 1e-6), 3e-7, max_relative = 1e-15);
        approx::assert_relative_eq!(one_digit(9.7e-9), 1e-8, max_relative = 1e-15);
    }
}
