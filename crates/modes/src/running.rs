//! A simulation that runs bit by bit.

use crate::failure::{RunError, SetupError};
use crate::push::Push;
use crate::range::check_positive;
use crate::report::{Energy, Impact, Landing};
use crate::run::{Pass, Present, Progress, STEP, Touching};
use crate::settings::{Method, Rule, Settings};
use crate::simulation::Simulation;
use crate::time::Stepping;
use crate::{LimitLaw, Outcome, Step};
use solaris_model::Event;
use std::sync::Arc;

/// The most steps of a fixed rule in one call.
const MOST_STEPS: f64 = 1e7;

/// A simulation on its way, which whoever calls takes further bit by bit, and may change in between.
///
/// What is found at a time is the same, to the bit, as in a [`run`](Simulation::run) by the same rule and step with frames at the
/// times that are stepped to. A clone is a snapshot: it goes on to the same bits. Between events a step allocates nothing, with
/// the rules of fixed steps.
///
/// ```
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
/// use solaris_modes::time::Stepping;
/// use solaris_modes::{Drive, Rule, Simulation};
///
/// let rod = LinkSpec::root("rod", Joint::new("hinge").rx()).mass(1.0).com(Vector3::new(0.0, -0.5, 0.0));
/// let figure = FigureBuilder::new("pendulum").link(rod).build()?;
/// let simulation = Simulation::new(&figure, Vector3::new(0.0, -9.80665, 0.0));
/// let mut running = simulation.start(Stepping::Fixed { rule: Rule::RungeKutta4, step: 1e-3 })?;
/// running.set_force(0, 2.0)?; // N m, until something else is said
/// for _ in 0..60 {
///     running.step(1.0 / 60.0)?;
/// }
/// let snapshot = running.clone();
/// running.drive("hinge", [Drive::Frozen])?; // stops it
/// running.step(0.5)?;
/// assert!(running.v()[0] == 0.0 && snapshot.v()[0] != 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "step")]
#[doc(alias = "real time")]
#[doc(alias = "game loop")]
#[derive(Clone)]
pub struct Running {
    progress: Progress,
    /// For those who ask for forces.
    present: Option<Box<Present>>,
}

/// What has happened since the call before the last: all of it belongs to the last call that stepped or changed something.
#[derive(Clone, Copy, Debug)]
pub struct Happened<'a> {
    /// What comes to the ground and leaves it, and drives that take over.
    pub events: &'a [Event],
    /// Joints that were stopped, and limits that were hit.
    pub impacts: &'a [Impact],
    /// What has come down on rigid ground.
    pub landings: &'a [Landing],
    /// Drives that have ended.
    pub outcomes: &'a [Outcome],
}

impl Simulation {
    /// Begins a run that goes on as [`Running::step`] says.
    ///
    /// Drives in intensive mode find a force anew with each call.
    ///
    /// # Errors
    ///
    /// [`RunError`], as [`run`](Self::run): steps and tolerances out of range, drives that cannot begin, a step that is too long
    /// for the stiffness of what begins.
    pub fn start(&self, stepping: Stepping) -> Result<Running, RunError> {
        let (what, value) = match stepping {
            Stepping::Fixed { step, .. } | Stepping::Impulses { step } => ("the step", step),
            Stepping::Adaptive { tolerance } | Stepping::Stiff { tolerance } => ("the tolerance", tolerance),
        };
        check_positive(|| what.to_owned(), value)?;
        let settings = Settings { duration: f64::INFINITY, ..Settings::new(0.0, 1.0) };
        let pass = Pass::new(&Arc::new(self.clone()), &settings, stepping)?;
        let mut running = Running { progress: Progress::begin(pass)?, present: None };
        // What cannot be stepped is refused here.
        running.progress.accelerations()?;
        Ok(running)
    }

    /// The steps to [`start`](Self::start) with, for the method of a whole run: as long as it says, and a millisecond where it would
    /// choose, by impulses over ground or where links touch each other or are held together, else by Runge and Kutta's rule.
    pub fn stepping_for(&self, method: Method) -> Stepping {
        let needs_impulses = || matches!(self.usual_method(), Method::Impulses { .. });
        match method {
            Method::Fixed { rule, step } => Stepping::Fixed { rule, step },
            Method::Impulses { step } => Stepping::Impulses { step },
            Method::Adaptive { tolerance } => Stepping::Adaptive { tolerance },
            _ if self.grounded().is_some() || needs_impulses() => Stepping::Impulses { step: STEP },
            _ => Stepping::Fixed { rule: Rule::RungeKutta4, step: STEP },
        }
    }
}

impl Running {
    /// On by `dt` (s).
    ///
    /// # Errors
    ///
    /// [`SetupError::Range`] for a `dt` that is no time above zero, or one of more than 10 million steps, and nothing has changed;
    /// [`RunError::Failed`] where the run fails, and the state is that of the last instant that was reached.
    pub fn step(&mut self, dt: f64) -> Result<(), RunError> {
        check_positive(|| "the time to step on by".to_owned(), dt)?;
        self.go_to(self.time() + dt)
    }

    /// On to a time (s); where it is there already nothing happens.
    ///
    /// # Errors
    ///
    /// As for [`step`](Self::step); a time that is over is out of range.
    pub fn advance_to(&mut self, time: f64) -> Result<(), RunError> {
        if !(time >= self.time() && time.is_finite()) {
            let what = "the time to advance to".to_owned();
            return Err(
                SetupError::Range { what, value: time, range: "a finite time that is not over" }.into()
            );
        }
        self.go_to(time)
    }

    fn go_to(&mut self, time: f64) -> Result<(), RunError> {
        if let Stepping::Fixed { step, .. } | Stepping::Impulses { step } = self.progress.pass.stepping
            && time - self.time() > MOST_STEPS * step
        {
            let (what, value) = ("the time to step on by".to_owned(), time - self.time());
            return Err(SetupError::Range { what, value, range: "at most 10 million steps" }.into());
        }
        self.forget();
        self.progress.go_to(time)
    }

    /// How long it has run (s).
    pub fn time(&self) -> f64 {
        self.progress.pass.t
    }

    /// The positions (length `nq`; rad, m).
    pub fn q(&self) -> &[f64] {
        &self.progress.pass.q
    }

    /// The velocities (length `nv`; rad/s, m/s).
    pub fn v(&self) -> &[f64] {
        &self.progress.pass.v
    }

    /// The accelerations (length `nv`; rad/s², m/s²), which are found when they are asked for.
    ///
    /// # Errors
    ///
    /// [`RunError::Failed`] where the dynamics refuse the state.
    pub fn accelerations(&mut self) -> Result<&[f64], RunError> {
        self.progress.accelerations()
    }

    /// The forces of the joints now (length `nv`; N m, N): of the drives, with what limits add where they hold something. They are those of a
    /// [`run`](Simulation::run) that [asks](Settings::forces) for them, and found when they are asked for; the first time makes room for it.
    ///
    /// # Errors
    ///
    /// [`RunError::Failed`] where the dynamics refuse the state.
    #[doc(alias = "tau")]
    pub fn forces(&mut self) -> Result<&[f64], RunError> {
        let present = present(&mut self.present, &self.progress)?;
        present.forces(&mut self.progress)
    }

    /// What the ground does now to every link that it presses, in the order of the links: by springs in the state as it is, else along with the
    /// [accelerations](Self::accelerations). Steps by impulses give the mean over the step that would come next.
    ///
    /// # Errors
    ///
    /// [`RunError::Failed`] where the dynamics refuse the state.
    #[doc(alias = "ground reaction")]
    pub fn contacts(&mut self) -> Result<&[Touching], RunError> {
        let present = present(&mut self.present, &self.progress)?;
        present.contacts(&mut self.progress)
    }

    /// Energy of the whole figure with its springs (J).
    ///
    /// # Errors
    ///
    /// [`RunError::Failed`] where the dynamics refuse the state.
    pub fn energy(&mut self) -> Result<Energy, RunError> {
        let Pass { body, q, v, .. } = &mut self.progress.pass;
        body.energy(q, v).map_err(|error| SetupError::from(error).into())
    }

    /// What it runs by now: drives and limits are those that were set last.
    pub fn simulation(&self) -> &Simulation {
        &self.progress.pass.simulation
    }

    /// What happened in the last call that stepped or changed something.
    pub fn happened(&self) -> Happened<'_> {
        let passed = &self.progress.pass.passed;
        let events = &passed.record.events;
        Happened { events, impacts: &passed.impacts, landings: &passed.landings, outcomes: &passed.outcomes }
    }

    /// Another constant force (N m or N) on a degree of freedom (index in `v`) that is free or that a constant force drives, from
    /// now until something else is said. Nothing is allocated.
    ///
    /// # Errors
    ///
    /// [`SetupError::Range`] for an index or a force that is none; [`SetupError::NotAForce`] where something else drives it.
    pub fn set_force(&mut self, dof: usize, force: f64) -> Result<(), RunError> {
        let nv = self.v().len();
        if dof >= nv {
            let what = format!("the degree of freedom of a force, of {nv},");
            return Err(SetupError::Range { what, value: dof as f64, range: "an index in v" }.into());
        }
        let name = |running: &Self| running.simulation().name(dof).to_owned();
        if !force.is_finite() {
            let what = format!("the force on '{}'", name(self));
            return Err(SetupError::Range { what, value: force, range: "a finite number" }.into());
        }
        if !self.progress.takes_force(dof) {
            return Err(SetupError::NotAForce { dof: name(self) }.into());
        }
        self.forget();
        self.progress.set_force(dof, force)
    }

    /// Another target (rad or m) for a servo that goes to a place ([`Aim::At`](crate::Aim::At)) and leads a degree of freedom (index in `v`) now, or for the
    /// first one of a sum, from now on. Nothing is allocated, unless something rests at a limit or stands on rigid ground, or a clone shares what is run.
    ///
    /// # Errors
    ///
    /// [`SetupError::Range`] for an index or a target that is none; [`SetupError::NotAServo`] where something else drives it.
    #[doc(alias = "setpoint")]
    pub fn set_target(&mut self, dof: usize, to: f64) -> Result<(), RunError> {
        let nv = self.v().len();
        if dof >= nv {
            let what = format!("the degree of freedom of a target, of {nv},");
            return Err(SetupError::Range { what, value: dof as f64, range: "an index in v" }.into());
        }
        let name = |running: &Self| running.simulation().name(dof).to_owned();
        if !to.is_finite() {
            let what = format!("the target of '{}'", name(self));
            return Err(SetupError::Range { what, value: to, range: "a finite number" }.into());
        }
        if !self.progress.takes_target(dof) {
            return Err(SetupError::NotAServo { dof: name(self) }.into());
        }
        self.forget();
        self.progress.set_target(dof, to)
    }

    /// Other pushes of the world in place of all that there are, from now on: as if they had been given by
    /// [`Simulation::add_push`], their times those of the run. What was due before is over; a blow at this very time strikes.
    ///
    /// Where they are [steady](Push::steady) forces on the very points that steady forces act on by now, only the forces change, and nothing is
    /// allocated, with the same exceptions as for [`set_target`](Self::set_target): whoever drags a point gives it a force in every frame. Steps allocate nothing afterwards in
    /// any case.
    ///
    /// # Errors
    ///
    /// Those of [`Simulation::add_push`], and nothing has changed; [`RunError::Failed`] where what follows at once fails.
    #[doc(alias = "external force")]
    pub fn set_pushes(&mut self, pushes: &[Push]) -> Result<(), RunError> {
        for push in pushes {
            self.simulation().check_push(push)?;
        }
        if self.progress.pass.only_forces_change(pushes) {
            self.forget();
            return self.progress.change_forces(pushes);
        }
        let mut next = self.clone();
        next.forget();
        next.progress.interrupt()?;
        next.progress.pass.exchange_pushes(pushes)?;
        next.present = None;
        *self = next;
        Ok(())
    }

    /// Other drives for a degree of freedom, or all of a joint, from now on; see [`Simulation::drive`].
    ///
    /// # Errors
    ///
    /// Those of [`Simulation::drive`], and nothing has changed; [`RunError::Failed`] for a curve that begins elsewhere.
    pub fn drive<S: Into<Step>>(
        &mut self,
        name: &str,
        steps: impl IntoIterator<Item = S>,
    ) -> Result<(), RunError> {
        let mut next = self.clone();
        next.forget();
        next.progress.interrupt()?;
        let dofs = next.simulation().dofs(name)?;
        Arc::make_mut(&mut next.progress.pass.simulation).drive(name, steps)?;
        next.progress.pass.exchange(&dofs)?;
        *self = next;
        Ok(())
    }

    /// What the limits of one degree of freedom, or of all of a joint, do from now on.
    ///
    /// # Errors
    ///
    /// Those of [`Simulation::set_limit`], and nothing has changed.
    pub fn set_limit(&mut self, name: &str, law: LimitLaw) -> Result<(), RunError> {
        let mut next = self.clone();
        next.forget();
        next.progress.interrupt()?;
        Arc::make_mut(&mut next.progress.pass.simulation).set_limit(name, law)?;
        next.progress.pass.renew()?;
        next.present = None;
        *self = next;
        Ok(())
    }

    /// Puts the figure somewhere else, with other velocities; drives by curves have to go on from there, so that they begin anew.
    ///
    /// # Errors
    ///
    /// Those of [`Simulation::set_start`], and nothing has changed.
    pub fn set_state(&mut self, q: &[f64], v: &[f64]) -> Result<(), RunError> {
        let mut next = self.clone();
        next.forget();
        next.progress.interrupt()?;
        Arc::make_mut(&mut next.progress.pass.simulation).set_start(q, v)?;
        next.progress.pass.put()?;
        *self = next;
        Ok(())
    }

    /// What happened before does not count any more.
    fn forget(&mut self) {
        let passed = &mut self.progress.pass.passed;
        passed.record.events.clear();
        passed.impacts.clear();
        passed.landings.clear();
        passed.outcomes.clear();
        let last = passed.phases.len().saturating_sub(1);
        passed.phases.drain(..last);
    }
}

/// What is asked of the present instant, made when it is asked for first.
fn present<'a>(
    present: &'a mut Option<Box<Present>>,
    progress: &Progress,
) -> Result<&'a mut Present, RunError> {
    match present {
        Some(present) => Ok(present),
        none => Ok(none.insert(Box::new(Present::of(progress)?))),
    }
}

impl std::fmt::Debug for Running {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Running").field("time", &self.time()).field("q", &self.q()).finish_non_exhaustive()
    }
}
