//! Springs, dampers and dry friction in the joints.

use solaris_model::{Figure, JointKind, Passive};
use solaris_scalar::Elementary;
use std::f64::consts::FRAC_PI_2;

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
/// solaris_dynamics::add_passive_forces(&figure, &[0.3], &[-0.2], &mut tau);
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
            for (force, turn) in tau[at.v..at.v + 3].iter_mut().zip(turn) {
                *force += passive.stiffness * turn;
            }
        }
    }
}

/// Dry friction has a direction only where something slides; rest needs none of it.
fn friction(acts: &Passive, rate: f64) -> f64 {
    if rate == 0.0 { 0.0 } else { acts.friction.copysign(acts.friction * rate) }
}

/// The rotation vector (rad) of a quaternion (x, y, z, w) of any length, the shortest way; zero for a quaternion of zeros.
///
/// Derivatives of the scalar are right everywhere but at half a turn, where the vector jumps.
pub fn rotation_vector<T: Elementary>(q: &[T]) -> [T; 3] {
    let number = T::from_f64;
    let sign = if q[3].value() < 0.0 { number(-1.0) } else { number(1.0) };
    let (imaginary, cosine) = ([q[0] * sign, q[1] * sign, q[2] * sign], q[3] * sign);
    let squared = |u: &[T; 3]| u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
    let scale = imaginary.iter().fold(0.0_f64, |most, x| most.max(x.value().abs()));
    if scale < 0.02 * cosine.value() {
        // φ = 2·u·atan(|u|)/|u| with u = sin/cos, by its series: near zero |u| has no derivatives.
        let u = imaginary.map(|x| x / cosine);
        let t = squared(&u);
        let series = [-1.0 / 11.0, 1.0 / 9.0, -1.0 / 7.0, 0.2, -1.0 / 3.0, 1.0];
        let factor = series.into_iter().fold(number(0.0), |sum, c| sum * t + number(c));
        return u.map(|x| number(2.0) * x * factor);
    }
    if scale == 0.0 {
        // Zeros, or what is no number.
        return imaginary;
    }
    let (u, cosine) = (imaginary.map(|x| x / number(scale)), cosine / number(scale));
    let sine = squared(&u).sqrt();
    let half = if cosine.value() < sine.value() {
        number(FRAC_PI_2) - (cosine / sine).atan()
    } else {
        (sine / cosine).atan()
    };
    u.map(|x| number(2.0) * half * x / sine)
}

#[cfg(test)]
mod tests {
    use super::rotation_vector;
    use approx::assert_relative_eq;
    use solaris_model::{UnitQuaternion, Vector3};
    use solaris_scalar::Dual;

    #[test]
    fn a_rotation_vector_is_found_again() {
        let axis = Vector3::new(0.48, -0.6, 0.64);
        // About where the series ends, at 0.04 rad along an axis, too.
        for angle in [0.0, 1e-9, 0.01, 0.06, 0.062, 0.0625, 0.063, 0.07, 1.0, 1.57, 1.58, 3.0, 3.1] {
            let turn = axis * angle;
            let quaternion = UnitQuaternion::new(turn).coords;
            for scale in [1.0, -1.0, 1e-100, 1e100] {
                let found = rotation_vector((quaternion * scale).as_slice());
                for (found, expected) in found.iter().zip(&turn) {
                    assert_relative_eq!(found, expected, max_relative = 4e-15, epsilon = 1e-300);
                }
            }
        }
        assert_relative_eq!(
            rotation_vector(&[1e-200, 0.0, 0.0, -1.0])[0],
            -2e-200,
            max_relative = 1e-15,
            epsilon = 0.0
        );
        assert!(rotation_vector(&[0.0_f64; 4]).iter().all(|x| x.abs() < 1e-300));
        assert!(rotation_vector(&[f64::NAN; 4]).iter().all(|x| x.is_nan()));
    }

    #[test]
    fn a_rotation_vector_has_derivatives_where_there_is_no_turn() {
        let q = [0.0, 0.0, 0.0, 1.0];
        let dual: Vec<Dual<4>> = q.iter().enumerate().map(|(i, x)| Dual::variable(*x, i)).collect();
        for (row, found) in rotation_vector(&dual).iter().enumerate() {
            for column in 0..4 {
                let expected = if row == column { 2.0 } else { 0.0 };
                assert_relative_eq!(found.partial(column), expected);
            }
        }
    }
}
