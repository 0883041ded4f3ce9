//! Runge and Kutta's rule with ever shorter steps, until two of them agree within a tolerance.

use super::super::pass::{Passed, pass};
use super::super::passes::Passes;
use super::super::{Chosen, compare, describe, scaled};
use super::is_of_the_step;
use crate::failure::{FailureKind, Remedy, RunError, RunFailure};
use crate::report::{Counts, ErrorEstimate, Remark};
use crate::settings::{Rule, Settings};
use crate::simulation::Simulation;
use crate::time::Stepping;
use std::sync::Arc;

/// The most steps that are tried.
const MOST_TRIALS: usize = 18;

/// How many steps come to one where something jumps, or has a kink: half the step would have it in a place of its step that tells of
/// the one before (at a third of a step and at two thirds an error is the same), and neither would show it.
const UNEVEN: f64 = 1.7;

/// Runge and Kutta's rule with ever shorter steps.
pub(super) struct Ladder<'a> {
    simulation: &'a Arc<Simulation>,
    settings: &'a Settings,
    tolerance: f64,
    /// The steps of the last pass in a frame.
    steps: f64,
    /// How many times as many the next one has.
    ratio: f64,
    last: Option<Passed>,
    /// What other passes took.
    beside: Counts,
}

impl<'a> Ladder<'a> {
    /// Steps that begin with a frame; `beside` is what was spent already.
    pub(super) fn new(
        simulation: &'a Arc<Simulation>,
        settings: &'a Settings,
        tolerance: f64,
        beside: Counts,
    ) -> Self {
        Self { simulation, settings, tolerance, steps: 0.5, ratio: 2.0, last: None, beside }
    }

    /// The step of the last pass (s).
    fn step(&self) -> f64 {
        (self.settings.rate * self.steps).recip()
    }

    pub(super) fn climb(mut self, passes: &mut Passes<'_>, remarks: Vec<Remark>) -> Result<Chosen, RunError> {
        let mut best = f64::INFINITY;
        let mut failure = None;
        let (mut stalls, mut estimate, mut before) = (0, f64::INFINITY, f64::NAN);
        for _ in 0..MOST_TRIALS {
            let spent =
                self.beside.evaluations + self.last.as_ref().map_or(0, |last| last.counts.evaluations);
            let next =
                (self.ratio * self.last.as_ref().map_or(0.0, |last| last.counts.evaluations as f64)) as u64;
            if spent + next > self.settings.guard.evaluations {
                break;
            }
            let ratio = (self.ratio * self.steps).ceil() / self.steps;
            self.steps *= ratio;
            let stepping = Stepping::Fixed { rule: Rule::RungeKutta4, step: self.step() };
            let passed = match pass(self.simulation, self.settings, stepping, &mut passes.next(stepping)) {
                Ok(passed) => passed,
                Err(RunError::Failed(found)) if is_of_the_step(&found) => {
                    (self.last, failure, before) = (None, Some(found), f64::NAN);
                    continue;
                }
                Err(error) => return Err(error),
            };
            if let Some(last) = self.last.take() {
                self.beside.add(&last.counts);
                let apart = compare::difference(&self.simulation.figure, &passed.record, &last.record)?;
                let error = scaled(apart, share(before, apart.position, (ratio, passed.jumps)));
                (before, self.ratio) = (apart.position, if passed.jumps { UNEVEN } else { 2.0 });
                if error.position <= self.tolerance {
                    return Ok(self.done(passed, error, stepping, remarks));
                }
                stalls = if error.position > 0.5 * estimate { stalls + 1 } else { 0 };
                estimate = error.position;
                best = best.min(estimate);
                if stalls >= 4 {
                    break;
                }
            }
            self.last = Some(passed);
        }
        Err(self.gave_up(best, failure))
    }

    /// No step met the tolerance within the evaluations that are allowed.
    fn gave_up(&self, best: f64, failure: Option<Box<RunFailure>>) -> RunError {
        let (tolerance, time) = (self.tolerance, failure.as_ref().map(|failure| failure.time));
        let failure = match failure.filter(|_| best.is_infinite()) {
            Some(failure) => {
                let RunFailure { time, dof, cause, .. } = *failure;
                let cause =
                    FailureKind::NoneFinished { tolerance, step: self.step(), cause: Box::new(cause) };
                RunFailure { time, dof, cause, remedies: vec![Remedy::StiffMethod, Remedy::SofterSprings] }
            }
            None => RunFailure {
                time: time.unwrap_or(self.settings.duration),
                dof: None,
                cause: FailureKind::Tolerance { tolerance, estimate: best },
                remedies: vec![
                    Remedy::LargerTolerance,
                    Remedy::NamedMethod { step: self.step() },
                    Remedy::ShorterChaos,
                ],
            },
        };
        Box::new(failure).into()
    }

    fn done(self, passed: Passed, error: ErrorEstimate, stepping: Stepping, remarks: Vec<Remark>) -> Chosen {
        let why = format!(
            "its error estimate {:.1e} is the first of ever shorter steps to meet the tolerance {:e}",
            error.position, self.tolerance
        );
        let (method, beside) = (describe(stepping, self.settings.rate), self.beside);
        Chosen { passed, error: Some(error), method, why, beside, remarks }
    }
}

/// The error of a run as a part of its difference from the one with `ratio` times the step, where the one `before` tells of the order:
/// differences that fall by sixteen, as they should where steps are halved, leave a fifteenth.
///
/// ```text
/// e(h) ≈ |x(h) − x(2h)| / (r − 1)        r = |x(2h) − x(4h)| / |x(h) − x(2h)|
/// ```
///
/// Where something jumps, errors may fall no faster than the step.
fn share(before: f64, difference: f64, (ratio, jumps): (f64, bool)) -> f64 {
    let falls = before / difference;
    // NaN where there is no difference before.
    if jumps {
        (ratio - 1.0).recip().max(1.0)
    } else if falls.partial_cmp(&4.0).is_none_or(std::cmp::Ordering::is_lt) {
        1.0
    } else {
        (falls.min(16.0) - 1.0).recip()
    }
}
