//! Forward and hybrid dynamics: the motion that forces bring about.

pub(crate) mod articulated;
pub(crate) mod contact;
pub(crate) mod propagation;

use crate::error::DynamicsError;
use crate::forward::propagation::velocity::velocity_terms;
use crate::forward::propagation::{accelerate, gather, gather_loads, inward, no_velocity_terms, outward};
use crate::inertia::inverse::invert;
use crate::inverse::apply_external;
use crate::scalar::Scalar;
use crate::spatial::Wrench;
use crate::spatial::load::Load;
use crate::spatial::symmetric::Symmetric;
use crate::tree::{Body, Tree};
use crate::wide::wide;
use crate::workspace::{Workspace, are_finite, check, check_length, check_result};
use nalgebra::{DMatrix, Vector3};
use solaris_model::EulerOrder;

/// The accelerations `a` that the generalized forces `tau` give the figure in the state `q`, `v`.
///
/// Three passes, each linear in the number of links: velocities outwards, what hangs from each joint inwards as one body
/// whose joints give way, accelerations outwards,
///
/// ```text
/// U = I·s      D = s·U + armature      u = τ − s·p      I ← I − U·Uᵀ/D      p ← p + I·c + U·u/D
/// q̈ = (u − U·a)/D
/// ```
///
/// for every degree of freedom along `s` that velocities alone accelerate by `c`. No matrix of the whole figure is formed:
/// the error grows as that of the state, not as the square of the mass matrix' condition.
///
/// `q` (rad, m) has length `nq`; `v`, `tau` (N m, N) and `a` (per s²) length `nv`; `external` as for
/// [`crate::inverse_dynamics`], in which case the links are also placed.
///
/// # Source
///
/// R. Featherstone, "The calculation of robot dynamics using articulated-body inertias", Int. J. Robotics Research 2(1)
/// (1983) 13–30; here with accelerations of the links' own origins in place of spatial ones, as in
/// [`crate::inverse_dynamics`], and degree of freedom by degree of freedom.
///
/// # Errors
///
/// As for [`crate::inverse_dynamics`], and [`DynamicsError::NoInertia`] for a degree of freedom whose force meets no
/// inertia.
///
/// # Examples
///
/// A pendulum let go from level falls with g/l:
///
/// ```
/// use solaris_dynamics::{Tree, Workspace, forward_dynamics};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0));
/// let figure = FigureBuilder::new("pendulum").link(bob).build()?;
/// let tree = Tree::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0))?;
/// let (mut workspace, mut a) = (Workspace::new(&tree), [0.0]);
/// forward_dynamics(&tree, &mut workspace, &[-std::f64::consts::FRAC_PI_2], &[0.0], &[0.0], &[], &mut a)?;
/// assert!((a[0] - 9.81 / 0.5).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "aba")]
#[doc(alias = "articulated-body algorithm")]
#[doc(alias = "fd")]
pub fn forward_dynamics<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    tau: &[T],
    external: &[(usize, Wrench<T>)],
    a: &mut [T],
) -> Result<(), DynamicsError> {
    wide::<T, _>(
        #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
        || forward(tree, workspace, q, v, tau, external, a),
    )
}

/// [`forward_dynamics`], compiled into whatever asks it.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn forward<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    tau: &[T],
    external: &[(usize, Wrench<T>)],
    a: &mut [T],
) -> Result<(), DynamicsError> {
    check("tau", tau, tree.nv(), |index| tree.v_name(index))?;
    check_length("a", a.len(), tree.nv())?;
    take_state(tree, workspace, q, v, external)?;
    inward::gather(tree, workspace, nothing, &[], tau);
    outward::accelerate(tree, workspace, &-tree.gravity, nothing, a, &mut []);
    check_accelerations(tree, workspace, a)
}

/// Hybrid dynamics: some degrees of freedom have a prescribed acceleration, the others a given force.
///
/// Where `prescribed[k]` is true, `a[k]` is read and `tau[k]` written: the force that brings the acceleration about.
/// Elsewhere `tau[k]` is read and `a[k]` written. One pass each way as in [`forward_dynamics`], where a prescribed degree
/// of freedom does not give way:
///
/// ```text
/// p ← p + I·(c + s·q̈)          τ = U·a + s·p
/// ```
///
/// With nothing prescribed this is forward dynamics, with everything inverse dynamics. All slices but `q` have length
/// `nv`; `external` as for [`crate::inverse_dynamics`].
///
/// # Source
///
/// R. Featherstone, "Rigid Body Dynamics Algorithms" (2008), §9.2, for the partition; the recursion is that of his 1983
/// paper with the prescribed joints locked to their accelerations.
///
/// # Errors
///
/// As for [`forward_dynamics`].
#[doc(alias = "hybrid")]
#[doc(alias = "prescribed motion")]
#[doc(alias = "hd")]
#[expect(
    clippy::too_many_arguments,
    reason = "the state, what is known and what is sought are slices of their own"
)]
pub fn hybrid_dynamics<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    prescribed: &[bool],
    external: &[(usize, Wrench<T>)],
    a: &mut [T],
    tau: &mut [T],
) -> Result<(), DynamicsError> {
    check_length("prescribed", prescribed.len(), tree.nv())?;
    check_given("a", a, tree, |k| prescribed[k])?;
    check_given("tau", tau, tree, |k| !prescribed[k])?;
    set_state(tree, workspace, q, v, external)?;
    gather(tree, workspace, those(prescribed), a, tau);
    accelerate(tree, workspace, &-tree.gravity, those(prescribed), a, tau);
    check_accelerations(tree, workspace, a)?;
    check_result("a force of hybrid dynamics", tau)
}

/// The inverse of the mass matrix, `M⁻¹` (`nv` × `nv`) at `q`: column `j` holds the accelerations that a force of 1 along
/// degree of freedom `j` gives the figure at rest without gravity.
///
/// The joints are gathered once, as in [`forward_dynamics`], and several columns at a time take one pass each way as far as the diagonal:
/// the work grows with `nv²`. Where a pivot loses nine digits, each column is forward dynamics by itself. Also places the links.
///
/// # Errors
///
/// As for [`forward_dynamics`].
#[doc(alias = "minverse")]
#[doc(alias = "computeMinverse")]
pub fn inverse_mass_matrix<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    matrix: &mut DMatrix<T>,
) -> Result<(), DynamicsError> {
    let n = tree.nv();
    check_length("each column of the inverse mass matrix", matrix.nrows(), n)?;
    check_length("each row of the inverse mass matrix", matrix.ncols(), n)?;
    tree.check_free()?;
    if invert(tree, workspace, q, matrix)? {
        return Ok(());
    }
    no_velocity_terms(workspace);
    // Taken out so that the workspace can be borrowed; an empty vector takes no memory.
    let mut force = std::mem::take(&mut workspace.zeros);
    gather(tree, workspace, nothing, &[], &force);
    for j in 0..n {
        workspace.loads.fill(Load::zero());
        force[j] = T::one();
        gather_loads(tree, workspace, nothing, &force);
        force[j] = T::zero();
        let column = &mut matrix.as_mut_slice()[j * n..][..n];
        accelerate(tree, workspace, &Vector3::zeros(), nothing, column, &mut []);
    }
    workspace.zeros = force;
    check_accelerations(tree, workspace, matrix.as_slice())
}

/// Of no degree of freedom is the acceleration prescribed.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn nothing(_: usize) -> bool {
    false
}

/// Of which degrees of freedom the acceleration is prescribed; one type for all operations, so that they share the passes.
pub(crate) fn those(prescribed: &[bool]) -> impl Fn(usize) -> bool + Copy {
    |k| prescribed[k]
}

/// [`take_state`], compiled once for all operations that share it.
pub(crate) fn set_state<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    external: &[(usize, Wrench<T>)],
) -> Result<(), DynamicsError> {
    wide::<T, _>(
        #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
        || take_state(tree, workspace, q, v, external),
    )
}

/// Takes in the state and all that acts besides forces along degrees of freedom.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn take_state<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    external: &[(usize, Wrench<T>)],
) -> Result<(), DynamicsError> {
    tree.check_free()?;
    workspace.take_positions(tree, q)?;
    check("v", v, tree.nv(), |index| tree.v_name(index))?;
    velocity_terms(tree, workspace, v);
    apply_external(tree, workspace, external)
}

/// Refuses the wrong length, and an entry that is read but is not finite.
pub(crate) fn check_given<T: Scalar>(
    what: &'static str,
    values: &[T],
    tree: &Tree<T>,
    given: impl Fn(usize) -> bool,
) -> Result<(), DynamicsError> {
    check_length(what, values.len(), tree.nv())?;
    let bad = (0..values.len()).find(|&k| given(k) && !values[k].is_finite());
    bad.map_or(Ok(()), |k| {
        Err(DynamicsError::NotFinite { what, dof: tree.v_name(k), value: format!("{:?}", values[k]) })
    })
}

/// Accelerations that are not finite, and where they come from.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn check_accelerations<T: Scalar>(
    tree: &Tree<T>,
    workspace: &Workspace<T>,
    a: &[T],
) -> Result<(), DynamicsError> {
    if are_finite(a) {
        return Ok(());
    }
    why_not_finite(tree, workspace, a)
}

/// What keeps accelerations from being finite.
#[cold]
#[inline(never)]
fn why_not_finite<T: Scalar>(tree: &Tree<T>, workspace: &Workspace<T>, a: &[T]) -> Result<(), DynamicsError> {
    let infinite = |inverse: &T| !inverse.is_finite();
    // The joints nearest to the tips are gathered first: what they lack spoils all before them.
    let bad = tree.bodies.iter().enumerate().rev().find_map(|(i, body)| {
        let pivots = workspace.yieldings[i].pivots();
        if let Some(axis) = pivots.iter().position(infinite).filter(|_| body.turns_freely) {
            let order = body.triple.map_or([0, 1, 2], EulerOrder::axes);
            let inertia = turning_inertia(body, workspace.articulated[i].angular).pivot(axis);
            return order.iter().position(|of| *of == axis).map(|turn| (body.end - 3 + turn, inertia));
        }
        let single_end = if pivots[0].is_zero() { body.end } else { body.end - 3 };
        let hinge = (body.first..single_end).rev().find(|&k| infinite(&workspace.hinges[k].inverse));
        hinge.map(|k| (k, tree.dofs[k].armature + workspace.hinges[k].diagonal(&tree.dofs[k], workspace)))
    });
    bad.map_or_else(
        || check_result("an acceleration", a),
        |(k, inertia)| {
            // The least of all lanes.
            let inertia = -(-inertia).greatest();
            Err(DynamicsError::NoInertia { dof: tree.v_name(k), inertia })
        },
    )
}

/// What a link that turns freely, with all that hangs from it, opposes to turning.
fn turning_inertia<T: Scalar>(body: &Body<T>, hanging: Symmetric<T>) -> Symmetric<T> {
    let mut all = hanging;
    if let Some(distribution) = &body.mass_distribution {
        all.add(&distribution.inertia_at_origin);
    }
    all
}
