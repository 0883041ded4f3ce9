//! The standing leg at midstance: as the hip passes over its ankle.

use crate::body::LegGeometry;
use crate::limbs::stance::Stance;
use nalgebra::Vector3;

/// When the hip passes over the ankle of a flat foot, and how far it is then above the height at which the shank's pitch is χ (m):
///
/// ```text
/// h² = (√(L1² − L2² sin² χ) + L2 cos χ)² − (D·s)²      D = hip − ankle
/// ```
///
/// Where it does not pass between the two clocks, it is taken at the one that is nearer.
pub(crate) fn above_flexion(
    leg: &LegGeometry,
    stance: &Stance,
    flexion: f64,
    (mut from, mut to): (f64, f64),
    hip: impl Fn(f64) -> Vector3<f64>,
) -> (f64, f64) {
    let split = |u: f64| stance.plane.split(&(hip(u) - stance.flat_ankle()));
    let ahead = |u: f64| split(u)[2];
    if ahead(from) > 0.0 || ahead(to) < 0.0 {
        (from, to) = if ahead(from) > 0.0 { (from, from) } else { (to, to) };
    }
    for _ in 0..40 {
        let middle = 0.5 * (from + to);
        if ahead(middle) < 0.0 {
            from = middle;
        } else {
            to = middle;
        }
    }
    let midstance = 0.5 * (from + to);
    let [side, up, _] = split(midstance);
    let (sin, cos) = flexion.sin_cos();
    let (thigh, shank) = (leg.thigh, leg.shank);
    let level = (thigh * thigh - (shank * sin).powi(2)).max(0.0).sqrt() + shank * cos;
    (midstance, up - (level * level - side * side).max(0.0).sqrt())
}
