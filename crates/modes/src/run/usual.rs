//! What is meant where no method is named.

use super::passes::Passes;
use super::{Chosen, NAMED, automatic, by_impulses};
use crate::contact::ContactLaw;
use crate::failure::{FailureKind, RunError, RunFailure};
use crate::report::{Observer, Remark};
use crate::settings::{Guard, Method, Settings};
use crate::simulation::Simulation;
use std::sync::Arc;

/// The tolerance (rad or m).
const TOLERANCE: f64 = 1e-6;

/// The step (s) of whatever would choose one.
pub(crate) const STEP: f64 = 1e-3;

/// On rigid ground: evaluations of a run, and of each second of it, that forces may take. What is at rest, falls over or rocks takes a
/// hundredth of them.
const MOST_EVALUATIONS: f64 = 20_000.0;

/// Why it is impulses.
const NEEDED: &str = "links that touch each other, or are held together, need it";
const INSTEAD: &str = "forces that keep what stands on rigid ground came to no end";

impl Simulation {
    /// The method that [`Method::Usual`] begins with.
    pub fn usual_method(&self) -> Method {
        if self.collisions.is_some() || !self.loops.is_empty() {
            Method::Impulses { step: STEP }
        } else {
            Method::Automatic { tolerance: TOLERANCE }
        }
    }
}

/// Runs with the usual method, and on rigid ground by impulses where forces come to no end.
pub(super) fn choose(
    simulation: &Arc<Simulation>,
    settings: &Settings,
    observer: &mut dyn Observer,
) -> Result<Chosen, RunError> {
    let Method::Automatic { tolerance } = simulation.usual_method() else {
        return by_impulses_for(NEEDED, simulation, settings, observer);
    };
    let automatic = |settings: &Settings, observer: &mut dyn Observer| {
        automatic::choose(simulation, settings, tolerance, &mut Passes::new(observer, settings))
    };
    if simulation.grounded().is_none_or(|(plane, _)| plane.law != ContactLaw::Rigid) {
        return automatic(settings, observer);
    }
    let most = (MOST_EVALUATIONS * (1.0 + settings.duration)) as u64;
    let guard = Guard { evaluations: settings.guard.evaluations.min(most), ..settings.guard };
    let failure = match automatic(&Settings { guard, ..settings.clone() }, observer) {
        Err(RunError::Failed(failure)) if is_of_the_ground(&failure) => failure,
        other => return other,
    };
    let mut chosen = by_impulses_for(INSTEAD, simulation, settings, observer)?;
    chosen.remarks.insert(0, Remark::ImpulsesInstead { tolerance, failure });
    Ok(chosen)
}

/// By impulses, which nobody has named.
fn by_impulses_for(
    why: &str,
    simulation: &Arc<Simulation>,
    settings: &Settings,
    observer: &mut dyn Observer,
) -> Result<Chosen, RunError> {
    let mut chosen = by_impulses(simulation, settings, STEP, observer)?;
    if chosen.why == NAMED {
        why.clone_into(&mut chosen.why);
    }
    Ok(chosen)
}

/// Whether it may be for what stands, and how, that forces have come to no end.
fn is_of_the_ground(failure: &RunFailure) -> bool {
    match &failure.cause {
        FailureKind::ContactLost { .. }
        | FailureKind::UnresolvedContact { .. }
        | FailureKind::Evaluations { .. }
        | FailureKind::Tolerance { .. }
        | FailureKind::Stuck { .. }
        | FailureKind::Energy { .. } => true,
        FailureKind::NoneFinished { cause, .. } => !matches!(**cause, FailureKind::NotFinite { .. }),
        _ => false,
    }
}
