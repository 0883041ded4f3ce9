//! Forces of the world on points of links.

use super::Body;
use nalgebra::Vector3;
use solaris_dynamics::{DynamicsError, Workspace, Wrench, velocities};
use solaris_model::Load;
use solaris_profiles::Elementary;

/// A point of a link, and what the world does to it now.
#[derive(Clone, Debug)]
pub(super) struct PushElement<T> {
    link: usize,
    point: Vector3<T>,
    /// In world axes (N, or N s in an impact).
    force: Vector3<T>,
}

impl<T: Elementary> PushElement<T> {
    /// That on a point (m) of a link, with no force yet.
    pub(super) fn on(&(link, point): &(usize, Vector3<f64>)) -> Self {
        Self { link, point: point.map(T::from_f64), force: Vector3::zeros() }
    }

    /// From now on it has this force (N).
    pub(super) fn set(&mut self, force: &Vector3<f64>) {
        self.force = force.map(T::from_f64);
    }

    /// The wrench on its link (about the world's origin), at the poses in `workspace`.
    pub(super) fn wrench(&self, workspace: &Workspace<T>) -> (usize, Wrench<T>) {
        let point = workspace.pose(self.link).transform(&self.point);
        (self.link, Wrench::at(&point, self.force, Vector3::zeros()))
    }

    /// What it does (W), at the poses and velocities in `workspace`.
    pub(super) fn power(&self, workspace: &Workspace<T>) -> T {
        let (pose, twist) = (workspace.pose(self.link), workspace.velocity(self.link));
        self.force.dot(&(twist.linear + twist.angular.cross(&(pose.rotation * self.point))))
    }
}

impl<T: Elementary> Body<T> {
    /// The same with pushes on points (m) of these links, without a force until [`set_push`](Self::set_push).
    pub(crate) fn pushed(mut self, on: &[(usize, Vector3<f64>)]) -> Self {
        self.pushes = on.iter().map(PushElement::on).collect();
        self.external.reserve(on.len());
        self
    }

    /// From now on the world pushes so (N, world axes), by the index of the push.
    pub(crate) fn set_push(&mut self, push: usize, force: &Vector3<f64>) {
        self.pushes[push].set(force);
    }

    /// Whether the world pushes anything.
    pub(crate) fn has_pushes(&self) -> bool {
        !self.pushes.is_empty()
    }

    /// What pushes do (W) in the state of the last call of [`hybrid`](Self::hybrid).
    pub(crate) fn power(&self) -> T {
        self.power
    }

    /// From now on the world gives these impulses (N s), by the index of the push, in [impacts](Self::impact) from this configuration;
    /// how much that would do to what moves with `v` (J).
    pub(crate) fn blow(
        &mut self,
        q: &[T],
        v: &[T],
        impulses: &[(usize, Vector3<f64>)],
    ) -> Result<T, DynamicsError> {
        velocities(&self.tree, &mut self.workspace, q, v)?;
        self.blows.clear();
        let mut work = T::zero();
        for (push, impulse) in impulses {
            let mut push = self.pushes[*push].clone();
            push.set(impulse);
            self.blows.push(push.wrench(&self.workspace));
            work += push.power(&self.workspace);
        }
        Ok(work)
    }

    /// From now on these loads, which it carries already, take back in [impacts](Self::impact) from this configuration the momenta that
    /// they would have with `v`.
    pub(crate) fn take_up(&mut self, q: &[T], v: &[T], loads: &[&Load]) -> Result<(), DynamicsError> {
        velocities(&self.tree, &mut self.workspace, q, v)?;
        self.blows.clear();
        let number = T::from_f64;
        for load in loads {
            let (pose, twist) = (self.workspace.pose(load.link), self.workspace.velocity(load.link));
            let arm = pose.rotation * load.at.map(number);
            let velocity = twist.linear + twist.angular.cross(&arm);
            let inertia = pose.rotation * load.inertia.map(number) * pose.rotation.transpose();
            let center = pose.transform(&load.at.map(number));
            self.blows.push((
                load.link,
                Wrench::at(&center, velocity * number(-load.mass), -(inertia * twist.angular)),
            ));
        }
        Ok(())
    }

    /// There is no blow any more.
    pub(crate) fn no_blow(&mut self) {
        self.blows.clear();
    }
}
