//! The Lagrangian recursion with every quantity computed once over the tree.

use super::constants::Lagrangian;
use super::equations::advance;
use super::products::Products;
use super::state::{LagrangianWorkspace, finish};
use crate::error::DynamicsError;
use crate::scalar::Scalar;
use crate::spatial::Wrench;

/// The generalized forces `tau` (N m or N) that move the figure with accelerations `a` through the state `q`, `v`, by the
/// thesis's recursion with every quantity computed once.
///
/// (4.10) and (4.11) become sums over the rationalised links `k` that follow link `i`:
///
/// ```text
/// c_i = m_i·r_i + Σ A_k·c_k        D_i = J_i·Ẅ_iᵀ + Σ A_k·D_k
/// ```
///
/// Arguments and results are those of [`super::chain_wise`] and [`crate::inverse_dynamics`].
///
/// # Source
///
/// Vasilonikolidakis (1991), §4.6, whose last paragraph proposes to compute what chains share once.
///
/// # Errors
///
/// As for [`crate::inverse_dynamics`].
#[doc(alias = "Lagrange-Euler")]
#[doc(alias = "Uicker-Kahn")]
pub fn tree_wise<T: Scalar, P: Products>(
    lagrangian: &Lagrangian<T, P>,
    workspace: &mut LagrangianWorkspace<T>,
    q: &[T],
    v: &[T],
    a: &[T],
    external: &[(usize, Wrench<T>)],
    tau: &mut [T],
) -> Result<(), DynamicsError> {
    workspace.take_in(lagrangian, q, v, a, external)?;
    finish(lagrangian, a, tau, |tau| {
        outwards(lagrangian, workspace);
        inwards(lagrangian, workspace, tau);
    })
}

/// A, W, Ẇ, Ẅ and ∂W/∂q of every rationalised link, parents first: (4.1) to (4.9).
fn outwards<T: Scalar, P: Products>(lagrangian: &Lagrangian<T, P>, ws: &mut LagrangianWorkspace<T>) {
    for (j, link) in lagrangian.links.iter().enumerate() {
        let parent = link.parent.map(|parent| &ws.motions[parent]);
        ws.motions[j] = advance::<P, T>(link, &ws.coordinates[j], ws.base(link), parent);
    }
}

/// c and D of every rationalised link, children first, by (4.10) and (4.11), and the forces by (4.12).
fn inwards<T: Scalar, P: Products>(
    lagrangian: &Lagrangian<T, P>,
    ws: &mut LagrangianWorkspace<T>,
    tau: &mut [T],
) {
    ws.balances.fill(None);
    for (j, link) in lagrangian.links.iter().enumerate().rev() {
        let (own, beyond) = (ws.own::<P>(j, link), ws.balances[j]);
        let Some(balance) = beyond.map_or(own, |beyond| Some(beyond.plus::<P>(own))) else {
            tau[j] = T::zero();
            continue;
        };
        let motion = &ws.motions[j];
        tau[j] = balance.force::<P>(link, lagrangian.tree.gravity(), &motion.by_coordinate);
        if let Some(parent) = link.parent {
            let carried = balance.carried::<P>(&motion.transform, ws.base(link));
            ws.balances[parent] = Some(carried.plus::<P>(ws.balances[parent]));
        }
    }
}
