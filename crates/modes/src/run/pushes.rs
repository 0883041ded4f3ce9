//! Pushes of the world: which act now, and blows in an instant.

use super::guard;
use super::pass::Pass;
use super::record::near;
use crate::failure::{RunError, SetupError};
use crate::impact::{Wanted, strike};
use crate::phase::{Phase, Role};
use crate::push::{Push, Thrust};
use crate::simulation::Simulation;
use nalgebra::Vector3;
use solaris_model::{Event, EventKind};
use std::sync::Arc;

/// The forces of all pushes in the time of the run.
pub(crate) fn thrusts(simulation: &Simulation) -> Result<Vec<Thrust>, SetupError> {
    let thrust = |push: &Push| {
        let link = simulation.figure.links()[push.link].name().to_owned();
        push.thrust().map_err(|source| SetupError::PushProfile { link, source })
    };
    simulation.pushes.iter().map(thrust).collect()
}

/// What each push does (N) from a time on.
pub(crate) fn after(thrusts: &[Thrust], time: f64) -> impl Iterator<Item = (usize, Vector3<f64>)> {
    let force =
        move |thrust: &Thrust| thrust.after(time, near(time)).map_or_else(Vector3::zeros, |x| x.at(time));
    thrusts.iter().map(force).enumerate()
}

impl Pass {
    /// Whether these are steady forces on the very points that steady forces act on by now.
    pub(crate) fn only_forces_change(&self, pushes: &[Push]) -> bool {
        let now = &self.simulation.pushes;
        let time = self.t + near(self.t);
        now.len() == pushes.len()
            && now.iter().zip(pushes).all(|(now, new)| {
                (now.link, now.point) == (new.link, new.point) && now.is_steady(time) && new.is_steady(time)
            })
    }

    /// Other forces on the same points from now on; nothing is allocated, unless a clone shares what is run.
    pub(crate) fn change_forces(&mut self, pushes: &[Push]) -> Result<(), RunError> {
        let simulations = [Some(Arc::make_mut(&mut self.simulation)), self.loaded.as_deref_mut()];
        for simulation in simulations.into_iter().flatten() {
            simulation.pushes.clone_from_slice(pushes);
        }
        for (i, push) in pushes.iter().enumerate() {
            let fault = |source| {
                let link = self.simulation.figure.links()[push.link].name().to_owned();
                SetupError::PushProfile { link, source }
            };
            self.thrusts[i] = push.thrust().map_err(fault)?;
            self.body.set_push(i, &self.thrusts[i].at(self.t));
        }
        Ok(())
    }

    /// Other pushes from now on: of a blow that was due before, nothing is left.
    pub(crate) fn exchange_pushes(&mut self, pushes: &[Push]) -> Result<(), RunError> {
        Arc::make_mut(&mut self.simulation).pushes = pushes.to_vec();
        self.thrusts = thrusts(&self.simulation)?;
        let past = self.t - near(self.t);
        self.struck = pushes.iter().map(|push| push.from < past).collect();
        self.renew()
    }

    /// Gives the phase the pushes of the stretch that begins now.
    pub(crate) fn load_pushes(&self, phase: &mut Phase, end: f64) {
        for (push, thrust) in self.thrusts.iter().enumerate() {
            let now = thrust.after(self.t, near(self.t));
            phase.set_push(push, now.map(|thrust| thrust.during(self.t, end)));
        }
    }

    /// The times (s) at which a push begins, ends or jumps.
    pub(crate) fn push_breaks(&self) -> impl Iterator<Item = f64> {
        let blows = self.simulation.pushes.iter().filter(|push| push.blow().is_some()).map(|push| push.from);
        self.thrusts.iter().flat_map(Thrust::breaks).chain(blows)
    }

    /// Gives the figure what the world does from now on: loads, pushes, and blows that are due.
    pub(crate) fn push(&mut self) -> Result<(), RunError> {
        self.carry()?;
        if self.simulation.pushes.is_empty() {
            return Ok(());
        }
        for (push, force) in after(&self.thrusts, self.t) {
            self.body.set_push(push, &force);
        }
        let due = self.t + near(self.t);
        let blows: Vec<(usize, Vector3<f64>)> = self
            .simulation
            .pushes
            .iter()
            .enumerate()
            .filter_map(|(i, push)| {
                let impulse = push.blow()?;
                (push.from <= due && !self.struck[i]).then_some((i, impulse))
            })
            .collect();
        if blows.is_empty() { Ok(()) } else { self.blow(&blows) }
    }

    /// What does not give way in an impact, and what its limits stop.
    pub(crate) fn given_way(&self) -> (Vec<bool>, Vec<(usize, Wanted)>) {
        let fixed = (0..self.driven.len()).map(|dof| {
            let prescribed = self.driven[dof].role() != Role::Dynamic && self.driven[dof].held.is_none();
            prescribed || self.simulation.figure.follows(dof)
        });
        let held = self.driven.iter().enumerate();
        (
            fixed.collect(),
            held.filter_map(|(dof, driven)| Some((dof, Wanted::Limit(driven.held?.0, 0.0)))).collect(),
        )
    }

    /// Blows in an instant: `M·Δv = Jᵀ·p`, with what is prescribed kept on its way and limits that hold.
    ///
    /// What stands on the ground is let go, to be struck by it as what comes down; that comes to the same, since both are the
    /// projection of the velocities that the blow alone would give.
    fn blow(&mut self, blows: &[(usize, Vector3<f64>)]) -> Result<(), RunError> {
        let fault = |t, error| RunError::from(guard::of_dynamics(t, error));
        let (fixed, held) = self.given_way();
        self.body.plant(&[]);
        self.active.forget();
        let before = self.body.blow(&self.q, &self.v, blows).map_err(|error| fault(self.t, error))?;
        let struck = strike(&mut self.body, &self.q, &self.v, &fixed, &held);
        self.body.no_blow();
        let struck = struck.map_err(|error| fault(self.t, error))?;
        let after = self.body.blow(&self.q, &struck.v, blows).map_err(|error| fault(self.t, error))?;
        self.body.no_blow();
        self.passed.counts.evaluations += 1;
        // Of an impulse p on what moves with u: p·(u⁻ + u⁺)/2.
        let work = 0.5 * (before + after);
        self.gain(work);
        self.take_velocities(struck);
        self.passed.jumps = true;
        for &(push, _) in blows {
            self.struck[push] = true;
            let link = self.simulation.figure.links()[self.simulation.pushes[push].link].name();
            let what = format!("{link}: blow");
            self.passed.record.events.push(Event { time: self.t, kind: EventKind::DriveChange { what } });
        }
        Ok(())
    }
}
