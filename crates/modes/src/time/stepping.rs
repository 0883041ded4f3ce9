//! One stretch of time, by any method.

use super::evaluate::{Evaluator, finite};
#[cfg(feature = "stiff")]
use super::solver;
use super::{RateError, System, fixed};
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
    /// A number out of its range.
    #[error("{what} is {value}; it must be {range}")]
    Range {
        /// What.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What it has to be.
        range: &'static str,
    },
    /// A method that was not built in.
    #[error("{method} is not built in: it needs the feature 'stiff'")]
    NotBuiltIn {
        /// The method.
        method: &'static str,
    },
}

/// Is shown the state of each frame, with its time (s); an error ends the stretch.
pub type OnFrame<'a, S> = dyn FnMut(&mut S, f64, &[f64]) -> Result<(), RateError> + 'a;

/// Steps `y` from the time `span.0` to `span.1` (s), or to the first event.
///
/// `frames` are times (s), rising, at which `frame(system, time, y)` is called on the way, those at the beginning left
/// out and those at the end, or at the event, included. A fixed rule steps from frame to frame, in equal steps; the other
/// methods interpolate. Rates are asked at times from `span.0` on and before `span.1`, so that what jumps at the end of
/// the stretch is still what it was. `counts.evaluations` may not grow beyond `most`.
///
/// An event is where an event function comes to zero from one side, as seen at the ends of steps; one that is zero, to
/// rounding, at the beginning is watched from where it has left zero, to the side where it is 1/4096 of the first step
/// later. One that crosses zero twice within one step is not seen to. Events are located to rounding, the first of
/// several is where the stretch ends, and `y` is then the state there: on the zero, or just before it.
///
/// # Errors
///
/// [`TimeError`]; `y` is then the last state that was reached.
#[allow(
    clippy::too_many_arguments,
    reason = "what is stepped, by what, from where to where, and who looks on"
)]
pub fn advance<S: System + ?Sized>(
    system: &mut S,
    stepping: Stepping,
    span: (f64, f64),
    y: &mut [f64],
    frames: &[f64],
    frame: &mut OnFrame<'_, S>,
    most: u64,
    counts: &mut Counts,
) -> Result<Stopped, TimeError> {
    check(stepping, span)?;
    finite(y).map_err(|source| TimeError::Rate { time: span.0, source })?;
    if span.0 >= span.1 {
        return Ok(Stopped { time: span.0, events: Vec::new() });
    }
    let evaluator = Evaluator::new(system, counts, most, span);
    let course = Course { span, frames, frame };
    match stepping {
        Stepping::Fixed { rule, step } => fixed::advance(evaluator, rule, step, y, course),
        #[cfg(not(feature = "stiff"))]
        Stepping::Adaptive { .. } => Err(TimeError::NotBuiltIn { method: "adaptive" }),
        #[cfg(not(feature = "stiff"))]
        Stepping::Stiff { .. } => Err(TimeError::NotBuiltIn { method: "stiff" }),
        #[cfg(feature = "stiff")]
        Stepping::Adaptive { tolerance } => {
            solver::advance(evaluator, solver::Kind::Adaptive, tolerance, y, course)
        }
        #[cfg(feature = "stiff")]
        Stepping::Stiff { tolerance } => {
            solver::advance(evaluator, solver::Kind::Stiff, tolerance, y, course)
        }
    }
}

/// From when to when, and who looks on.
#[allow(clippy::type_complexity, reason = "as in `advance`")]
pub(super) struct Course<'a, S: ?Sized> {
    pub(super) span: (f64, f64),
    pub(super) frames: &'a [f64],
    frame: &'a mut OnFrame<'a, S>,
}

impl<S: ?Sized> Course<'_, S> {
    /// The next frame after `time`, by index, or none until the end.
    pub(super) fn next(&self, mut index: usize, time: f64) -> (usize, Option<f64>) {
        while self.frames.get(index).is_some_and(|&frame| frame <= time) {
            index += 1;
        }
        (index, self.frames.get(index).copied().filter(|&frame| frame <= self.span.1))
    }

    /// Shows the state at a frame.
    pub(super) fn show(&mut self, system: &mut S, time: f64, y: &[f64]) -> Result<(), TimeError> {
        (self.frame)(system, time, y).map_err(|source| TimeError::Rate { time, source })
    }
}

fn check(stepping: Stepping, span: (f64, f64)) -> Result<(), TimeError> {
    let (what, value) = match stepping {
        Stepping::Fixed { step, .. } => ("the step", step),
        Stepping::Adaptive { tolerance } | Stepping::Stiff { tolerance } => ("the tolerance", tolerance),
    };
    if !(value > 0.0 && value.is_finite()) {
        return Err(TimeError::Range { what, value, range: "finite and positive" });
    }
    for (what, value) in [("the beginning of the stretch", span.0), ("the end of the stretch", span.1)] {
        if !value.is_finite() {
            return Err(TimeError::Range { what, value, range: "finite" });
        }
    }
    Ok(())
}
