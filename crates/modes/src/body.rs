//! A figure with everything that acts in it by itself: springs, dampers, limits, gravity.

mod closures;
mod joints;
mod limits;
mod planted;
mod points;
mod pushes;
mod touching;

use crate::contact::{ContactPatch, Surface};
use crate::element::{LimitLaw, PointSpring};
use crate::failure::SetupError;
use crate::report::Energy;
pub(crate) use closures::Closure;
use joints::JointElements;
use limits::Stop;
pub(crate) use limits::{Pushing, pushing};
use nalgebra::{DMatrix, Vector3};
use planted::Planted;
use points::PointElement;
use pushes::PushElement;
use solaris_dynamics::{
    DynamicsError, Frame, Pose, Tree, Twist, Workspace, Wrench, accelerations, contact_dynamics,
    forward_kinematics, hybrid_dynamics, inverse_dynamics, joint_jacobians, kinetic_energy, mass_matrix,
    point_columns, potential_energy, velocities,
};
use solaris_model::Figure;
use solaris_profiles::Elementary;
use touching::GroundElement;
pub(crate) use touching::{Pressed, Pressure};

/// How near to the ground (m) a sphere may touch it within a step, whatever its velocity.
const CLOSE: f64 = 2e-3;

/// A figure with everything that acts in it by itself, for one scalar: what the drives' forces come on top of.
///
/// Forces `tau` are those of the **drives**: springs, dampers, friction and limits of the joints, springs between points and
/// gravity and the ground act besides them,
///
/// ```text
/// M·a + h = τ + τ_joints + τ_limits + Jᵀ·(F_points + F_ground)
/// ```
///
/// What the figure does not have costs nothing: without springs between points and without a ground no velocities of links are
/// found.
///
/// Degrees of freedom that follow others are taken as free: whoever calls gives them the motion that their leaders ask for.
#[derive(Clone, Debug)]
pub(crate) struct Body<T> {
    tree: Tree<T>,
    /// The same without gravity, for impacts.
    weightless: Tree<T>,
    workspace: Workspace<T>,
    joints: JointElements<T>,
    stops: Vec<Stop<T>>,
    points: Vec<PointElement<T>>,
    ground: Option<GroundElement<T>>,
    pushes: Vec<PushElement<T>>,
    /// What the world does in an impact besides.
    blows: Vec<(usize, Wrench<T>)>,
    /// What stands on the ground and stays there, and what loops hold together.
    planted: Option<Planted<T>>,
    /// What acts by itself along each degree of freedom, in the state of the last call.
    passive: Vec<T>,
    /// What springs between points and the ground do to links, in the state of the last call.
    external: Vec<(usize, Wrench<T>)>,
    /// What dampers and friction took in the state of the last call, those of the ground among them.
    heat: T,
    /// What pushes did (W) in the state of the last call.
    power: T,
    /// What the ground did in the state of the last call.
    pressure: Pressure<T>,
    /// Whether the ground acts by impulses, and not by forces of its own.
    by_impulses: bool,
    total: Vec<T>,
    zeros: Vec<T>,
}

impl<T: Elementary> Body<T> {
    /// `springs` name links of `figure`; `limits` by degree of freedom.
    pub(crate) fn new(
        figure: &Figure,
        gravity: Vector3<f64>,
        springs: &[PointSpring],
        limits: &[LimitLaw],
    ) -> Result<Self, SetupError> {
        Ok(Self::compile(figure, gravity, springs, limits)?)
    }

    /// The same as [`new`](Self::new), with the only kind of error that it has.
    pub(crate) fn compile(
        figure: &Figure,
        gravity: Vector3<f64>,
        springs: &[PointSpring],
        limits: &[LimitLaw],
    ) -> Result<Self, DynamicsError> {
        let untied = (!figure.followers().is_empty()).then(|| figure.untied());
        let figure = untied.as_ref().unwrap_or(figure);
        let tree = Tree::new(figure, gravity)?;
        let zeros = vec![T::zero(); tree.nv()];
        Ok(Self {
            workspace: Workspace::new(&tree),
            weightless: Tree::new(figure, Vector3::zeros())?,
            joints: JointElements::of(figure),
            stops: Stop::of(figure, limits),
            points: springs.iter().map(PointElement::of).collect(),
            passive: zeros.clone(),
            external: Vec::with_capacity(2 * springs.len()),
            heat: T::zero(),
            ground: None,
            pushes: Vec::new(),
            blows: Vec::new(),
            power: T::zero(),
            planted: None,
            pressure: Pressure::none(),
            by_impulses: false,
            total: zeros.clone(),
            zeros,
            tree,
        })
    }

    /// The same on a ground, whose touches name links of the figure.
    pub(crate) fn on(mut self, surface: Option<&Surface>) -> Self {
        self.ground = surface.map(GroundElement::of).filter(|ground| ground.len() > 0);
        self.external.reserve(self.ground.as_ref().map_or(0, GroundElement::len));
        self
    }

    /// From now on the ground has no forces of its own: impulses of whoever steps take their place.
    pub(crate) fn touch_by_impulses(&mut self, by_impulses: bool) {
        self.by_impulses = by_impulses;
    }

    /// From now on these stand on the ground and stay where they are, until others take their place.
    pub(crate) fn plant(&mut self, patches: &[ContactPatch]) {
        let closures = self.planted.take().map_or_else(Vec::new, Planted::into_closures);
        self.planted = Planted::new(&self.tree, self.ground.as_ref(), patches, closures);
    }

    /// From now on these loops are closed, and nothing stands on the ground.
    pub(crate) fn close(&mut self, closures: Vec<Closure<T>>) {
        self.planted = Planted::new(&self.tree, self.ground.as_ref(), &[], closures);
    }

    /// From now on the limits of a degree of freedom, where they push back, do this, whatever the state says.
    pub(crate) fn hold_limit(&mut self, dof: usize, pushing: Pushing) {
        for stop in self.stops.iter_mut().filter(|stop| stop.dof() == dof) {
            stop.hold(Some(pushing));
        }
    }

    /// The limits do as those of `other` have been told, which is the same figure in another scalar.
    pub(crate) fn hold_limits_as<U: Elementary>(&mut self, other: &Body<U>) {
        for (stop, other) in self.stops.iter_mut().zip(&other.stops) {
            stop.hold(other.held());
        }
    }

    /// Hybrid dynamics: where `prescribed[k]`, `a[k]` is read and the drive's force `tau[k]` written, else the other way round.
    ///
    /// `q` has length `nq`, the others `nv`.
    pub(crate) fn hybrid(
        &mut self,
        q: &[T],
        v: &[T],
        prescribed: &[bool],
        a: &mut [T],
        tau: &mut [T],
    ) -> Result<(), DynamicsError> {
        self.act(q, v)?;
        self.check("tau", tau.len())?;
        self.check("prescribed", prescribed.len())?;
        for (k, total) in self.total.iter_mut().enumerate() {
            *total = if prescribed[k] { T::zero() } else { tau[k] + self.passive[k] };
        }
        let (tree, workspace, external) = (&self.tree, &mut self.workspace, &self.external);
        match &mut self.planted {
            Some(planted) => {
                planted.hold(self.ground.as_ref(), workspace);
                let contacts = planted.contacts();
                let total = &mut self.total;
                contact_dynamics(tree, workspace, contacts, q, v, prescribed, external, a, total)?;
                if planted.has_footholds() {
                    self.pressure.force = planted.force();
                }
            }
            None => hybrid_dynamics(tree, workspace, q, v, prescribed, external, a, &mut self.total)?,
        }
        for (k, force) in tau.iter_mut().enumerate().filter(|(k, _)| prescribed[*k]) {
            *force = self.total[k] - self.passive[k];
        }
        Ok(())
    }

    /// The drives' forces of a motion.
    ///
    /// `planted` is what the ground does to links that stand on it (about the world's origin).
    pub(crate) fn inverse(
        &mut self,
        q: &[T],
        v: &[T],
        a: &[T],
        planted: &[(usize, Wrench<T>)],
        tau: &mut [T],
    ) -> Result<(), DynamicsError> {
        self.act(q, v)?;
        self.external.extend_from_slice(planted);
        inverse_dynamics(&self.tree, &mut self.workspace, q, v, a, &self.external, tau)?;
        for (force, passive) in tau.iter_mut().zip(&self.passive) {
            *force -= *passive;
        }
        Ok(())
    }

    /// Impact: where `prescribed[k]`, the jump `jump[k]` of the velocity is read and the impulse `impulse[k]` written, else the
    /// other way round.
    ///
    /// ```text
    /// M·Δv = p
    /// ```
    ///
    /// Gravity, springs and dampers have no part in it: their forces are finite. What stands on the ground comes to rest there.
    pub(crate) fn impact(
        &mut self,
        (q, v): (&[T], &[T]),
        prescribed: &[bool],
        jump: &mut [T],
        impulse: &mut [T],
    ) -> Result<(), DynamicsError> {
        let (tree, workspace, zeros, blows) =
            (&self.weightless, &mut self.workspace, &self.zeros, &self.blows);
        match &mut self.planted {
            Some(planted) => {
                velocities(&self.tree, workspace, q, v)?;
                planted.stop(self.ground.as_ref(), workspace);
                let contacts = planted.contacts();
                contact_dynamics(tree, workspace, contacts, q, zeros, prescribed, blows, jump, impulse)?;
            }
            None => hybrid_dynamics(tree, workspace, q, zeros, prescribed, blows, jump, impulse)?,
        }
        Ok(())
    }

    /// What dampers and friction take (W) in the state of the last call of [`hybrid`](Self::hybrid) or
    /// [`inverse`](Self::inverse).
    pub(crate) fn heat(&self) -> T {
        self.heat
    }

    /// What the ground does in the state of the last call of [`hybrid`](Self::hybrid) or [`inverse`](Self::inverse).
    pub(crate) fn pressure(&self) -> &Pressure<T> {
        &self.pressure
    }

    /// What the ground does to each contact patch (N, N m, about the world's origin), as the last call of [`hybrid`](Self::hybrid), or of
    /// [`impact`](Self::impact) (N s, N m s), found it.
    pub(crate) fn patch_wrenches(&self) -> impl Iterator<Item = Wrench<T>> {
        self.planted.iter().flat_map(Planted::wrenches)
    }

    /// What each loop does to the link that it holds (N, N m, about the world's origin), as the last call of [`hybrid`](Self::hybrid) found it.
    pub(crate) fn closing(&self) -> &[(usize, Wrench<T>)] {
        self.planted.as_ref().map_or(&[], Planted::closing)
    }

    /// The greatest acceleration (m/s², rad/s²) that a contact patch asks for and the last call of [`hybrid`](Self::hybrid) could not give
    /// it, or velocity (m/s, rad/s) in an [`impact`](Self::impact), after the index of that contact patch.
    pub(crate) fn missing(&self) -> (usize, f64) {
        self.planted.as_ref().map_or((0, 0.0), Planted::most_missing)
    }

    /// Where the lowest point of a sphere that can touch the ground is (m), at the poses of the last call.
    pub(crate) fn lowest(&self, touch: usize) -> Vector3<T> {
        let sphere = self.ground.as_ref().map(|ground| &ground.spheres()[touch]);
        sphere.map_or_else(Vector3::zeros, |sphere| sphere.lowest(&self.workspace))
    }

    /// How far above the ground it is (m).
    pub(crate) fn gap(&self, touch: usize) -> T {
        self.ground.as_ref().map_or_else(T::zero, |ground| ground.gap(touch, &self.workspace))
    }

    /// Places the links.
    pub(crate) fn place(&mut self, q: &[T]) -> Result<(), DynamicsError> {
        forward_kinematics(&self.tree, &mut self.workspace, q)
    }

    /// The spheres that come to the ground within a time `within` (s) at their velocities, or nearly: index, how far off the ground (m)
    /// and the lowest point; where [`velocities`](Self::velocities) were found last.
    pub(crate) fn nearly_touching(&self, within: f64, near: &mut Vec<(usize, f64, Vector3<T>)>) {
        near.clear();
        for (index, sphere) in self.ground.iter().flat_map(|ground| ground.spheres().iter().enumerate()) {
            let (gap, material) = (self.gap(index).value(), sphere.material(&self.workspace));
            if gap < CLOSE + within * material.velocity.dot(&material.velocity).sqrt().value() {
                near.push((index, gap, material.point));
            }
        }
    }

    /// How joints and limits that push back hold each degree of freedom back in a state, at this moment: `d` (N m s/rad) and `k`
    /// (N m/rad) of a force `−d·v − k·q`.
    pub(crate) fn holds_back(&self, q: &[T], v: &[T], damping: &mut [T], stiffness: &mut [T]) {
        damping.fill(T::zero());
        stiffness.fill(T::zero());
        let mut add = |dof: usize, d: T, k: T| {
            damping[dof] += d;
            stiffness[dof] += k;
        };
        self.joints.holds_back(v, &mut add);
        for stop in &self.stops {
            stop.holds_back(q, v, &mut add);
        }
    }

    /// What limits give up that come back to where they begin faster than what they limit (W).
    pub(crate) fn slackens(&self, q: &[T], v: &[T]) -> T {
        self.stops.iter().fold(T::zero(), |sum, stop| sum + stop.slackens(q, v))
    }

    /// What springs between points and pushes do to links in a state, about the world's origin.
    pub(crate) fn acting(&mut self, q: &[T], v: &[T]) -> Result<&[(usize, Wrench<T>)], DynamicsError> {
        self.external.clear();
        velocities(&self.tree, &mut self.workspace, q, v)?;
        for spring in &self.points {
            spring.act(&self.workspace, &mut self.external);
        }
        for push in &self.pushes {
            self.external.push(push.wrench(&self.workspace));
        }
        Ok(&self.external)
    }

    /// Prepares [`columns`](Self::columns) at `q`.
    pub(crate) fn joint_jacobians(&mut self, q: &[T]) -> Result<(), DynamicsError> {
        joint_jacobians(&self.tree, &mut self.workspace, q)
    }

    /// Finds poses and velocities of the links.
    pub(crate) fn velocities(&mut self, q: &[T], v: &[T]) -> Result<(), DynamicsError> {
        velocities(&self.tree, &mut self.workspace, q, v)
    }

    /// The pose of a link, and its velocity, where [`velocities`](Self::velocities) were found last.
    pub(crate) fn pose(&self, link: usize) -> &Pose<T> {
        self.workspace.pose(link)
    }

    pub(crate) fn velocity(&self, link: usize) -> &Twist<T> {
        self.workspace.velocity(link)
    }

    /// Finds accelerations of the links.
    pub(crate) fn accelerations(&mut self, (q, v, a): (&[T], &[T], &[T])) -> Result<(), DynamicsError> {
        accelerations(&self.tree, &mut self.workspace, q, v, a)
    }

    /// The acceleration of the material at a point of the world on a link, and its angular acceleration, where
    /// [`accelerations`](Self::accelerations) were found last.
    pub(crate) fn acceleration_at(&self, link: usize, point: &Vector3<T>) -> Twist<T> {
        let (arm, velocity) = (point - self.pose(link).translation, self.velocity(link).angular);
        let Twist { linear, angular } = *self.workspace.acceleration(link);
        Twist { linear: linear + angular.cross(&arm) + velocity.cross(&velocity.cross(&arm)), angular }
    }

    /// The velocity of the material at a point of the world on a link, and its angular velocity, for a unit rate of each degree of freedom on which it depends.
    pub(crate) fn columns(&self, link: usize, point: &Vector3<T>, visit: impl FnMut(usize, Twist<T>)) {
        let pose = self.workspace.pose(link);
        let frame = Frame::at(link, pose.rotation.tr_mul(&(point - pose.translation)));
        point_columns(&self.tree, &self.workspace, &frame, visit);
    }

    /// The accelerations (m/s²) of the lowest points of all spheres that can touch the ground, away from it.
    pub(crate) fn rises(
        &mut self,
        q: &[T],
        v: &[T],
        a: &[T],
    ) -> Result<impl Iterator<Item = T>, DynamicsError> {
        accelerations(&self.tree, &mut self.workspace, q, v, a)?;
        Ok(self.ground.iter().flat_map(|ground| ground.rises(&self.workspace)))
    }

    /// What the ground does at each touch in a state, by its index.
    pub(crate) fn touching(
        &mut self,
        q: &[T],
        v: &[T],
    ) -> Result<impl Iterator<Item = Pressed<T>>, DynamicsError> {
        velocities(&self.tree, &mut self.workspace, q, v)?;
        Ok(self.ground.iter().flat_map(|ground| ground.each(&self.workspace)))
    }

    /// The energy of a state.
    pub(crate) fn energy(&mut self, q: &[T], v: &[T]) -> Result<Energy, DynamicsError> {
        let kinetic = kinetic_energy(&self.tree, &mut self.workspace, q, v)?.value();
        let potential = potential_energy(&self.tree, &mut self.workspace, q)?.value();
        let stops = self.stops.iter().map(|stop| stop.energy(q).value());
        let points = self.points.iter().map(|spring| spring.energy(&self.workspace).value());
        let ground = self.ground.as_ref().filter(|_| !self.by_impulses);
        let ground = ground.map_or(0.0, |ground| ground.energy(&self.workspace).value());
        let elastic = self.joints.energy(q).value() + stops.sum::<f64>() + points.sum::<f64>() + ground;
        Ok(Energy { kinetic, potential, elastic })
    }

    /// The mass matrix (`nv` × `nv`) at `q`.
    pub(crate) fn mass_matrix(&mut self, q: &[T], matrix: &mut DMatrix<T>) -> Result<(), DynamicsError> {
        mass_matrix(&self.tree, &mut self.workspace, q, matrix)
    }

    /// The forces that a motion takes of the links' inertia alone: `M·a + C(q, v)·v`.
    pub(crate) fn inertial_forces(
        &mut self,
        (q, v, a): (&[T], &[T], &[T]),
        forces: &mut [T],
    ) -> Result<(), DynamicsError> {
        inverse_dynamics(&self.weightless, &mut self.workspace, q, v, a, &[], forces)
    }

    /// Finds what acts by itself in a state.
    fn act(&mut self, q: &[T], v: &[T]) -> Result<(), DynamicsError> {
        let expected = self.tree.nq();
        if q.len() != expected {
            return Err(DynamicsError::Length { what: "q", expected, found: q.len() });
        }
        self.check("v", v.len())?;
        self.passive.fill(T::zero());
        self.heat = self.joints.act(q, v, &mut self.passive);
        for stop in &self.stops {
            self.heat += stop.act(q, v, &mut self.passive);
        }
        self.external.clear();
        self.pressure = Pressure::none();
        let on_ground = self.ground.is_some() && !self.by_impulses;
        if !self.points.is_empty() || on_ground || self.has_pushes() || self.planted.is_some() {
            velocities(&self.tree, &mut self.workspace, q, v)?;
        }
        for spring in &self.points {
            self.heat += spring.act(&self.workspace, &mut self.external);
        }
        self.power = T::zero();
        for push in &self.pushes {
            self.external.push(push.wrench(&self.workspace));
            self.power += push.power(&self.workspace);
        }
        if let Some(ground) = self.ground.as_ref().filter(|_| !self.by_impulses) {
            self.pressure = ground.act(&self.workspace, &mut self.external);
            self.heat += self.pressure.damping + self.pressure.friction;
        }
        Ok(())
    }

    fn check(&self, what: &'static str, found: usize) -> Result<(), DynamicsError> {
        let expected = self.tree.nv();
        if found == expected { Ok(()) } else { Err(DynamicsError::Length { what, expected, found }) }
    }
}

#[cfg(test)]
mod laws;
#[cfg(test)]
pub(crate) mod random;
