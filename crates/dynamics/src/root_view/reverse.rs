//! Coordinates, rates and forces of a reversed joint, whose child has become its parent.
//!
//! What holds for one way holds for the way back: every map is its own inverse.

use super::path::{conjugate, rotation, unit};
use crate::scalar::Scalar;
use crate::spatial::direction::{apply, apply_transposed, cross};
use nalgebra::{Matrix3, Vector3};
use solaris_model::JointLayout;

/// One joint of the declared figure, in both state vectors.
#[derive(Clone, Copy, Debug)]
pub(super) struct JointMap {
    pub(super) declared: JointLayout,
    pub(super) view: JointLayout,
    pub(super) reversed: bool,
    /// Where in the joint's `q` its quaternion begins, if it has one.
    pub(super) quaternion: Option<usize>,
}

/// The two state vectors between which an entry is taken, as layouts of the joint in each.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    pub(super) from: JointLayout,
    pub(super) to: JointLayout,
}

impl JointMap {
    /// From the declared figure to the view.
    pub(super) fn forth(self) -> Way {
        Way { from: self.declared, to: self.view }
    }

    /// From the view to the declared figure.
    pub(super) fn back(self) -> Way {
        Way { from: self.view, to: self.declared }
    }

    /// Takes the joint's coordinates along `way`. A ball joint turned round has the conjugate quaternion; a free joint with
    /// the position `p` and the rotation `R` has `−Rᵀ·p` and `Rᵀ`.
    pub(super) fn positions<T: Scalar>(&self, way: Way, source: &[T], target: &mut [T]) {
        let (from, to) = (&source[way.from.q..][..way.from.nq], &mut target[way.to.q..][..way.to.nq]);
        let Some(at) = self.quaternion.filter(|_| self.reversed) else {
            return copy(from, to, self.reversed);
        };
        let quaternion = unit(from, at);
        to[at..].copy_from_slice(&conjugate(quaternion));
        if at == 3 {
            let back = -apply_transposed(&rotation(&quaternion), &three(from, 0));
            to[..3].copy_from_slice(back.as_slice());
        }
    }

    /// Takes the joint's velocities or accelerations along `way`, at the coordinates `q` of the source. Turned round, with `R`
    /// and `p` of the source, `u` linear and `w` angular,
    ///
    /// ```text
    /// w' = −R·w      u' = −R·u + R·w × p
    /// ```
    ///
    /// and accelerations alike, because the rate of change of `R` adds a product of equal vectors.
    pub(super) fn rates<T: Scalar>(&self, way: Way, q: &[T], source: &[T], target: &mut [T]) {
        let (from, to) = (&source[way.from.v..][..way.from.nv], &mut target[way.to.v..][..way.to.nv]);
        let Some(at) = self.quaternion.filter(|_| self.reversed) else {
            return copy(from, to, self.reversed);
        };
        let q = &q[way.from.q..][..way.from.nq];
        let turn: Matrix3<T> = rotation(&unit(q, at));
        let angular = apply(&turn, &three(from, at));
        to[at..].copy_from_slice((-angular).as_slice());
        if at == 3 {
            let linear = cross(&angular, &three(q, 0)) - apply(&turn, &three(from, 0));
            to[..3].copy_from_slice(linear.as_slice());
        }
    }

    /// Takes the joint's forces along `way`, at the coordinates `q` of the **target**. Turned round, with `R` and `p` of the
    /// target, so that the power is the same,
    ///
    /// ```text
    /// f' = −Rᵀ·f      n' = −Rᵀ·(n + f × p)
    /// ```
    pub(super) fn forces<T: Scalar>(&self, way: Way, q: &[T], source: &[T], target: &mut [T]) {
        let (from, to) = (&source[way.from.v..][..way.from.nv], &mut target[way.to.v..][..way.to.nv]);
        let Some(at) = self.quaternion.filter(|_| self.reversed) else {
            return copy(from, to, self.reversed);
        };
        let q = &q[way.to.q..][..way.to.nq];
        let turn: Matrix3<T> = rotation(&unit(q, at));
        let mut moment = three(from, at);
        if at == 3 {
            let force = three(from, 0);
            moment += cross(&force, &three(q, 0));
            to[..3].copy_from_slice((-apply_transposed(&turn, &force)).as_slice());
        }
        to[at..].copy_from_slice((-apply_transposed(&turn, &moment)).as_slice());
    }
}

/// Axes turned round come in the opposite order.
fn copy<T: Copy>(from: &[T], to: &mut [T], reversed: bool) {
    to.copy_from_slice(from);
    if reversed {
        to.reverse();
    }
}

fn three<T: Scalar>(values: &[T], from: usize) -> Vector3<T> {
    Vector3::new(values[from], values[from + 1], values[from + 2])
}
