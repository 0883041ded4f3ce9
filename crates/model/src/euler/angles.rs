//! The conversion of rotations to Euler angles and back.
//!
//! With `ε` the sense of the order and the quaternion `(q_i, q_j, q_k, w)` along its axes,
//!
//! ```text
//! w − q_j = (cos b/2 − sin b/2)·cos D     q_i − ε q_k = (cos b/2 − sin b/2)·sin D     D = (a − ε c)/2
//! w + q_j = (cos b/2 + sin b/2)·cos S     q_i + ε q_k = (cos b/2 + sin b/2)·sin S     S = (a + ε c)/2
//! ```
//!
//! Near gimbal lock one of the two pairs is small and its angle uncertain, but then the rotation hardly depends on it; the
//! other pair is large, and its angle is all that is left of `a` and `c`. So what rounding leaves always turns back into
//! the same rotation.

use super::EulerOrder;
use nalgebra::{Rotation3, UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

impl EulerOrder {
    /// The rotation of these angles (rad) in order.
    ///
    /// ```
    /// use solaris_model::{EulerOrder, Vector3};
    /// // Z-Y-X: the turn about x acts on the link first, the one about z last.
    /// let turned = EulerOrder::Zyx.rotation(&[std::f64::consts::FRAC_PI_2, 0.0, std::f64::consts::FRAC_PI_2]) * Vector3::y();
    /// assert!((turned - Vector3::z()).norm() < 1e-15);
    /// ```
    pub fn rotation(self, angles: &[f64; 3]) -> UnitQuaternion<f64> {
        let [i, j, k] = self.axes().map(Vector3::ith_axis);
        let turn = |axis, angle: f64| UnitQuaternion::from_axis_angle(&axis, angle);
        turn(i, angles[0]) * turn(j, angles[1]) * turn(k, angles[2])
    }

    /// The angles (rad) of a rotation: the first and the last in (−π, π], the middle one in [−π/2, π/2].
    ///
    /// In gimbal lock, within 1e-15 rad, the last angle is 0.
    pub fn angles(self, rotation: &UnitQuaternion<f64>) -> [f64; 3] {
        let parts = self.parts(rotation);
        let (sum, difference) = match parts.lock {
            Some(Lock::Upper) => (parts.sum, parts.sum),
            Some(Lock::Lower) => (parts.difference, parts.difference),
            None => (parts.sum, parts.difference),
        };
        let wrap = |angle: f64| {
            let wrapped = nearest(angle, 0.0, TAU);
            if wrapped <= -PI { wrapped + TAU } else { wrapped }
        };
        [wrap(sum + difference), parts.middle, wrap(self.sense() * (sum - difference))]
    }

    /// The angles (rad) of a rotation matrix: [`EulerOrder::angles`] of its quaternion.
    pub fn angles_of_matrix(self, rotation: &Rotation3<f64>) -> [f64; 3] {
        self.angles(&UnitQuaternion::from_rotation_matrix(rotation))
    }

    /// The angles (rad) of a rotation that are nearest to others, such as those a moment ago: whole turns are added, and
    /// the middle angle passes ±π/2 where that is nearer.
    ///
    /// In gimbal lock, within 1e-15 rad, the angle that means nothing stays as it is in `near`. Angles that follow a motion this
    /// way run on without a jump.
    pub fn angles_near(self, rotation: &UnitQuaternion<f64>, near: &[f64; 3]) -> [f64; 3] {
        let (parts, sense) = (self.parts(rotation), self.sense());
        let (sum, difference) =
            (f64::midpoint(near[0], sense * near[2]), f64::midpoint(near[0], -sense * near[2]));
        // In lock both solutions below are the same rotations; half turns of the sum or difference are whole turns of it.
        let (sum, difference) = match parts.lock {
            Some(Lock::Upper) => (nearest(parts.sum, sum, PI), difference),
            Some(Lock::Lower) => (sum, nearest(parts.difference, difference, PI)),
            None => (parts.sum, parts.difference),
        };
        let first = [sum + difference, parts.middle, sense * (sum - difference)];
        let second = [first[0] + PI, PI - first[1], first[2] + PI];
        let [first, second] = [first, second].map(|angles| {
            let angles: [f64; 3] = std::array::from_fn(|i| nearest(angles[i], near[i], TAU));
            (angles, (0..3).map(|i| (angles[i] - near[i]).powi(2)).sum::<f64>())
        });
        if second.1 < first.1 { second.0 } else { first.0 }
    }

    fn parts(self, rotation: &UnitQuaternion<f64>) -> Parts {
        let (q, e) = (rotation.quaternion(), self.sense());
        let [i, j, k] = self.axes().map(|axis| q.coords[axis]);
        let (lower, upper) = ([q.w - j, i - e * k], [q.w + j, i + e * k]);
        let (small, large) = (lower[0].hypot(lower[1]), upper[0].hypot(upper[1]));
        // sin b from the products, cos b from the lengths: each is exact where the other is near 1.
        let middle = (2.0 * (q.w * j + e * i * k)).atan2(small * large);
        let lock = match (small <= LOCK, large <= LOCK) {
            (true, _) => Some(Lock::Upper),
            (_, true) => Some(Lock::Lower),
            _ => None,
        };
        let angle = |[cosine, sine]: [f64; 2]| sine.atan2(cosine);
        Parts {
            sum: angle(upper),
            difference: angle(lower),
            middle: middle.clamp(-FRAC_PI_2, FRAC_PI_2),
            lock,
        }
    }
}

/// A pair shorter than this (√2/2 of the distance to lock) is rounding.
const LOCK: f64 = 4.0 * f64::EPSILON;

/// The middle angle at +π/2 or −π/2.
#[derive(Clone, Copy)]
enum Lock {
    Upper,
    Lower,
}

/// What a rotation says of its angles, see the [module](self).
struct Parts {
    /// `S`
    sum: f64,
    /// `D`
    difference: f64,
    /// `b`
    middle: f64,
    lock: Option<Lock>,
}

/// The angle that differs from `angle` by whole `turns` and is nearest to `near`.
fn nearest(angle: f64, near: f64, turn: f64) -> f64 {
    angle - turn * ((angle - near) / turn).round()
}
