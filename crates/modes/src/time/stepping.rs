//! Ways to step through a stretch of time, and how it may end.

use super::RateError;
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
    /// Equal steps, at most this long (s), each with the impulses that contact, friction and hard limits need in it.
    Impulses {
        /// The longest step (s).
        step: f64,
    },
    /// An explicit method of order eight that chooses its steps.
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
    /// A method for what has contacts and limits, and a system without any.
    #[error("impulses are for figures, and this system is none")]
    NoImpulses,
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
    /// A method that was not built in: it needs this crate's feature `stiff`.
    #[error("{method} is not built in")]
    NotBuiltIn {
        /// The method.
        method: &'static str,
    },
}

/// Is shown the state of each frame, with its time (s); an error ends the stretch.
pub type OnFrame<'a, S> = dyn FnMut(&mut S, f64, &[f64]) -> Result<(), RateError> + 'a;

/// From when to when, and who looks on.
#[allow(clippy::type_complexity, reason = "as in `advance`")]
pub(super) struct Course<'a, S: ?Sized> {
    pub(super) span: (f64, f64),
    pub(super) frames: &'a [f64],
    pub(super) frame: &'a mut OnFrame<'a, S>,
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
