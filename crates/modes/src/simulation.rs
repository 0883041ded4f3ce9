//! A figure, what drives it, and what acts on it: ready to be run.

use crate::carry::{Carry, check_span};
use crate::collision::Collisions;
use crate::contact::{ContactPoint, GroundPlane, Surface};
use crate::drive::{Drive, EndCondition, Step};
use crate::element::{Anchor, LimitLaw, Loop, PointSpring};
use crate::failure::SetupError;
use crate::push::Push;
use crate::range::check_not_negative;
use crate::sequence::Stage;
use nalgebra::Vector3;
use solaris_model::{Figure, nearest};

/// A figure under a gravity, with its state at the beginning, what drives each of its degrees of freedom one after the
/// other, and passive elements.
///
/// To begin with every degree of freedom is free, at zero and at rest, and joint limits stop what dynamics move.
#[doc(alias = "integrate")]
#[doc(alias = "world")]
#[derive(Clone, Debug)]
pub struct Simulation {
    pub(crate) figure: Figure,
    pub(crate) gravity: Vector3<f64>,
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
    /// By degree of freedom.
    pub(crate) drives: Vec<Vec<Step>>,
    /// By degree of freedom: with which of its drives it goes on after the last one.
    pub(crate) again: Vec<Option<usize>>,
    /// The parts of a sequence.
    pub(crate) stages: Vec<Stage>,
    pub(crate) springs: Vec<PointSpring>,
    pub(crate) loops: Vec<Loop>,
    /// Which of them are closed, to begin with.
    pub(crate) closed: Vec<bool>,
    /// By degree of freedom.
    pub(crate) limits: Vec<LimitLaw>,
    pub(crate) surface: Option<Surface>,
    pub(crate) collisions: Option<Collisions>,
    pub(crate) pushes: Vec<Push>,
    pub(crate) carries: Vec<Carry>,
}

impl Simulation {
    /// `figure` under the acceleration of `gravity` (m/s², world axes), zero for none.
    pub fn new(figure: &Figure, gravity: Vector3<f64>) -> Self {
        let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
        let mut q = vec![0.0; nq];
        // Cannot fail: the length is right.
        let _ = figure.neutral(&mut q);
        Self {
            figure: figure.clone(),
            gravity,
            q,
            v: vec![0.0; nv],
            drives: vec![vec![Drive::Free.into()]; nv],
            again: vec![None; nv],
            stages: Vec::new(),
            springs: Vec::new(),
            loops: Vec::new(),
            closed: Vec::new(),
            limits: vec![LimitLaw::default(); nv],
            surface: None,
            collisions: None,
            pushes: Vec::new(),
            carries: Vec::new(),
        }
    }

    /// The figure.
    pub fn figure(&self) -> &Figure {
        &self.figure
    }

    /// The acceleration of gravity (m/s²).
    pub fn gravity(&self) -> &Vector3<f64> {
        &self.gravity
    }

    /// The state at the beginning: `q` (length `nq`; rad, m) and `v` (length `nv`).
    pub fn state(&self) -> (&[f64], &[f64]) {
        (&self.q, &self.v)
    }

    /// Sets the state at the beginning. Quaternions are given unit length.
    ///
    /// # Errors
    ///
    /// Wrong lengths, numbers that are not finite, quaternions that are none.
    pub fn set_start(&mut self, q: &[f64], v: &[f64]) -> Result<(), SetupError> {
        let mut own = q.to_vec();
        self.figure.normalize(&mut own)?;
        if v.len() != self.v.len() {
            return Err(SetupError::Dynamics(solaris_dynamics::DynamicsError::Length {
                what: "v",
                expected: self.v.len(),
                found: v.len(),
            }));
        }
        if let Some(bad) = v.iter().position(|x| !x.is_finite()) {
            let what = format!("the velocity of '{}'", self.name(bad));
            return Err(SetupError::Range { what, value: v[bad], range: "a finite number" });
        }
        self.q = own;
        self.v.copy_from_slice(v);
        Ok(())
    }

    /// What drives a degree of freedom: one drive after the other. After the last one is done it stands still; a last drive
    /// that never is done lasts.
    ///
    /// The name is that of a degree of freedom, or of a joint, all of whose degrees of freedom are meant but those that
    /// follow others.
    ///
    /// # Errors
    ///
    /// [`SetupError`] for names that are none, drives that the joint does not have, a degree of freedom that follows another,
    /// numbers out of range.
    pub fn drive<S: Into<Step>>(
        &mut self,
        name: &str,
        steps: impl IntoIterator<Item = S>,
    ) -> Result<(), SetupError> {
        let steps: Vec<Step> = steps.into_iter().map(Into::into).collect();
        let dofs = self.dofs(name)?;
        if let [dof] = dofs[..]
            && let Some(follower) = self.figure.followers().iter().find(|follower| follower.dof == dof)
        {
            let [dof, leader] = [dof, follower.leader].map(|dof| self.name(dof).to_owned());
            return Err(SetupError::DrivenFollower { dof, leader });
        }
        for dof in dofs.into_iter().filter(|dof| !self.figure.follows(*dof)) {
            self.check_steps(dof, &steps)?;
            self.drives[dof].clone_from(&steps);
            self.again[dof] = None;
            // It takes no part in a sequence any more.
            self.stages.iter_mut().for_each(|stage| stage.parties.retain(|(party, _)| *party != dof));
        }
        Ok(())
    }

    /// The same, and after the last of the drives the one of index `first` begins again, and those after it, without end.
    ///
    /// ```
    /// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
    /// use solaris_modes::{Drive, Settings, Shape, Simulation};
    ///
    /// let link = LinkSpec::root("block", Joint::new("slide").tx()).mass(1.0);
    /// let mut simulation = Simulation::new(&FigureBuilder::new("f").link(link).build()?, Vector3::zeros());
    /// // To and fro.
    /// let to = |to| Drive::Move { to, over: 0.5, along: Shape::MinimumJerk };
    /// simulation.drive_again("slide", [to(1.0), to(0.0)], 0)?;
    /// let run = simulation.run(&Settings::new(3.5, 10.0))?;
    /// assert!((run.motion.q(35)[0] - 1.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`drive`](Self::drive), and for a `first` that there is not. Drives that are all over without any time going on fail
    /// the run.
    pub fn drive_again<S: Into<Step>>(
        &mut self,
        name: &str,
        steps: impl IntoIterator<Item = S>,
        first: usize,
    ) -> Result<(), SetupError> {
        let steps: Vec<Step> = steps.into_iter().map(Into::into).collect();
        if first >= steps.len() {
            let what = format!("the drive of '{name}' that comes again");
            let range = "the index of one of its drives";
            return Err(SetupError::Range { what, value: first as f64, range });
        }
        self.drive(name, steps)?;
        for dof in self.dofs(name)?.into_iter().filter(|dof| !self.figure.follows(*dof)) {
            self.again[dof] = Some(first);
        }
        Ok(())
    }

    /// The index of the drive that comes after the one of index `step`.
    pub(crate) fn next_drive(&self, dof: usize, step: usize) -> usize {
        let next = step + 1;
        self.again[dof].filter(|_| next >= self.drives[dof].len()).unwrap_or(next)
    }

    /// What drives a degree of freedom.
    pub fn driven_by(&self, dof: usize) -> &[Step] {
        &self.drives[dof]
    }

    /// Adds a spring and damper between two points.
    ///
    /// # Errors
    ///
    /// [`SetupError::UnknownLink`], [`SetupError::Range`].
    pub fn add_spring(&mut self, spring: PointSpring) -> Result<(), SetupError> {
        self.check_anchors(&spring.between, "a spring")?;
        for (what, value) in
            [("stiffness", spring.stiffness), ("damping", spring.damping), ("rest length", spring.rest)]
        {
            check_not_negative(|| format!("the {what} of a spring"), value)?;
        }
        self.springs.push(spring);
        Ok(())
    }

    /// Holds two points together, for a time or for the whole run. By [`Method::Impulses`](crate::Method::Impulses) what begins apart is drawn together at 0.1 m/s;
    /// other methods want it closed.
    ///
    /// # Errors
    ///
    /// [`SetupError::UnknownLink`], [`SetupError::Range`], [`SetupError::LoopOfNothing`].
    pub fn add_loop(&mut self, closed: Loop) -> Result<(), SetupError> {
        self.check_anchors(&closed.between, "a loop")?;
        let [first, second] = closed.between.map(|anchor| anchor.link);
        if first == second {
            return Err(SetupError::LoopOfNothing);
        }
        check_span(
            [closed.from, closed.until],
            || "the beginning of a loop".to_owned(),
            || "how long a loop holds".to_owned(),
        )?;
        self.closed.push(closed.from <= 0.0);
        self.loops.push(closed);
        Ok(())
    }

    /// The loops that are closed, for a time or for the whole run.
    pub fn loops(&self) -> &[Loop] {
        &self.loops
    }

    fn check_anchors(&self, anchors: &[Anchor], of: &str) -> Result<(), SetupError> {
        let links = self.figure.links().len();
        for Anchor { link, point } in anchors {
            if let Some(link) = link.filter(|link| *link >= links) {
                let (figure, name) = (self.figure.name().to_owned(), format!("number {link}"));
                return Err(SetupError::UnknownLink { figure, name, nearest: None });
            }
            if let Some(value) = point.iter().find(|x| !x.is_finite()) {
                let what = format!("a point of {of}");
                return Err(SetupError::Range { what, value: *value, range: "finite numbers" });
            }
        }
        Ok(())
    }

    /// The springs and dampers between points.
    pub fn springs(&self) -> &[PointSpring] {
        &self.springs
    }

    /// Lays a ground under the figure, which `contact_points` can touch, [`contact_points`](crate::contact_points) for all that the figure says of
    /// itself; in place of the one that there was.
    ///
    /// It acts on what dynamics move.
    ///
    /// # Errors
    ///
    /// [`SetupError::UnknownLink`], [`SetupError::Range`].
    pub fn set_ground(
        &mut self,
        plane: GroundPlane,
        contact_points: Vec<ContactPoint>,
    ) -> Result<(), SetupError> {
        self.surface = Some(Surface::new(&self.figure, plane, contact_points)?);
        Ok(())
    }

    /// The ground, if there is one, and what can touch it.
    pub fn grounded(&self) -> Option<(&GroundPlane, &[ContactPoint])> {
        self.surface.as_ref().map(|surface| (&surface.plane, &*surface.contact_points))
    }

    /// Lets links touch each other, by [`Method::Impulses`](crate::Method::Impulses) only; in place of what was said before.
    ///
    /// ```
    /// use solaris_model::{Vector3, human};
    /// use solaris_modes::{Collisions, Simulation};
    ///
    /// # #[cfg(feature = "collide")] {
    /// let figure = human(1.75, 73.0)?;
    /// let mut simulation = Simulation::new(&figure, Vector3::y() * -9.81);
    /// simulation.set_collisions(Collisions::of(&figure, 0.5)?)?;
    /// # }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`SetupError::CollisionsNotBuiltIn`] without this crate's feature `collide`, `SetupError::Collision` for links without shapes,
    /// [`SetupError::Range`].
    pub fn set_collisions(&mut self, collisions: Collisions) -> Result<(), SetupError> {
        collisions.check(&self.figure)?;
        self.collisions = Some(collisions).filter(|collisions| !collisions.pairs.is_empty());
        Ok(())
    }

    /// Which links touch each other, if any do.
    pub fn collisions(&self) -> Option<&Collisions> {
        self.collisions.as_ref()
    }

    /// What forces are weighed against: that of gravity on the figure (N), its mass (kg) where there is none, 1 without mass.
    pub(crate) fn weight(&self) -> f64 {
        let (mass, gravity) = (self.figure.mass(), self.gravity.norm());
        [mass * gravity, mass].into_iter().find(|weight| *weight > 0.0).unwrap_or(1.0)
    }

    /// What the limits of a degree of freedom (index in `v`) do.
    pub fn limit_of(&self, dof: usize) -> LimitLaw {
        self.limits[dof]
    }

    /// What the limits of all joints do.
    ///
    /// # Errors
    ///
    /// [`SetupError::Range`].
    pub fn set_limits(&mut self, law: LimitLaw) -> Result<(), SetupError> {
        check_limit(&law)?;
        self.limits.fill(law);
        Ok(())
    }

    /// What the limits of one degree of freedom, or of all of a joint, do.
    ///
    /// # Errors
    ///
    /// [`SetupError::UnknownDof`], [`SetupError::Range`].
    pub fn set_limit(&mut self, name: &str, law: LimitLaw) -> Result<(), SetupError> {
        check_limit(&law)?;
        for dof in self.dofs(name)? {
            self.limits[dof] = law;
        }
        Ok(())
    }

    /// Name of a degree of freedom.
    pub(crate) fn name(&self, dof: usize) -> &str {
        &self.figure.layout().v_names()[dof]
    }

    /// The degrees of freedom that a name means.
    pub(crate) fn dofs(&self, name: &str) -> Result<Vec<usize>, SetupError> {
        let layout = self.figure.layout();
        if let Some(dof) = layout.dof_index(name) {
            return Ok(vec![dof]);
        }
        if let Some(joint) = self.figure.joint_index(name) {
            let at = layout.joints()[joint];
            return Ok((at.v..at.v + at.nv).collect());
        }
        let joints = self.figure.links().iter().map(|link| link.joint().name());
        let names = layout.v_names().iter().map(String::as_str).chain(joints);
        let nearest = nearest(name, names);
        Err(SetupError::UnknownDof { figure: self.figure.name().to_owned(), name: name.to_owned(), nearest })
    }

    pub(crate) fn check_steps(&self, dof: usize, steps: &[Step]) -> Result<(), SetupError> {
        let owned = || self.name(dof).to_owned();
        for Step { drive, until } in steps {
            if self.figure.layout().coordinate(dof).is_none() && !drive.fits_ball_joints() {
                let joint = self.figure.links().iter().zip(self.figure.layout().joints());
                let joint = joint
                    .filter(|(_, at)| (at.v..at.v + at.nv).contains(&dof))
                    .map(|(link, _)| link.joint().name());
                let joint = joint.collect::<String>();
                return Err(SetupError::NoSuchDrive { dof: owned(), joint, drive: drive.name() });
            }
            drive.check(self.name(dof))?;
            self.check_until(until, || format!("the time until which '{}' has a drive", owned()))?;
        }
        Ok(())
    }

    /// Refuses what nothing can come to.
    pub(crate) fn check_until(
        &self,
        until: &EndCondition,
        time: impl Fn() -> String,
    ) -> Result<(), SetupError> {
        match until {
            EndCondition::Done | EndCondition::Part(_) => {}
            EndCondition::Time(value) | EndCondition::Lasting(value) => {
                check_not_negative(time, *value)?;
            }
            EndCondition::Position { dof: name, value } | EndCondition::Velocity { dof: name, value } => {
                let [watched] = self.dofs(name)?[..] else {
                    let (figure, name) = (self.figure.name().to_owned(), name.clone());
                    return Err(SetupError::UnknownDof { figure, name, nearest: None });
                };
                if matches!(until, EndCondition::Position { .. })
                    && self.figure.layout().coordinate(watched).is_none()
                {
                    let (joint, drive) = (name.clone(), "until a position");
                    return Err(SetupError::NoSuchDrive { dof: name.clone(), joint, drive });
                }
                if !value.is_finite() {
                    let what = format!("the value that '{name}' is to pass through");
                    return Err(SetupError::Range { what, value: *value, range: "a finite number" });
                }
            }
            EndCondition::TouchDown { link } | EndCondition::LiftOff { link } => {
                if self.figure.link_index(link).is_none() {
                    let names = self.figure.links().iter().map(solaris_model::Link::name);
                    let (figure, nearest) = (self.figure.name().to_owned(), nearest(link, names));
                    return Err(SetupError::UnknownLink { figure, name: link.clone(), nearest });
                }
            }
        }
        Ok(())
    }
}

fn check_limit(law: &LimitLaw) -> Result<(), SetupError> {
    match *law {
        LimitLaw::Ignore => Ok(()),
        LimitLaw::Hard { restitution } if (0.0..=1.0).contains(&restitution) => Ok(()),
        LimitLaw::Hard { restitution: value } => {
            Err(SetupError::Range { what: "the restitution of a limit".to_owned(), value, range: "0 to 1" })
        }
        LimitLaw::Spring { stiffness, damping } => {
            check_not_negative(|| "the stiffness of a limit".to_owned(), stiffness)?;
            check_not_negative(|| "the damping of a limit".to_owned(), damping)
        }
    }
}
