//! MuJoCo's numbers for states and forces, and ours.
//!
//! They differ for ball and free joints alone. With `R` the orientation of the link (from its quaternion) and `ω` its
//! angular velocity along its own axes, which both have:
//!
//! ```text
//!                    MuJoCo                     here
//! position           px py pz | qw qx qy qz     px py pz | qx qy qz qw
//! velocity           v_world  | ω               v = Rᵀ·v_world            | ω
//! acceleration       a_world  | ω̇               a = Rᵀ·a_world − ω × v    | ω̇
//! force              f_world  | moment          f = Rᵀ·f_world            | moment
//! ```
//!
//! MuJoCo's `v_world` is the velocity of the body's origin, as here, and `a_world` its rate of change; the term `ω × v`
//! is that of the turning axes. Hinges and slides are copied. The order is that of the figure that [`super::read`] makes,
//! which is MuJoCo's.

use super::orientation::wxyz;
use solaris_model::{Figure, JointKind, Vector3};

/// Positions, velocities, accelerations.
type State = (Vec<f64>, Vec<f64>, Vec<f64>);

/// Why a state of MuJoCo is none of a figure.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum StateError {
    /// A slice of the wrong length.
    #[error("{what} has {found} numbers; for this figure it must have {expected}")]
    Length {
        /// Which slice.
        what: &'static str,
        /// Numbers that it has.
        found: usize,
        /// Numbers that it must have.
        expected: usize,
    },
    /// A quaternion that is no rotation.
    #[error("the quaternion of joint '{joint}' has no length")]
    Quaternion {
        /// The joint.
        joint: String,
    },
}

/// `q`, `v`, `a` of `qpos` (length nq), `qvel`, `qacc` (length nv): see the table above. Quaternions get unit length.
///
/// # Errors
///
/// [`StateError`] for wrong lengths and quaternions of length zero.
pub fn state_from_mujoco(
    figure: &Figure,
    qpos: &[f64],
    qvel: &[f64],
    qacc: &[f64],
) -> Result<State, StateError> {
    check_all(figure, [("qpos", qpos), ("qvel", qvel), ("qacc", qacc)])?;
    let (mut q, mut v, mut a) = (qpos.to_vec(), qvel.to_vec(), qacc.to_vec());
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        let Some(first) = link.joint().kind().quaternion() else { continue };
        let parts = &qpos[at.q + first..][..4];
        let turn =
            wxyz(parts).ok_or_else(|| StateError::Quaternion { joint: link.joint().name().to_owned() })?;
        q[at.q + first..][..4].copy_from_slice(turn.coords.as_slice());
        if matches!(link.joint().kind(), JointKind::Free { .. }) {
            let omega = three(&qvel[at.v + 3..]);
            let velocity = turn.inverse() * three(&qvel[at.v..]);
            let acceleration = turn.inverse() * three(&qacc[at.v..]) - omega.cross(&velocity);
            v[at.v..][..3].copy_from_slice(velocity.as_slice());
            a[at.v..][..3].copy_from_slice(acceleration.as_slice());
        }
    }
    Ok((q, v, a))
}

/// `qpos`, `qvel`, `qacc` of `q`, `v`, `a`: [`state_from_mujoco`] turned round.
///
/// # Errors
///
/// As [`state_from_mujoco`].
pub fn state_to_mujoco(figure: &Figure, q: &[f64], v: &[f64], a: &[f64]) -> Result<State, StateError> {
    check_all(figure, [("q", q), ("v", v), ("a", a)])?;
    let (mut qpos, mut qvel, mut qacc) = (q.to_vec(), v.to_vec(), a.to_vec());
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        let Some(first) = link.joint().kind().quaternion() else { continue };
        let [x, y, z, w] = [0, 1, 2, 3].map(|i| q[at.q + first + i]);
        let turn = wxyz(&[w, x, y, z])
            .ok_or_else(|| StateError::Quaternion { joint: link.joint().name().to_owned() })?;
        let [x, y, z, w] = [0, 1, 2, 3].map(|i| turn.coords[i]);
        qpos[at.q + first..][..4].copy_from_slice(&[w, x, y, z]);
        if matches!(link.joint().kind(), JointKind::Free { .. }) {
            let (velocity, omega) = (three(&v[at.v..]), three(&v[at.v + 3..]));
            let acceleration = three(&a[at.v..]) + omega.cross(&velocity);
            qvel[at.v..][..3].copy_from_slice((turn * velocity).as_slice());
            qacc[at.v..][..3].copy_from_slice((turn * acceleration).as_slice());
        }
    }
    Ok((qpos, qvel, qacc))
}

/// Generalized forces along our coordinates, of those along MuJoCo's (length nv) in the position `q` of ours.
///
/// # Errors
///
/// As [`state_from_mujoco`].
pub fn forces_from_mujoco(figure: &Figure, q: &[f64], forces: &[f64]) -> Result<Vec<f64>, StateError> {
    turned(figure, q, forces, true)
}

/// Generalized forces along MuJoCo's coordinates, of those along ours (length nv) in the position `q` of ours.
///
/// # Errors
///
/// As [`state_from_mujoco`].
pub fn forces_to_mujoco(figure: &Figure, q: &[f64], tau: &[f64]) -> Result<Vec<f64>, StateError> {
    turned(figure, q, tau, false)
}

fn turned(figure: &Figure, q: &[f64], forces: &[f64], into_link: bool) -> Result<Vec<f64>, StateError> {
    check("q", q, figure.layout().nq())?;
    check("forces", forces, figure.layout().nv())?;
    let mut out = forces.to_vec();
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        if !matches!(link.joint().kind(), JointKind::Free { .. }) {
            continue;
        }
        let [x, y, z, w] = [3, 4, 5, 6].map(|i| q[at.q + i]);
        let turn = wxyz(&[w, x, y, z])
            .ok_or_else(|| StateError::Quaternion { joint: link.joint().name().to_owned() })?;
        let turn = if into_link { turn.inverse() } else { turn };
        out[at.v..][..3].copy_from_slice((turn * three(&forces[at.v..])).as_slice());
    }
    Ok(out)
}

fn check_all(figure: &Figure, [q, v, a]: [(&'static str, &[f64]); 3]) -> Result<(), StateError> {
    check(q.0, q.1, figure.layout().nq())?;
    check(v.0, v.1, figure.layout().nv())?;
    check(a.0, a.1, figure.layout().nv())
}

fn check(what: &'static str, values: &[f64], expected: usize) -> Result<(), StateError> {
    if values.len() == expected {
        Ok(())
    } else {
        Err(StateError::Length { what, found: values.len(), expected })
    }
}

fn three(values: &[f64]) -> Vector3<f64> {
    Vector3::new(values[0], values[1], values[2])
}
