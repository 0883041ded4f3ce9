//! Kinetic and potential energy.

use crate::error::DynamicsError;
use crate::kinematics::{forward_kinematics, velocities};
use crate::scalar::Scalar;
use crate::spatial::direction::{apply, apply_transposed, cross, dot};
use crate::tree::Tree;
use crate::workspace::{Workspace, check_result};

/// Kinetic energy (J) of the state `q`, `v`:
///
/// ```text
/// T = ½ Σ m·|ċ|² + ω·I_c·ω + ½ Σ armature_k·v_k²
/// ```
///
/// a sum of terms none of which is negative. Also places the links and finds their velocities.
///
/// # Errors
///
/// As for [`velocities`].
#[doc(alias = "energy")]
pub fn kinetic_energy<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
) -> Result<T, DynamicsError> {
    velocities(tree, workspace, q, v)?;
    let mut twice = T::zero();
    for (i, body) in tree.bodies.iter().enumerate() {
        let Some(distribution) = &body.mass_distribution else { continue };
        let (rotation, twist) = (&workspace.poses[i].rotation, &workspace.twists[i]);
        let velocity = twist.linear + cross(&twist.angular, &apply(rotation, &distribution.com));
        let angular = apply_transposed(rotation, &twist.angular);
        twice += distribution.mass * dot(&velocity, &velocity)
            + dot(&angular, &apply(&distribution.inertia, &angular));
    }
    for &(k, armature) in &tree.armature {
        twice += armature * v[k] * v[k];
    }
    let energy = twice * T::from_f64(0.5);
    check_result("the kinetic energy", &[energy])?;
    Ok(energy)
}

/// Potential energy (J) of gravity at `q`, zero with every centre of mass at the height of the world's origin:
///
/// ```text
/// V = −Σ m·g·c
/// ```
///
/// Also places the links.
///
/// # Errors
///
/// As for [`forward_kinematics`].
#[doc(alias = "energy")]
pub fn potential_energy<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
) -> Result<T, DynamicsError> {
    forward_kinematics(tree, workspace, q)?;
    let mut energy = T::zero();
    for (body, pose) in tree.bodies.iter().zip(&workspace.poses) {
        let Some(distribution) = &body.mass_distribution else { continue };
        let com = pose.translation + apply(&pose.rotation, &distribution.com);
        energy -= distribution.mass * dot(&tree.gravity, &com);
    }
    check_result("the potential energy", &[energy])?;
    Ok(energy)
}
