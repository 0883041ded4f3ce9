//! One pass through a simulation, by one method.

use super::active_contacts::state::ActiveContacts;
use super::carries::whole_body;
use super::closing;
use super::driven::{Driven, Meaning, Mode};
use super::guard;
use super::ledger::{Ledger, least_energy};
use super::pushes;
use super::record::{Record, near};
use super::touching;
use crate::body::Body;
use crate::carry::Held;
use crate::failure::{FailureKind, Remedy, RunError, RunFailure, SetupError};
use crate::phase::{GROUND, Phase, Role};
use crate::push::Thrust;
use crate::report::{Counts, Impact, Landing, Observer, PhaseReport};
use crate::settings::{Rule, Settings};
use crate::simulation::Simulation;
use crate::time::{RateError, Stepping, Stopped, TimeError, advance};
use crate::{Drive, Outcome};
use std::sync::Arc;

/// Rounds of changes at one instant that are still believed.
const MOST_ROUNDS: usize = 1000;

/// What a pass came to.
#[derive(Clone)]
pub(crate) struct Passed {
    pub(crate) record: Record,
    pub(crate) ledger: Ledger,
    pub(crate) counts: Counts,
    pub(crate) outcomes: Vec<Outcome>,
    pub(crate) impacts: Vec<Impact>,
    pub(crate) landings: Vec<Landing>,
    pub(crate) phases: Vec<PhaseReport>,
    /// Whether anything was integrated.
    pub(crate) is_dynamic: bool,
    /// Whether velocities, forces, or how forces change, jumped on the way.
    pub(crate) jumps: bool,
    /// What the ground did to what dynamics move, as in the state of a phase.
    pub(crate) ground: [f64; GROUND],
    /// What pushes of the world did (J).
    pub(crate) pushed: f64,
    /// What a method that chooses its steps said of their errors, added up.
    pub(crate) errors: f64,
    /// Whether it was by impulses.
    pub(crate) by_impulses: bool,
}

/// One pass, on its way.
#[derive(Clone)]
pub(crate) struct Pass {
    pub(crate) simulation: Arc<Simulation>,
    pub(crate) settings: Settings,
    pub(crate) stepping: Stepping,
    pub(crate) t: f64,
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
    /// The last accelerations that were found.
    pub(crate) a: Vec<f64>,
    pub(crate) driven: Vec<Driven>,
    /// By degree of freedom: when its drives began again last (s).
    pub(crate) again: Vec<f64>,
    /// The whole figure, for analyses and impacts.
    pub(crate) body: Body<f64>,
    /// Where the next stretch has to end at the latest (s).
    pub(crate) cap: f64,
    /// Where whoever steps it wants to look next (s), if that is not at frames.
    pub(crate) until: f64,
    /// What stands on the ground and stays there.
    pub(crate) active: ActiveContacts,
    /// What an impact has leapt over: drives that wait for a velocity.
    pub(crate) leapt: Vec<Meaning>,
    /// What the world does, by push, and whether a blow has been given.
    pub(crate) thrusts: Vec<Thrust>,
    pub(crate) struck: Vec<bool>,
    /// When each part of the sequence that is over was (s).
    pub(crate) stages: Vec<f64>,
    /// What is held, and the simulation with that; none before the first is looked for.
    pub(crate) held: Option<Held>,
    pub(crate) loaded: Option<Box<Simulation>>,
    pub(crate) passed: Passed,
    pub(super) work: f64,
    pub(super) heat: f64,
    pub(super) compiled: Option<Compiled>,
    /// Time and number of changes without time going on.
    rounds: (f64, usize),
    /// Whether nobody wants accelerations and what stands, but positions and velocities alone.
    is_sketch: bool,
    /// Where steps of an explicit method that stability makes shorter than this (s) are refused, though they are of its own choice.
    pub(super) shortest: Option<f64>,
}

/// A phase, and what it was compiled for.
#[derive(Clone)]
pub(super) struct Compiled {
    pub(super) phase: Phase,
    roles: Vec<Role>,
    q: Vec<f64>,
    /// The drives whose forces depend on the state when steps were last looked at: degree of freedom, and place among its drives.
    pub(super) servos: Vec<(usize, usize)>,
}

/// Runs through a simulation once.
pub(crate) fn pass(
    simulation: &Arc<Simulation>,
    settings: &Settings,
    stepping: Stepping,
    observer: &mut dyn Observer,
) -> Result<Passed, RunError> {
    Pass::new(simulation, settings, stepping)?.through(observer)
}

/// Runs through a simulation once, for nothing but positions and velocities in frames, and no evaluation for their sake. With a
/// `shortest` step (s), one that stability makes shorter is refused.
pub(crate) fn sketch(
    simulation: &Arc<Simulation>,
    settings: &Settings,
    stepping: Stepping,
    shortest: Option<f64>,
    observer: &mut dyn Observer,
) -> Result<Passed, RunError> {
    let mut pass = Pass::new(simulation, settings, stepping)?;
    // Intensive drives begin with the acceleration of the frame.
    let mut drives = simulation.drives.iter().flatten();
    pass.is_sketch = !drives.any(|step| matches!(step.drive, Drive::Intensive { .. }));
    pass.shortest = shortest;
    pass.through(observer)
}

impl Pass {
    fn through(mut self, observer: &mut dyn Observer) -> Result<Passed, RunError> {
        self.begin_all()?;
        while self.t < self.settings.duration - near(self.settings.duration) {
            if observer.is_cancelled() {
                return Err(RunError::Cancelled);
            }
            self.stretch(observer)?;
        }
        self.finish()
    }

    pub(crate) fn new(
        simulation: &Arc<Simulation>,
        settings: &Settings,
        stepping: Stepping,
    ) -> Result<Self, RunError> {
        let by_impulses = matches!(stepping, Stepping::Impulses { .. });
        if simulation.collisions.is_some() && !by_impulses {
            return Err(SetupError::NeedsImpulses.into());
        }
        let figure = &simulation.figure;
        let (mut q, mut v) = (simulation.q.clone(), simulation.v.clone());
        let mut a = vec![0.0; v.len()];
        figure.follow(&mut q, &mut v, &mut a);
        let mut body = whole_body(simulation, by_impulses)?;
        if !by_impulses {
            closing::check(simulation, &mut body, &q, &v)?;
        }
        touching::check(simulation)?;
        let at_rest = |_| Driven::new(0, 0.0, Mode::Still, f64::INFINITY);
        Ok(Self {
            simulation: Arc::clone(simulation),
            settings: settings.clone(),
            stepping,
            t: 0.0,
            driven: (0..v.len()).map(at_rest).collect(),
            again: vec![f64::NEG_INFINITY; v.len()],
            q,
            v,
            a,
            body,
            cap: f64::INFINITY,
            until: f64::INFINITY,
            active: ActiveContacts::default(),
            leapt: Vec::new(),
            thrusts: pushes::thrusts(simulation)?,
            struck: vec![false; simulation.pushes.len()],
            stages: Vec::new(),
            held: None,
            loaded: None,
            passed: Passed {
                record: Record::new(settings.duration, settings.rate),
                ledger: Ledger::new(least_energy(simulation)),
                counts: Counts::default(),
                outcomes: Vec::new(),
                impacts: Vec::new(),
                landings: Vec::new(),
                phases: Vec::new(),
                is_dynamic: false,
                jumps: false,
                ground: [0.0; GROUND],
                pushed: 0.0,
                errors: 0.0,
                by_impulses,
            },
            work: 0.0,
            heat: 0.0,
            compiled: None,
            rounds: (0.0, 0),
            is_sketch: false,
            shortest: None,
        })
    }

    /// From now to the next change.
    fn stretch(&mut self, observer: &mut dyn Observer) -> Result<(), RunError> {
        let (mut compiled, meanings, end) = self.open()?;
        let result = self.step(&mut compiled.phase, end, observer);
        self.compiled = Some(compiled);
        self.close(&result?, &meanings)
    }

    /// Whether contact, friction and hard limits act by impulses in each step, and are no events.
    pub(crate) fn by_impulses(&self) -> bool {
        matches!(self.stepping, Stepping::Impulses { .. })
    }

    /// What is to be stepped from now on, what its events mean, and when it ends (s).
    pub(super) fn open(&mut self) -> Result<(Compiled, Vec<Meaning>, f64), RunError> {
        self.check_rounds()?;
        let end = self.next_stop();
        self.track(end)?;
        let mut compiled = self.compile()?;
        let meanings = self.load(&mut compiled.phase, end)?;
        self.note_phase(&compiled.phase);
        Ok((compiled, meanings, end))
    }

    /// What follows from where a stretch stopped.
    pub(super) fn close(&mut self, stopped: &Stopped, meanings: &[Meaning]) -> Result<(), RunError> {
        self.cap = f64::INFINITY;
        self.passed.jumps |= !stopped.events.is_empty();
        let mut events: Vec<Meaning> = stopped.events.iter().map(|&event| meanings[event]).collect();
        self.drop_wrong_ways(&mut events)?;
        self.change(&events)
    }

    /// Steps the phase, frames and all.
    fn step(
        &mut self,
        phase: &mut Phase,
        end: f64,
        observer: &mut dyn Observer,
    ) -> Result<Stopped, RunError> {
        let Self { passed, q, v, a, t, active, simulation, settings, is_sketch, .. } = self;
        let is_sketch = *is_sketch;
        let mut y = phase.pack(q, v, self.work, self.heat);
        let at = |error| guard::of_rate(*t, error);
        if passed.record.due().is_some_and(|due| due <= *t + near(*t)) {
            phase.accelerations(*t, &y, a).map_err(at)?;
            passed.counts.evaluations += 1;
            passed.record.push(q, v, a);
            passed.record.press(phase.pressed(&active.links), phase.between());
        }
        let dynamic = phase.is_dynamic();
        let (work, heat) = (phase.accounts(), phase.accounts() + 1);
        if dynamic {
            let energy = phase.energy(*t, &y).map_err(|error| at(RateError::Dynamics(error)))?;
            passed.ledger.begin(energy, y[work], y[heat]);
        }
        let stepping = if dynamic {
            self.stepping
        } else {
            // Nothing is integrated; events on curves are looked for once a frame.
            Stepping::Fixed { rule: Rule::ExplicitEuler, step: settings.rate.recip() }
        };
        let frames = passed.record.before(end).to_vec();
        let frames = &frames[frames.partition_point(|frame| *frame <= *t + near(*t))..];
        let mut failure: Option<Box<RunFailure>> = None;
        let Passed { record, ledger, counts, .. } = passed;
        let mut spent = 0;
        let mut frame = |phase: &mut Phase, time: f64, y: &[f64]| -> Result<(), RateError> {
            phase.unpack(time, y, q, v);
            if !(is_sketch && dynamic) {
                phase.accelerations(time, y, a)?;
                spent += 1;
            }
            record.push(q, v, a);
            record.press(phase.pressed(&active.links), phase.between());
            observer.progress(time / settings.duration);
            if dynamic {
                let share = ledger.check(phase.energy(time, y)?, y[work], y[heat]);
                failure = guard::look(simulation, &settings.guard, phase, stepping, (time, q), share).err();
            }
            // Any error ends the stretch; the failure says which it is.
            if failure.is_some() || observer.is_cancelled() { Err(RateError::Stopped) } else { Ok(()) }
        };
        let result = advance(
            phase,
            stepping,
            (*t, end),
            &mut y,
            frames,
            &mut frame,
            settings.guard.evaluations,
            counts,
        );
        counts.evaluations += spent;
        passed.errors += phase.take_errors();
        let stopped = match (result, failure) {
            (Ok(stopped), None) => stopped,
            (_, Some(failure)) => {
                return Err(guard::explain(
                    simulation,
                    phase,
                    stepping,
                    (&y, passed.record.last()),
                    *failure,
                ));
            }
            (Err(TimeError::Rate { source: RateError::Stopped, .. }), None) => {
                return Err(RunError::Cancelled);
            }
            (Err(error), None) => {
                let failure = guard::of_time(error)?;
                return Err(guard::explain(simulation, phase, stepping, (&y, passed.record.last()), failure));
            }
        };
        *t = stopped.time;
        phase.unpack(*t, &y, q, v);
        (self.work, self.heat) = (y[work], y[heat]);
        if !simulation.pushes.is_empty() {
            passed.pushed += y[y.len() - 1];
        }
        for (sum, part) in passed.ground.iter_mut().zip(&y[heat + 1..]) {
            *sum += part;
        }
        if dynamic {
            let energy = phase.energy(*t, &y).map_err(|error| guard::of_rate(*t, error.into()))?;
            let share = passed.ledger.check(energy, y[work], y[heat]);
            if let Err(failure) = guard::look(simulation, &settings.guard, phase, stepping, (*t, q), share) {
                return Err(guard::explain(
                    simulation,
                    phase,
                    stepping,
                    (&y, passed.record.last()),
                    *failure,
                ));
            }
            passed.ledger.end(energy, y[work], y[heat]);
        }
        Ok(stopped)
    }

    /// The phase for the roles that the drives give.
    fn compile(&mut self) -> Result<Compiled, RunError> {
        let roles = self.roles();
        if let Some(compiled) = self.compiled.take()
            && compiled.roles == roles
            && self.stands_where(&compiled)
        {
            return self.look_again(compiled);
        }
        self.end_phase();
        let simulation = self.loaded.as_deref().unwrap_or(&self.simulation);
        let mut phase = Phase::with(simulation, &roles, &self.q, self.settings.leave_out)?;
        if let Stepping::Impulses { step } = self.stepping {
            phase.step_by_impulses_of(step)?;
        }
        let mut compiled = Compiled { phase, roles, q: self.q.clone(), servos: self.servos() };
        // What is watched for may bring back what was left out.
        self.load(&mut compiled.phase, self.next_stop())?;
        let phase = &compiled.phase;
        self.passed.phases.push(PhaseReport { start: self.t, ..phase.report.clone() });
        self.passed.is_dynamic |= phase.is_dynamic();
        if phase.is_dynamic() {
            self.look_before(&mut compiled.phase)?;
        }
        Ok(compiled)
    }

    /// The roles that the drives give.
    pub(crate) fn roles(&self) -> Vec<Role> {
        let mut roles: Vec<Role> = self.driven.iter().map(Driven::role).collect();
        for follower in self.simulation.figure.followers() {
            roles[follower.dof] = roles[follower.leader];
        }
        roles
    }

    /// Whether what stands still stands where it stood when the phase was compiled.
    fn stands_where(&self, compiled: &Compiled) -> bool {
        let joints = self.simulation.figure.layout().joints().iter();
        joints.filter(|at| compiled.roles[at.v..at.v + at.nv].contains(&Role::Still)).all(|at| {
            // A joint some of whose axes move has the others where they are.
            (0..at.nq).all(|i| {
                let moves = at.nq == at.nv && compiled.roles[at.v + i] != Role::Still;
                moves || self.q[at.q + i].to_bits() == compiled.q[at.q + i].to_bits()
            })
        })
    }

    /// The force of the frame of every degree of freedom that tracks a target.
    fn track(&mut self, end: f64) -> Result<(), RunError> {
        self.find_forces(end - self.t)?;
        // A force that is new may lift off what rests.
        let tracks = |driven: &Driven| driven.held.is_some() && matches!(driven.mode, Mode::Track(..));
        if self.driven.iter().any(tracks) {
            self.rest(&[])?;
        }
        // And make a contact patch give way.
        let is_new = self.driven.iter().any(|driven| matches!(driven.mode, Mode::Track(..)));
        if is_new { self.find_contacts(&[]) } else { Ok(()) }
    }

    /// When the next stretch has to end (s).
    pub(super) fn next_stop(&self) -> f64 {
        let mut stop = self.settings.duration.min(self.cap);
        let later = |time: f64| time > self.t + near(self.t);
        for (driven, steps) in self.driven.iter().zip(&self.simulation.drives) {
            let times = driven.breaks().into_iter().chain([driven.ends(steps)]);
            stop = times.filter(|time| later(*time)).fold(stop, f64::min);
        }
        let breaks = self.push_breaks().chain(self.carry_breaks()).chain([self.stage_end()]);
        stop = breaks.filter(|time| later(*time)).fold(stop, f64::min);
        if self.driven.iter().any(|driven| matches!(driven.mode, Mode::Track(..))) {
            stop = self.passed.record.after(self.t).map_or(stop, |frame| frame.min(stop)).min(self.until);
        }
        stop
    }

    fn check_rounds(&mut self) -> Result<(), RunError> {
        let (time, rounds) = &mut self.rounds;
        *rounds = if self.t > *time + near(self.t) { 0 } else { *rounds + 1 };
        *time = time.max(self.t);
        if *rounds <= MOST_ROUNDS {
            return Ok(());
        }
        let cause = FailureKind::Impacts { count: *rounds };
        let remedies = vec![Remedy::RoomBetween, Remedy::SoftLimits];
        Err(Box::new(RunFailure { time: self.t, dof: None, cause, remedies }).into())
    }

    /// What is watched for may have brought back links that were left out until now.
    fn note_phase(&mut self, phase: &Phase) {
        let changed = |last: &PhaseReport| last.dropped.len() != phase.report.dropped.len();
        if self.passed.phases.last().is_some_and(changed) {
            self.end_phase();
            self.passed.phases.push(PhaseReport { start: self.t, ..phase.report.clone() });
        }
    }

    fn end_phase(&mut self) {
        if let Some(last) = self.passed.phases.last_mut() {
            last.end = self.t;
        }
    }

    /// The last frame, and what did not come to its end.
    fn finish(mut self) -> Result<Passed, RunError> {
        if self.passed.record.due().is_some() {
            let mut compiled = self.compile()?;
            self.load(&mut compiled.phase, self.next_stop())?;
            let y = compiled.phase.pack(&self.q, &self.v, self.work, self.heat);
            let found = compiled.phase.accelerations(self.t, &y, &mut self.a);
            found.map_err(|error| guard::of_rate(self.t, error))?;
            self.passed.record.push(&self.q, &self.v, &self.a);
            let pressed = compiled.phase.pressed(&self.active.links);
            self.passed.record.press(pressed, compiled.phase.between());
        }
        self.end_phase();
        self.note_unfinished();
        Ok(self.passed)
    }
}
