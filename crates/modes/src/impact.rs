//! Impacts: how velocities jump when some of them have to.

use crate::body::Body;
use solaris_dynamics::DynamicsError;

/// On which side of its range a degree of freedom is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// At the lower limit.
    Lower,
    /// At the upper limit.
    Upper,
}

impl Side {
    /// 1 where the range ends above, −1 where it ends below: the direction out of it.
    pub(crate) fn outward(self) -> f64 {
        if self == Self::Upper { 1.0 } else { -1.0 }
    }
}

/// What an impact has done.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Struck {
    /// The velocities after it (rad/s or m/s).
    pub(crate) v: Vec<f64>,
    /// The impulses on the degrees of freedom (N m s or N s): none where nothing but the figure acts.
    pub(crate) impulse: Vec<f64>,
    /// The kinetic energy that was lost (J).
    pub(crate) loss: f64,
    /// What is at a limit that does not push it.
    pub(crate) released: Vec<usize>,
}

/// What an impact is to do to one degree of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Wanted {
    /// It takes this velocity, whatever impulse that takes.
    Velocity(f64),
    /// It is at a limit on this side: it goes out of its range no faster than this velocity, that is, it comes into it at least as
    /// fast, and the limit pushes inwards only, and only where it is just as fast.
    Limit(Side, f64),
}

/// The velocities after an impact in an instant.
///
/// ```text
/// M·(v⁺ − v⁻) = P
/// Velocity(u)   v⁺ = u                      fixed   v⁺ = v⁻                      others   P = 0
/// Limit(u)      v⁺ ≤ u and P ≤ 0 outwards, one of them an equality
/// ```
///
/// `fixed` are degrees of freedom on motions of their own, which do not jump. The energy that is lost is `−½·Pᵀ·(v⁺ + v⁻)`,
/// exactly that of the velocities.
///
/// # Source
///
/// R. Featherstone, "Rigid Body Dynamics Algorithms" (2008), §11.7, for impulsive dynamics as dynamics without velocities; the
/// conditions of limits are a linear complementarity problem with a positive definite matrix, solved as in K. G. Murty,
/// "Note on a Bard-type scheme for solving the complementarity problem", Opsearch 11 (1974): always the first violation is
/// turned round, which ends for every such matrix.
pub(crate) fn strike(
    body: &mut Body<f64>,
    q: &[f64],
    v: &[f64],
    fixed: &[bool],
    wanted: &[(usize, Wanted)],
) -> Result<Struck, DynamicsError> {
    let nv = v.len();
    let (mut given, mut jump, mut impulse) = (fixed.to_vec(), vec![0.0; nv], vec![0.0; nv]);
    for &(dof, _) in wanted {
        given[dof] = true;
    }
    // With limits that all push, the usual case, one pass is enough. The bound is never met but by rounding.
    let limits = wanted.iter().filter(|(_, wanted)| matches!(wanted, Wanted::Limit(..))).count();
    for _ in 0..most_passes(limits) {
        for dof in 0..nv {
            (jump[dof], impulse[dof]) = (0.0, 0.0);
        }
        for &(dof, what) in wanted.iter().filter(|(dof, _)| given[*dof]) {
            let (Wanted::Velocity(velocity) | Wanted::Limit(_, velocity)) = what;
            jump[dof] = velocity - v[dof];
        }
        body.impact((q, v), &given, &mut jump, &mut impulse)?;
        let scale = (norm(&jump), norm(&impulse));
        let violated = |(dof, what): &&(usize, Wanted)| {
            let Wanted::Limit(side, most) = *what else { return false };
            let (beyond, push) =
                (side.outward() * (v[*dof] + jump[*dof] - most), side.outward() * impulse[*dof]);
            // Beyond rounding: the limit would pull, or would be passed.
            if given[*dof] { push > 1e-12 * scale.1 } else { beyond > 1e-12 * (scale.0 + v[*dof].abs()) }
        };
        let Some(&(dof, _)) = wanted.iter().find(violated) else { break };
        given[dof] = !given[dof];
    }
    let after: Vec<f64> = v.iter().zip(&jump).map(|(v, jump)| v + jump).collect();
    let gain: f64 =
        impulse.iter().zip(v.iter().zip(&after)).map(|(p, (v, after))| p * 0.5 * (v + after)).sum();
    let released = wanted.iter().map(|(dof, _)| *dof).filter(|dof| !given[*dof]).collect();
    Ok(Struck { v: after, impulse, loss: -gain, released })
}

/// As many as there are choices of what is let go, within reason.
fn most_passes(held: usize) -> usize {
    1 << held.min(16)
}

fn norm(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::LimitLaw;
    use approx::assert_abs_diff_eq;
    use nalgebra::Vector3;
    use solaris_model::{FigureBuilder, Joint, LinkSpec};

    /// Blocks that slide along x, each on the one before: `q` are the distances between them.
    fn train(masses: &[f64]) -> Body<f64> {
        let names: Vec<String> = (0..masses.len()).map(|k| format!("block{k}")).collect();
        let mut builder = FigureBuilder::new("train");
        for (k, mass) in masses.iter().enumerate() {
            let joint = Joint::new(format!("slide{k}")).tx();
            let link = match k.checked_sub(1) {
                None => LinkSpec::root(&names[k], joint),
                Some(parent) => LinkSpec::child(&names[k], &names[parent], joint),
            };
            builder = builder.link(link.mass(*mass));
        }
        let figure = builder.build().expect("valid");
        let limits = vec![LimitLaw::Ignore; masses.len()];
        Body::new(&figure, Vector3::new(0.0, -9.81, 0.0), &[], &limits).expect("valid")
    }

    #[test]
    fn a_block_that_is_stopped_against_another_shares_its_momentum() {
        // 1 kg at 3 m/s, on it 2 kg at 3 − 1.5 = 1.5 m/s; the gap's rate is to become +0.5·1.5. Momentum is 6 kg m/s.
        let mut body = train(&[1.0, 2.0]);
        let struck =
            strike(&mut body, &[0.0, 0.1], &[3.0, -1.5], &[false; 2], &[(1, Wanted::Velocity(0.75))])
                .expect("finite");
        assert_abs_diff_eq!(struck.v[0], 1.5, epsilon = 1e-14);
        assert_abs_diff_eq!(struck.v[1], 0.75, epsilon = 1e-14);
        // The impulse on the second block; nothing acts on the pair.
        assert_abs_diff_eq!(struck.impulse[1], 2.0 * (2.25 - 1.5), epsilon = 1e-14);
        assert_abs_diff_eq!(struck.impulse[0], 0.0, epsilon = 1e-14);
        // ½·μ·(1 − e²)·Δv² with μ = 2/3 kg and e = 1/2.
        assert_abs_diff_eq!(struck.loss, 0.5 * (2.0 / 3.0) * 0.75 * 2.25, epsilon = 1e-14);
    }

    #[test]
    fn what_is_fixed_does_not_jump() {
        let mut body = train(&[1.0, 2.0]);
        let struck =
            strike(&mut body, &[0.0, 0.1], &[3.0, -1.5], &[true, false], &[(1, Wanted::Velocity(0.75))]);
        let struck = struck.expect("finite");
        assert_abs_diff_eq!(struck.v[0], 3.0, epsilon = 0.0);
        // Its drive takes the whole impulse: 2 kg from 1.5 to 3.75 m/s.
        assert_abs_diff_eq!(struck.impulse[0], 2.0 * 2.25, epsilon = 1e-14);
        assert_abs_diff_eq!(struck.loss, 0.5 * 2.0 * (1.5 * 1.5 - 3.75 * 3.75), epsilon = 1e-13);
    }

    #[test]
    fn a_limit_that_holds_takes_part_and_one_that_would_pull_lets_go() {
        // Three blocks, the third resting at a limit of its gap to the second. The second's gap to the first is struck.
        let start = ([0.0; 3], [0.0, -1.0, 0.0]);
        let strike_at = |side| {
            let mut body = train(&[1.0, 2.0, 3.0]);
            let wanted = [(1, Wanted::Velocity(1.0)), (2, Wanted::Limit(side, 0.0))];
            strike(&mut body, &start.0, &start.1, &[true, false, false], &wanted).expect("finite")
        };
        // Thrown forwards by 2 m/s, the second pushes the third where that may not come nearer: 5 kg are thrown.
        let pushed = strike_at(Side::Lower);
        assert!(pushed.released.is_empty());
        assert_abs_diff_eq!(pushed.v[2], 0.0, epsilon = 1e-14);
        assert_abs_diff_eq!(pushed.impulse[1], 10.0, epsilon = 1e-13);
        assert_abs_diff_eq!(pushed.impulse[2], 6.0, epsilon = 1e-13);
        // Where it may come nearer but not go farther away, it stays behind: its limit cannot pull.
        let left = strike_at(Side::Upper);
        assert_eq!(left.released, [2]);
        assert_abs_diff_eq!(left.v[2], -2.0, epsilon = 1e-14);
        assert_abs_diff_eq!(left.impulse[2], 0.0, epsilon = 0.0);
        assert_abs_diff_eq!(left.impulse[1], 4.0, epsilon = 1e-13);
    }

    #[test]
    fn a_row_of_blocks_at_rest_keeps_what_touches_and_sheds_what_does_not() {
        // The first of five is stopped; each of the others rests at a limit of its distance from the one before. Those that
        // may not get farther away stop with it; the first that may goes on, and all behind it with it.
        let mut body = train(&[1.0; 5]);
        let v = [1.0, 0.0, 0.0, 0.0, 0.0];
        let held = [(1, Side::Upper), (2, Side::Upper), (3, Side::Lower), (4, Side::Upper)];
        let held = held.map(|(dof, side)| (dof, Wanted::Limit(side, 0.0)));
        let wanted = [&[(0, Wanted::Velocity(0.0))], &held[..]].concat();
        let struck = strike(&mut body, &[0.0; 5], &v, &[false; 5], &wanted).expect("finite");
        // The third gap opens: from there on they move on at 1 m/s.
        assert_eq!(struck.released, [3]);
        for (found, expected) in struck.v.iter().zip([0.0, 0.0, 0.0, 1.0, 0.0]) {
            assert_abs_diff_eq!(*found, expected, epsilon = 1e-13);
        }
        assert_abs_diff_eq!(struck.loss, 1.5, epsilon = 1e-13);
    }

    #[test]
    fn the_loss_is_the_difference_of_the_kinetic_energies() {
        let masses = [1.0, 2.0, 0.5];
        let mut body = train(&masses);
        let (q, v) = ([0.0; 3], [0.7, -1.1, 2.0]);
        let wanted = [(0, Wanted::Velocity(-0.3)), (2, Wanted::Limit(Side::Upper, 0.0))];
        let struck = strike(&mut body, &q, &v, &[false; 3], &wanted).expect("finite");
        let mut kinetic = |v: &[f64]| body.energy(&q, v).expect("finite").kinetic;
        assert_abs_diff_eq!(struck.loss, kinetic(&v) - kinetic(&struck.v), epsilon = 1e-13);
    }
}
