//! Savings by leaving out what nothing depends on.

use super::compare::{Answer, compare};
use super::outlook::Outlook;
use super::rows::timed;
use crate::report::Run;
use crate::settings::{Method, Settings};
use crate::simulation::Simulation;

/// A run with everything in it beside one from which what nothing depends on is left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Savings {
    /// The method of both.
    pub method: String,
    /// How long they took (s): with everything, and with what is left. Nothing without a clock.
    pub seconds: Option<(f64, f64)>,
    /// Arithmetic operations of one evaluation, the mean over the time: of the whole figure, and of what is left.
    pub operations: (f64, f64),
    /// How far the two motions are apart (rad or m).
    pub difference: f64,
}

/// Measures by `method`, or as the settings say; nothing where a run failed.
pub(super) fn measure(
    simulation: &Simulation,
    settings: &Settings,
    method: Option<Method>,
    repeats: usize,
    observer: &mut Outlook<'_>,
) -> Option<Savings> {
    let method = method.unwrap_or(settings.method);
    let mut run = |leave_out: bool| {
        let settings = Settings { method, leave_out, ..settings.clone() };
        timed(simulation, &settings, repeats, observer).ok()
    };
    let (whole, with_all) = run(false)?;
    let (left, with_less) = run(true)?;
    let answer = Answer::Motion(&whole.motion);
    let (difference, _) = compare(simulation.figure(), &left.motion, &answer, f64::INFINITY);
    Some(Savings {
        method: left.report.method.clone(),
        seconds: with_all.zip(with_less),
        operations: operations(&left),
        difference,
    })
}

/// Operations of an evaluation, of the whole figure and of what is left, weighed by how long each phase lasts.
fn operations(run: &Run) -> (f64, f64) {
    let mut sums = (0.0, 0.0, 0.0);
    for phase in &run.report.phases {
        // A phase may be as short as an instant.
        let weight = (phase.end - phase.start).max(1e-12);
        let [whole, left] = [phase.operations_of_all, phase.operations].map(|all| all.total() as f64);
        sums = (sums.0 + weight, sums.1 + weight * whole, sums.2 + weight * left);
    }
    if sums.0 > 0.0 { (sums.1 / sums.0, sums.2 / sums.0) } else { (0.0, 0.0) }
}
