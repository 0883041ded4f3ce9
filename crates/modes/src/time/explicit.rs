//! The explicit method that chooses its steps: Dormand and Prince's pair of order eight.

mod control;
mod pair;
mod tableau;

use super::evaluate::Evaluator;
use super::locate::{Look, Sides};
use super::stepping::Course;
use super::{RateError, Stopped, System, TimeError};
use control::Control;
use pair::Pair;

/// Steps shorter than this many roundings of the time are none.
const LEAST: f64 = 16.0 * f64::EPSILON;

/// Steps `y` through a stretch with steps of its own choice, each within `tolerance`, relative and absolute.
///
/// States at frames, and where events are, are those of the interpolation. Where event functions are watched a step is looked at
/// from frame to frame, so that what comes to zero and goes back between is seen as well as by steps of a frame.
pub(super) fn advance<S: System + ?Sized>(
    evaluator: Evaluator<'_, S>,
    tolerance: f64,
    y: &mut [f64],
    course: Course<'_, S>,
) -> Result<Stopped, TimeError> {
    let (from, to) = course.span;
    let mut march = March::new(evaluator, course, y)?;
    march.pair.begin(&mut march.evaluator, from, y)?;
    let mut h = control::first(&mut march.evaluator, &mut march.pair, (from, to - from), y, tolerance)?;
    let mut control = Control::new();
    // What a try that went too far has failed with.
    let mut failure: Option<TimeError> = None;
    while march.time < to {
        let smooth = march.evaluator.system.smooth_until(march.time).min(to);
        h = fitted(h, smooth - march.time);
        if h < (LEAST * march.time.abs()).max(f64::MIN_POSITIVE) {
            return Err(failure.unwrap_or_else(|| too_short(march.time)));
        }
        let end = if h < smooth - march.time { march.time + h } else { smooth };
        let tried = match march.pair.step(&mut march.evaluator, (march.time, h), y) {
            Ok(()) => march.pair.error(h, y, tolerance),
            Err(error) if is_final(&error) => return Err(error),
            Err(error) => {
                march.evaluator.counts.rejected += 1;
                failure = Some(error);
                h = control.fail(h);
                continue;
            }
        };
        let (next, is_met) = control.next(h, tried);
        if !is_met {
            march.evaluator.counts.rejected += 1;
            h = next;
            continue;
        }
        failure = None;
        march.evaluator.counts.steps += 1;
        march.evaluator.system.note_error(tolerance * tried);
        if let Some(stopped) = march.take(end, h, y)? {
            return Ok(stopped);
        }
        h = next;
        if march.time < to {
            // The rate at the end of a step that is taken has to be there; a shorter step would not change that.
            march.pair.find_end(&mut march.evaluator, march.time)?;
            march.pair.go_on();
        }
    }
    Ok(Stopped { time: to, events: Vec::new() })
}

/// A stretch on its way.
struct March<'a, 'b, S: System + ?Sized> {
    evaluator: Evaluator<'a, S>,
    course: Course<'b, S>,
    pair: Pair,
    /// How far it has come (s).
    time: f64,
    /// The next frame that is to be shown.
    index: usize,
    sides: Option<Sides>,
    /// Of the event functions.
    values: Vec<f64>,
}

impl<'a, 'b, S: System + ?Sized> March<'a, 'b, S> {
    fn new(mut evaluator: Evaluator<'a, S>, course: Course<'b, S>, y: &[f64]) -> Result<Self, TimeError> {
        let (time, events) = (course.span.0, evaluator.system.events());
        let mut values = vec![0.0; events];
        let mut sides = None;
        if events > 0 {
            evaluator.event_values(time, y, &mut values)?;
            sides = Some(Sides::new(values.clone(), |index| evaluator.system.event_side(index)));
        }
        Ok(Self { evaluator, course, pair: Pair::new(y.len()), time, index: 0, sides, values })
    }

    /// Takes the step of length `h` (s) that the pair has found, to the time `end` (s): shows its frames, and ends where an
    /// event is.
    fn take(&mut self, end: f64, h: f64, y: &mut [f64]) -> Result<Option<Stopped>, TimeError> {
        let start = self.time;
        let mut from = start;
        while from < end {
            let (index, frame) = self.course.next(self.index, from);
            self.index = index;
            let frame = frame.filter(|frame| *frame <= end);
            let to = frame.unwrap_or(end);
            let fraction = self.look((start, h), (from, to), end, y)?;
            let is_event = fraction.is_some();
            let stop = fraction
                .filter(|fraction| *fraction < 1.0)
                .map_or(to, |fraction| (from + fraction * (to - from)).min(to));
            if stop < end {
                self.state_at((start, h), stop, y)?;
            } else {
                self.pair.between.copy_from_slice(&self.pair.next);
            }
            if frame.is_some_and(|frame| frame <= stop) {
                self.course.show(self.evaluator.system, stop, &self.pair.between)?;
            }
            from = stop;
            if is_event {
                break;
            }
        }
        self.time = from;
        y.copy_from_slice(&self.pair.between);
        let Some(sides) = self.sides.as_ref().filter(|sides| !sides.crossed.is_empty()) else {
            return Ok(None);
        };
        self.evaluator.counts.events += sides.crossed.len() as u64;
        Ok(Some(Stopped { time: from, events: sides.crossed.clone() }))
    }

    /// Finds the state at a time (s) within the step.
    fn state_at(&mut self, (start, h): (f64, f64), time: f64, y: &[f64]) -> Result<(), TimeError> {
        self.pair.interpolate(&mut self.evaluator, (start, h), y)?;
        let found = self.pair.at(&*self.evaluator.system, (time - start) / h, y);
        found.map_err(|source| TimeError::Rate { time, source })
    }

    /// The fraction of a part of the step at which the first event functions come to zero.
    fn look(
        &mut self,
        step: (f64, f64),
        (from, to): (f64, f64),
        end: f64,
        y: &[f64],
    ) -> Result<Option<f64>, TimeError> {
        let Some(mut sides) = self.sides.take() else { return Ok(None) };
        let found = self.look_by(&mut sides, step, (from, to), end, y);
        self.sides = Some(sides);
        found
    }

    fn look_by(
        &mut self,
        sides: &mut Sides,
        step: (f64, f64),
        (from, to): (f64, f64),
        end: f64,
        y: &[f64],
    ) -> Result<Option<f64>, TimeError> {
        let mut values = std::mem::take(&mut self.values);
        let result = self.values_at(step, (to, end), y, &mut values).and_then(|()| {
            let size = y.iter().chain(&self.pair.next).fold(0.0_f64, |most, entry| most.max(entry.abs()));
            let length = to - from;
            let resolution = 2.0 * f64::EPSILON * to.abs() / length;
            let look = Look { end: to, length, size, resolution };
            sides.look(look, &values, &mut |fraction, values| {
                self.values_at(step, (from + fraction * length, end), y, values)
            })
        });
        self.values = values;
        result
    }

    /// The values of the event functions at a time (s) within the step, which ends at `end` (s).
    fn values_at(
        &mut self,
        step: (f64, f64),
        (time, end): (f64, f64),
        y: &[f64],
        values: &mut [f64],
    ) -> Result<(), TimeError> {
        if time < end {
            self.state_at(step, time, y)?;
            self.evaluator.event_values(time, &self.pair.between, values)
        } else {
            self.evaluator.event_values(end, &self.pair.next, values)
        }
    }
}

/// A step that does not go beyond the end, nor leaves a step behind it that is much shorter than it could be.
fn fitted(h: f64, left: f64) -> f64 {
    if h * 1.01 >= left {
        left
    } else if h * 2.0 > left {
        0.5 * left
    } else {
        h
    }
}

/// Whether a failure leaves nothing to try.
fn is_final(failure: &TimeError) -> bool {
    matches!(failure, TimeError::Evaluations { .. } | TimeError::Rate { source: RateError::Stopped, .. })
}

fn too_short(time: f64) -> TimeError {
    let why = "no step is short enough to meet its tolerance".to_owned();
    TimeError::Stuck { time, method: "the adaptive method".to_owned(), why }
}
