//! Angular velocity and acceleration from a quaternion's rates.

use nalgebra::{Quaternion, UnitQuaternion, Vector3, Vector4};
use solaris_profiles::Boundary;

/// Least cosine of half the angle between neighbours: beyond 120° the shorter way is a guess.
const LEAST_COSINE: f64 = 0.5;
/// Least length that filtering may leave of a quaternion.
const LEAST_LENGTH: f64 = 0.5;

/// Gives the quaternions whose four components are `columns` unit length and signs that follow each other.
///
/// An error is the row of the first that turns too far from the one before it, and how far (degrees).
pub(super) fn align(columns: &mut [Vec<f64>]) -> Result<(), (usize, f64)> {
    let rows = columns[0].len();
    let mut before: Option<Vector4<f64>> = None;
    for row in 0..rows {
        let read = Vector4::from_fn(|i, _| columns[i][row]);
        let mut unit = read / read.norm();
        if let Some(before) = before {
            let cosine = before.dot(&unit);
            if cosine < 0.0 {
                unit = -unit;
            }
            // A quaternion without length has no cosine, and is caught as well.
            if cosine.is_nan() || cosine.abs() < LEAST_COSINE {
                return Err((row, 2.0 * cosine.abs().min(1.0).acos().to_degrees()));
            }
        }
        for i in 0..4 {
            columns[i][row] = unit[i];
        }
        before = Some(unit);
    }
    Ok(())
}

/// Orientation, angular velocity (rad/s) and angular acceleration (rad/s²) of a link, along its own axes.
pub(super) struct Turning {
    /// x, y, z, w, of unit length.
    pub(super) orientation: [f64; 4],
    rotation: UnitQuaternion<f64>,
    pub(super) velocity: Vector3<f64>,
    pub(super) acceleration: Vector3<f64>,
}

impl Turning {
    /// From the components (x, y, z, w) with their rates; `None` where hardly anything is left of the quaternion.
    ///
    /// With `q = √s·u` and `u` of unit length, `q̄⊗q̇ = s·ū⊗u̇ + ṡ/2`, whose vector is `s·ω/2`; once more,
    /// `vec(q̄⊗q̈) = d(s·ω/2)/dt`, because `q̇̄⊗q̇` has no vector.
    pub(super) fn new(components: [Boundary; 4]) -> Option<Self> {
        let read = |part: fn(&Boundary) -> f64| {
            let [x, y, z, w] = components.each_ref().map(part);
            Quaternion::new(w, x, y, z)
        };
        let (q, rate, second) = (read(|c| c.position), read(|c| c.velocity), read(|c| c.acceleration));
        let s = q.norm_squared();
        let has_length = s >= LEAST_LENGTH * LEAST_LENGTH;
        let velocity = (q.conjugate() * rate).imag() * (2.0 / s);
        let stretch = 2.0 * q.coords.dot(&rate.coords) / s;
        let acceleration = (q.conjugate() * second).imag() * (2.0 / s) - velocity * stretch;
        let rotation = UnitQuaternion::new_normalize(q);
        let orientation = rotation.coords.into();
        has_length.then_some(Self { orientation, rotation, velocity, acceleration })
    }

    /// Velocity (m/s) of the link's origin along its axes, and the rate of these numbers (m/s²), from its place in the
    /// joint's frame with its rates.
    pub(super) fn slide(&self, place: [Boundary; 3]) -> [Vector3<f64>; 2] {
        let enter = |part: fn(&Boundary) -> f64| {
            self.rotation.inverse_transform_vector(&Vector3::from(place.each_ref().map(part)))
        };
        let velocity = enter(|c| c.velocity);
        [velocity, enter(|c| c.acceleration) - self.velocity.cross(&velocity)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// `θ = t + t²` about z, with a length of `1 + 0.3 t` that is no part of the turn, at half a second.
    #[test]
    fn a_length_that_changes_turns_nothing() {
        let (length, growth, half, rate) = (1.15, 0.3, 0.375_f64, 1.0);
        let (s, c) = half.sin_cos();
        let z = Boundary::new(
            length * s,
            growth * s + length * rate * c,
            2.0 * growth * rate * c + length * (c - rate * rate * s),
        );
        let w = Boundary::new(
            length * c,
            growth * c - length * rate * s,
            -2.0 * growth * rate * s - length * (s + rate * rate * c),
        );
        let zero = Boundary::rest(0.0);
        let turning = Turning::new([zero, zero, z, w]).expect("a length");
        assert_relative_eq!(turning.velocity, Vector3::z() * 2.0, epsilon = 1e-14);
        assert_relative_eq!(turning.acceleration, Vector3::z() * 2.0, epsilon = 1e-14);
        assert!(Turning::new([zero; 4]).is_none());
    }
}
