//! Forces with their moments, handed from frame to frame.

use crate::scalar::Scalar;
use crate::spatial::Pose;
use crate::spatial::direction::{Direction, Moved, apply, cross};
use nalgebra::{Matrix3, Vector3};

/// A force and its moment about the origin of the frame it is written in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Load<T> {
    pub(crate) force: Vector3<T>,
    pub(crate) moment: Vector3<T>,
}

impl<T: Scalar> Load<T> {
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn zero() -> Self {
        Self { force: Vector3::zeros(), moment: Vector3::zeros() }
    }

    /// The moment about `e`; afterwards the load stands in the frame before the turn.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn leave_turn<E: Direction<T>>(&mut self, e: E, turn: Moved<T>) -> T {
        let moment = e.dot(&self.moment);
        *self = Self { force: e.leave(self.force, turn), moment: e.leave(self.moment, turn) };
        moment
    }

    /// Force and moment along the link's axes go to `tau`; afterwards the load stands in the joint's frame of a ball or free
    /// joint.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn land(&mut self, sphere: &Pose<T>, tau: &mut [T]) {
        let (linear, angular) = tau.split_at_mut(tau.len() - 3);
        for (i, tau) in linear.iter_mut().enumerate() {
            *tau = self.force[i];
        }
        for (i, tau) in angular.iter_mut().enumerate() {
            *tau = self.moment[i];
        }
        self.leave_frame(&sphere.rotation);
        self.shift(&sphere.translation);
    }

    /// From the frame after three turns to the one before them.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn leave_three<X: Direction<T>, Y: Direction<T>, Z: Direction<T>>(
        &mut self,
        (x, y, z): (X, Y, Z),
        turns: &[Moved<T>; 3],
    ) {
        let force = y.leave(z.leave(self.force, turns[2]), turns[1]);
        let moment = y.leave(z.leave(self.moment, turns[2]), turns[1]);
        *self = Self { force: x.leave(force, turns[0]), moment: x.leave(moment, turns[0]) };
    }

    /// The force along `e`; afterwards the moment is about the origin before the slide.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn leave_slide<E: Direction<T>>(&mut self, e: E, slide: Moved<T>) -> T {
        // d × f = −(f × d)
        self.moment -= e.crossed(&self.force, slide.s);
        e.dot(&self.force)
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn add(&mut self, other: &Self) {
        self.force += other.force;
        self.moment += other.moment;
    }

    /// From a turned frame to the one that it was turned from.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn leave_frame(&mut self, rotation: &Matrix3<T>) {
        *self = Self { force: apply(rotation, &self.force), moment: apply(rotation, &self.moment) };
    }

    /// From an origin at `d` to the one that `d` is measured from.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn shift(&mut self, d: &Vector3<T>) {
        self.moment += cross(d, &self.force);
    }
}
