//! One stretch of time, by any method.

use super::{RateError, System};
use crate::report::Counts;
use crate::settings::Rule;

/// How a stretch is stepped through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stepping {
    /// Equal steps, at most this long (s), so many that they end where something is asked.
    Fixed {
        /// The rule.
        rule: Rule,
        /// The longest step (s).
        step: f64,
    },
    /// An explicit method that chooses its steps; feature `stiff`.
    Adaptive {
        /// Relative and absolute tolerance of a step.
        tolerance: f64,
    },
    /// An implicit method that chooses its steps; feature `stiff`.
    Stiff {
        /// Relative and absolute tolerance of a step.
        tolerance: f64,
    },
}

/// Where a stretch ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Stopped {
    /// The time (s): the end of the stretch, or that of the events.
    pub time: f64,
    /// The event functions that pass through zero there, by index.
    pub events: Vec<usize>,
}

/// Why a stretch did not come to its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TimeError {
    /// A state without a rate.
    #[error("at t = {time} s: {source}")]
    Rate {
        /// When (s).
        time: f64,
        /// Why.
        source: RateError,
    },
    /// A method that cannot go on.
    #[error("{method} cannot go on at t = {time} s: {why}")]
    Stuck {
        /// When (s).
        time: f64,
        /// The method.
        method: String,
        /// Why.
        why: String,
    },
    /// More evaluations than were allowed.
    #[error("{evaluations} evaluations are spent at t = {time} s")]
    Evaluations {
        /// When (s).
        time: f64,
        /// How many.
        evaluations: u64,
    },
    /// A rule that needs positions and velocities, and a state that has none.
    #[error("{rule} steps positions and velocities, and the state has none")]
    NoPositions {
        /// The rule.
        rule: Rule,
    },
    /// A method that was not built in.
    #[error("{method} is not built in: it needs the feature 'stiff'")]
    NotBuiltIn {
        /// The method.
        method: &'static str,
    },
}

/// Steps `y` from `from` to `to` (s), or to the first event.
///
/// `frames` are times (s), rising, at which `frame(system, time, y)` is called on the way, those at `from` left out and those at `to` or
/// at the event included. `counts.evaluations` may not grow beyond `most`.
///
/// An event is where an event function passes through zero from one side to the other; one that is zero at `from` is watched from
/// where it has left zero. Events are located to rounding; `y` is then the state just there.
///
/// # Errors
///
/// [`TimeError`]; `y` is then the last state that was reached.
#[allow(clippy::too_many_arguments, reason = "what is stepped, by what, from where to where, and who looks on")]
pub fn advance<S: System + ?Sized>(
    system: &mut S,
    stepping: Stepping,
    span: (f64, f64),
    y: &mut [f64],
    frames: &[f64],
    frame: &mut dyn FnMut(&mut S, f64, &[f64]) -> Result<(), RateError>,
    most: u64,
    counts: &mut Counts,
) -> Result<Stopped, TimeError> {
    let _ = (system, stepping, span, y, frames, frame, most, counts);
    unimplemented!()
}
