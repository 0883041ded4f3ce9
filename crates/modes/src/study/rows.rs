//! One setting, measured.

use super::agreement::Agreement;
use super::compare::Accuracy;
use super::outlook::Outlook;
use super::{method_name, momentum, setting};
use crate::failure::{RunError, SetupError};
use crate::report::{Counts, Observer, Run};
use crate::settings::{Method, Settings};
use crate::simulation::Simulation;
use solaris_model::Motion;
use std::fmt;

/// A setting, what it took, and what came of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The method with its step or tolerance.
    pub method: Method,
    /// What it took; zero throughout where it failed.
    pub counts: Counts,
    /// How long it took (s), the best of the repeats; nothing without a clock.
    pub seconds: Option<f64>,
    /// How far off it was, or the failure that ended it.
    pub result: Result<Accuracy, String>,
    /// Where the motion cannot be compared to its end: single frames, each from the reference's state.
    pub agreement: Option<Agreement>,
    pub(super) is_built_in: bool,
}

impl Row {
    /// The evaluations that it took, or, of a fixed step that failed over `duration` (s), would have taken.
    pub fn evaluations(&self, duration: f64) -> Option<u64> {
        match (self.counts.evaluations, self.method) {
            (0, Method::Fixed { rule, step }) => {
                Some((duration / step).ceil().max(1.0) as u64 * rule.evaluations())
            }
            (0, _) => None,
            (evaluations, _) => Some(evaluations),
        }
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}", method_name(self.method), setting(self.method))
    }
}

/// Runs a setting; nothing where somebody stopped it. `compare` gives the errors of positions and of velocities.
pub(super) fn measure(
    simulation: &Simulation,
    settings: &Settings,
    method: Method,
    repeats: usize,
    observer: &mut Outlook<'_>,
    compare: impl FnOnce(&Motion) -> (f64, f64),
) -> Option<Row> {
    let settings = Settings { method, ..settings.clone() };
    let mut row = Row {
        method,
        counts: Counts::default(),
        seconds: None,
        result: Err(String::new()),
        agreement: None,
        is_built_in: true,
    };
    if observer.is_cancelled() {
        return None;
    }
    match timed(simulation, &settings, repeats, observer) {
        Ok((Run { motion, report }, seconds)) => {
            let (position, velocity) = compare(&motion);
            let energy = report.energy;
            row.counts = report.cost.counts;
            row.seconds = seconds;
            row.result = Ok(Accuracy {
                position,
                velocity,
                energy: if energy.imbalance > 0.0 { energy.imbalance / energy.scale } else { 0.0 },
                momentum: momentum::drift(simulation, &motion),
                estimate: report.error.map(|error| error.position),
            });
        }
        Err(RunError::Cancelled) => return None,
        Err(error) => {
            row.is_built_in = !matches!(error, RunError::Setup(SetupError::NotBuiltIn { .. }));
            row.result = Err(error.to_string());
        }
    }
    Some(row)
}

/// A run and its best time, over at most so many repeats and about a second.
pub(super) fn timed(
    simulation: &Simulation,
    settings: &Settings,
    repeats: usize,
    observer: &mut dyn Observer,
) -> Result<(Run, Option<f64>), RunError> {
    let before = observer.now();
    let run = simulation.run_observed(settings, observer)?;
    let Some(mut best) = elapsed(before, observer) else { return Ok((run, None)) };
    let mut spent = best;
    for _ in 1..repeats {
        if spent > 1.0 || observer.is_cancelled() {
            break;
        }
        let before = observer.now();
        simulation.run_observed(settings, observer)?;
        let Some(seconds) = elapsed(before, observer) else { break };
        (best, spent) = (best.min(seconds), spent + seconds);
    }
    Ok((run, Some(best)))
}

fn elapsed(before: Option<f64>, observer: &dyn Observer) -> Option<f64> {
    Some((observer.now()? - before?).max(0.0))
}
