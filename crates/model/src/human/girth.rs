//! Girths of a person's drawn segments: as their mass and the density of tissue say.

use crate::inertia::ShapeKind;
use nalgebra::Vector3;

/// How much of a heavier trunk's cross-section is breadth; the rest is depth.
///
/// Of 4082 men (ANSUR II) the breadths of chest, hips and waist go with the mass to the powers 0.27, 0.36 and 0.62 at the same
/// height, the depths to 0.61, 0.65 and 0.85: about as one to two.
const BREADTH_SHARE: f64 = 1.0 / 3.0;

/// The semi-axes of an upright ellipsoid of this `volume` (m³) that is as high as the one with these `radii` (m).
pub(super) fn ellipsoid(radii: Vector3<f64>, volume: f64) -> Vector3<f64> {
    let fuller = volume / (ShapeKind::Ellipsoid { radii }).volume();
    let (breadth, depth) = (fuller.powf(BREADTH_SHARE), fuller.powf(1.0 - BREADTH_SHARE));
    radii.component_mul(&Vector3::new(breadth, 1.0, depth))
}

/// The radius (m) of a capsule of this `volume` (m³) whose half spheres' centres are `length` (m) apart:
///
/// ```text
/// π·r²·(L + 4/3·r) = V
/// ```
pub(super) fn capsule(length: f64, volume: f64) -> f64 {
    let area = volume / std::f64::consts::PI;
    // Newton's iteration from the cylinder's radius comes down upon the root of a convex function: it cannot miss it.
    let mut radius = (area / length).sqrt();
    for _ in 0..60 {
        let excess = radius * radius * (length + 4.0 / 3.0 * radius) - area;
        let step = excess / (radius * (2.0 * length + 4.0 * radius));
        radius -= step;
        if step <= 1e-15 * radius {
            break;
        }
    }
    radius
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_capsule_holds_what_it_is_asked_to() {
        // A cylinder of 1 m and a sphere, both of radius 0.1 m.
        let volume = std::f64::consts::PI * 0.01 * (1.0 + 0.4 / 3.0);
        assert!((capsule(1.0, volume) - 0.1).abs() < 1e-15);
        // Hardly longer than wide, and a thread.
        for (length, volume) in [(1e-3, 1.0), (1.0, 1e-9)] {
            let radius = capsule(length, volume);
            let held = (ShapeKind::Capsule { radius, length }).volume();
            assert!((held / volume - 1.0).abs() < 1e-12, "{length} m: {held} m³");
        }
    }

    #[test]
    fn eight_times_the_volume_is_twice_as_broad_and_four_times_as_deep() {
        let slim = Vector3::new(0.1, 0.2, 0.1);
        let full = ellipsoid(slim, 8.0 * (ShapeKind::Ellipsoid { radii: slim }).volume());
        assert!((full - Vector3::new(0.2, 0.2, 0.4)).norm() < 1e-15);
    }
}
