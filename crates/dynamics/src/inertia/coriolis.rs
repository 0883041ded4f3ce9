//! The Coriolis matrix, and the joint torques of gravity.

use crate::error::DynamicsError;
use crate::inertia::mass_matrix::{accelerating, gather, levers};
use crate::inverse::inverse_dynamics;
use crate::kinematics::acceleration::rates;
use crate::kinematics::climb::{Step, climb};
use crate::kinematics::velocities;
use crate::scalar::Scalar;
use crate::spatial::direction::{cross, dot};
use crate::spatial::load::Load;
use crate::tree::Tree;
use crate::workspace::{Flow, Workspace, check_length, check_result};
use nalgebra::{DMatrix, Matrix3};

/// The Coriolis matrix `C` (`nv` × `nv`) of the state `q`, `v`: `C·v` are the Coriolis and centrifugal forces,
///
/// ```text
/// M·a + C·v + g = tau          Ṁ = C + Cᵀ, so that Ṁ − 2·C is skew
/// ```
///
/// Many matrices give the forces `C·v`; this one is
///
/// ```text
/// C = Σ ∫ J_xᵀ·J̇_x dm
/// ```
///
/// with `J_x` the Jacobian of every particle. Where the coordinates are angles and ways it is the matrix of
/// Christoffel's symbols; with ball and free joints it is the same form over their velocities, and keeps both properties.
/// In the thesis's matrices it would be `C_ij = Σ tr(∂W/∂q_i·J·(∂Ẇ/∂q_j)ᵀ)`.
///
/// `q` (rad, m) has length `nq`, `v` (per s) length `nv`. The work grows with the number of links times the depth of the
/// tree, plus `nv²` for writing. Also places the links and finds their velocities. Armatures have no part in it.
///
/// # Source
///
/// The factorisation of S. Echeandia, P. M. Wensing, "Numerical methods to compute the Coriolis matrix and Christoffel
/// symbols for rigid-body systems", J. Comput. Nonlinear Dyn. 16 (2021) 091004, after G. Niemeyer, J.-J. E. Slotine,
/// "Performance in adaptive manipulator control", Int. J. Robotics Research 10 (1991) 149–161; here by composite bodies,
/// with `∫ ṙ·rᵀ dm` in place of their body-level Coriolis matrix.
///
/// # Errors
///
/// [`DynamicsError`] for a slice or matrix of the wrong size, an entry that is not finite, a workspace of another tree,
/// or entries beyond the precision.
#[doc(alias = "coriolis")]
#[doc(alias = "centrifugal")]
#[doc(alias = "computeCoriolisMatrix")]
#[doc(alias = "christoffel")]
pub fn coriolis_matrix<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    matrix: &mut DMatrix<T>,
) -> Result<(), DynamicsError> {
    check_length("each column of the Coriolis matrix", matrix.nrows(), tree.nv())?;
    check_length("each row of the Coriolis matrix", matrix.ncols(), tree.nv())?;
    velocities(tree, workspace, q, v)?;
    levers(tree, workspace);
    rates(tree, workspace, v);
    gather(tree, workspace);
    gather_flows(tree, workspace);
    matrix.as_mut_slice().fill(T::zero());
    for (link, body) in tree.bodies.iter().enumerate() {
        for j in body.first..body.end {
            write_column(tree, workspace, link, j, matrix);
            write_row(tree, workspace, link, j, matrix);
        }
    }
    check_result("the Coriolis matrix", matrix.as_slice())
}

/// The forces `tau` (N m or N) that hold the figure against gravity at `q`, at rest: the slope of the potential energy.
///
/// # Errors
///
/// As for [`inverse_dynamics`].
#[doc(alias = "gravity")]
#[doc(alias = "computeGeneralizedGravity")]
#[doc(alias = "gravity compensation")]
pub fn gravity_torques<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    tau: &mut [T],
) -> Result<(), DynamicsError> {
    // Taken out so that the workspace can be borrowed; an empty vector takes no memory.
    let rest = std::mem::take(&mut workspace.zeros);
    let result = if rest.len() == tree.nv() {
        inverse_dynamics(tree, workspace, q, &rest, &rest, &[], tau)
    } else {
        Err(DynamicsError::Workspace)
    };
    workspace.zeros = rest;
    result
}

/// The flow of all that each link carries. A flow `(ḣ, Q)` of a mass `(m, h)` about a point that is `s` away from the new
/// one, and moves away by `ṡ`, is there
///
/// ```text
/// ḣ' = ḣ + m·ṡ          Q' = Q + ḣ·sᵀ + ṡ·hᵀ + m·ṡ·sᵀ
/// ```
fn gather_flows<T: Scalar>(tree: &Tree<T>, ws: &mut Workspace<T>) {
    let half = T::from_f64(0.5);
    for (i, body) in tree.bodies.iter().enumerate() {
        ws.flows[i] = body.mass_distribution.as_ref().map_or_else(Flow::zero, |distribution| {
            let (rotation, spin) = (&ws.poses[i].rotation, &ws.twists[i].angular);
            // The second moments ∫ r·rᵀ dm, from the inertia.
            let inertia = distribution.inertia_at_origin.full();
            let second = Matrix3::from_diagonal_element(inertia.trace() * half) - inertia;
            let second = rotation * second * rotation.transpose();
            let turned = |i: usize| cross(spin, &second.column(i).into());
            Flow {
                first: cross(spin, &(rotation * distribution.first)),
                second: Matrix3::from_columns(&[turned(0), turned(1), turned(2)]),
            }
        });
    }
    for (i, body) in tree.bodies.iter().enumerate().rev() {
        let Some(parent) = body.parent else { continue };
        let (Flow { first, second }, composite) = (ws.flows[i], &ws.composites[i]);
        let (s, rate) = (&ws.reaches[i], &ws.reach_rates[i]);
        let moved = first + rate * composite.mass;
        let carried = &mut ws.flows[parent];
        carried.first += moved;
        carried.second += second + moved * s.transpose() + rate * composite.first.transpose();
    }
}

/// Column `j` down to row `j`: the forces that the rates `J̇_j` of all that `link` carries ask of degree of freedom `j` and
/// of all before it.
fn write_column<T: Scalar>(
    tree: &Tree<T>,
    ws: &Workspace<T>,
    link: usize,
    j: usize,
    matrix: &mut DMatrix<T>,
) {
    // f = ∫ J̇ dm and n = ∫ r × J̇ dm with J̇ = λ̇ + ė × r + e × ṙ.
    let (composite, flow) = (&ws.composites[link], &ws.flows[link]);
    let lever_rate = &ws.lever_rates[j];
    let (mut force, mut moment) = (lever_rate * composite.mass, cross(&composite.first, lever_rate));
    if tree.dofs[j].kind.turns() {
        let (axis, rate) = (&ws.axes[j], &ws.axis_rates[j]);
        force += cross(rate, &composite.first) + cross(axis, &flow.first);
        // r × (e × ṙ) = e·(r·ṙ) − ṙ·(r·e)
        moment += composite.inertia.times(rate) + axis * flow.second.trace() - flow.second * axis;
    }
    climb(tree, link, j + 1, |step| match step {
        Step::Dof(k) => {
            let turning = if tree.dofs[k].kind.turns() { dot(&ws.axes[k], &moment) } else { T::zero() };
            matrix[(k, j)] = turning + dot(&ws.levers[k], &force);
        }
        Step::Parent(link) => moment += cross(&ws.reaches[link], &force),
    });
}

/// Row `k` left of column `k`: what the rates of the columns before it make of all that `link` carries, moved along `k`.
fn write_row<T: Scalar>(tree: &Tree<T>, ws: &Workspace<T>, link: usize, k: usize, matrix: &mut DMatrix<T>) {
    // C_kj = λ̇_j·f + ė_j·n + e_j·p with f = ∫ J_k dm, n = ∫ r × J_k dm and p = ∫ ṙ × J_k dm.
    let flow = &ws.flows[link];
    let Load { force, mut moment } = accelerating(tree, ws, link, k);
    let mut pull = cross(&flow.first, &ws.levers[k]);
    if tree.dofs[k].kind.turns() {
        let axis = &ws.axes[k];
        // ṙ × (e × r) = e·(r·ṙ) − r·(ṙ·e)
        pull += axis * flow.second.trace() - flow.second.tr_mul(axis);
    }
    climb(tree, link, k, |step| match step {
        Step::Dof(j) => {
            let turning = if tree.dofs[j].kind.turns() {
                dot(&ws.axis_rates[j], &moment) + dot(&ws.axes[j], &pull)
            } else {
                T::zero()
            };
            matrix[(k, j)] = turning + dot(&ws.lever_rates[j], &force);
        }
        Step::Parent(link) => {
            moment += cross(&ws.reaches[link], &force);
            pull += cross(&ws.reach_rates[link], &force);
        }
    });
}
