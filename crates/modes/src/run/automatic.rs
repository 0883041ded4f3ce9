//! The choice of a method, with its step or tolerance, that meets a tolerance of the whole run.

mod adaptive;
mod ladder;
mod stiff;

use super::pass::sketch;
use super::passes::Passes;
use super::{Chosen, NOTHING};
use crate::failure::{FailureKind, RunError, RunFailure, SetupError};
use crate::report::{Counts, ErrorEstimate, Remark};
use crate::settings::Settings;
use crate::simulation::Simulation;
use crate::time::Stepping;
use adaptive::{FINER, FIRST, Search, one_digit};
use ladder::Ladder;
use std::sync::Arc;

/// Steps of an explicit rule in a frame that stability may ask for before an implicit method is tried.
const MANY: f64 = 16.0;

/// How many tolerances of a step are tried before one comes to the end.
const MOST_BEGINNINGS: usize = 4;

/// Runs with whichever method meets the tolerance (rad or m): the one that chooses its steps, unless the scene is stiff, or a rule of
/// fixed steps is cheaper or comes farther.
pub(super) fn choose(
    simulation: &Arc<Simulation>,
    settings: &Settings,
    tolerance: f64,
    passes: &mut Passes<'_>,
) -> Result<Chosen, RunError> {
    let mut remarks = Vec::new();
    let mut own = one_digit(FIRST * tolerance).max(LEAST);
    // Steps of an explicit method that have to be shorter are an implicit one's affair.
    let mut shortest = Some((MANY * settings.rate).recip());
    for _ in 0..MOST_BEGINNINGS {
        let stepping = Stepping::Adaptive { tolerance: own };
        let failure = match sketch(simulation, settings, stepping, shortest, &mut passes.next(stepping)) {
            Ok(passed) if !passed.is_dynamic => {
                let (error, why) = (Some(ErrorEstimate::default()), "every motion is given".to_owned());
                let (method, beside) = (NOTHING.to_owned(), Counts::default());
                return Ok(Chosen { passed, error, method, why, beside, remarks });
            }
            Ok(passed) => {
                return Search::new(simulation, settings, tolerance, (own, passed)).go(passes, remarks);
            }
            Err(RunError::Failed(failure)) => failure,
            Err(error) => return Err(error),
        };
        match failure.cause {
            FailureKind::StepTooLong { eigenvalue, .. } => {
                shortest = None;
                match stiff::stiff(simulation, settings, tolerance, eigenvalue, passes) {
                    Ok(chosen) => return Ok(chosen),
                    Err(RunError::Setup(SetupError::NotBuiltIn { .. })) => {
                        remarks.push(Remark::StiffNotBuiltIn { eigenvalue });
                    }
                    Err(RunError::Cancelled) => return Err(RunError::Cancelled),
                    Err(error) => remarks.push(Remark::StiffFailed(Box::new(error))),
                }
            }
            _ if is_of_the_step(&failure) => own = one_digit(own * FINER * FINER).max(LEAST),
            _ => return Err(failure.into()),
        }
    }
    Ladder::new(simulation, settings, tolerance, Counts::default()).climb(passes, remarks)
}

/// The least tolerance of a step: below it there is rounding only.
const LEAST: f64 = 1e-14;

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
