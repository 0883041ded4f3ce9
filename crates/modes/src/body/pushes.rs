//! Forces of the world on points of links.

use nalgebra::Vector3;
use solaris_dynamics::{Workspace, Wrench};
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
