//! The algorithm of §4.6: every chain from the root to an end-effector on its own.

use super::constants::Lagrangian;
use super::equations::{Balance, advance};
use super::products::Products;
use super::state::{LagrangianWorkspace, finish};
use crate::error::DynamicsError;
use crate::scalar::Scalar;
use crate::spatial::Wrench;

/// The generalized forces `tau` (N m or N) that move the figure with accelerations `a` through the state `q`, `v`, by the
/// thesis's recursion over chains.
///
/// A figure with N end-effectors has N chains, each from the root; what they share is computed in each of them, but counted
/// once: a mass is taken in the first chain that it is in, and the forces of the chains are added,
///
/// ```text
/// F_i = Σ_p ᵖF_i
/// ```
///
/// Arguments and results are those of [`crate::inverse_dynamics`]: `q` (rad, m) has length `nq`; `v`, `a` and `tau` length
/// `nv`; `external` lists link index and wrench on it, in world axes about the world's origin.
///
/// # Source
///
/// Vasilonikolidakis (1991), §4.6, with the corrections of `docs/sources.md`; the equations are cited line by line.
///
/// # Errors
///
/// As for [`crate::inverse_dynamics`].
///
/// # Examples
///
/// Held level, a pendulum of 2 kg at half a metre needs 2 · 9.81 · 0.5 N m:
///
/// ```
/// use solaris_dynamics::lagrange::{Lagrangian, LagrangianWorkspace, chain_wise};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0));
/// let figure = FigureBuilder::new("pendulum").link(bob).build()?;
/// let lagrangian = Lagrangian::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0))?;
/// let (mut workspace, mut tau) = (LagrangianWorkspace::new(&lagrangian), [0.0]);
/// chain_wise(&lagrangian, &mut workspace, &[-std::f64::consts::FRAC_PI_2], &[0.0], &[0.0], &[], &mut tau)?;
/// assert!((tau[0] - -9.81).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "Lagrange-Euler")]
#[doc(alias = "Uicker-Kahn")]
pub fn chain_wise<T: Scalar, P: Products>(
    lagrangian: &Lagrangian<T, P>,
    workspace: &mut LagrangianWorkspace<T>,
    q: &[T],
    v: &[T],
    a: &[T],
    external: &[(usize, Wrench<T>)],
    tau: &mut [T],
) -> Result<(), DynamicsError> {
    // Step 1: the quantities of the call.
    workspace.take_in(lagrangian, q, v, a, external)?;
    finish(lagrangian, a, tau, |tau| {
        // Step 2: F = 0.
        tau.fill(T::zero());
        for p in 0..lagrangian.chains.len() {
            outwards(lagrangian, workspace, p);
            inwards(lagrangian, workspace, p, tau);
        }
    })
}

/// Step 3: A, its derivatives, W, Ẇ, Ẅ and ∂W/∂q of chain `p`, by (4.1) to (4.9). (Slip 18: W⁻¹ is not
/// needed.)
fn outwards<T: Scalar, P: Products>(
    lagrangian: &Lagrangian<T, P>,
    ws: &mut LagrangianWorkspace<T>,
    p: usize,
) {
    let mut before = None;
    for &j in &lagrangian.chains[p].links {
        let link = &lagrangian.links[j];
        let parent = before.map(|before: usize| &ws.motions[before]);
        ws.motions[j] = advance::<P, T>(link, &ws.coordinates[j], ws.base(link), parent);
        before = Some(j);
    }
}

/// Steps 4 and 5: c and D of chain `p` by (4.10) and (4.11), with `c_{n+1} = 0` and `D_{n+1} = 0`, and its forces by (4.12).
/// (Slips 19 to 21.)
fn inwards<T: Scalar, P: Products>(
    lagrangian: &Lagrangian<T, P>,
    ws: &LagrangianWorkspace<T>,
    p: usize,
    tau: &mut [T],
) {
    let chain = &lagrangian.chains[p];
    let mut after: Option<(usize, Balance<T>)> = None;
    for (place, &i) in chain.links.iter().enumerate().rev() {
        let (link, motion) = (&lagrangian.links[i], &ws.motions[i]);
        // A mass that chains 1 to p − 1 have taken is not taken again.
        let own = if place >= chain.first_new { ws.own::<P>(i, link) } else { None };
        let carried = after.map(|(next, balance)| {
            balance.carried::<P>(&ws.motions[next].transform, ws.base(&lagrangian.links[next]))
        });
        let Some(balance) = carried.map_or(own, |carried| Some(carried.plus::<P>(own))) else { continue };
        tau[i] += balance.force::<P>(link, lagrangian.tree.gravity(), &motion.by_coordinate);
        after = Some((i, balance));
    }
}
