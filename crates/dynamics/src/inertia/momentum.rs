//! Momentum and centre of mass.

use crate::error::DynamicsError;
use crate::kinematics::{forward_kinematics, velocities};
use crate::scalar::Scalar;
use crate::spatial::Momentum;
use crate::spatial::direction::{apply, apply_transposed, cross};
use crate::tree::Tree;
use crate::workspace::{Workspace, check_result};
use nalgebra::Vector3;

/// Linear momentum and angular momentum about the world's origin, in world axes, of the state `q`, `v`:
///
/// ```text
/// P = Σ m·ċ          L = Σ c × m·ċ + R·I_c·Rᵀ·ω
/// ```
///
/// Also places the links and finds their velocities.
///
/// # Errors
///
/// As for [`velocities`].
#[doc(alias = "angular momentum")]
#[doc(alias = "linear momentum")]
pub fn momentum<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
) -> Result<Momentum<T>, DynamicsError> {
    velocities(tree, workspace, q, v)?;
    let (mut linear, mut angular) = (Vector3::zeros(), Vector3::zeros());
    for (i, body) in tree.bodies.iter().enumerate() {
        let Some(distribution) = &body.mass_distribution else { continue };
        let (pose, twist) = (&workspace.poses[i], &workspace.twists[i]);
        let arm = apply(&pose.rotation, &distribution.com);
        let own = (twist.linear + cross(&twist.angular, &arm)) * distribution.mass;
        let spin = apply(&distribution.inertia, &apply_transposed(&pose.rotation, &twist.angular));
        linear += own;
        angular += cross(&(pose.translation + arm), &own) + apply(&pose.rotation, &spin);
    }
    check_result("the linear momentum", linear.as_slice())?;
    check_result("the angular momentum", angular.as_slice())?;
    Ok(Momentum { linear, angular })
}

/// The centre of mass `Σ m·c / Σ m` (m) in the world at `q`; the world's origin for a figure without mass.
///
/// Also places the links.
///
/// # Errors
///
/// As for [`forward_kinematics`].
#[doc(alias = "com")]
#[doc(alias = "center of gravity")]
#[doc(alias = "cog")]
#[doc(alias = "subtree_com")]
pub fn center_of_mass<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
) -> Result<Vector3<T>, DynamicsError> {
    forward_kinematics(tree, workspace, q)?;
    placed_center_of_mass(tree, workspace)
}

/// The same for links that are placed.
pub(crate) fn placed_center_of_mass<T: Scalar>(
    tree: &Tree<T>,
    workspace: &Workspace<T>,
) -> Result<Vector3<T>, DynamicsError> {
    let mut sum = Vector3::zeros();
    for (body, pose) in tree.bodies.iter().zip(&workspace.poses) {
        let Some(distribution) = &body.mass_distribution else { continue };
        sum += (pose.translation + apply(&pose.rotation, &distribution.com))
            * (distribution.mass * tree.mass_inverse);
    }
    check_result("the centre of mass", sum.as_slice())?;
    Ok(sum)
}
