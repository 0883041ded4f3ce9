//! A pass that is gone through bit by bit, by whoever calls.

use super::driven::{Meaning, Mode};
use super::guard;
use super::pass::{Compiled, Pass};
use super::record::near;
use crate::drive::Aim;
use crate::drive::force::Force;
use crate::failure::RunError;
use crate::phase::Phase;
use crate::push::Push;
use crate::settings::Rule;
use crate::time::{March, Stepping, Stopped, TimeError, Way, advance};
use solaris_dynamics::Wrench;
use std::sync::Arc;

/// A stretch that has been begun.
#[derive(Clone)]
pub(crate) struct Stretch {
    compiled: Compiled,
    meanings: Vec<Meaning>,
    y: Vec<f64>,
    end: f64,
    /// Where a fixed rule is in it.
    march: Option<March>,
}

/// A pass, and the stretch that it is in.
#[derive(Clone)]
pub(crate) struct Progress {
    pub(crate) pass: Pass,
    stretch: Option<Stretch>,
}

impl Progress {
    /// Everything begins.
    pub(crate) fn begin(mut pass: Pass) -> Result<Self, RunError> {
        pass.begin_all()?;
        Ok(Self { pass, stretch: None })
    }

    /// On to a time (s).
    ///
    /// Where that fails, the state is that of the last instant that was reached.
    pub(crate) fn go_to(&mut self, until: f64) -> Result<(), RunError> {
        self.pass.until = until;
        while self.pass.t < until - near(until) {
            let mut stretch = self.stretch.take().map_or_else(|| self.pass.begin_stretch(), Ok)?;
            let stop = stretch.end.min(until);
            let stopped = self.pass.go_on(&mut stretch, stop)?;
            if stopped.is_some() || self.pass.t >= stretch.end - near(stretch.end) {
                let stopped = stopped.unwrap_or(Stopped { time: self.pass.t, events: Vec::new() });
                let meanings = self.leave(stretch)?;
                self.pass.close(&stopped, &meanings)?;
            } else {
                self.stretch = Some(stretch);
            }
        }
        // A force that is found anew for each call.
        if self.pass.driven.iter().any(|driven| matches!(driven.mode, Mode::Track(..))) {
            self.interrupt()?;
        }
        Ok(())
    }

    /// Ends the stretch that it is in, so that anything may change.
    pub(crate) fn interrupt(&mut self) -> Result<(), RunError> {
        self.stretch.take().map_or(Ok(()), |stretch| self.leave(stretch).map(|_| ()))
    }

    /// Ends a stretch; what its events mean.
    fn leave(&mut self, mut stretch: Stretch) -> Result<Vec<Meaning>, RunError> {
        self.pass.settle_accounts(&mut stretch)?;
        self.pass.compiled = Some(stretch.compiled);
        Ok(stretch.meanings)
    }

    /// Whether a constant force acts on a degree of freedom, be it of zero.
    pub(crate) fn takes_force(&self, dof: usize) -> bool {
        matches!(self.pass.driven[dof].mode, Mode::Force(Force::Constant(_)))
    }

    /// Another constant force (N m or N) on a degree of freedom that [takes](Self::takes_force) one.
    pub(crate) fn set_force(&mut self, dof: usize, force: f64) -> Result<(), RunError> {
        self.pass.driven[dof].mode = Mode::Force(Force::Constant(force));
        if self.pass.driven.iter().any(|driven| driven.held.is_some()) {
            // What rests at a limit may be lifted off it.
            self.interrupt()?;
            self.pass.change(&[])?;
        } else if let Some(stretch) = &mut self.stretch {
            stretch.compiled.phase.set_force(dof, Force::Constant(force));
        }
        Ok(())
    }

    /// Other forces on the points that are pushed by now.
    pub(crate) fn change_forces(&mut self, pushes: &[Push]) -> Result<(), RunError> {
        self.pass.change_forces(pushes)?;
        if self.rests() {
            // What rests or stands may be lifted.
            self.interrupt()?;
            return self.pass.change(&[]);
        }
        if let Some(stretch) = &mut self.stretch {
            for (i, thrust) in self.pass.thrusts.iter().enumerate() {
                stretch.compiled.phase.set_push(i, Some(thrust.clone()));
            }
        }
        self.look_again()
    }

    /// Whether a servo that goes to a place leads a degree of freedom now.
    pub(crate) fn takes_target(&self, dof: usize) -> bool {
        let driven = &self.pass.driven[dof];
        let step = self.pass.simulation.drives[dof].get(driven.step);
        let servo = step.and_then(|step| step.drive.servo());
        matches!(driven.mode, Mode::Force(_)) && servo.is_some_and(|servo| matches!(servo.aim, Aim::At(_)))
    }

    /// Another target (rad or m) for a degree of freedom that [takes](Self::takes_target) one.
    pub(crate) fn set_target(&mut self, dof: usize, to: f64) -> Result<(), RunError> {
        let driven = &mut self.pass.driven[dof];
        let steps = &mut Arc::make_mut(&mut self.pass.simulation).drives[dof];
        if let Some(servo) = steps.get_mut(driven.step).and_then(|step| step.drive.servo_mut()) {
            servo.aim = Aim::At(to);
        }
        if let Mode::Force(force) = &mut driven.mode {
            force.lead_to(to);
        }
        if self.rests() {
            self.interrupt()?;
            return self.pass.change(&[]);
        }
        if let Some(stretch) = &mut self.stretch {
            stretch.compiled.phase.lead_to(dof, to);
        }
        self.look_again()
    }

    /// Whether something rests at a limit or stands on the ground.
    fn rests(&self) -> bool {
        !self.pass.active.holds.is_empty() || self.pass.driven.iter().any(|driven| driven.held.is_some())
    }

    /// Forces have jumped: what is watched is looked at anew.
    fn look_again(&mut self) -> Result<(), RunError> {
        let Some(Stretch { compiled, y, march: Some(march), .. }) = &mut self.stretch else { return Ok(()) };
        let found = march.look_again(&mut compiled.phase, y, &mut self.pass.passed.counts);
        found.map_err(|error| guard::of_time(error).map_or_else(|error| error, RunError::from))
    }

    /// What the ground does to links now, by link, about the world's origin, where it is found along with the
    /// [accelerations](Self::accelerations), which were asked for just before.
    pub(crate) fn pressed(&self) -> impl Iterator<Item = (usize, Wrench<f64>)> + '_ {
        let phases = self.stretch.iter().map(|stretch| &stretch.compiled.phase);
        phases.flat_map(|phase| phase.pressed(&self.pass.active.links))
    }

    /// The same of what links do to each other.
    pub(crate) fn between(&self) -> impl Iterator<Item = (usize, Wrench<f64>)> + '_ {
        let phases = self.stretch.iter().map(|stretch| &stretch.compiled.phase);
        phases.flat_map(Phase::between).flat_map(|between| between.wrenches(between.links))
    }

    /// The accelerations now (rad/s² or m/s²).
    pub(crate) fn accelerations(&mut self) -> Result<&[f64], RunError> {
        if self.stretch.is_none() {
            self.stretch = Some(self.pass.begin_stretch()?);
        }
        if let Some(Stretch { compiled, y, .. }) = &mut self.stretch {
            let found = compiled.phase.accelerations(self.pass.t, y, &mut self.pass.a);
            found.map_err(|error| guard::of_rate(self.pass.t, error))?;
        }
        Ok(&self.pass.a)
    }
}

impl Pass {
    fn begin_stretch(&mut self) -> Result<Stretch, RunError> {
        let (mut compiled, meanings, end) = self.open()?;
        let y = compiled.phase.pack(&self.q, &self.v, self.work, self.heat);
        let phase = &mut compiled.phase;
        if phase.is_dynamic() {
            let energy = phase.energy(self.t, &y).map_err(|error| guard::of_rate(self.t, error.into()))?;
            self.passed.ledger.begin(energy, y[phase.accounts()], y[phase.accounts() + 1]);
        }
        let stepping = self.stepping_of(phase);
        let way = match stepping {
            Stepping::Fixed { rule, .. } => Some(Way::Rule(rule)),
            Stepping::Impulses { .. } => Some(Way::Impulses),
            _ => None,
        };
        let march = match way {
            Some(way) => {
                let begun = March::begin(phase, way, (self.t, end), &y, &mut self.passed.counts);
                Some(
                    begun
                        .map_err(|error| guard::of_time(error).map_or_else(|error| error, RunError::from))?,
                )
            }
            None => None,
        };
        Ok(Stretch { compiled, meanings, y, end, march })
    }

    /// By what a phase is stepped: where nothing is integrated, events on curves are looked for once a call.
    fn stepping_of(&self, phase: &Phase) -> Stepping {
        if phase.is_dynamic() {
            self.stepping
        } else {
            Stepping::Fixed { rule: Rule::ExplicitEuler, step: f64::INFINITY }
        }
    }

    /// Goes on in a stretch.
    fn go_on(&mut self, stretch: &mut Stretch, stop: f64) -> Result<Option<Stopped>, RunError> {
        let Stretch { compiled: Compiled { phase, .. }, y, end, march, .. } = stretch;
        let counts = &mut self.passed.counts;
        let result = match (self.stepping, march) {
            (_, Some(march)) => {
                let longest = match self.stepping {
                    Stepping::Fixed { step, .. } | Stepping::Impulses { step } if phase.is_dynamic() => step,
                    _ => f64::INFINITY,
                };
                march.go_on(phase, longest, (stop, *end), y, counts)
            }
            (stepping, None) => {
                let span = (self.t, stop);
                advance(phase, stepping, span, y, &[], &mut |_, _, _| Ok(()), u64::MAX, counts)
                    .map(|stopped| Some(stopped).filter(|stopped| !stopped.events.is_empty()))
            }
        };
        let stopped = match result {
            Ok(stopped) => stopped,
            Err(error) => return Err(self.explained(phase, y, error)),
        };
        let time = stopped.as_ref().map_or(stop, |stopped| stopped.time);
        phase.unpack(time, y, &mut self.q, &mut self.v);
        self.t = time;
        guard::look(&self.simulation, &self.settings.guard, phase, self.stepping, (time, &self.q), 0.0)?;
        Ok(stopped)
    }

    fn explained(&self, phase: &mut Phase, y: &[f64], error: TimeError) -> RunError {
        match guard::of_time(error) {
            Ok(failure) => guard::explain(&self.simulation, phase, self.stepping, (y, &[]), failure),
            Err(error) => error,
        }
    }

    /// What the stretch has done to the accounts.
    fn settle_accounts(&mut self, stretch: &mut Stretch) -> Result<(), RunError> {
        let Stretch { compiled: Compiled { phase, .. }, y, .. } = stretch;
        let (work, heat) = (y[phase.accounts()], y[phase.accounts() + 1]);
        (self.work, self.heat) = (work, heat);
        if !self.simulation.pushes.is_empty() {
            self.passed.pushed += y[y.len() - 1];
        }
        for (sum, part) in self.passed.ground.iter_mut().zip(&y[phase.accounts() + 2..]) {
            *sum += part;
        }
        if phase.is_dynamic() {
            let energy = phase.energy(self.t, y).map_err(|error| guard::of_rate(self.t, error.into()))?;
            self.passed.ledger.check(energy, work, heat);
            self.passed.ledger.end(energy, work, heat);
        }
        Ok(())
    }
}
