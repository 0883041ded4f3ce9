//! The maps of forces between the declared figure and its view.

use super::RootView;
use super::path::{Moving, rotation, unit};
use crate::error::DynamicsError;
use crate::scalar::Scalar;
use crate::spatial::Wrench;
use crate::spatial::direction::{apply, cross, dot};
use crate::workspace::{check, check_length, check_result};
use nalgebra::Vector3;

impl<T: Scalar> RootView<T> {
    /// Takes forces of the declared figure into the view at `q_view`, where the new root carries the wrench `base` that the
    /// declared one carried: [`crate::Workspace::base_wrench`] after its inverse dynamics. The way back is
    /// [`forces_from_view`](Self::forces_from_view).
    ///
    /// # Errors
    ///
    /// As for [`to_view`](Self::to_view).
    pub fn forces_to_view(
        &self,
        tau: &[T],
        base: &Wrench<T>,
        q_view: &[T],
        tau_view: &mut [T],
    ) -> Result<(), DynamicsError> {
        let (declared, view) = (&self.declared, self.view());
        check("tau", tau, declared.nv(), |k| declared.v_names()[k].clone())?;
        check("q_view", q_view, view.nq(), |k| view.q_names()[k].clone())?;
        check_length("tau_view", tau_view.len(), view.nv())?;
        tau_view[..6].fill(T::zero());
        self.joints.iter().for_each(|map| map.forces(map.forth(), q_view, tau, tau_view));
        let carried = Carried { wrench: *base, point: Vector3::zeros() };
        self.to_declared.follow(q_view, &[], &[], |frame, dof, axis| {
            tau_view[dof] += carried.along(frame, axis);
        });
        check_result("a force of the view", tau_view)
    }

    /// Takes the forces of the joints from the view to the declared figure at `q` (the view's configuration), where the new
    /// root goes on carrying what is left over: as a force from outside, so that the declared root's joint has none.
    ///
    /// # Errors
    ///
    /// As for [`to_view`](Self::to_view).
    pub fn joint_forces_from_view(
        &self,
        tau_view: &[T],
        q: &[T],
        tau: &mut [T],
    ) -> Result<(), DynamicsError> {
        let (declared, view) = (&self.declared, self.view());
        check("tau_view", tau_view, view.nv(), |k| view.v_names()[k].clone())?;
        check("q", q, declared.nq(), |k| declared.q_names()[k].clone())?;
        check_length("tau", tau.len(), declared.nv())?;
        tau[..self.root_armature.len()].fill(T::zero());
        self.joints.iter().for_each(|map| map.forces(map.back(), q, tau_view, tau));
        Ok(())
    }

    /// Takes forces `tau_view` of the view at `q_view` to the declared figure at `q` (the same configuration), which
    /// accelerates at `a`: the forces that its own inverse dynamics gives for the same motion.
    ///
    /// What the new root's joint carries, a force `f` and a moment `n` about the point `x_V`, is now carried by the declared
    /// root's, and by every joint on the path between the two: a degree of freedom there along `e`, whose axis goes through
    /// `x`, has in addition
    ///
    /// ```text
    /// slide: e·f      turn: e·(n + (x_V − x) × f)
    /// ```
    ///
    /// and the declared root's the force `armature·a` of its armature, which is not in the view; `a` is looked at for
    /// nothing else.
    ///
    /// # Errors
    ///
    /// As for [`to_view`](Self::to_view).
    pub fn forces_from_view(
        &self,
        q_view: &[T],
        tau_view: &[T],
        q: &[T],
        a: &[T],
        tau: &mut [T],
    ) -> Result<(), DynamicsError> {
        let (declared, view) = (&self.declared, self.view());
        check("q_view", q_view, view.nq(), |k| view.q_names()[k].clone())?;
        check("a", a, declared.nv(), |k| declared.v_names()[k].clone())?;
        self.joint_forces_from_view(tau_view, q, tau)?;
        let carried = Carried::by_root(q_view, tau_view);
        self.to_root.follow(q, &[], &[], |frame, dof, axis| tau[dof] += carried.along(frame, axis));
        for (dof, armature) in self.root_armature.iter().enumerate() {
            tau[dof] += *armature * a[dof];
        }
        check_result("a force of the declared figure", tau)
    }
}

/// What a root carries: a force, and a moment about a point of the world.
struct Carried<T> {
    wrench: Wrench<T>,
    point: Vector3<T>,
}

impl<T: Scalar> Carried<T> {
    /// What the view's root carries with these forces, about its own origin.
    fn by_root(q_view: &[T], tau_view: &[T]) -> Self {
        let three = |of: &[T], from: usize| Vector3::new(of[from], of[from + 1], of[from + 2]);
        let turn = rotation(&unit(q_view, 3));
        let (force, moment) = (apply(&turn, &three(tau_view, 0)), apply(&turn, &three(tau_view, 3)));
        Self { wrench: Wrench { force, moment }, point: three(q_view, 0) }
    }

    /// The part along a degree of freedom whose axis goes through the origin of `frame`.
    fn along(&self, frame: &Moving<T>, (turns, axis): (bool, Vector3<T>)) -> T {
        let Wrench { force, moment } = &self.wrench;
        if turns {
            dot(&axis, &(moment + cross(&(self.point - frame.translation), force)))
        } else {
            dot(&axis, force)
        }
    }
}
