//! The acceleration of a figure that the ground pushes with a known force, in closed form.

use crate::error::DynamicsError;
use crate::inertia::centroidal::{first_slope, gather_first};
use crate::inertia::mass_matrix::levers;
use crate::inverse::{check_forces, inverse_dynamics};
use crate::kinematics::place;
use crate::scalar::Scalar;
use crate::spatial::Wrench;
use crate::spatial::direction::{cross, dot};
use crate::tree::Tree;
use crate::workspace::{Workspace, check_length, check_result};
use nalgebra::Vector3;

/// The translational acceleration of the root under a prescribed net `force` (N, world axes), with all other
/// accelerations given: written into the first three entries of `a`, and the forces of the whole motion into `tau`.
///
/// The root's joint has to begin with three translations in different directions, or to be a free joint. All of the
/// figure's mass follows these, so that their block of the mass matrix is the total mass, and with `F₀` the force that
/// the motion needs while they do not accelerate,
///
/// ```text
/// Δ = (force − F₀) / Σm          a_t = U⁻¹·Δ          tau_k ← tau_k + Δ·∂(Σ m·c)/∂q_k
/// ```
///
/// where the columns of `U` are the translations' axes in the world (a rotation for a free joint, whose velocities are along
/// the link's axes). That is one pass of [`inverse_dynamics`], a division, and three products for each degree of freedom:
/// no second pass.
///
/// `force` is what acts on the figure besides gravity and the `external` wrenches; zero lets the figure fall. It enters at
/// the root's translations and has no moment there: a reaction of the ground that has a place is an external wrench. `q`
/// (rad, m) has length `nq`; `v`, `a` (per s, per s²) and `tau` (N m, N) length `nv`. The first three entries of `a` are not
/// read. An armature of the root's translations is not part of the mass: what accelerates it is added to `tau`.
///
/// Also places the links.
///
/// # Source
///
/// Vasilonikolidakis (1991), §6.6, eqs. (6.5)–(6.21), who finds the same acceleration by a 3 × 3 system and two passes; the
/// matrix of that system is the total mass times the identity, and so it need not be formed. See `docs/sources.md`.
///
/// # Errors
///
/// As for [`inverse_dynamics`]; [`DynamicsError::Root`] for a root without three translations.
///
/// # Examples
///
/// Nothing holds the figure: it falls with gravity.
///
/// ```
/// use solaris_dynamics::{Tree, Workspace, ground_acceleration};
/// use solaris_model::{Vector3, human};
///
/// let tree = Tree::<f64>::new(&human(1.65, 58.0)?, Vector3::new(0.0, -9.81, 0.0))?;
/// let mut workspace = Workspace::new(&tree);
/// let (q, v, mut a, mut tau) = ([0.0; 66], [0.0; 66], [0.0; 66], [0.0; 66]);
/// let nothing = Vector3::zeros();
/// ground_acceleration(&tree, &mut workspace, &q, &v, &mut a, &[], &nothing, &mut tau)?;
/// assert!((a[1] + 9.81).abs() < 1e-12 && tau.iter().all(|tau| tau.abs() < 1e-12));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "grf")]
#[doc(alias = "ground reaction")]
#[expect(clippy::too_many_arguments, reason = "a state, what acts on it, and what comes of it")]
pub fn ground_acceleration<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    a: &mut [T],
    external: &[(usize, Wrench<T>)],
    force: &Vector3<T>,
    tau: &mut [T],
) -> Result<(), DynamicsError> {
    if !begins_with_translations(tree) {
        return Err(DynamicsError::Root { link: tree.link_name(0) });
    }
    check_length("a", a.len(), tree.nv())?;
    check_result("the prescribed force", force.as_slice())?;
    a[..3].fill(T::zero());
    inverse_dynamics(tree, workspace, q, v, a, external, tau)?;
    // External wrenches have placed the links already.
    if external.is_empty() {
        place(tree, workspace)?;
    }
    levers(tree, workspace);
    gather_first(tree, workspace);
    let ws = &*workspace;
    let delta = (force - ws.base.force) * tree.mass_inverse;
    for (link, body) in tree.bodies.iter().enumerate() {
        for k in body.first..body.end {
            tau[k] += dot(&delta, &first_slope(tree, ws, link, k));
        }
    }
    let [x, y, z] = [&ws.axes[0], &ws.axes[1], &ws.axes[2]];
    let volume = dot(x, &cross(y, z));
    a[0] = dot(&delta, &cross(y, z)) / volume;
    a[1] = dot(&delta, &cross(z, x)) / volume;
    a[2] = dot(&delta, &cross(x, y)) / volume;
    for &(k, armature) in tree.armature.iter().filter(|(k, _)| *k < 3) {
        tau[k] += armature * a[k];
    }
    check_forces(tree, tau)
}

/// Whether the root's joint begins with three translations that span space.
fn begins_with_translations<T: Scalar>(tree: &Tree<T>) -> bool {
    let Some(dofs) = tree.dofs.first_chunk::<3>() else { return false };
    let [x, y, z] = dofs.each_ref().map(|dof| &dof.axis);
    let volume = dot(x, &cross(y, z));
    tree.bodies[0].end >= 3
        && dofs.iter().all(|dof| !dof.kind.turns())
        && (volume.all_within(0.01, 1.01) || volume.all_within(-1.01, -0.01))
}
