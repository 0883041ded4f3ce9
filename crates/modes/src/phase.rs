//! A stretch of time in which every degree of freedom keeps its role: the equations of motion of what is left of the figure.

mod colliding;
mod condition;
mod impulses;
mod loops;
mod plan;
mod prescribed;
mod reduction;
mod rows;
mod small;
mod state;
mod watched;

use crate::between::Between;
use crate::body::Pushing;
use crate::contact::ContactPatch;
use crate::drive::force::Force;
use crate::drive::path::Path;
use crate::failure::SetupError;
use crate::push::Thrust;
use crate::report::{Energy, PhaseReport};
use crate::simulation::Simulation;
use crate::time::{RateError, System};
use nalgebra::DMatrix;
use prescribed::Prescribed;
use reduction::Source;
use small::Small;
use solaris_dynamics::{DynamicsError, Wrench};
pub(crate) use state::GROUND;
use state::StateMap;
pub(crate) use watched::Watched;

/// What a degree of freedom is to the dynamics of a phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Role {
    /// Dynamics move it.
    Dynamic,
    /// It has a motion of its own.
    Prescribed,
    /// It stands still, and is fused away.
    Still,
}

/// The equations of motion of one stretch. The state is positions and velocities of what dynamics move, then the work of the
/// drives and the heat of dampers since the beginning (J), and with a ground what that does since the stretch began.
///
/// What nothing that is computed depends on is left out when the phase is made: links on prescribed motions that carry nothing
/// that dynamics move, degrees of freedom that stand still, and with nothing to be moved the dynamics themselves. `report` says
/// what. Work, heat and energy are those of what is left. No evaluation allocates.
///
/// A degree of freedom that follows another has the role of its leader, whatever role it is given.
#[derive(Clone)]
pub(crate) struct Phase {
    pub(crate) report: PhaseReport,
    source: Source,
    /// Of the figure (N), or its mass where there is no gravity.
    weight: f64,
    roles: Vec<Role>,
    leave_out: bool,
    state: StateMap,
    prescribed: Prescribed,
    watched: Vec<Watched>,
    /// On which side of zero what is watched belongs, where it begins there.
    sides: Vec<f64>,
    /// The drives' forces on degrees of freedom that are held: what a limit adds to them is all that it pushes.
    held: Vec<(usize, Force)>,
    /// What stands on the ground and stays there.
    planted: Vec<ContactPatch>,
    /// Where the ground and hard limits act by impulses, the length of a whole step (s).
    by_impulses: Option<f64>,
    /// What methods that choose their steps say of the errors of their steps, added up.
    errors: f64,
    small: Option<Small>,
}

impl Phase {
    /// `roles` by degree of freedom of the full figure; `q` is the full configuration, of which what stands still keeps its values.
    /// Whether what nothing depends on is left out, `leave_out` says: what is computed differs by no more than rounding.
    ///
    /// # Errors
    ///
    /// [`SetupError`] for a ball or free joint that dynamics move in part, a follower that they are to move, and a figure that
    /// they do not know.
    pub(crate) fn with(
        simulation: &Simulation,
        roles: &[Role],
        q: &[f64],
        leave_out: bool,
    ) -> Result<Self, SetupError> {
        let source = Source::of(simulation);
        let roles = source.roles(roles)?;
        let weight = simulation.weight();
        let mut phase = Self {
            report: PhaseReport::default(),
            state: StateMap::new(
                &simulation.figure,
                &roles,
                (simulation.surface.is_some(), !simulation.pushes.is_empty()),
            ),
            prescribed: Prescribed::new(&simulation.figure, &roles, q, simulation.pushes.len()),
            watched: Vec::new(),
            sides: Vec::new(),
            held: Vec::new(),
            planted: Vec::new(),
            by_impulses: None,
            errors: 0.0,
            small: None,
            source,
            weight,
            roles,
            leave_out,
        };
        phase.compile(&[])?;
        Ok(phase)
    }

    /// The force of a drive on a degree of freedom that dynamics move; none where nothing was said.
    pub(crate) fn set_force(&mut self, dof: usize, force: Force) {
        if let Some(entry) = self.state.velocity_of(dof) {
            self.prescribed.set_force(entry - self.state.positions(), force);
        } else {
            self.held.retain(|(other, _)| *other != dof);
            self.held.push((dof, force));
        }
    }

    /// The first servo that drives a degree of freedom leads to rest at a position (rad or m) from now on.
    pub(crate) fn lead_to(&mut self, dof: usize, to: f64) {
        if let Some(entry) = self.state.velocity_of(dof) {
            self.prescribed.force_mut(entry - self.state.positions()).lead_to(to);
        } else if let Some((_, force)) = self.held.iter_mut().find(|(held, _)| *held == dof) {
            force.lead_to(to);
        }
    }

    /// The motion of a prescribed degree of freedom; where nothing was said it stands where it stood.
    pub(crate) fn set_path(&mut self, dof: usize, path: Path) {
        self.prescribed.set(dof, path);
    }

    /// What a push of the world does, by its index; none until something was said.
    pub(crate) fn set_push(&mut self, push: usize, thrust: Option<Thrust>) {
        self.prescribed.set_push(push, thrust);
    }

    /// Until the next call the limits of a degree of freedom, where they push back, do this.
    pub(crate) fn hold_limit(&mut self, dof: usize, pushing: Pushing) {
        if let Some(small) = &mut self.small {
            small.hold_limit(dof, pushing);
        }
    }

    /// From now on these stand on the ground, with links that dynamics move.
    pub(crate) fn plant(&mut self, patches: &[ContactPatch]) {
        if self.planted != patches {
            self.planted = patches.to_vec();
            if let Some(small) = &mut self.small {
                small.plant(&self.planted);
            }
        }
    }

    /// From now on the ground and hard limits act by impulses, in steps of this length (s).
    pub(crate) fn step_by_impulses_of(&mut self, step: f64) -> Result<(), SetupError> {
        self.by_impulses = Some(step);
        match &mut self.small {
            Some(small) => small.act_by_impulses(&self.source, &self.state, step),
            None => Ok(()),
        }
    }

    /// What the ground does to links (N, N m, about the world's origin), where [`accelerations`](Self::accelerations) were found last;
    /// `standing` are the links of what is [planted](Self::plant).
    pub(crate) fn pressed<'a>(
        &'a self,
        standing: &'a [usize],
    ) -> impl Iterator<Item = (usize, Wrench<f64>)> + 'a {
        let impulses = self.small.iter().filter_map(|small| small.impulses.as_ref());
        let by_impulses = impulses.flat_map(|impulses| impulses.wrenches().iter().copied());
        standing.iter().copied().zip(self.patch_wrenches()).chain(by_impulses)
    }

    /// What links do to each other, where [`accelerations`](Self::accelerations) were found last.
    pub(crate) fn between(&self) -> &[Between] {
        self.small.as_ref().map_or(&[], Small::between)
    }

    /// What the ground does to each of them (N, N m, about the world's origin), where [`accelerations`](Self::accelerations) were
    /// found last.
    pub(crate) fn patch_wrenches(&self) -> impl Iterator<Item = Wrench<f64>> {
        self.small.iter().flat_map(Small::patch_wrenches)
    }

    /// What is watched for from here on, and on which side of zero it belongs where it begins there (1, −1, or 0 for either).
    ///
    /// # Errors
    ///
    /// [`SetupError`] as for [`with`](Self::with): the force that holds a degree of freedom may need links that were left out.
    pub(crate) fn watch(&mut self, watched: Vec<Watched>, sides: Vec<f64>) -> Result<(), SetupError> {
        let holds = |watched: &[Watched]| {
            let dofs = watched.iter().filter_map(|watched| match watched {
                Watched::Hold { dof } => Some(*dof),
                _ => None,
            });
            dofs.collect::<Vec<_>>()
        };
        let (before, after) = (holds(&self.watched), holds(&watched));
        (self.watched, self.sides) = (watched, sides);
        let complete = self.small.as_ref().is_some_and(|small| small.is_complete(&self.source, &after));
        if complete || before == after { Ok(()) } else { self.compile(&after) }
    }

    /// What methods that choose their steps have said of the errors of their steps since this was asked last, added up.
    pub(crate) fn take_errors(&mut self) -> f64 {
        std::mem::take(&mut self.errors)
    }

    /// Whether dynamics move a degree of freedom of the full figure.
    pub(crate) fn moves(&self, dof: usize) -> bool {
        self.roles[dof] == Role::Dynamic
    }

    /// Whether anything has to be stepped: dynamics move something, or the force that holds something is watched, or nothing is
    /// to be left out.
    pub(crate) fn is_dynamic(&self) -> bool {
        !self.leave_out
            || self.state.dofs() > 0
            || self.watched.iter().any(|watched| matches!(watched, Watched::Hold { .. }))
    }

    /// The index of the work in the state (J); heat (J) follows, and with a ground what that does, [`GROUND`] entries: its impulse
    /// (N s) along x, y and z, and what its damping and friction take (J).
    pub(crate) fn accounts(&self) -> usize {
        self.state.accounts()
    }

    /// The state of the full `q`, `v`, with work and heat (J).
    pub(crate) fn pack(&self, q: &[f64], v: &[f64], work: f64, heat: f64) -> Vec<f64> {
        self.state.pack(q, v, work, heat)
    }

    /// The full `q`, `v` at a time of the run: dynamic from the state, prescribed from their paths, what stands still.
    pub(crate) fn unpack(&self, t: f64, y: &[f64], q: &mut [f64], v: &mut [f64]) {
        self.prescribed.write(t, q, v);
        self.state.unpack(y, q, v);
    }

    /// The full accelerations at a time of the run.
    pub(crate) fn accelerations(&mut self, t: f64, y: &[f64], a: &mut [f64]) -> Result<(), RateError> {
        self.prescribed.write_accelerations(t, a);
        if let Some(small) = &mut self.small {
            if self.by_impulses.is_some() {
                small.find_impulses(&self.prescribed, (t, y), None)?;
            } else {
                small.solve(&self.prescribed, t, y)?;
                small.tie();
            }
            small.write_accelerations(a);
        }
        Ok(())
    }

    /// Energy of what is left of the figure.
    pub(crate) fn energy(&mut self, t: f64, y: &[f64]) -> Result<Energy, DynamicsError> {
        self.small.as_mut().map_or(Ok(Energy::default()), |small| small.energy(&self.prescribed, t, y))
    }

    /// The condition of the mass matrix of what dynamics move, each degree of freedom in units in which its own inertia is 1, where
    /// it is beyond `most`, and the degree of freedom of the full figure where it shows most: that with the greatest part in the
    /// direction of the least inertia.
    pub(crate) fn condition_beyond(
        &mut self,
        t: f64,
        y: &[f64],
        most: f64,
    ) -> Result<Option<(f64, usize)>, DynamicsError> {
        match &mut self.small {
            Some(small) if self.state.dofs() > 0 => {
                condition::beyond(small, &self.state, &self.prescribed, (t, y), most)
            }
            _ => Ok(None),
        }
    }

    /// The degree of freedom of the full figure that an entry of the state belongs to; none for accounts.
    pub(crate) fn dof_of(&self, entry: usize) -> Option<usize> {
        self.state.dof_of(entry)
    }

    /// Finds what is left of the figure where the forces that hold `held` have to be known.
    fn compile(&mut self, held: &[usize]) -> Result<(), SetupError> {
        let standing = self.prescribed.standing();
        let reduced = |fuse| {
            let reduction = self.source.reduce(&self.roles, held, standing, self.leave_out, fuse)?;
            let report = plan::report(&self.source, &self.roles, standing, reduction.as_ref());
            Ok::<_, SetupError>((reduction, report))
        };
        let mut chosen = reduced(true)?;
        if !chosen.1.fused.is_empty() {
            // Axes that what stands still has turned askew may cost more than standing still does.
            let other = reduced(false)?;
            if other.1.operations.total() < chosen.1.operations.total() {
                chosen = other;
            }
        }
        let (reduction, report) = chosen;
        self.report = PhaseReport { start: self.report.start, end: self.report.end, ..report };
        let small = reduction
            .map(|reduction| Small::new(&self.source, &self.roles, reduction, &self.state, &self.prescribed));
        self.small = small.transpose()?;
        if let Some(small) = &mut self.small {
            small.plant(&self.planted);
            if let Some(step) = self.by_impulses {
                small.act_by_impulses(&self.source, &self.state, step)?;
            }
        }
        Ok(())
    }
}

impl System for Phase {
    fn len(&self) -> usize {
        self.state.len()
    }

    fn rate(&mut self, t: f64, y: &[f64], rate: &mut [f64]) -> Result<(), RateError> {
        rate.fill(0.0);
        if let Some(small) = &mut self.small {
            small.solve(&self.prescribed, t, y)?;
            small.write_rates(&self.state, rate);
        }
        match rate.iter().position(|value| !value.is_finite()) {
            Some(index) => Err(RateError::NotFinite { index, value: rate[index] }),
            None => Ok(()),
        }
    }

    fn jacobian(&mut self, t: f64, y: &[f64], jacobian: &mut DMatrix<f64>) -> Result<(), RateError> {
        jacobian.fill(0.0);
        let Some(small) = &mut self.small else { return Ok(()) };
        small.jacobian(&self.source, &self.state, &self.prescribed, (t, y), jacobian)
    }

    fn position_rate(&self, y: &[f64], rate: &mut [f64]) -> bool {
        self.state.position_rates(y, rate);
        true
    }

    fn step_by_impulses(&mut self, t: f64, h: f64, y: &[f64], next: &mut [f64]) -> Result<bool, RateError> {
        next.copy_from_slice(y);
        if let Some(small) = &mut self.small {
            small.step_by_impulses(&self.state, &self.prescribed, (t, h), y, next)?;
        }
        Ok(self.by_impulses.is_some())
    }

    fn events(&self) -> usize {
        self.watched.len()
    }

    fn event_side(&self, index: usize) -> f64 {
        self.sides.get(index).copied().unwrap_or(0.0)
    }

    fn event_values(&mut self, t: f64, y: &[f64], values: &mut [f64]) {
        self.watched_values(t, y, values);
    }

    fn note_error(&mut self, error: f64) {
        self.errors += error;
    }

    fn smooth_until(&self, t: f64) -> f64 {
        self.prescribed.smooth_until(t)
    }

    fn settle(&self, y: &mut [f64]) {
        self.state.settle(y);
    }
}

#[cfg(test)]
mod laws;
