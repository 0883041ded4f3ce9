//! The implicit method, backward differentiation formulas of orders one to five, of the crate diffsol, which only this file and those
//! below it know.

mod equations;

use super::evaluate::{Evaluator, finite};
use super::locate::{Look, Sides};
use super::stepping::Course;
use super::{RateError, Stopped, System, TimeError};
use crate::report::Counts;
use diffsol::error::OdeSolverError;
use diffsol::ode_solver::OdeSolverStatistics;
use diffsol::{
    BdfState, DiffsolError, NalgebraContext, NalgebraLU, OdeBuilder, OdeSolverConfig, OdeSolverMethod,
    OdeSolverProblem, OdeSolverState, OdeSolverStopReason, Vector, VectorCommon,
};
use equations::{Equations, Mat, Stretch, Vect};

const TOO_SHORT: &str = "no step is short enough to meet its tolerance";

/// Steps `y` through a stretch with steps of the method's own choice, each within `tolerance`, relative and absolute.
pub(super) fn advance<S: System + ?Sized>(
    evaluator: Evaluator<'_, S>,
    tolerance: f64,
    y: &mut [f64],
    course: Course<'_, S>,
) -> Result<Stopped, TimeError> {
    let (start, events) = (y.to_vec(), evaluator.system.events());
    let (span, frames) = (course.span, course.frames);
    let mut stretch = Stretch { evaluator, course };
    let mut run = Run { tolerance, span, frames, events, counts: Counts::default(), y };
    let result = run.through(Equations::new(&mut stretch, &start));
    let counts = run.counts;
    stretch.evaluator.counts.add(&counts);
    result
}

/// One stretch under way.
struct Run<'a> {
    tolerance: f64,
    span: (f64, f64),
    frames: &'a [f64],
    /// The number of event functions.
    events: usize,
    /// Steps and events; evaluations are counted where they are made.
    counts: Counts,
    y: &'a mut [f64],
}

impl Run<'_> {
    fn through(&mut self, equations: Equations<'_>) -> Result<Stopped, TimeError> {
        let (from, to) = self.span;
        let mut sides = None;
        if self.events > 0 {
            let mut values = vec![0.0; self.events];
            let mut host = equations.host.borrow_mut();
            host.event_values(from, self.y, &mut values)?;
            sides = Some(Sides::new(values, |index| host.event_side(index)));
        }
        let mut problem = OdeBuilder::<Mat>::new()
            .t0(from)
            .h0(to - from)
            .rtol(self.tolerance)
            .atol([self.tolerance])
            .build_from_eqn(equations)
            .map_err(|error| stuck(from, &error))?;
        // This one is counted over the whole stretch, not for each step; a step that shrinks without end is found by its
        // length.
        problem.ode_options.max_nonlinear_solver_failures = usize::MAX;
        let state: BdfState<Vect> = self.begin(&problem, 1)?;
        let solver = problem.bdf_solver::<NalgebraLU<f64>>(state);
        self.drive(&problem, solver.map_err(|error| stuck(from, &error))?, sides)
    }

    /// The state at the beginning, with a first step that does not go beyond the end.
    fn begin<State: OdeSolverState<Vect>>(
        &self,
        problem: &OdeSolverProblem<Equations<'_>>,
        order: usize,
    ) -> Result<State, TimeError> {
        let (from, to) = self.span;
        let mut state = State::new_without_initialise(problem).map_err(|error| stuck(from, &error))?;
        // Here there is no shorter step to try.
        if let Some(failure) = problem.eqn.take_failure() {
            return Err(failure);
        }
        state.as_mut().set_step_size(to - from, &problem.atol, problem.rtol, &problem.eqn, order);
        let step = state.as_mut().h;
        *step = if *step > 0.0 { step.min(to - from) } else { to - from };
        Ok(state)
    }

    fn drive<'p, 'e: 'p>(
        &mut self,
        problem: &'p OdeSolverProblem<Equations<'e>>,
        mut solver: impl OdeSolverMethod<'p, Equations<'e>>,
        mut sides: Option<Sides>,
    ) -> Result<Stopped, TimeError> {
        let (from, to) = self.span;
        solver.set_stop_time(to).map_err(|error| stuck(from, &error))?;
        let mut before = Before { time: from, size: size(self.y) };
        let mut room = Room::new(self.y.len(), sides.as_ref().map_or(0, Sides::len), *problem.context());
        let mut shown = self.frames.partition_point(|&frame| frame <= from);
        loop {
            let shortest = (16.0 * f64::EPSILON * before.time.abs()).max(f64::MIN_POSITIVE);
            *solver.config_mut().as_base_mut().minimum_timestep = shortest;
            let stepped = solver.step();
            self.count(solver.get_statistics());
            self.y.copy_from_slice(solver.state().y.inner().as_slice());
            problem.eqn.host.borrow().settle(self.y);
            let reached = match (stepped, problem.eqn.take_failure()) {
                (_, Some(failure)) if is_final(&failure) => return Err(failure),
                (Err(_), Some(failure)) => {
                    return Err(failure);
                }
                (Err(error), None) => return Err(stuck(before.time, &error)),
                // What failed in a trial that was rejected has found a way around.
                (Ok(reason), _) => reason == OdeSolverStopReason::TstopReached,
            };
            // A step without the Jacobian that it needs is as short as an explicit one, and there is no end to them.
            if let Some(failure) = problem.eqn.jacobian_failure() {
                return Err(failure);
            }
            let now = if reached { to } else { solver.state().t };
            if now <= before.time {
                return Err(stuck_because(now, TOO_SHORT.to_owned()));
            }
            let mut end = now;
            if let Some(sides) = &mut sides
                && let Some(fraction) = before.look(sides, &problem.eqn, &solver, &mut room, now, self.y)?
                && fraction < 1.0
            {
                end = (before.time + fraction * (now - before.time)).min(now);
            }
            while let Some(&frame) = self.frames.get(shown).filter(|&&frame| frame <= end) {
                shown += 1;
                let y = if frame < now { room.state(&problem.eqn, &solver, frame)? } else { &*self.y };
                problem.eqn.host.borrow_mut().show(frame, y)?;
            }
            if end < now {
                self.y.copy_from_slice(room.state(&problem.eqn, &solver, end)?);
            }
            if let Some(sides) = &sides
                && !sides.crossed.is_empty()
            {
                self.counts.events += sides.crossed.len() as u64;
                return Ok(Stopped { time: end, events: sides.crossed.clone() });
            }
            if reached {
                return Ok(Stopped { time: to, events: Vec::new() });
            }
            before = Before { time: now, size: size(self.y) };
        }
    }

    fn count(&mut self, statistics: &OdeSolverStatistics) {
        self.counts.steps = statistics.number_of_steps as u64;
        self.counts.rejected =
            (statistics.number_of_error_test_failures + statistics.number_of_nonlinear_solver_fails) as u64;
    }
}

/// Where a step began.
struct Before {
    time: f64,
    /// The magnitude of the state there.
    size: f64,
}

impl Before {
    /// The fraction of the step from here to `now` at which the first functions come to zero.
    fn look<'p, 'e: 'p>(
        &self,
        sides: &mut Sides,
        equations: &Equations<'e>,
        solver: &impl OdeSolverMethod<'p, Equations<'e>>,
        room: &mut Room,
        now: f64,
        y: &[f64],
    ) -> Result<Option<f64>, TimeError> {
        let mut values = std::mem::take(&mut room.values);
        equations.host.borrow_mut().event_values(now, y, &mut values)?;
        let length = now - self.time;
        let resolution = 2.0 * f64::EPSILON * now.abs() / length;
        let step = Look { end: now, length, size: self.size.max(size(y)), resolution };
        let found = sides.look(step, &values, &mut |fraction, values| {
            let time = self.time + fraction * length;
            let y = room.state(equations, solver, time)?;
            equations.host.borrow_mut().event_values(time, y, values)
        });
        room.values = values;
        found
    }
}

/// Room for states within a step, and for the values of event functions at its end.
struct Room {
    between: Vect,
    values: Vec<f64>,
}

impl Room {
    fn new(states: usize, events: usize, context: NalgebraContext) -> Self {
        Self { between: Vect::zeros(states, context), values: vec![0.0; events] }
    }

    /// The state at a time within the last step, by interpolation.
    fn state<'p, 'e: 'p>(
        &mut self,
        equations: &Equations<'e>,
        solver: &impl OdeSolverMethod<'p, Equations<'e>>,
        time: f64,
    ) -> Result<&[f64], TimeError> {
        // A step that ends at the stop time may end a rounding before it.
        let time = time.min(solver.state().t);
        solver.interpolate_inplace(time, &mut self.between).map_err(|error| stuck(time, &error))?;
        let y = self.between.inner_mut().as_mut_slice();
        equations.host.borrow().settle(y);
        finite(y).map_err(|source| TimeError::Rate { time, source })?;
        Ok(y)
    }
}

/// Whether a failure leaves nothing to try.
fn is_final(failure: &TimeError) -> bool {
    matches!(failure, TimeError::Evaluations { .. } | TimeError::Rate { source: RateError::Stopped, .. })
}

fn size(y: &[f64]) -> f64 {
    y.iter().fold(0.0, |most, entry| most.max(entry.abs()))
}

fn stuck(time: f64, error: &DiffsolError) -> TimeError {
    use OdeSolverError::{StepSizeTooSmall, TooManyErrorTestFailures};
    let why = match error {
        DiffsolError::OdeSolverError(StepSizeTooSmall { .. }) => TOO_SHORT.to_owned(),
        DiffsolError::OdeSolverError(TooManyErrorTestFailures { .. }) => {
            "ever shorter steps were tried and rejected, 40 in a row".to_owned()
        }
        other => other.to_string(),
    };
    stuck_because(time, why)
}

fn stuck_because(time: f64, why: String) -> TimeError {
    TimeError::Stuck { time, method: "the stiff method".to_owned(), why }
}
