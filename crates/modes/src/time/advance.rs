//! One stretch of time, by any method.

use super::evaluate::{Evaluator, finite};
use super::fixed::Way;
#[cfg(feature = "stiff")]
use super::solver;
use super::stepping::Course;
use super::{OnFrame, Stepping, Stopped, System, TimeError, explicit, fixed};
use crate::report::Counts;
use crate::settings::Rule;

/// Spans shorter than this many roundings of the time leave no error to choose a step by: they are one step of a fixed rule.
const SHORTEST: f64 = 4000.0 * f64::EPSILON;

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
    let is_short = y.is_empty() || span.1 - span.0 <= SHORTEST * span.0.abs().max(span.1.abs());
    match stepping {
        Stepping::Adaptive { .. } | Stepping::Stiff { .. } if is_short && is_built_in(stepping) => {
            fixed::advance(evaluator, Way::Rule(Rule::RungeKutta4), span.1 - span.0, y, course)
        }
        Stepping::Fixed { rule, step } => fixed::advance(evaluator, Way::Rule(rule), step, y, course),
        Stepping::Impulses { step } => fixed::advance(evaluator, Way::Impulses, step, y, course),
        Stepping::Adaptive { tolerance } => explicit::advance(evaluator, tolerance, y, course),
        #[cfg(not(feature = "stiff"))]
        Stepping::Stiff { .. } => Err(TimeError::NotBuiltIn { method: "stiff" }),
        #[cfg(feature = "stiff")]
        Stepping::Stiff { tolerance } => solver::advance(evaluator, tolerance, y, course),
    }
}

fn is_built_in(stepping: Stepping) -> bool {
    cfg!(feature = "stiff") || !matches!(stepping, Stepping::Stiff { .. })
}

fn check(stepping: Stepping, span: (f64, f64)) -> Result<(), TimeError> {
    let (what, value) = match stepping {
        Stepping::Fixed { step, .. } | Stepping::Impulses { step } => ("the step", step),
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
