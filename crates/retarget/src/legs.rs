//! The inverse kinematics of a leg: two bones that bring the ankle to a place.

use crate::align::between;
use solaris_model::{UnitQuaternion, Vector3};

/// How a leg is turned, in the world: first its shank about the knee, then all of it about the hip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bent {
    pub(crate) knee: UnitQuaternion<f64>,
    pub(crate) hip: UnitQuaternion<f64>,
}

/// Brings the ankle to `ankle` (m, from the hip).
///
/// With `a` the thigh and `b` the shank (m) as they point now, turned by φ about the unit axis `n` of the knee, the ankle is so far from the hip
/// that
///
/// ```text
/// |a + R(n, φ)·b|² = a² + b² + 2(a∥·b∥) + 2(a·b⊥) cos φ + 2(a·(n × b)) sin φ
/// ```
///
/// of which the solution is taken in which the knee is bent forward (positive about `n`); where the ankle is farther than the leg is long, or
/// nearer than it can bend, the nearest that it reaches. Then the shortest turn about the hip brings the ankle's direction to the one asked for.
pub(crate) fn bend(a: &Vector3<f64>, b: &Vector3<f64>, n: &Vector3<f64>, ankle: &Vector3<f64>) -> Bent {
    let along = n * n.dot(b);
    let across = b - along;
    let constant = a.norm_squared() + b.norm_squared() + 2.0 * a.dot(&along);
    let (cosine, sine) = (2.0 * a.dot(&across), 2.0 * a.dot(&n.cross(&across)));
    let (size, straight) = (cosine.hypot(sine), sine.atan2(cosine));
    let knee = if size > 1e-300 {
        let bent = ((ankle.norm_squared() - constant) / size).clamp(-1.0, 1.0).acos();
        straight + bent
    } else {
        0.0
    };
    let knee = UnitQuaternion::from_scaled_axis(n * knee);
    let hip = between(&(a + knee * b), ankle);
    Bent { knee, hip }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ankle_comes_to_its_place_with_the_knee_forward() {
        let (a, b) = (Vector3::new(0.01, -0.4, 0.1), Vector3::new(0.0, -0.38, -0.1));
        for ankle in
            [Vector3::new(0.0, -0.7, 0.1), Vector3::new(0.1, -0.5, 0.3), Vector3::new(0.0, -0.75, -0.2)]
        {
            let Bent { knee, hip } = bend(&a, &b, &Vector3::x(), &ankle);
            let (thigh, shank) = (hip * a, hip * (knee * b));
            assert!((thigh + shank - ankle).norm() < 1e-12, "{ankle}");
            // The knee is in front of the line from hip to ankle.
            assert!(thigh.cross(&ankle).dot(&(hip * Vector3::x())) > 0.0, "{thigh} {ankle}");
        }
    }

    #[test]
    fn a_leg_that_is_where_it_should_be_stays() {
        let (a, b) = (Vector3::new(0.02, -0.4, 0.1), Vector3::new(0.0, -0.38, -0.2));
        let Bent { knee, hip } = bend(&a, &b, &Vector3::x(), &(a + b));
        assert!(knee.angle() < 1e-7 && hip.angle() < 1e-7, "{} {}", knee.angle(), hip.angle());
    }

    #[test]
    fn what_is_too_far_is_reached_for_with_a_straight_leg() {
        let (a, b) = (Vector3::new(0.0, -0.4, 0.1), Vector3::new(0.0, -0.4, -0.1));
        let far = Vector3::new(0.0, -2.0, 1.0);
        let Bent { knee, hip } = bend(&a, &b, &Vector3::x(), &far);
        let reached = hip * (a + knee * b);
        assert!((reached.norm() - a.norm() - b.norm()).abs() < 1e-12 && reached.angle(&far) < 1e-7);
    }
}
