//! What is asked of a point and of the link that carries it.

use nalgebra::{Matrix3, Rotation3, Unit, UnitQuaternion, Vector3};
use solaris_dynamics::{Pose, Twist};

/// What is asked of a point of a figure, or of how the link that carries it is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Goal {
    /// The point is at a place (m, world).
    Place(Vector3<f64>),
    /// An axis of the link points from the point to a place. A place in the point itself lies in every direction.
    Look {
        /// The axis, in the link's frame.
        axis: Unit<Vector3<f64>>,
        /// The place (m, world).
        at: Vector3<f64>,
    },
    /// The link is turned against the world in this way: its axes into the world's.
    Turned(UnitQuaternion<f64>),
}

impl Goal {
    /// What is missing, in world axes: the way to the place (m), or the rotation vector (rad) that turns the link as it is to be turned,
    /// of all of those the shortest.
    ///
    /// ```text
    /// e = x* − x        e = θ·(u × d)/|u × d|, θ = ∠(u, d), d = (x* − x)/|x* − x|        e = log(R*·Rᵀ)
    /// ```
    pub(super) fn missing(&self, pose: &Pose<f64>) -> Vector3<f64> {
        match self {
            Self::Place(at) => at - pose.translation,
            Self::Look { axis, at } => {
                let along = pose.rotation * axis.into_inner();
                Unit::try_new(at - pose.translation, 0.0)
                    .map_or_else(Vector3::zeros, |to| between(&along, &to))
            }
            Self::Turned(turned) => {
                let left =
                    turned.to_rotation_matrix() * Rotation3::from_matrix_unchecked(pose.rotation).inverse();
                UnitQuaternion::from_rotation_matrix(&left).scaled_axis()
            }
        }
    }

    /// How fast a motion of the point's frame takes away what is missing: half the square of `e` changes by `−e·c`.
    ///
    /// ```text
    /// c = v        c = ω − u·(u·ω) + d × v/|x* − x|        c = ω
    /// ```
    pub(super) fn column(&self, pose: &Pose<f64>, motion: &Twist<f64>) -> Vector3<f64> {
        match self {
            Self::Place(_) => motion.linear,
            Self::Look { axis, at } => {
                let along = pose.rotation * axis.into_inner();
                let turning = motion.angular - along * along.dot(&motion.angular);
                let way = at - pose.translation;
                let square = way.norm_squared();
                if square > 0.0 { turning + way.cross(&motion.linear) / square } else { turning }
            }
            Self::Turned(_) => motion.angular,
        }
    }
}

/// The shortest rotation vector (rad) from one direction to another; of opposite ones any.
fn between(from: &Vector3<f64>, to: &Vector3<f64>) -> Vector3<f64> {
    let normal = from.cross(to);
    let (sine, cosine) = (normal.norm(), from.dot(to));
    let angle = sine.atan2(cosine);
    match Unit::try_new(normal, 0.0) {
        Some(axis) => axis.into_inner() * angle,
        None if cosine > 0.0 => Vector3::zeros(),
        None => {
            // Square to `from`, and to the axis that is farthest from it.
            let aside = Matrix3::identity().column(from.iamin()).cross(from);
            aside.normalize() * angle
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn posed(turned: UnitQuaternion<f64>, at: Vector3<f64>) -> Pose<f64> {
        Pose { rotation: turned.to_rotation_matrix().into_inner(), translation: at }
    }

    /// `d/dt ½e² = −e·c`, by differences, of a frame that turns and moves.
    #[test]
    fn columns_are_the_slopes_of_what_is_missing() {
        let turned = UnitQuaternion::from_euler_angles(0.3, -0.7, 1.1);
        let at = Vector3::new(0.2, 0.5, -0.1);
        let (linear, angular) = (Vector3::new(0.4, -0.2, 0.9), Vector3::new(-0.6, 0.8, 0.3));
        let axis = Unit::new_normalize(Vector3::new(0.1, 0.2, 1.0));
        for goal in [
            Goal::Place(Vector3::new(1.0, 0.1, 0.4)),
            Goal::Look { axis, at: Vector3::new(-0.7, 0.3, 0.8) },
            Goal::Turned(UnitQuaternion::from_euler_angles(-0.9, 0.2, 0.1)),
        ] {
            let after = |time: f64| {
                let turned = UnitQuaternion::from_scaled_axis(angular * time) * turned;
                0.5 * goal.missing(&posed(turned, at + linear * time)).norm_squared()
            };
            let slope = (after(1e-5) - after(-1e-5)) / 2e-5;
            let pose = posed(turned, at);
            let expected = -goal.missing(&pose).dot(&goal.column(&pose, &Twist { linear, angular }));
            assert!((slope - expected).abs() < 1e-8, "{goal:?}: {slope} {expected}");
        }
    }

    #[test]
    fn opposite_directions_are_half_a_turn_apart() {
        for from in [Vector3::x(), Vector3::y(), Vector3::new(0.6, 0.0, -0.8)] {
            let turn = between(&from, &-from);
            assert!((turn.norm() - std::f64::consts::PI).abs() < 1e-12 && turn.dot(&from).abs() < 1e-12);
            let turned = UnitQuaternion::from_scaled_axis(turn) * from;
            assert!((turned + from).norm() < 1e-12, "{turned}");
        }
        assert_eq!(between(&Vector3::y(), &Vector3::y()), Vector3::zeros());
    }
}
