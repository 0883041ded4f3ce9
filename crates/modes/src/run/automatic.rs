//! The choice of method and step that meet a tolerance.

use super::kinks::has_kinks;
use super::pass::{Passed, pass};
use super::{Chosen, NOTHING, Quiet, compare, describe, scaled};
use crate::failure::{FailureKind, Remedy, RunError, RunFailure, SetupError};
use crate::report::{Counts, ErrorEstimate, Observer, Remark};
use crate::settings::{Rule, Settings};
use crate::simulation::Simulation;
use crate::time::Stepping;
use std::sync::Arc;

/// Steps of an explicit rule in a frame that stability may ask for before an implicit method is tried.
const MANY: f64 = 16.0;

/// The most halvings of the step, and tenths of the tolerance.
const MOST_TRIALS: usize = 18;

/// Runs with whichever method meets the tolerance (rad or m).
pub(super) fn choose(
    simulation: &Arc<Simulation>,
    settings: &Settings,
    tolerance: f64,
    observer: &mut dyn Observer,
) -> Result<Chosen, RunError> {
    let frame = settings.rate.recip();
    let first = Stepping::Fixed { rule: Rule::RungeKutta4, step: frame };
    let mut remarks = Vec::new();
    let stable = match pass(simulation, settings, first, &mut Quiet(observer)) {
        Ok(passed) if !passed.is_dynamic => {
            let (error, why) = (Some(ErrorEstimate::default()), "every motion is given".to_owned());
            let (method, beside) = (NOTHING.to_owned(), Counts::default());
            return Ok(Chosen { passed, error, method, why, beside, remarks });
        }
        Ok(passed) => {
            return Ladder::new(simulation, settings, tolerance, frame, Some(passed))
                .climb(observer, remarks);
        }
        Err(RunError::Failed(failure)) => match failure.cause {
            FailureKind::StepTooLong { longest, eigenvalue, .. } => (longest, Some(eigenvalue)),
            _ if is_of_the_step(&failure) => (0.5 * frame, None),
            _ => return Err(failure.into()),
        },
        Err(error) => return Err(error),
    };
    let (longest, eigenvalue) = stable;
    if let Some(eigenvalue) = eigenvalue.filter(|_| frame > MANY * longest) {
        match stiff(simulation, settings, tolerance, eigenvalue, observer) {
            Ok(chosen) => return Ok(chosen),
            Err(RunError::Setup(SetupError::NotBuiltIn { .. })) => {
                remarks.push(Remark::StiffNotBuiltIn { eigenvalue });
            }
            Err(RunError::Cancelled) => return Err(RunError::Cancelled),
            Err(error) => remarks.push(Remark::StiffFailed(Box::new(error))),
        }
    }
    Ladder::new(simulation, settings, tolerance, longest.min(frame), None).climb(observer, remarks)
}

/// Runge and Kutta's rule with ever shorter steps.
struct Ladder<'a> {
    simulation: &'a Arc<Simulation>,
    settings: &'a Settings,
    tolerance: f64,
    /// The step of the last pass (s).
    step: f64,
    last: Option<Passed>,
    beside: Counts,
}

impl<'a> Ladder<'a> {
    fn new(
        simulation: &'a Arc<Simulation>,
        settings: &'a Settings,
        tolerance: f64,
        longest: f64,
        last: Option<Passed>,
    ) -> Self {
        let frame = settings.rate.recip();
        // Whole steps in a frame.
        let step = frame / (frame / longest - 1e-9).ceil().max(1.0);
        // The first pass, where there is none yet, is one with this step.
        let step = if last.is_some() { step } else { 2.0 * step };
        Self { simulation, settings, tolerance, step, last, beside: Counts::default() }
    }

    fn climb(mut self, observer: &mut dyn Observer, remarks: Vec<Remark>) -> Result<Chosen, RunError> {
        let mut best = f64::INFINITY;
        let mut failure = None;
        let (mut stalls, mut estimate, mut before) = (0, f64::INFINITY, f64::NAN);
        for _ in 0..MOST_TRIALS {
            let spent =
                self.beside.evaluations + self.last.as_ref().map_or(0, |last| last.counts.evaluations);
            let next = 2 * self.last.as_ref().map_or(0, |last| last.counts.evaluations);
            if spent + next > self.settings.guard.evaluations {
                break;
            }
            self.step *= 0.5;
            let stepping = Stepping::Fixed { rule: Rule::RungeKutta4, step: self.step };
            let passed = match pass(self.simulation, self.settings, stepping, &mut Quiet(observer)) {
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
                let jumps = passed.jumps || has_kinks(self.simulation, &passed)?;
                let error = scaled(apart, share(before, apart.position, jumps));
                before = apart.position;
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
            observer.progress(0.0);
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
                let cause = FailureKind::NoneFinished { tolerance, step: self.step, cause: Box::new(cause) };
                RunFailure { time, dof, cause, remedies: vec![Remedy::StiffMethod, Remedy::SofterSprings] }
            }
            None => RunFailure {
                time: time.unwrap_or(self.settings.duration),
                dof: None,
                cause: FailureKind::Tolerance { tolerance, estimate: best },
                remedies: vec![
                    Remedy::LargerTolerance,
                    Remedy::NamedMethod { step: self.step },
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

/// The error of a run as a part of its difference from the one with twice the step, where the one `before` tells of the order:
/// differences that fall by sixteen, as they should, leave a fifteenth.
///
/// ```text
/// e(h) ≈ |x(h) − x(2h)| / (r − 1)        r = |x(2h) − x(4h)| / |x(h) − x(2h)|
/// ```
fn share(before: f64, difference: f64, jumps: bool) -> f64 {
    let ratio = before / difference;
    // NaN where there is no difference before.
    if jumps || ratio.partial_cmp(&4.0).is_none_or(std::cmp::Ordering::is_lt) {
        1.0
    } else {
        (ratio.min(16.0) - 1.0).recip()
    }
}

/// The implicit method with ever smaller tolerances.
fn stiff(
    simulation: &Arc<Simulation>,
    settings: &Settings,
    tolerance: f64,
    eigenvalue: f64,
    observer: &mut dyn Observer,
) -> Result<Chosen, RunError> {
    let mut beside = Counts::default();
    let mut last: Option<Passed> = None;
    // The tolerance of a step that usually gives that of the whole.
    let mut own = (0.1 * tolerance).max(1e-12);
    let mut best = f64::INFINITY;
    while own >= 1e-13 {
        let stepping = Stepping::Stiff { tolerance: own };
        let passed = pass(simulation, settings, stepping, &mut Quiet(observer))?;
        if let Some(last) = last.take() {
            beside.add(&last.counts);
            let error = compare::difference(&simulation.figure, &passed.record, &last.record)?;
            best = best.min(error.position);
            if error.position <= tolerance {
                let why = format!(
                    "the stiffest eigenvalue, {eigenvalue:.3e} 1/s, would hold an explicit rule to steps a frame is many of; its \
                     error estimate {:.1e} meets the tolerance {tolerance:e}",
                    error.position
                );
                let method = describe(stepping, settings.rate);
                return Ok(Chosen { passed, error: Some(error), method, why, beside, remarks: Vec::new() });
            }
        }
        last = Some(passed);
        own *= 0.1;
    }
    let cause = FailureKind::Tolerance { tolerance, estimate: best };
    let remedies = vec![Remedy::LargerTolerance];
    Err(Box::new(RunFailure { time: settings.duration, dof: None, cause, remedies }).into())
}

/// Whether a shorter step may help.
fn is_of_the_step(failure: &RunFailure) -> bool {
    matches!(
        failure.cause,
        FailureKind::StepTooLong { .. }
            | FailureKind::Energy { .. }
            | FailureKind::NotFinite { .. }
            | FailureKind::Stuck { .. }
            | FailureKind::State(_)
            | FailureKind::Dynamics(_)
    )
}
