//! Springs, dampers and dry friction in the joints.

use nalgebra::Vector3;
use solaris_model::{Figure, JointKind, Passive};

/// Adds to `tau` (N m or N, length `nv`) what a motion needs against the springs, dampers and friction of the joints.
///
/// ```text
/// τ += k·(q − rest) + d·v + f·sign(v)        sign(0) = 0
/// ```
///
/// on every one-axis degree of freedom at `q` (rad or m, length `nq`) and `v` (rad/s or m/s, length `nv`). On a ball
/// joint the spring acts on the rotation vector of the shortest way from the neutral orientation, `τ = k·φ`, whose
/// potential is `k·|φ|²/2`; its `rest` is not used. Damper and friction of ball and free joints act on each velocity; a
/// free joint has no spring.
///
/// # Panics
///
/// Where a slice is shorter than that.
///
/// # Examples
///
/// ```
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Passive};
///
/// let acts = Passive { stiffness: 10.0, rest: 0.1, damping: 2.0, friction: 0.5 };
/// let door = LinkSpec::root("door", Joint::new("hinge").rz().passive(acts)).mass(20.0);
/// let figure = FigureBuilder::new("room").link(door).build()?;
/// let mut tau = [1.0];
/// solaris_modes::add_passive_forces(&figure, &[0.3], &[-0.2], &mut tau);
/// assert!((tau[0] - (1.0 + 10.0 * 0.2 - 2.0 * 0.2 - 0.5)).abs() < 1e-15);
/// # Ok::<(), solaris_model::FigureError>(())
/// ```
pub fn add_passive_forces(figure: &Figure, q: &[f64], v: &[f64], tau: &mut [f64]) {
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        let kind = link.joint().kind();
        for i in 0..at.nv {
            let acts = kind.passive(i);
            if acts.is_none() {
                continue;
            }
            let (rate, force) = (v[at.v + i], &mut tau[at.v + i]);
            *force += acts.damping * rate + friction(acts, rate);
            if !kind.axes().is_empty() {
                *force += acts.stiffness * (q[at.q + i] - acts.rest);
            }
        }
        if let JointKind::Ball { passive, .. } = kind
            && passive.stiffness != 0.0
        {
            let turn = rotation_vector(&q[at.q..at.q + 4]);
            for (force, turn) in tau[at.v..at.v + 3].iter_mut().zip(turn.iter()) {
                *force += passive.stiffness * turn;
            }
        }
    }
}

/// Dry friction has a direction only where something slides; rest needs none of it.
fn friction(acts: &Passive, rate: f64) -> f64 {
    if rate == 0.0 { 0.0 } else { acts.friction.copysign(acts.friction * rate) }
}

/// The rotation vector (rad) of a quaternion (x, y, z, w) of any length, the shortest way.
fn rotation_vector(q: &[f64]) -> Vector3<f64> {
    let imaginary = Vector3::new(q[0], q[1], q[2]) * if q[3] < 0.0 { -1.0 } else { 1.0 };
    let sine = imaginary.norm();
    // Near zero the angle is twice the sine over the cosine.
    if sine == 0.0 { Vector3::zeros() } else { imaginary * (2.0 * sine.atan2(q[3].abs()) / sine) }
}
