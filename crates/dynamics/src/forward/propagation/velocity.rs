//! The first outward pass: velocities, and the accelerations and loads that they bring about.

use crate::inverse::{centrifugal_load, field, first_three, last_three};
use crate::scalar::Scalar;
use crate::spatial::direction::{Direction, Moved, apply, apply_transposed, cross};
use crate::spatial::load::Load;
use crate::tree::Tree;
use crate::tree::dof::{along, along_three};
use crate::workspace::Workspace;
use nalgebra::Vector3;

/// Velocities, from the root outwards: every link's angular velocity, the accelerations that velocities bring without
/// any acceleration of a degree of freedom, and the loads that keep the links' mass on its way.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn velocity_terms<T: Scalar>(tree: &Tree<T>, ws: &mut Workspace<T>, v: &[T]) {
    for (i, body) in tree.bodies.iter().enumerate() {
        let (mut angular, mut velocity_product) = (Vector3::zeros(), Vector3::zeros());
        if let Some(parent) = body.parent {
            angular = ws.motions[parent].angular;
            velocity_product = apply(&ws.motions[parent].field, &body.offset);
        }
        ws.offset_velocity_products[i] = velocity_product;
        if let Some(turned) = &body.turned {
            angular = apply_transposed(turned, &angular);
        }
        if let Some(slot) = body.sphere {
            let (sphere, v) = (&ws.spheres[slot], &v[body.first..body.end]);
            let (before, w) = (apply_transposed(&sphere.rotation, &angular), last_three(v));
            if v.len() == 6 {
                let carried = cross(&angular, &cross(&angular, &sphere.translation));
                let turned = cross(&(before + before + w), &first_three(v));
                ws.velocity_products[body.first] = apply_transposed(&sphere.rotation, &carried) + turned;
            }
            ws.velocity_products[body.end - 1] = cross(&before, &w);
            angular = before + w;
        }
        for k in body.first..body.single_end {
            let dof = &tree.dofs[k];
            let (moved, rate) = (dof.moved(ws.moved[dof.q]), v[k] * dof.sign);
            along!(dof, ws.rotations, |e| turn {
                ws.velocity_products[k] = turning(e, &mut angular, moved, rate);
            }, slide {
                let carried = e.add(e.crossed(&angular, moved.s), rate + rate);
                ws.velocity_products[k] = cross(&angular, &carried);
            });
        }
        if let Some(triple) = body.triple {
            let (turns, from) = (ws.last_three(body), body.single_end);
            let (rates, velocity_products) = (&v[from..][..3], &mut ws.velocity_products[from..][..3]);
            along_three!(triple, |x, y, z| {
                velocity_products[0] = turning(x, &mut angular, turns[0], rates[0]);
                velocity_products[1] = turning(y, &mut angular, turns[1], rates[1]);
                velocity_products[2] = turning(z, &mut angular, turns[2], rates[2]);
            });
        }
        let field = field(&angular, &Vector3::zeros());
        ws.loads[i] = match &body.mass_distribution {
            Some(distribution) => centrifugal_load(distribution, &field),
            None => Load::zero(),
        };
        (ws.motions[i].angular, ws.motions[i].field) = (angular, field);
    }
}

/// `ω ← Rᵀω + e·q̇`; what it returns is `Rᵀω × e·q̇`.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn turning<T: Scalar, E: Direction<T>>(
    e: E,
    angular: &mut Vector3<T>,
    turn: Moved<T>,
    rate: T,
) -> Vector3<T> {
    let before = e.enter(*angular, turn);
    *angular = e.add(before, rate);
    e.crossed(&before, rate)
}

/// A figure at rest that carries nothing.
pub(crate) fn no_velocity_terms<T: Scalar>(ws: &mut Workspace<T>) {
    ws.velocity_products.fill(Vector3::zeros());
    ws.offset_velocity_products.fill(Vector3::zeros());
    ws.loads.fill(Load::zero());
}
