//! The last outward pass: accelerations of links and degrees of freedom.

use super::yielding::ThreeTurns;
use super::{Hinge, one_by_one, turns_freely};
use crate::scalar::Scalar;
use crate::spatial::Pose;
use crate::spatial::direction::{Direction, Moved, apply_transposed, cross};
use crate::tree::dof::{Dof, along, along_three};
use crate::tree::{Body, Tree};
use crate::workspace::{LinkMotion, Workspace};
use nalgebra::Vector3;

/// Accelerations, from the root outwards, over a world that itself has the acceleration `base`: writes `a` where it is not
/// `prescribed`, `tau` where it is.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn accelerate<T: Scalar>(
    tree: &Tree<T>,
    ws: &mut Workspace<T>,
    base: &Vector3<T>,
    prescribed: impl Fn(usize) -> bool + Copy,
    a: &mut [T],
    tau: &mut [T],
) {
    let mut answer = Answer { dofs: &tree.dofs, hinges: &ws.hinges, prescribed, a, tau };
    for (i, body) in tree.bodies.iter().enumerate() {
        let parent = body.parent.map(|parent| &ws.motions[parent]);
        let mut moving = Accelerating::at_joint(body, parent, base, &ws.offset_velocity_products[i]);
        let yields = turns_freely(body, answer.prescribed);
        if let Some(slot) = body.sphere {
            moving.fly(&ws.spheres[slot], body, &ws.velocity_products);
            for k in body.first..body.end - if yields { 3 } else { 0 } {
                along!(&tree.dofs[k], ws.rotations, |e| turn {
                    moving.let_turn(e, k, &mut answer);
                }, slide {
                    moving.let_slide(e, k, &mut answer);
                });
            }
            if yields {
                let angular = ws.yieldings[i].angular(&moving.linear);
                let relative = angular - moving.angular;
                answer.write_three(body.end - 3, [relative.x, relative.y, relative.z]);
                moving.angular = angular;
            }
        }
        for k in one_by_one(body, yields) {
            let dof = &tree.dofs[k];
            let moved = dof.moved(ws.moved[dof.q]);
            along!(dof, ws.rotations, |e| turn {
                moving.turn(e, moved, &ws.velocity_products[k]);
                moving.let_turn(e, k, &mut answer);
            }, slide {
                moving.linear += e.crossed(&moving.angular, moved.s) + ws.velocity_products[k];
                moving.let_slide(e, k, &mut answer);
            });
        }
        if let Some(triple) = body.triple.filter(|_| yields) {
            let (turns, k) = (ws.last_three(body), body.single_end);
            let velocity_products = &ws.velocity_products[k..][..3];
            along_three!(triple, |x, y, z| {
                moving.turn(x, turns[0], &velocity_products[0]);
                moving.turn(y, turns[1], &velocity_products[1]);
                moving.turn(z, turns[2], &velocity_products[2]);
                let angular = ws.yieldings[i].angular(&moving.linear);
                let relative = angular - moving.angular;
                let turning = ThreeTurns::new(triple, (x, y, z), &turns);
                answer.write_three(k, turning.accelerations(relative));
                moving.angular = angular;
            });
        }
        ws.motions[i].angular_acceleration = moving.angular;
        ws.motions[i].acceleration = moving.linear;
    }
}

/// Angular acceleration of a frame and acceleration of its origin.
struct Accelerating<T> {
    angular: Vector3<T>,
    linear: Vector3<T>,
}

/// Where the accelerations come from and where they go.
struct Answer<'a, T, P> {
    dofs: &'a [Dof<T>],
    hinges: &'a [Hinge<T>],
    prescribed: P,
    a: &'a mut [T],
    tau: &'a mut [T],
}

impl<T: Scalar> Accelerating<T> {
    /// Of the joint's frame before its first degree of freedom.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn at_joint(
        body: &Body<T>,
        parent: Option<&LinkMotion<T>>,
        base: &Vector3<T>,
        velocity_product: &Vector3<T>,
    ) -> Self {
        let moving = match parent {
            Some(parent) => {
                let angular = parent.angular_acceleration;
                Self {
                    angular,
                    linear: parent.acceleration + cross(&angular, &body.offset) + velocity_product,
                }
            }
            None => Self { angular: Vector3::zeros(), linear: *base },
        };
        match &body.turned {
            Some(turned) => Self {
                angular: apply_transposed(turned, &moving.angular),
                linear: apply_transposed(turned, &moving.linear),
            },
            None => moving,
        }
    }

    /// Past a turn about `e`, without its own acceleration.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn turn<E: Direction<T>>(&mut self, e: E, turn: Moved<T>, velocity_product: &Vector3<T>) {
        self.angular = e.enter(self.angular, turn) + velocity_product;
        self.linear = e.enter(self.linear, turn);
    }

    /// Past the place of a ball or free joint, without the accelerations of its degrees of freedom.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn fly(&mut self, sphere: &Pose<T>, body: &Body<T>, velocity_products: &[Vector3<T>]) {
        self.linear =
            apply_transposed(&sphere.rotation, &(self.linear + cross(&self.angular, &sphere.translation)));
        self.angular = apply_transposed(&sphere.rotation, &self.angular) + velocity_products[body.end - 1];
        if body.end - body.first == 6 {
            self.linear += velocity_products[body.first];
        }
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn let_turn<E: Direction<T>, P: Fn(usize) -> bool>(
        &mut self,
        e: E,
        k: usize,
        answer: &mut Answer<'_, T, P>,
    ) {
        let acceleration = answer.acceleration(k, self);
        self.angular = e.add(self.angular, acceleration);
        answer.force(k, self, acceleration);
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn let_slide<E: Direction<T>, P: Fn(usize) -> bool>(
        &mut self,
        e: E,
        k: usize,
        answer: &mut Answer<'_, T, P>,
    ) {
        let acceleration = answer.acceleration(k, self);
        self.linear = e.add(self.linear, acceleration);
        answer.force(k, self, acceleration);
    }
}

impl<T: Scalar, P: Fn(usize) -> bool> Answer<'_, T, P> {
    /// `q̈ = (u − U·a)/D` of a free degree of freedom, whose link would have the acceleration `a` without it.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn acceleration(&mut self, k: usize, without: &Accelerating<T>) -> T {
        let (hinge, sign) = (&self.hinges[k], self.dofs[k].sign);
        if (self.prescribed)(k) {
            return self.a[k] * sign;
        }
        let acceleration = (hinge.force_left - hinge.opposes(without)) * hinge.inverse;
        self.a[k] = acceleration * sign;
        acceleration
    }

    /// Accelerations of three turns at once.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn write_three(&mut self, first: usize, accelerations: [T; 3]) {
        let a = &mut self.a[first..][..3];
        a[0] = accelerations[0];
        a[1] = accelerations[1];
        a[2] = accelerations[2];
    }

    /// `τ = U·a + b` of a prescribed degree of freedom, whose link has the acceleration `a`.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn force(&mut self, k: usize, with: &Accelerating<T>, acceleration: T) {
        if (self.prescribed)(k) {
            let (hinge, dof) = (&self.hinges[k], &self.dofs[k]);
            let force = hinge.opposes(with) + hinge.force_left + dof.armature * acceleration;
            self.tau[k] = force * dof.sign;
        }
    }
}

impl<T: Scalar> Hinge<T> {
    /// The force along the degree of freedom that an acceleration of its link asks for.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn opposes(&self, moving: &Accelerating<T>) -> T {
        let (m, f, angular, linear) = (&self.moment, &self.force, &moving.angular, &moving.linear);
        (m.x * angular.x + m.y * angular.y + m.z * angular.z)
            + (f.x * linear.x + f.y * linear.y + f.z * linear.z)
    }
}
