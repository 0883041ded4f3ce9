//! Rules for steps of fixed length.

use super::evaluate::{Evaluator, finite};
use super::locate::{Look, Sides};
use super::stepping::Course;
use super::{Stopped, System, TimeError};
use crate::report::Counts;
use crate::settings::Rule;

/// What a step is taken by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Way {
    /// A rule for rates.
    Rule(Rule),
    /// The system's own impulses.
    Impulses,
}

/// The part of a step by which a gap may be longer than a whole number of steps, for times are rounded.
const ROUNDED: f64 = 1e-9;

/// Steps `y` through a stretch: from frame to frame in equal steps, at most `longest` (s).
pub(super) fn advance<S: System + ?Sized>(
    mut evaluator: Evaluator<'_, S>,
    way: Way,
    longest: f64,
    y: &mut [f64],
    mut course: Course<'_, S>,
) -> Result<Stopped, TimeError> {
    let (from, to) = course.span;
    let mut march = March::new(&mut evaluator, way, from, y)?;
    let mut index = 0;
    while march.time < to {
        let (next, frame) = course.next(index, march.time);
        index = next;
        let stopped = march.to(&mut evaluator, longest, frame.unwrap_or(to), y)?;
        if frame.is_some_and(|frame| frame <= march.time) {
            course.show(evaluator.system, march.time, y)?;
        }
        if let Some(stopped) = stopped {
            return Ok(stopped);
        }
    }
    Ok(Stopped { time: march.time, events: Vec::new() })
}

/// A stretch on its way, which can be left at any time and gone on with.
#[derive(Clone, Debug)]
pub(crate) struct March {
    stepper: Stepper,
    detector: Option<EventDetector>,
    /// How far it has come (s).
    time: f64,
}

impl March {
    /// A stretch of `system` over a span of time (s), from a state on.
    pub(crate) fn begin<S: System + ?Sized>(
        system: &mut S,
        way: Way,
        span: (f64, f64),
        y: &[f64],
        counts: &mut Counts,
    ) -> Result<Self, TimeError> {
        Self::new(&mut Evaluator::new(system, counts, u64::MAX, span), way, span.0, y)
    }

    /// On to the time `stop` (s) within the span, in equal steps of at most `longest` (s), or to the first event. Nothing is
    /// allocated but for an event.
    pub(crate) fn go_on<S: System + ?Sized>(
        &mut self,
        system: &mut S,
        longest: f64,
        (stop, end): (f64, f64),
        y: &mut [f64],
        counts: &mut Counts,
    ) -> Result<Option<Stopped>, TimeError> {
        self.to(&mut Evaluator::new(system, counts, u64::MAX, (self.time, end)), longest, stop, y)
    }

    /// The functions that are watched have jumped, for forces have changed in an instant: what they are now is not an event. Nothing is
    /// allocated.
    pub(crate) fn look_again<S: System + ?Sized>(
        &mut self,
        system: &mut S,
        y: &[f64],
        counts: &mut Counts,
    ) -> Result<(), TimeError> {
        let Some(EventDetector { sides, values, .. }) = &mut self.detector else { return Ok(()) };
        let time = self.time;
        Evaluator::new(system, counts, u64::MAX, (time, time)).event_values(time, y, values)?;
        sides.begin_anew(values);
        Ok(())
    }

    /// From a time (s) and a state on.
    fn new<S: System + ?Sized>(
        evaluator: &mut Evaluator<'_, S>,
        way: Way,
        time: f64,
        y: &[f64],
    ) -> Result<Self, TimeError> {
        let stepper = Stepper::new(way, &*evaluator.system, y)?;
        let detector = EventDetector::new(evaluator, time, y)?;
        Ok(Self { stepper, detector, time })
    }

    /// On to the time `stop` (s), in equal steps of at most `longest` (s), or to the first event.
    fn to<S: System + ?Sized>(
        &mut self,
        evaluator: &mut Evaluator<'_, S>,
        longest: f64,
        stop: f64,
        y: &mut [f64],
    ) -> Result<Option<Stopped>, TimeError> {
        let start = self.time;
        let steps = ((stop - start) / longest - ROUNDED).ceil().max(1.0);
        let mut taken = 0.0;
        while taken < steps {
            taken += 1.0;
            let end = if taken < steps { start + (stop - start) * (taken / steps) } else { stop };
            let length = end - self.time;
            self.stepper.begin(evaluator, self.time, y)?;
            self.stepper.step(evaluator, self.time, length, y)?;
            evaluator.counts.steps += 1;
            if let Some(detector) = &mut self.detector
                && let Some(fraction) = detector.look(evaluator, &mut self.stepper, (self.time, end), y)?
            {
                self.time = if fraction < 1.0 { (self.time + length * fraction).min(end) } else { end };
                y.copy_from_slice(&detector.state);
                evaluator.counts.events += detector.sides.crossed.len() as u64;
                return Ok(Some(Stopped { time: self.time, events: detector.sides.crossed.clone() }));
            }
            y.copy_from_slice(&self.stepper.next);
            self.time = end;
        }
        Ok(None)
    }
}

/// The room that a rule needs for its steps.
#[derive(Clone, Debug)]
struct Stepper {
    way: Way,
    /// Which entries of the state are positions, for the rules that treat them apart.
    positions: Vec<bool>,
    /// The rate at the beginning of the step.
    first: Vec<f64>,
    rate: Vec<f64>,
    sum: Vec<f64>,
    state: Vec<f64>,
    /// The state at the end of the step.
    next: Vec<f64>,
}

impl Stepper {
    fn new<S: System + ?Sized>(way: Way, system: &S, y: &[f64]) -> Result<Self, TimeError> {
        let n = y.len();
        let mut positions = Vec::new();
        if let Way::Rule(rule @ (Rule::SemiImplicitEuler | Rule::ConstantAcceleration)) = way {
            // What is written over are positions.
            let mut rate = vec![f64::NAN; n];
            if !system.position_rate(y, &mut rate) {
                return Err(TimeError::NoPositions { rule });
            }
            positions = rate.iter().map(|rate| !rate.is_nan()).collect();
        }
        let zeros = || vec![0.0; n];
        Ok(Self {
            way,
            positions,
            first: zeros(),
            rate: zeros(),
            sum: zeros(),
            state: zeros(),
            next: zeros(),
        })
    }

    /// Evaluates the rate at the beginning of a step, or of several from the same beginning.
    fn begin<S: System + ?Sized>(
        &mut self,
        evaluator: &mut Evaluator<'_, S>,
        t: f64,
        y: &[f64],
    ) -> Result<(), TimeError> {
        if self.way == Way::Impulses { Ok(()) } else { evaluator.rate(t, y, &mut self.first) }
    }

    /// The state `next`, a step of length `h` (s) after `y`.
    fn step<S: System + ?Sized>(
        &mut self,
        evaluator: &mut Evaluator<'_, S>,
        t: f64,
        h: f64,
        y: &[f64],
    ) -> Result<(), TimeError> {
        match self.way {
            Way::Rule(Rule::ExplicitEuler) => after(y, h, &self.first, &mut self.next),
            Way::Rule(Rule::SemiImplicitEuler) => self.kick_then_drift(evaluator.system, h, h, y),
            Way::Rule(Rule::ConstantAcceleration) => self.kick_then_drift(evaluator.system, h, 0.5 * h, y),
            Way::Rule(Rule::RungeKutta4) => self.runge_kutta(evaluator, t, h, y)?,
            Way::Impulses => evaluator.step_by_impulses(t, h, y, &mut self.next)?,
        }
        evaluator.system.settle(&mut self.next);
        finite(&self.next).map_err(|source| TimeError::Rate { time: t + h, source })
    }

    /// All but positions by the rate at the beginning; positions by the velocities after `kick` (s).
    ///
    /// ```text
    /// v⁺ = v + h·a        q⁺ = q + h·q̇(q, v + kick·a)
    /// ```
    fn kick_then_drift<S: System + ?Sized>(&mut self, system: &S, h: f64, kick: f64, y: &[f64]) {
        for i in 0..y.len() {
            self.state[i] = if self.positions[i] { y[i] } else { y[i] + kick * self.first[i] };
        }
        self.rate.copy_from_slice(&self.first);
        system.position_rate(&self.state, &mut self.rate);
        after(y, h, &self.rate, &mut self.next);
    }

    /// The classical rule of order four.
    ///
    /// ```text
    /// k₁ = f(t, y)               k₂ = f(t + h/2, y + h·k₁/2)
    /// k₃ = f(t + h/2, y + h·k₂/2)   k₄ = f(t + h, y + h·k₃)
    /// y⁺ = y + h·(k₁ + 2k₂ + 2k₃ + k₄)/6
    /// ```
    ///
    /// # Source
    ///
    /// W. Kutta: Beitrag zur näherungsweisen Integration totaler Differentialgleichungen. Zeitschrift für Mathematik und
    /// Physik 46 (1901), 435–453.
    fn runge_kutta<S: System + ?Sized>(
        &mut self,
        evaluator: &mut Evaluator<'_, S>,
        t: f64,
        h: f64,
        y: &[f64],
    ) -> Result<(), TimeError> {
        self.rate.copy_from_slice(&self.first);
        self.sum.copy_from_slice(&self.first);
        for (at, weight) in [(0.5, 2.0), (0.5, 2.0), (1.0, 1.0)] {
            after(y, at * h, &self.rate, &mut self.state);
            evaluator.rate(t + at * h, &self.state, &mut self.rate)?;
            for (sum, rate) in self.sum.iter_mut().zip(&self.rate) {
                *sum += weight * rate;
            }
        }
        after(y, h / 6.0, &self.sum, &mut self.next);
        Ok(())
    }
}

/// What is needed to see events.
#[derive(Clone, Debug)]
struct EventDetector {
    sides: Sides,
    values: Vec<f64>,
    /// The state at the event.
    state: Vec<f64>,
    scratch: Vec<f64>,
}

impl EventDetector {
    fn new<S: System + ?Sized>(
        evaluator: &mut Evaluator<'_, S>,
        t: f64,
        y: &[f64],
    ) -> Result<Option<Self>, TimeError> {
        let events = evaluator.system.events();
        if events == 0 {
            return Ok(None);
        }
        let mut values = vec![0.0; events];
        evaluator.event_values(t, y, &mut values)?;
        let sides = Sides::new(values.clone(), |index| evaluator.system.event_side(index));
        Ok(Some(Self { sides, values, state: y.to_vec(), scratch: vec![0.0; events] }))
    }

    /// The fraction of the step from `y` to `stepper.next` at which the first functions come to zero; `state` is then the
    /// state there.
    fn look<S: System + ?Sized>(
        &mut self,
        evaluator: &mut Evaluator<'_, S>,
        stepper: &mut Stepper,
        (start, end): (f64, f64),
        y: &[f64],
    ) -> Result<Option<f64>, TimeError> {
        evaluator.event_values(end, &stepper.next, &mut self.values)?;
        let size = y.iter().chain(&stepper.next).fold(0.0_f64, |most, entry| most.max(entry.abs()));
        let step = Look { end, length: end - start, size, resolution: 0.0 };
        let Self { sides, values, state, scratch } = self;
        // The step's end is looked at first, and again where an event is there; `next` is scratch in between.
        state.copy_from_slice(&stepper.next);
        let mut probe = |fraction: f64, values: &mut [f64]| {
            let h = fraction * (end - start);
            stepper.step(evaluator, start, h, y)?;
            evaluator.event_values(start + h, &stepper.next, values)
        };
        let found = sides.look(step, values, &mut probe)?;
        match found {
            Some(fraction) if fraction < 1.0 => {
                probe(fraction, scratch)?;
                state.copy_from_slice(&stepper.next);
            }
            _ => stepper.next.copy_from_slice(state),
        }
        Ok(found)
    }
}

/// `y + h·rate`.
fn after(y: &[f64], h: f64, rate: &[f64], next: &mut [f64]) {
    for ((next, y), rate) in next.iter_mut().zip(y).zip(rate) {
        *next = y + h * rate;
    }
}
