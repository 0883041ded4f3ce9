//! Round cones, drawn out along their axes: balls, ellipsoids, capsules, tapered limbs.

use super::{Bounds, Sample};
use nalgebra::Vector3;

/// Two balls about the origin and `(0, length, 0)` and the cone that touches both, then stretched.
#[derive(Clone, Debug)]
pub(crate) struct Cone {
    near: f64,
    far: f64,
    length: f64,
    /// How far along the axis the nearest place is for a step away from it: the tangent of the cone's half angle.
    lean: f64,
    stretch: Vector3<f64>,
    /// Least stretch: with it the value is never more than the distance.
    least: f64,
    /// The least stretch over each.
    shrink: Vector3<f64>,
}

/// The steepest cone, as the sine of its half angle.
const STEEPEST: f64 = 0.95;

impl Cone {
    /// Radii (m) at the origin and at `length` (m) along y.
    pub(crate) fn new(near: f64, far: f64, length: f64) -> Self {
        let sine = ((near - far) / length.max(1e-9)).clamp(-STEEPEST, STEEPEST);
        let one = Vector3::repeat(1.0);
        Self {
            near,
            far,
            length,
            lean: sine / (1.0 - sine * sine).sqrt(),
            stretch: one,
            least: 1.0,
            shrink: one,
        }
    }

    /// An ellipsoid with these semi-axes (m).
    pub(crate) fn ellipsoid(radii: Vector3<f64>) -> Self {
        let least = radii.min();
        let shrink = radii.map(|radius| least / radius);
        Self { near: 1.0, far: 1.0, length: 0.0, lean: 0.0, stretch: radii, least, shrink }
    }

    /// The box around all points whose values are not above `value` (m).
    pub(super) fn within(&self, value: f64) -> Bounds {
        let end = Vector3::new(0.0, self.length, 0.0);
        let more = value / self.least;
        let Bounds(low, high) = Bounds::around([Vector3::zeros()], self.near + more);
        let Bounds(low2, high2) = Bounds::around([end], self.far + more);
        Bounds(low.inf(&low2).component_mul(&self.stretch), high.sup(&high2).component_mul(&self.stretch))
    }

    pub(super) fn sample(&self, p: &Vector3<f64>) -> Sample {
        let mut away = p.component_div(&self.stretch);
        let mut radius = self.near;
        if self.length > 0.0 {
            // In the plane of the axis and the point: the nearest place on the axis, moved along by the cone's slope.
            let along = away.y + (away.x * away.x + away.z * away.z).sqrt() * self.lean;
            let centre = along.clamp(0.0, self.length);
            radius += (self.far - self.near) * (centre / self.length);
            away.y -= centre;
        }
        let distance = away.norm();
        let gradient = away.component_mul(&self.shrink) / distance.max(1e-12);
        (self.least * (distance - radius), gradient)
    }
}
