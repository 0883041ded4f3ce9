//! Centroidal dynamics: the centre of mass, and the momentum about it with its matrix and rate.
//!
//! Everything is summed from the root's origin, so that nothing but the centre's own place depends on where the figure
//! stands.

use crate::error::DynamicsError;
use crate::inertia::mass_matrix::{accelerating, gather, levers};
use crate::kinematics::acceleration::{accelerations, carried};
use crate::kinematics::{forward_kinematics, velocities};
use crate::scalar::Scalar;
use crate::spatial::direction::{apply, apply_transposed, cross, dot};
use crate::spatial::{Momentum, Twist, Wrench};
use crate::tree::Tree;
use crate::workspace::{Composite, Workspace, check_length, check_result};
use nalgebra::{DMatrix, Matrix3, Vector3};

/// A figure frozen in a posture, as one rigid body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompositeBody<T> {
    /// Total mass (kg).
    pub mass: T,
    /// Centre of mass in the world (m).
    pub center: Vector3<T>,
    /// Rotational inertia about the centre of mass, along the world's axes (kg m²).
    pub inertia: Matrix3<T>,
}

/// The whole figure at `q` as one rigid body: mass, centre and inertia about it.
///
/// Also places the links.
///
/// # Errors
///
/// As for [`forward_kinematics`]; [`DynamicsError::Overflow`] too for an inertia beyond the precision.
#[doc(alias = "locked inertia")]
#[doc(alias = "composite rigid body")]
pub fn composite_body<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
) -> Result<CompositeBody<T>, DynamicsError> {
    forward_kinematics(tree, workspace, q)?;
    levers(tree, workspace);
    gather(tree, workspace);
    let Composite { mass, first, inertia } = workspace.composites[0];
    let arm = first * tree.mass_inverse;
    // The root's origin is not the centre: I_c = I − (r·h·1 − r·hᵀ) with h = m·r.
    let inertia =
        inertia.full() - Matrix3::from_diagonal_element(dot(&arm, &first)) + arm * first.transpose();
    let center = workspace.poses[0].translation + arm;
    check_result("the centre of mass", center.as_slice())?;
    check_result("the inertia of the figure", inertia.as_slice())?;
    Ok(CompositeBody { mass, center, inertia })
}

/// The Jacobian (3 × `nv`) of the centre of mass at `q`: its velocity (m/s) in world axes is `J_G·v`.
///
/// ```text
/// m·J_G,k = Σ m_b·∂c_b/∂q_k
/// ```
///
/// over the links `b` that degree of freedom `k` moves; zero for a figure without mass. Also places the links.
///
/// # Errors
///
/// As for [`crate::jacobian`].
#[doc(alias = "com jacobian")]
#[doc(alias = "jacobianCenterOfMass")]
pub fn center_of_mass_jacobian<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    matrix: &mut DMatrix<T>,
) -> Result<(), DynamicsError> {
    check_length("each column of the centre of mass's Jacobian", matrix.nrows(), 3)?;
    check_length("each row of the centre of mass's Jacobian", matrix.ncols(), tree.nv())?;
    forward_kinematics(tree, workspace, q)?;
    levers(tree, workspace);
    gather_first(tree, workspace);
    for (link, body) in tree.bodies.iter().enumerate() {
        for k in body.first..body.end {
            let column = first_slope(tree, workspace, link, k) * tree.mass_inverse;
            matrix.as_mut_slice()[3 * k..][..3].copy_from_slice(column.as_slice());
        }
    }
    check_result("the centre of mass's Jacobian", matrix.as_slice())
}

/// The centroidal momentum matrix `A_G` (6 × `nv`) at `q`: `A_G·v` is the linear momentum (rows 0 to 2) and the angular
/// momentum about the centre of mass (rows 3 to 5), in world axes.
///
/// Armatures have no part in it. Also places the links.
///
/// # Source
///
/// D. E. Orin, A. Goswami, S.-H. Lee, "Centroidal dynamics of a humanoid robot", Autonomous Robots 35 (2013) 161–176,
/// who put the angular rows first; the columns here are those of the composite bodies of [`crate::mass_matrix`].
///
/// # Errors
///
/// As for [`crate::jacobian`].
#[doc(alias = "ccrba")]
#[doc(alias = "cmm")]
pub fn centroidal_momentum_matrix<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    matrix: &mut DMatrix<T>,
) -> Result<(), DynamicsError> {
    check_length("each column of the momentum matrix", matrix.nrows(), 6)?;
    check_length("each row of the momentum matrix", matrix.ncols(), tree.nv())?;
    forward_kinematics(tree, workspace, q)?;
    levers(tree, workspace);
    gather(tree, workspace);
    let center = workspace.composites[0].first * tree.mass_inverse;
    offsets(tree, workspace, &center);
    for (link, body) in tree.bodies.iter().enumerate() {
        for k in body.first..body.end {
            let load = accelerating(tree, workspace, link, k);
            let about_center = load.moment + cross(&workspace.offsets[link], &load.force);
            let column = &mut matrix.as_mut_slice()[6 * k..][..6];
            column[..3].copy_from_slice(load.force.as_slice());
            column[3..].copy_from_slice(about_center.as_slice());
        }
    }
    check_result("the momentum matrix", matrix.as_slice())
}

/// Linear momentum, and angular momentum **about the centre of mass**, in world axes, of the state `q`, `v`:
///
/// ```text
/// P = Σ m·ċ          L_G = Σ (c − G) × m·ċ + R·I_c·Rᵀ·ω
/// ```
///
/// Also places the links and finds their velocities.
///
/// # Errors
///
/// As for [`velocities`].
#[doc(alias = "centroidal")]
#[doc(alias = "angular momentum")]
pub fn centroidal_momentum<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
) -> Result<Momentum<T>, DynamicsError> {
    velocities(tree, workspace, q, v)?;
    let sum = sum_about_center(tree, workspace, |ws, link, arm, inertia| {
        let Twist { linear, angular } = ws.twists[link];
        (linear + cross(&angular, arm), inertia(&angular))
    });
    check_result("the linear momentum", sum.0.as_slice())?;
    check_result("the angular momentum", sum.1.as_slice())?;
    Ok(Momentum { linear: sum.0, angular: sum.1 })
}

/// The rate `A_G·a + Ȧ_G·v` of the centroidal momentum at `q`, `v`, `a`: force (N), and moment (N m) **about the centre
/// of mass**, in world axes. With `a = 0` it is the bias `Ȧ_G·v`.
///
/// It is what acts on the figure from outside, gravity and all:
///
/// ```text
/// Ṗ = Σ m·c̈          L̇_G = Σ (c − G) × m·c̈ + I·α + ω × I·ω
/// ```
///
/// Also places the links and finds their velocities and accelerations.
///
/// # Errors
///
/// As for [`accelerations`].
#[doc(alias = "dccrba")]
pub fn centroidal_momentum_rate<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    a: &[T],
) -> Result<Wrench<T>, DynamicsError> {
    accelerations(tree, workspace, q, v, a)?;
    let sum = sum_about_center(tree, workspace, |ws, link, arm, inertia| {
        let (spin, Twist { linear, angular }) = (ws.twists[link].angular, ws.accelerations[link]);
        (linear + carried(&spin, &angular, arm), inertia(&angular) + cross(&spin, &inertia(&spin)))
    });
    check_result("the rate of the linear momentum", sum.0.as_slice())?;
    check_result("the rate of the angular momentum", sum.1.as_slice())?;
    Ok(Wrench { force: sum.0, moment: sum.1 })
}

/// `Σ m·u` and `Σ (c − G) × m·u + l` over the links, where `motion` tells `u` and `l` of each: it is given the arm from the
/// link's origin to its centre of mass, and the product with its inertia about that.
fn sum_about_center<T: Scalar>(
    tree: &Tree<T>,
    ws: &mut Workspace<T>,
    motion: impl Fn(
        &Workspace<T>,
        usize,
        &Vector3<T>,
        &dyn Fn(&Vector3<T>) -> Vector3<T>,
    ) -> (Vector3<T>, Vector3<T>),
) -> (Vector3<T>, Vector3<T>) {
    levers(tree, ws);
    gather_first(tree, ws);
    let center = ws.composites[0].first * tree.mass_inverse;
    offsets(tree, ws, &center);
    let (mut linear, mut angular) = (Vector3::zeros(), Vector3::zeros());
    for (link, body) in tree.bodies.iter().enumerate() {
        let Some(distribution) = &body.mass_distribution else { continue };
        let rotation = &ws.poses[link].rotation;
        let arm = apply(rotation, &distribution.com);
        let inertia =
            |w: &Vector3<T>| apply(rotation, &apply(&distribution.inertia, &apply_transposed(rotation, w)));
        let (velocity, spin) = motion(ws, link, &arm, &inertia);
        let own = velocity * distribution.mass;
        linear += own;
        angular += cross(&(ws.offsets[link] + arm), &own) + spin;
    }
    (linear, angular)
}

/// Mass and first moment of each link with all that it carries, about the link's own origin, world axes; the inertia is left
/// as it is.
pub(crate) fn gather_first<T: Scalar>(tree: &Tree<T>, ws: &mut Workspace<T>) {
    for ((body, composite), pose) in tree.bodies.iter().zip(&mut ws.composites).zip(&ws.poses) {
        (composite.mass, composite.first) = body.mass_distribution.as_ref().map_or_else(
            || (T::zero(), Vector3::zeros()),
            |distribution| (distribution.mass, apply(&pose.rotation, &distribution.first)),
        );
    }
    for (i, body) in tree.bodies.iter().enumerate().rev() {
        let Some(parent) = body.parent else { continue };
        let (mass, first) =
            (ws.composites[i].mass, ws.composites[i].first + ws.reaches[i] * ws.composites[i].mass);
        ws.composites[parent].mass += mass;
        ws.composites[parent].first += first;
    }
}

/// `∂(m·c)/∂q_k` of all that `link` carries along its degree of freedom `k`, world axes.
pub(crate) fn first_slope<T: Scalar>(tree: &Tree<T>, ws: &Workspace<T>, link: usize, k: usize) -> Vector3<T> {
    let (composite, along) = (&ws.composites[link], ws.levers[k]);
    let slid = along * composite.mass;
    if tree.dofs[k].kind.turns() { slid + cross(&ws.axes[k], &composite.first) } else { slid }
}

/// Where the links' origins are as seen from a `center` that is itself given from the root's origin; world axes.
fn offsets<T: Scalar>(tree: &Tree<T>, ws: &mut Workspace<T>, center: &Vector3<T>) {
    for (i, body) in tree.bodies.iter().enumerate() {
        ws.offsets[i] = body.parent.map_or(-center, |parent| ws.offsets[parent] + ws.reaches[i]);
    }
}
