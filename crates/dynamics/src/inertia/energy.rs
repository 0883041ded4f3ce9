//! Kinetic and potential energy.

use crate::error::DynamicsError;
use crate::kinematics::{forward_kinematics, velocities};
use crate::scalar::Real;
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
pub fn kinetic_energy<T: Real>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
) -> Result<T, DynamicsError> {
    velocities(tree, workspace, q, v)?;
    let mut twice = T::zero();
    for (i, body) in tree.bodies.iter().enumerate() {
        let Some(matter) = &body.matter else { continue };
        let (rotation, twist) = (&workspace.poses[i].rotation, &workspace.twists[i]);
        let velocity = twist.linear + cross(&twist.angular, &apply(rotation, &matter.com));
        let angular = apply_transposed(rotation, &twist.angular);
        twice += matter.mass * dot(&velocity, &velocity) + dot(&angular, &apply(&matter.inertia, &angular));
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
pub fn potential_energy<T: Real>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
) -> Result<T, DynamicsError> {
    forward_kinematics(tree, workspace, q)?;
    let mut energy = T::zero();
    for (body, pose) in tree.bodies.iter().zip(&workspace.poses) {
        let Some(matter) = &body.matter else { continue };
        let com = pose.translation + apply(&pose.rotation, &matter.com);
        energy -= matter.mass * dot(&tree.gravity, &com);
    }
    check_result("the potential energy", &[energy])?;
    Ok(energy)
}
