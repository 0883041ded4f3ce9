//! The three passes of forward and hybrid dynamics, everything in the links' own frames.
//!
//! Velocities run outwards and leave the accelerations that they bring by themselves ([`velocity::velocity_terms`]). Then the links
//! are gathered inwards ([`gather`]): each joint passes on what hangs from it as one body, whose free degrees of freedom
//! give way and whose prescribed ones do not. Accelerations run outwards at last ([`accelerate`]).

pub(crate) mod inward;
pub(crate) mod outward;
pub(crate) mod velocity;
mod yielding;

pub(crate) use inward::gather_loads;
pub(crate) use velocity::no_velocity_terms;
pub(crate) use yielding::Yielding;

use crate::scalar::Scalar;
use crate::spatial::direction::Direction;
use crate::tree::dof::{Dof, along};
use crate::tree::{Body, Tree};
use crate::wide::wide;
use crate::workspace::Workspace;
use nalgebra::Vector3;
use std::ops::Range;

/// [`inward::gather`], compiled once for all operations that share it.
pub(crate) fn gather<T: Scalar>(
    tree: &Tree<T>,
    ws: &mut Workspace<T>,
    prescribed: impl Fn(usize) -> bool + Copy,
    a: &[T],
    tau: &[T],
) {
    wide::<T, _>(
        #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
        || inward::gather(tree, ws, prescribed, a, tau),
    );
}

/// [`outward::accelerate`], compiled once for all operations that share it.
pub(crate) fn accelerate<T: Scalar>(
    tree: &Tree<T>,
    ws: &mut Workspace<T>,
    base: &Vector3<T>,
    prescribed: impl Fn(usize) -> bool + Copy,
    a: &mut [T],
    tau: &mut [T],
) {
    wide::<T, _>(
        #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
        || outward::accelerate(tree, ws, base, prescribed, a, tau),
    );
}

/// What one degree of freedom has to do with the acceleration of its link: kept from the way in for the way out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hinge<T> {
    /// `U`: moment and force that go with an acceleration by 1.
    moment: Vector3<T>,
    force: Vector3<T>,
    /// `1/D`, where `D` is the force that an acceleration by 1 takes; zero where the acceleration is prescribed.
    pub(crate) inverse: T,
    /// The force that is left for the acceleration once the bias is served; of a prescribed acceleration, the bias.
    force_left: T,
}

impl<T: Scalar> Hinge<T> {
    pub(crate) fn idle() -> Self {
        let (moment, force) = (Vector3::zeros(), Vector3::zeros());
        Self { moment, force, inverse: T::zero(), force_left: T::zero() }
    }

    /// `s·U`: what links oppose to an acceleration along the degree of freedom.
    pub(crate) fn diagonal(&self, dof: &Dof<T>, ws: &Workspace<T>) -> T {
        along!(dof, ws.rotations, |e| turn {
            e.dot(&self.moment)
        }, slide {
            e.dot(&self.force)
        })
    }
}

/// Whether the joint of a body gives way to every turn of its link.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn turns_freely<T: Scalar>(body: &Body<T>, prescribed: impl Fn(usize) -> bool) -> bool {
    body.turns_freely && !(body.end - 3..body.end).any(prescribed)
}

/// The degrees of freedom that a pass takes one by one: neither those of a ball or free joint nor three turns that give way at once.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn one_by_one<T: Scalar>(body: &Body<T>, yields: bool) -> Range<usize> {
    let end = if yields || body.sphere.is_some() { body.single_end } else { body.end };
    body.first..end
}
