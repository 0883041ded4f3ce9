//! Joints that let their link turn in every way: what they pass on is the same whichever angles describe the turn.

use crate::forward::articulated::Articulated;
use crate::scalar::Scalar;
use crate::spatial::direction::{Direction, Moved, apply, apply_transposed, columns, dot, of_columns};
use crate::spatial::load::Load;
use crate::spatial::symmetric::Factor;
use nalgebra::{Matrix3, Vector3};
use solaris_model::EulerOrder;

/// How a link turns whose joint gives way to every turn, `n` being the moment that the joint hands on:
///
/// ```text
/// n = A·α + B·a + n₀          α = A⁻¹·(n − n₀) − G·a          G = A⁻¹·B
/// ```
///
/// Put into the force, this leaves no inertia against turning: `C ← C − Bᵀ·G`, `f ← f₀ + Gᵀ·(n − n₀)`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Yielding<T> {
    factor: Factor<T>,
    /// `G`
    coupling: Matrix3<T>,
    /// `A⁻¹·(n − n₀)`
    turning: Vector3<T>,
}

impl<T: Scalar> Yielding<T> {
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn idle() -> Self {
        Self { factor: Factor::zero(), coupling: Matrix3::zeros(), turning: Vector3::zeros() }
    }

    /// Lets the link of `inertia` turn under the joint's `moment`; `inertia` and `load` become those of what is left.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn give_way(inertia: &mut Articulated<T>, load: &mut Load<T>, moment: Vector3<T>) -> Self {
        let (factor, b) = (inertia.angular.factor(), inertia.coupling);
        let columns = columns(&b);
        let (x, y, z) = (factor.solve(&columns[0]), factor.solve(&columns[1]), factor.solve(&columns[2]));
        let c = &mut inertia.linear;
        c.xx -= dot(&columns[0], &x);
        c.yy -= dot(&columns[1], &y);
        c.zz -= dot(&columns[2], &z);
        c.xy -= dot(&columns[0], &y);
        c.xz -= dot(&columns[0], &z);
        c.yz -= dot(&columns[1], &z);
        inertia.clear_turning();
        let mut yielding = Self { factor, coupling: of_columns(&x, &y, &z), turning: Vector3::zeros() };
        yielding.pass(load, moment);
        yielding
    }

    /// A new load under a new moment.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn pass(&mut self, load: &mut Load<T>, moment: Vector3<T>) {
        let left = moment - load.moment;
        self.turning = self.factor.solve(&left);
        load.force += apply_transposed(&self.coupling, &left);
        load.moment = moment;
    }

    /// Angular acceleration of the link whose origin has the acceleration `linear`.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn angular(&self, linear: &Vector3<T>) -> Vector3<T> {
        self.turning - apply(&self.coupling, linear)
    }

    /// 1 over what each of the link's axes has of inertia once those before it have given way.
    pub(crate) fn pivots(&self) -> [T; 3] {
        self.factor.pivots
    }
}

/// Three turns about different coordinate axes `e_1`, `e_2`, `e_3`, seen after the second: there `e_1` has leant over
/// towards `e_3`,
///
/// ```text
/// e_1 → cos q_2·e_1 ± sin q_2·e_3
/// ```
#[derive(Clone, Copy)]
pub(crate) struct ThreeTurns<T, X, Y, Z> {
    axes: (X, Y, Z),
    last: Moved<T>,
    upright: T,
    lean: T,
}

impl<T: Scalar, X: Direction<T>, Y: Direction<T>, Z: Direction<T>> ThreeTurns<T, X, Y, Z> {
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn new(order: EulerOrder, axes: (X, Y, Z), turns: &[Moved<T>; 3]) -> Self {
        let lean = if order.is_cyclic() { turns[1].s } else { -turns[1].s };
        Self { axes, last: turns[2], upright: T::one() / turns[1].c, lean }
    }

    /// The moment on the link, along its own axes, whose parts along the three axes are `tau`.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn moment(&self, tau: &[T]) -> Vector3<T> {
        let (x, y, z) = self.axes;
        let along = x.add(Vector3::zeros(), self.lean.times_from(tau[2], tau[0]) * self.upright);
        z.enter(z.add(y.add(along, tau[1]), tau[2]), self.last)
    }

    /// The accelerations of the three turns that add up to the angular acceleration `relative`, along the link's axes.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn accelerations(&self, relative: Vector3<T>) -> [T; 3] {
        let (x, y, z) = self.axes;
        let before = z.leave(relative, self.last);
        let first = x.dot(&before) * self.upright;
        [first, y.dot(&before), self.lean.times_from(first, z.dot(&before))]
    }
}
