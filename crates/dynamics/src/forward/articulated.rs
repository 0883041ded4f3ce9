//! Articulated-body inertia: what a link with all that hangs from it opposes to being accelerated, its free joints
//! giving way.

use crate::scalar::Scalar;
use crate::spatial::direction::{Direction, Moved, apply, apply_transposed, conjugated, cross, rows};
use crate::spatial::symmetric::Symmetric;
use nalgebra::{Matrix3, Vector3};

/// Moment and force about the origin of a frame for an angular acceleration `α` and an acceleration `a` of that origin,
/// everything in that frame:
///
/// ```text
/// n = A·α + B·a          f = Bᵀ·α + C·a
/// ```
#[derive(Clone, Copy, Debug)]
pub(crate) struct Articulated<T> {
    /// `A`
    pub(crate) angular: Symmetric<T>,
    /// `B`
    pub(crate) coupling: Matrix3<T>,
    /// `C`
    pub(crate) linear: Symmetric<T>,
}

impl<T: Scalar> Articulated<T> {
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn zero() -> Self {
        Self { angular: Symmetric::zero(), coupling: Matrix3::zeros(), linear: Symmetric::zero() }
    }

    /// Adds a link's own mass `m`: to `A` its inertia about its origin, to `B` `[h]×`, where `h = m·c`, to `C` `m·1`.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn add_mass(&mut self, mass: T, h: &Vector3<T>, inertia_at_origin: &Symmetric<T>) {
        let (b, c) = (&mut self.coupling, &mut self.linear);
        self.angular.add(inertia_at_origin);
        b.m12 -= h.z;
        b.m13 += h.y;
        b.m21 += h.z;
        b.m23 -= h.x;
        b.m31 -= h.y;
        b.m32 += h.x;
        c.xx += mass;
        c.yy += mass;
        c.zz += mass;
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn add(&mut self, other: &Self) {
        self.angular.add(&other.angular);
        self.coupling += other.coupling;
        self.linear.add(&other.linear);
    }

    /// Nothing is left against turning.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn clear_turning(&mut self) {
        (self.angular, self.coupling) = (Symmetric::zero(), Matrix3::zeros());
    }

    /// Moment and force for an angular acceleration about `e` by 1.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn of_turn<E: Direction<T>>(&self, e: E) -> (Vector3<T>, Vector3<T>) {
        (e.of_symmetric(&self.angular), e.of_transposed(&self.coupling))
    }

    /// Moment and force for an acceleration along `e` by 1.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn of_slide<E: Direction<T>>(&self, e: E) -> (Vector3<T>, Vector3<T>) {
        (e.of(&self.coupling), e.of_symmetric(&self.linear))
    }

    /// Moment and force for an angular acceleration.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn of_angular(&self, angular: &Vector3<T>) -> (Vector3<T>, Vector3<T>) {
        (self.angular.times(angular), apply_transposed(&self.coupling, angular))
    }

    /// Moment and force for an acceleration of the origin.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn of_linear(&self, linear: &Vector3<T>) -> (Vector3<T>, Vector3<T>) {
        (apply(&self.coupling, linear), self.linear.times(linear))
    }

    /// Lets a degree of freedom give way: `I ← I − U·Uᵀ/D`, where `U` are the moment and the force that go with its
    /// acceleration.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn give_way(&mut self, moment: &Vector3<T>, force: &Vector3<T>, inverse: T) {
        let (scaled_moment, scaled_force) = (moment * inverse, force * inverse);
        self.angular.subtract_outer(&scaled_moment, moment);
        self.linear.subtract_outer(&scaled_force, force);
        for column in 0..3 {
            for row in 0..3 {
                let entry = &mut self.coupling[(row, column)];
                *entry = scaled_moment[row].times_from(force[column], *entry);
            }
        }
    }

    /// From the frame after a turn about `e` to the one before it: `R·X·Rᵀ` for every block.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn leave_turn<E: Direction<T>>(&mut self, e: E, turn: Moved<T>) {
        self.angular = e.leave_symmetric(&self.angular, turn);
        self.coupling = e.leave_matrix(&self.coupling, turn);
        self.linear = e.leave_symmetric(&self.linear, turn);
    }

    /// From a turned frame to the one that it was turned from: `R·X·Rᵀ` for every block.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn leave_frame(&mut self, rotation: &Matrix3<T>) {
        self.angular = self.angular.rotated(rotation);
        self.coupling = conjugated(&self.coupling, rotation);
        self.linear = self.linear.rotated(rotation);
    }

    /// From an origin at `d` to the one that `d` is measured from:
    ///
    /// ```text
    /// B' = B + [d]×·C          A' = A − B·[d]× + [d]×·B'ᵀ
    /// ```
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn shift(&mut self, d: &Vector3<T>) {
        let (b, c) = (self.coupling, &self.linear);
        let columns =
            [Vector3::new(c.xx, c.xy, c.xz), Vector3::new(c.xy, c.yy, c.yz), Vector3::new(c.xz, c.yz, c.zz)];
        for (column, of_c) in columns.iter().enumerate() {
            let turned = cross(d, of_c);
            for row in 0..3 {
                self.coupling[(row, column)] += turned[row];
            }
        }
        // Rows of −B·[d]× are d × (rows of B), written out; columns of [d]×·B'ᵀ are d × (rows of B').
        let (b, c) = (rows(&b), rows(&self.coupling));
        let before = [cross(d, &b[0]), cross(d, &b[1]), cross(d, &b[2])];
        let after = [cross(d, &c[0]), cross(d, &c[1]), cross(d, &c[2])];
        let a = &mut self.angular;
        a.xx += before[0].x + after[0].x;
        a.yy += before[1].y + after[1].y;
        a.zz += before[2].z + after[2].z;
        a.xy += before[0].y + after[1].x;
        a.xz += before[0].z + after[2].x;
        a.yz += before[1].z + after[2].y;
    }
}
