//! The implicit method with ever smaller tolerances, until two of them agree within one of the whole run.

use super::super::pass::{Passed, pass};
use super::super::passes::Passes;
use super::super::{Chosen, compare, describe};
use crate::failure::{FailureKind, Remedy, RunError, RunFailure};
use crate::report::Counts;
use crate::settings::Settings;
use crate::simulation::Simulation;
use crate::time::Stepping;
use std::sync::Arc;

/// The implicit method with ever smaller tolerances.
pub(super) fn stiff(
    simulation: &Arc<Simulation>,
    settings: &Settings,
    tolerance: f64,
    eigenvalue: f64,
    passes: &mut Passes<'_>,
) -> Result<Chosen, RunError> {
    let mut beside = Counts::default();
    let mut last: Option<Passed> = None;
    // The tolerance of a step that usually gives that of the whole.
    let mut own = (0.1 * tolerance).max(1e-12);
    let mut best = f64::INFINITY;
    while own >= 1e-13 {
        let stepping = Stepping::Stiff { tolerance: own };
        let passed = pass(simulation, settings, stepping, &mut passes.next(stepping))?;
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
