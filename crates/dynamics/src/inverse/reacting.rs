//! Inverse dynamics under what acts from outside as the motion needs it.

use super::{apply_placed, check_forces, inward, outward};
use crate::error::DynamicsError;
use crate::inertia::momentum::placed_center_of_mass;
use crate::kinematics::place;
use crate::scalar::Scalar;
use crate::spatial::Wrench;
use crate::tree::Tree;
use crate::workspace::{Workspace, check, check_length};
use nalgebra::Vector3;

/// The forces `tau` (N m or N) of [`crate::inverse_dynamics`] under wrenches that follow from what the motion needs, as reactions of
/// the ground do.
///
/// `react` gives those wrenches. It is told the centre of mass (m), and the workspace with the links placed
/// ([`Workspace::pose`]) and what has to act from outside in all ([`Workspace::base_wrench`]). Afterwards that is what `react` has
/// left. Inverse dynamics without wrenches, [`crate::center_of_mass`] and inverse dynamics with them give the same, to the bit; here
/// the way outwards is gone once.
///
/// # Errors
///
/// As for [`crate::inverse_dynamics`], and those of `react`.
///
/// # Examples
///
/// A hand that bears all of a pendulum's weight at its centre of mass leaves nothing to the pivot:
///
/// ```
/// use solaris_dynamics::{DynamicsError, Tree, Workspace, Wrench, inverse_dynamics_with};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0));
/// let figure = FigureBuilder::new("pendulum").link(bob).build()?;
/// let tree = Tree::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0))?;
/// let (mut workspace, mut tau) = (Workspace::new(&tree), [0.0]);
/// let bear = |workspace: &Workspace<f64>, com: &Vector3<f64>| {
///     let force = workspace.base_wrench().force;
///     Ok::<_, DynamicsError>([(0, Wrench { force, moment: com.cross(&force) })])
/// };
/// inverse_dynamics_with(&tree, &mut workspace, &[1.0], &[0.0], &[0.0], bear, &mut tau)?;
/// assert!(tau[0].abs() < 1e-12 && workspace.base_wrench().force.norm() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "ground reaction")]
#[doc(alias = "contact forces")]
pub fn inverse_dynamics_with<T: Scalar, L: AsRef<[(usize, Wrench<T>)]>, E: From<DynamicsError>>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    a: &[T],
    react: impl FnOnce(&Workspace<T>, &Vector3<T>) -> Result<L, E>,
    tau: &mut [T],
) -> Result<(), E> {
    workspace.set_positions(tree, q)?;
    check("v", v, tree.nv(), |index| tree.v_name(index))?;
    check("a", a, tree.nv(), |index| tree.v_name(index))?;
    check_length("tau", tau.len(), tree.nv())?;
    outward(tree, workspace, v, a);
    workspace.own_loads.copy_from_slice(&workspace.loads);
    inward(tree, workspace, tau);
    check_forces(tree, tau)?;
    place(tree, workspace)?;
    let com = placed_center_of_mass(tree, workspace)?;
    let external = react(workspace, &com)?;
    workspace.loads.copy_from_slice(&workspace.own_loads);
    apply_placed(tree, workspace, external.as_ref())?;
    inward(tree, workspace, tau);
    for &(k, armature) in &tree.armature {
        tau[k] += armature * a[k];
    }
    Ok(check_forces(tree, tau)?)
}
