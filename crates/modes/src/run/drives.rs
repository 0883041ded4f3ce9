//! Drives that begin, go on from frame to frame, and end.

use super::active_contacts::state::ActiveContacts;
use super::driven::{Driven, Meaning, Mode, name, target};
use super::pass::Pass;
use super::record::near;
use crate::drive::force::Force;
use crate::drive::forced::forced;
use crate::drive::path::Path;
use crate::drive::simple::{Begun, analyse, begin};
use crate::drive::tracking::Tracker;
use crate::failure::{FailureKind, Remedy, RunError, RunFailure, SetupError};
use crate::phase::Role;
use crate::{Drive, EndCondition, LimitLaw, OutcomeKind, Target};
use solaris_model::{Event, EventKind};
use solaris_profiles::ProfileError;
use std::sync::Arc;

/// How far, at most, a curve may begin from where its degree of freedom is, and from its velocity: what integration and
/// numbers written with few digits leave.
const SAME: f64 = 1e-6;

/// Drives that come again sooner than this (s) take no time.
const LEAST_ROUND: f64 = 1e-6;

impl Pass {
    /// All first drives.
    pub(crate) fn begin_all(&mut self) -> Result<(), RunError> {
        for follower in self.simulation.figure.followers() {
            let names = [follower.dof, follower.leader].map(|dof| self.simulation.name(dof).to_owned());
            let free = |step: &&crate::Step| {
                !matches!(
                    step.drive,
                    Drive::Frozen | Drive::Kinematic(_) | Drive::Move { .. } | Drive::Recorded(_)
                )
            };
            if let Some(step) = self.simulation.drives[follower.leader].iter().find(free) {
                let [dof, leader] = names;
                return Err(SetupError::Follower { dof, leader, drive: step.drive.name() }.into());
            }
        }
        let all: Vec<(usize, usize)> = (0..self.driven.len())
            .filter(|dof| !self.simulation.figure.follows(*dof))
            .map(|dof| (dof, 0))
            .collect();
        self.carry()?;
        self.begin(&all)?;
        self.take_over(&[])?;
        self.push()?;
        self.settle(&[])?;
        self.find_contacts(&[])?;
        self.leap()?;
        self.note_pushes(&[]);
        Ok(())
    }

    /// Drives that waited for a velocity which an impact has leapt over.
    fn leap(&mut self) -> Result<(), RunError> {
        let leapt = std::mem::take(&mut self.leapt);
        if leapt.is_empty() { Ok(()) } else { self.change(&leapt) }
    }

    /// What follows from events, and from the clock.
    pub(crate) fn change(&mut self, events: &[Meaning]) -> Result<(), RunError> {
        // At the end of the run nothing begins any more.
        if self.t >= self.settings.duration - near(self.settings.duration) {
            for (dof, _) in self.over(events) {
                self.driven[dof].waits = true;
            }
            return Ok(());
        }
        self.take_over(events)?;
        self.push()?;
        self.settle(events)?;
        self.find_contacts(events)?;
        self.leap()?;
        self.note_pushes(events);
        Ok(())
    }

    /// Drives that are over, and those that come after them, until none is due.
    fn take_over(&mut self, events: &[Meaning]) -> Result<(), RunError> {
        let mut next = self.over(events);
        while !next.is_empty() {
            self.check_progress(&next)?;
            self.note_changes(&next);
            self.begin(&next)?;
            next = self.over(&[]);
        }
        Ok(())
    }

    /// Refuses drives that come again and again without any time going on.
    fn check_progress(&mut self, next: &[(usize, usize)]) -> Result<(), RunError> {
        for &(dof, step) in next.iter().filter(|(dof, step)| *step <= self.driven[*dof].step) {
            if self.again[dof] >= self.t - LEAST_ROUND {
                let drive = name(self.simulation.drives[dof].get(step));
                let dof = self.simulation.name(dof).to_owned();
                let cause = FailureKind::NoTime { dof: dof.clone(), drive };
                let remedies = vec![Remedy::TakeTime];
                return Err(Box::new(RunFailure { time: self.t, dof: Some(dof), cause, remedies }).into());
            }
            self.again[dof] = self.t;
        }
        Ok(())
    }

    /// Writes down which drives come next.
    fn note_changes(&mut self, next: &[(usize, usize)]) {
        for &(dof, step) in next {
            let steps = &self.simulation.drives[dof];
            let (from, to) = (name(steps.get(self.driven[dof].step)), name(steps.get(step)));
            let what = format!("{}: {from} -> {to}", self.simulation.name(dof));
            self.passed.record.events.push(Event { time: self.t, kind: EventKind::DriveChange { what } });
            self.passed.jumps = true;
        }
    }

    /// Writes down what came of the drives that are over; what comes next.
    fn over(&mut self, events: &[Meaning]) -> Vec<(usize, usize)> {
        let mut next = Vec::new();
        for dof in 0..self.driven.len() {
            next.extend(self.over_of(dof, events).map(|step| (dof, step)));
        }
        while self.pass_stage(events) {
            for dof in 0..self.driven.len() {
                let is_part = |step: &crate::Step| matches!(step.until, EndCondition::Part(_));
                let waits = self.simulation.drives[dof].get(self.driven[dof].step).is_some_and(is_part);
                if waits && next.iter().all(|(other, _)| *other != dof) {
                    next.extend(self.over_of(dof, events).map(|step| (dof, step)));
                }
            }
        }
        next
    }

    /// The next drive of a degree of freedom, if the one that it has is over, whose outcome is written down.
    fn over_of(&mut self, dof: usize, events: &[Meaning]) -> Option<usize> {
        if self.simulation.figure.follows(dof) {
            return None;
        }
        let simulation = Arc::clone(&self.simulation);
        let steps = &simulation.drives[dof];
        let (driven, due) = (&self.driven[dof], self.t + near(self.t));
        let over = events.contains(&Meaning::DriveEnds(dof))
            || steps.get(driven.step).is_some_and(|step| match step.until {
                EndCondition::Time(time) => time <= due,
                EndCondition::Lasting(time) => driven.start + time <= due,
                EndCondition::Part(part) => part < self.stages_over(),
                _ => false,
            });
        let done = !driven.waits && driven.end <= due;
        if done {
            let result = self.result(dof);
            self.outcome(dof, result);
        } else if over && !driven.waits {
            let lasts = driven.end.is_infinite();
            let ended = if lasts { self.result_of_lasting(dof) } else { OutcomeKind::Interrupted };
            self.outcome(dof, ended);
        }
        let until_done = steps.get(self.driven[dof].step).is_none_or(|step| step.until == EndCondition::Done);
        let next = self.simulation.next_drive(dof, self.driven[dof].step);
        // What leads back to a motion holds where that ends, unless something else is to come.
        let holds = self.driven[dof].feels() && next == steps.len();
        if over || (done && until_done && !holds) {
            return Some(next);
        }
        if done {
            let driven = &mut self.driven[dof];
            (driven.waits, driven.end) = (true, f64::INFINITY);
            // A force goes on as it ended; everything else has arrived.
            let step = self.simulation.drives[dof].get(driven.step);
            let is_force =
                |drive: &Drive| matches!(drive, Drive::Torque(_) | Drive::Servo(_) | Drive::Sum(_));
            if !step.is_some_and(|step| is_force(&step.drive)) {
                driven.mode = Mode::Still;
            }
        }
        None
    }

    /// The laws of the simulation are others from now on.
    pub(crate) fn renew(&mut self) -> Result<(), RunError> {
        self.rebuild()?;
        self.body.plant(&self.active.holds);
        self.compiled = None;
        for (driven, law) in self.driven.iter_mut().zip(&self.simulation.limits) {
            driven.held = driven.held.filter(|_| matches!(law, LimitLaw::Hard { .. }));
        }
        self.change(&[])
    }

    /// The state is that of the simulation's beginning from now on, and every drive that has not ended begins anew.
    pub(crate) fn put(&mut self) -> Result<(), RunError> {
        self.q.clone_from(&self.simulation.q);
        self.v.clone_from(&self.simulation.v);
        self.simulation.figure.follow(&mut self.q, &mut self.v, &mut self.a);
        (self.compiled, self.active) = (None, ActiveContacts::default());
        self.body.plant(&[]);
        for driven in &mut self.driven {
            driven.held = None;
        }
        let now: Vec<(usize, usize)> = (0..self.driven.len())
            .filter(|dof| !self.simulation.figure.follows(*dof))
            .map(|dof| (dof, self.driven[dof].step))
            .collect();
        self.begin(&now)?;
        self.change(&[])
    }

    /// The drives of a degree of freedom are others from now on, of which the first begins.
    pub(crate) fn exchange(&mut self, dofs: &[usize]) -> Result<(), RunError> {
        for &dof in dofs {
            if !self.simulation.figure.follows(dof) && !self.driven[dof].waits {
                let lasts = self.driven[dof].end.is_infinite();
                self.outcome(dof, if lasts { OutcomeKind::Ended } else { OutcomeKind::Interrupted });
            }
        }
        let follows = |dof: &usize| self.simulation.figure.follows(*dof);
        let first: Vec<(usize, usize)> =
            dofs.iter().filter(|dof| !follows(dof)).map(|dof| (*dof, 0)).collect();
        self.begin(&first)?;
        self.change(&[])
    }

    /// Begins drives, all at the same instant, so that one analysis serves those that need one.
    fn begin(&mut self, drives: &[(usize, usize)]) -> Result<(), RunError> {
        let targets: Vec<(usize, Target)> = drives
            .iter()
            .filter_map(|&(dof, step)| Some((dof, target(&self.simulation.drives[dof].get(step)?.drive)?)))
            .collect();
        for &(dof, step) in drives {
            let driven = self.begun(dof, step)?;
            let held = self.driven[dof].held.filter(|_| !matches!(driven.mode, Mode::Still | Mode::Path(_)));
            self.driven[dof] = Driven { held, ..driven };
        }
        if targets.is_empty() {
            return Ok(());
        }
        let (prescribed, a, tau) = self.given();
        let layout = self.simulation.figure.layout();
        let analysis = analyse(&mut self.body, layout, &self.q, &self.v, &prescribed, &a, &tau, &targets)
            .map_err(|error| super::guard::of_dynamics(self.t, error))?;
        self.passed.counts.evaluations += 2;
        let mut next = Vec::new();
        for (i, &(dof, target)) in targets.iter().enumerate() {
            let step = self.driven[dof].step;
            let begins = self.analysed(dof, &target, analysis.force[i], analysis.acceleration[i]);
            if !begins && self.simulation.drives[dof][step].until == EndCondition::Done {
                next.push((dof, self.simulation.next_drive(dof, step)));
            }
        }
        self.check_progress(&next)?;
        self.note_changes(&next);
        if next.is_empty() { Ok(()) } else { self.begin(&next) }
    }

    /// What a drive makes of its analysis; whether it begins. Where it does not, it waits at rest.
    fn analysed(&mut self, dof: usize, target: &Target, force: f64, acceleration: f64) -> bool {
        let step = self.driven[dof].step;
        let Some(coordinate) = self.simulation.figure.layout().coordinate(dof) else { return false };
        self.driven[dof].acceleration = Some(acceleration);
        let (mode, end) = match &self.simulation.drives[dof][step].drive {
            Drive::Simple { course, .. } => {
                match begin(*course, *target, self.q[coordinate], self.v[dof], acceleration, self.t) {
                    Begun::Along { path, end } => (Mode::Path(path), end),
                    Begun::Not(result) => {
                        self.outcome(dof, result);
                        self.driven[dof].waits = true;
                        return false;
                    }
                }
            }
            // Free-style: the force is held.
            _ => (Mode::Force(Force::Constant(force)), self.driven[dof].end),
        };
        (self.driven[dof].mode, self.driven[dof].end) = (mode, end);
        true
    }

    /// A drive that begins now; simple modes stand still until their analysis is there.
    fn begun(&self, dof: usize, step: usize) -> Result<Driven, RunError> {
        let now = self.t;
        let new = |mode, end| Driven::new(step, now, mode, end);
        let Some(drive) = self.simulation.drives[dof].get(step).map(|step| &step.drive) else {
            // A ball or free joint cannot stand still in part.
            let is_part = self.simulation.figure.layout().coordinate(dof).is_none();
            let mode = if is_part { Mode::Force(Force::Constant(0.0)) } else { Mode::Still };
            return Ok(new(mode, f64::INFINITY));
        };
        let fault = |source: ProfileError| {
            RunError::from(SetupError::Profile { dof: self.simulation.name(dof).to_owned(), source })
        };
        let position =
            self.simulation.figure.layout().coordinate(dof).map_or(0.0, |coordinate| self.q[coordinate]);
        let velocity = self.v[dof];
        Ok(match drive {
            Drive::Free => new(Mode::Force(Force::Constant(0.0)), f64::INFINITY),
            Drive::Frozen | Drive::Simple { .. } => new(Mode::Still, f64::INFINITY),
            Drive::Kinematic(profile) => {
                let path = Path::profile(profile, now).map_err(fault)?;
                let start = path.at(now);
                self.check_start(dof, (start.position, start.velocity), (position, velocity))?;
                let end = path.end();
                new(Mode::Path(path), end)
            }
            Drive::Move { to, over, along } => {
                let path = Path::moving(*along, *over, (position, velocity), *to, now).map_err(fault)?;
                new(Mode::Path(path), now + over)
            }
            Drive::Recorded(recorded) => {
                let Some(coordinate) = self.simulation.figure.layout().coordinate(dof) else {
                    return Ok(new(Mode::Still, f64::INFINITY));
                };
                let path = Path::Recorded { recorded: Arc::clone(recorded), dof, coordinate };
                let start = path.at(now);
                self.check_start(dof, (start.position, start.velocity), (position, velocity))?;
                new(Mode::Path(path), recorded.span().1.max(now))
            }
            Drive::Torque(_) | Drive::Servo(_) | Drive::Sum(_) => {
                let (force, end) = forced(drive, now).map_err(fault)?;
                new(Mode::Force(force), end)
            }
            Drive::FreeStyle { duration, .. } => new(Mode::Force(Force::Constant(0.0)), now + duration),
            Drive::Intensive { target, duration, law, .. } => {
                let tracker = Tracker::new(*law, *target, now, *duration, (position, velocity, self.a[dof]));
                new(Mode::Track(Box::new(tracker), 0.0), now + duration)
            }
        })
    }

    /// Refuses a curve that would make its degree of freedom jump.
    fn check_start(&self, dof: usize, curve: (f64, f64), state: (f64, f64)) -> Result<(), RunError> {
        let same = |a: f64, b: f64| (a - b).abs() <= SAME * (1.0 + a.abs().max(b.abs()));
        if same(curve.0, state.0) && same(curve.1, state.1) {
            return Ok(());
        }
        let dof = self.simulation.name(dof).to_owned();
        let remedies = vec![Remedy::CurveFromThere, Remedy::StartAtCurve, Remedy::MoveInstead];
        let (begins, velocity, found, moving) = (curve.0, curve.1, state.0, state.1);
        let cause = FailureKind::Jump { dof: dof.clone(), begins, velocity, found, moving };
        Err(Box::new(RunFailure { time: self.t, dof: Some(dof), cause, remedies }).into())
    }

    /// What is prescribed now, with its accelerations, and the drives' forces on the rest.
    pub(crate) fn given(&self) -> (Vec<bool>, Vec<f64>, Vec<f64>) {
        let figure = &self.simulation.figure;
        let mut prescribed: Vec<bool> =
            self.driven.iter().map(|driven| driven.role() != Role::Dynamic).collect();
        let mut a: Vec<f64> = self.a.clone();
        for (dof, driven) in self.driven.iter().enumerate() {
            match &driven.mode {
                Mode::Path(path) => a[dof] = path.at(self.t).acceleration,
                Mode::Still => a[dof] = 0.0,
                _ if driven.held.is_some() => a[dof] = 0.0,
                _ => {}
            }
        }
        for follower in figure.followers() {
            prescribed[follower.dof] = true;
        }
        let (mut q, mut v) = (self.q.clone(), self.v.clone());
        figure.follow(&mut q, &mut v, &mut a);
        let state = |dof| (figure.layout().coordinate(dof).map_or(0.0, |x| self.q[x]), self.v[dof]);
        let forces = self.driven.iter().enumerate().map(|(dof, driven)| driven.force(self.t, state(dof)));
        (prescribed, a, forces.collect())
    }
}
