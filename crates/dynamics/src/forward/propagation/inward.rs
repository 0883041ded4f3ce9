//! The inward pass: the articulated-body inertia and bias force of what hangs from every joint.

use super::yielding::ThreeTurns;
use super::{Hinge, Yielding, one_by_one, turns_freely};
use crate::forward::articulated::Articulated;
use crate::inverse::last_three;
use crate::scalar::Scalar;
use crate::spatial::Pose;
use crate::spatial::direction::{Direction, Moved};
use crate::spatial::load::Load;
use crate::tree::dof::{along, along_three};
use crate::tree::{Body, Tree};
use crate::workspace::Workspace;
use nalgebra::Vector3;

/// What is known of a degree of freedom: its force or its acceleration.
#[derive(Clone, Copy)]
enum Known<T> {
    Force(T),
    Acceleration(T),
}

/// A body as it is felt through the joints passed so far, and the load that it has without acceleration.
struct Carried<T> {
    inertia: Articulated<T>,
    load: Load<T>,
}

/// Gathers the links inwards. Where `prescribed`, `a` holds the acceleration, elsewhere `tau` the force.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn gather<T: Scalar>(
    tree: &Tree<T>,
    ws: &mut Workspace<T>,
    prescribed: impl Fn(usize) -> bool + Copy,
    a: &[T],
    tau: &[T],
) {
    for articulated in &mut ws.articulated {
        *articulated = Articulated::zero();
    }
    for (i, body) in tree.bodies.iter().enumerate().rev() {
        let mut carried = Carried { inertia: ws.articulated[i], load: ws.loads[i] };
        if let Some(own) = &body.mass_distribution {
            carried.inertia.add_mass(own.mass, &own.first, &own.inertia_at_origin);
        }
        let known = |k: usize| {
            if prescribed(k) { Known::Acceleration(a[k]) } else { Known::Force(tau[k]) }
        };
        let yields = turns_freely(body, prescribed);
        if !yields {
            ws.yieldings[i] = Yielding::idle();
        }
        if let Some(triple) = body.triple.filter(|_| yields) {
            let (turns, k) = (ws.last_three(body), body.single_end);
            let Carried { inertia, load } = &mut carried;
            along_three!(triple, |x, y, z| {
                let moment = ThreeTurns::new(triple, (x, y, z), &turns).moment(&tau[k..][..3]);
                ws.yieldings[i] = Yielding::give_way(inertia, load, moment);
                inertia.linear = z.leave_symmetric(&inertia.linear, turns[2]);
                inertia.linear = y.leave_symmetric(&inertia.linear, turns[1]);
                inertia.linear = x.leave_symmetric(&inertia.linear, turns[0]);
                load.leave_three((x, y, z), &turns);
            });
        }
        for k in one_by_one(body, yields).rev() {
            let dof = &tree.dofs[k];
            let (moved, known) = (dof.moved(ws.moved[dof.q]), known(k).along(dof.sign));
            ws.hinges[k] = along!(dof, ws.rotations, |e| turn {
                carried.turn(e, moved, &ws.velocity_products[k], dof.armature, known)
            }, slide {
                carried.slide(e, moved, &ws.velocity_products[k], dof.armature, known)
            });
        }
        if let Some(slot) = body.sphere {
            if yields {
                let Carried { inertia, load } = &mut carried;
                ws.yieldings[i] = Yielding::give_way(inertia, load, last_three(&tau[..body.end]));
            }
            for k in (body.first..body.end - if yields { 3 } else { 0 }).rev() {
                let dof = &tree.dofs[k];
                ws.hinges[k] = along!(dof, ws.rotations, |e| turn {
                    carried.let_turn(e, dof.armature, known(k))
                }, slide {
                    carried.let_slide(e, dof.armature, known(k))
                });
            }
            carried.land(&ws.spheres[slot], body, &ws.velocity_products);
        }
        // Nothing asks what the world feels.
        let Some(parent) = body.parent else { continue };
        if let Some(turned) = &body.turned {
            carried.inertia.leave_frame(turned);
            carried.load.leave_frame(turned);
        }
        carried.add(carried.inertia.of_linear(&ws.offset_velocity_products[i]));
        carried.inertia.shift(&body.offset);
        ws.articulated[parent].add(&carried.inertia);
        carried.load.shift(&body.offset);
        ws.loads[parent].add(&carried.load);
    }
}

/// Gathers new loads inwards through the joints as the last [`gather`] left them; `tau` holds the forces of the degrees of
/// freedom that give way, the others stay where they are.
pub(crate) fn gather_loads<T: Scalar>(
    tree: &Tree<T>,
    ws: &mut Workspace<T>,
    prescribed: impl Fn(usize) -> bool + Copy,
    tau: &[T],
) {
    for (i, body) in tree.bodies.iter().enumerate().rev() {
        let mut load = ws.loads[i];
        let yields = turns_freely(body, prescribed);
        if let Some(triple) = body.triple.filter(|_| yields) {
            let (turns, k) = (ws.last_three(body), body.single_end);
            along_three!(triple, |x, y, z| {
                let moment = ThreeTurns::new(triple, (x, y, z), &turns).moment(&tau[k..][..3]);
                ws.yieldings[i].pass(&mut load, moment);
                load.leave_three((x, y, z), &turns);
            });
        } else if yields {
            ws.yieldings[i].pass(&mut load, last_three(&tau[..body.end]));
        }
        for k in (body.first..body.end - if yields { 3 } else { 0 }).rev() {
            let (dof, hinge) = (&tree.dofs[k], &mut ws.hinges[k]);
            let moved = dof.moved(ws.moved[dof.q]);
            let mut give_way = |load: &mut Load<T>, bias: T| {
                hinge.force_left = if prescribed(k) { bias } else { tau[k] * dof.sign - bias };
                let acceleration = hinge.force_left * hinge.inverse;
                load.add(&Load { force: hinge.force * acceleration, moment: hinge.moment * acceleration });
            };
            along!(dof, ws.rotations, |e| turn {
                let bias = e.dot(&load.moment);
                give_way(&mut load, bias);
                load = Load { force: e.leave(load.force, moved), moment: e.leave(load.moment, moved) };
            }, slide {
                let bias = e.dot(&load.force);
                give_way(&mut load, bias);
                load.shift(&e.add(Vector3::zeros(), moved.s));
            });
        }
        let Some(parent) = body.parent else { continue };
        if let Some(slot) = body.sphere {
            load.leave_frame(&ws.spheres[slot].rotation);
            load.shift(&ws.spheres[slot].translation);
        }
        if let Some(turned) = &body.turned {
            load.leave_frame(turned);
        }
        load.shift(&body.offset);
        ws.loads[parent].add(&load);
    }
}

impl<T: Scalar> Known<T> {
    /// The same along the positive axis.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn along(self, sign: T) -> Self {
        match self {
            Self::Force(force) => Self::Force(force * sign),
            Self::Acceleration(acceleration) => Self::Acceleration(acceleration * sign),
        }
    }
}

impl<T: Scalar> Carried<T> {
    /// Before a turn about `e`.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn turn<E: Direction<T>>(
        &mut self,
        e: E,
        turn: Moved<T>,
        velocity_product: &Vector3<T>,
        armature: T,
        known: Known<T>,
    ) -> Hinge<T> {
        let hinge = self.let_turn(e, armature, known);
        self.add(self.inertia.of_angular(velocity_product));
        self.inertia.leave_turn(e, turn);
        self.load = Load { force: e.leave(self.load.force, turn), moment: e.leave(self.load.moment, turn) };
        hinge
    }

    /// Before a slide along `e`.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn slide<E: Direction<T>>(
        &mut self,
        e: E,
        slide: Moved<T>,
        velocity_product: &Vector3<T>,
        armature: T,
        known: Known<T>,
    ) -> Hinge<T> {
        let hinge = self.let_slide(e, armature, known);
        self.add(self.inertia.of_linear(velocity_product));
        let d = e.add(Vector3::zeros(), slide.s);
        self.inertia.shift(&d);
        self.load.shift(&d);
        hinge
    }

    /// Before a ball or free joint, whose degrees of freedom have been passed.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn land(&mut self, sphere: &Pose<T>, body: &Body<T>, velocity_products: &[Vector3<T>]) {
        // Where nothing is left against turning, this is nothing.
        self.add(self.inertia.of_angular(&velocity_products[body.end - 1]));
        let floats = body.end - body.first == 6;
        if floats {
            self.add(self.inertia.of_linear(&velocity_products[body.first]));
        }
        self.inertia.leave_frame(&sphere.rotation);
        self.load.leave_frame(&sphere.rotation);
        if floats {
            self.inertia.shift(&sphere.translation);
            self.load.shift(&sphere.translation);
        }
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn let_turn<E: Direction<T>>(&mut self, e: E, armature: T, known: Known<T>) -> Hinge<T> {
        let (moment, force) = self.inertia.of_turn(e);
        let (diagonal, bias) = (e.dot(&moment) + armature, e.dot(&self.load.moment));
        let rounding = e.rounding(&self.inertia.angular);
        self.give_way(moment, force, [diagonal, rounding], bias, known)
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn let_slide<E: Direction<T>>(&mut self, e: E, armature: T, known: Known<T>) -> Hinge<T> {
        let (moment, force) = self.inertia.of_slide(e);
        let (diagonal, bias) = (e.dot(&force) + armature, e.dot(&self.load.force));
        let rounding = e.rounding(&self.inertia.linear);
        self.give_way(moment, force, [diagonal, rounding], bias, known)
    }

    /// ```text
    /// free:         u = τ − b      I ← I − U·Uᵀ/D      p ← p + U·u/D
    /// prescribed:                                       p ← p + U·q̈
    /// ```
    ///
    /// A `D` that is not above its own rounding opposes nothing; the result then is NaN.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn give_way(
        &mut self,
        moment: Vector3<T>,
        force: Vector3<T>,
        [diagonal, rounding]: [T; 2],
        bias: T,
        known: Known<T>,
    ) -> Hinge<T> {
        let (inverse, force_left, acceleration) = match known {
            Known::Force(tau) => {
                let inverse = diagonal.recip_or_nan(rounding);
                self.inertia.give_way(&moment, &force, inverse);
                (inverse, tau - bias, (tau - bias) * inverse)
            }
            Known::Acceleration(acceleration) => (T::zero(), bias, acceleration),
        };
        self.add((moment * acceleration, force * acceleration));
        Hinge { moment, force, inverse, force_left }
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn add(&mut self, (moment, force): (Vector3<T>, Vector3<T>)) {
        self.load.moment += moment;
        self.load.force += force;
    }
}
