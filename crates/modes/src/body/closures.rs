//! Closed loops as conditions on the accelerations of links.

use nalgebra::{Matrix3, Vector3};
use solaris_dynamics::{ContactConstraint, Scalar, Workspace};
use solaris_profiles::Elementary;

/// Two points, and perhaps the axes of their links, that are held together.
#[derive(Clone, Debug)]
pub(crate) struct Closure<T> {
    /// A link, and the point of it (m, its frame).
    held: (usize, Vector3<T>),
    /// What it is held to: a point of another link, or of the world.
    to: (Option<usize>, Vector3<T>),
    /// Whether axes are held together as well, and how those of what it is held to stand in the link's own, once that is known.
    is_weld: bool,
    turn: Option<Matrix3<T>>,
}

impl<T: Elementary> Closure<T> {
    /// Points are those of the links' frames (m), or of the world; none where both are the world's.
    pub(crate) fn new(ends: [(Option<usize>, Vector3<f64>); 2], is_weld: bool) -> Option<Self> {
        let [first, second] = ends.map(|(link, point)| (link, point.map(T::from_f64)));
        let (held, to) = if first.0.is_some() { (first, second) } else { (second, first) };
        Some(Self { held: (held.0?, held.1), to, is_weld, turn: None })
    }

    /// The condition, with nothing asked for yet.
    pub(super) fn condition(&self) -> ContactConstraint<T> {
        let (link, point) = self.held;
        let condition = if self.is_weld {
            ContactConstraint::fixed(link, point)
        } else {
            ContactConstraint::point(link, point)
        };
        match self.to {
            (Some(other), point) => condition.to(other, point),
            (None, _) => condition,
        }
    }

    /// Asks for the accelerations, or the jumps of velocities, that leave nothing of how the two are apart, at the poses and velocities in
    /// `workspace`:
    ///
    /// ```text
    /// a = −damping·(v₁ − v₂) − stiffness·(x₁ − x₂)
    /// ```
    ///
    /// and the same of angular velocities and the rotation vector between the axes, which is small.
    pub(super) fn ask(
        &mut self,
        workspace: &Workspace<T>,
        condition: &mut ContactConstraint<T>,
        damping: T,
        stiffness: T,
    ) {
        let (point, velocity) = moving(workspace, Some(self.held.0), &self.held.1);
        let (other, away) = moving(workspace, self.to.0, &self.to.1);
        condition.acceleration = (velocity - away) * -damping - (point - other) * stiffness;
        if !self.is_weld {
            return;
        }
        let axes =
            |link: Option<usize>| link.map_or_else(Matrix3::identity, |link| workspace.pose(link).rotation);
        let (own, theirs) = (axes(Some(self.held.0)), axes(self.to.0));
        // As it is, and not how it would change.
        let turn = *self.turn.get_or_insert_with(|| own.tr_mul(&theirs).map(|x| T::from_f64(x.value())));
        let angular =
            |link: Option<usize>| link.map_or_else(Vector3::zeros, |link| workspace.velocity(link).angular);
        let off = own * turn * theirs.transpose();
        let half = T::from_f64(0.5);
        let apart =
            Vector3::new(off[(2, 1)] - off[(1, 2)], off[(0, 2)] - off[(2, 0)], off[(1, 0)] - off[(0, 1)])
                * half;
        condition.angular =
            Some((angular(Some(self.held.0)) - angular(self.to.0)) * -damping - apart * stiffness);
    }
}

/// Where a point of a link, or of the world, is, and its velocity.
fn moving<T: Scalar>(
    workspace: &Workspace<T>,
    link: Option<usize>,
    point: &Vector3<T>,
) -> (Vector3<T>, Vector3<T>) {
    let Some(link) = link else { return (*point, Vector3::zeros()) };
    let (pose, twist) = (workspace.pose(link), workspace.velocity(link));
    let arm = pose.rotation * point;
    (pose.translation + arm, twist.linear + twist.angular.cross(&arm))
}
