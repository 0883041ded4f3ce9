//! How legs reach: the body is lowered in time where one would be too short.

use super::Step;
use crate::live::paces::Paces;
use nalgebra::Vector3;
use solaris_profiles::step;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// The knee for which the body is lowered.
const KNEE: f64 = 4.0 * DEGREE;
/// Number of hats by which it is, over a step, and of the instants that are looked at for each.
pub(super) const HATS: usize = 8;
const INSTANTS: usize = 4;
/// Hats before and after, over which it comes and goes.
const SOFTLY: f64 = 3.0;
/// The last part of a swing, in which the body is lowered for it.
const LANDS: f64 = 0.15;

impl Step {
    /// By how much the body is lowered (m).
    pub(super) fn lowering(&self, t: f64) -> f64 {
        let x = (t / self.beat.time).clamp(0.0, 1.0) * (HATS - 1) as f64;
        let first = (x as usize).min(HATS - 2);
        let s = x - first as f64;
        let left = 1.0 - s;
        // Cardinal cubic B-splines, of which the first two stay at zero and the last ones are mirrored: it begins and ends at rest.
        let weights =
            [left.powi(3), 4.0 - 3.0 * s * s * (1.0 + left), 4.0 - 3.0 * left * left * (1.0 + s), s.powi(3)];
        let hat = |k: usize| self.lowered[k.min(2 * (HATS - 1) - k)];
        let before = first.checked_sub(1).map_or(0.0, hat);
        let hats = [before, hat(first), hat(first + 1), hat(first + 2)];
        weights.iter().zip(hats).map(|(weight, hat)| weight * hat).sum::<f64>() / 6.0
    }

    /// Lowers the body where a leg on the ground, or one that is about to land, would be too short.
    pub(super) fn lower(&mut self, paces: &Paces) {
        let beat = self.beat;
        let samples = INSTANTS * (HATS - 1);
        let mut needs = [0.0_f64; HATS];
        for i in 1..=samples {
            let t = beat.time * i as f64 / samples as f64;
            let hips = self.hips(paces, t).1;
            let mut need = 0.0_f64;
            for side in [0, 1] {
                let swings = beat.walks() && side == beat.trailing() && t > beat.lift;
                if swings && t < beat.time - LANDS * (beat.time - beat.lift) {
                    continue;
                }
                let print = &beat.feet[side].print;
                let hip = print.local(side, &hips[side]);
                let ankle = if swings {
                    let [x, y, z, ..] = self.swung_in(paces, t);
                    Vector3::new(x, y, z)
                } else {
                    self.grounded(paces, side, t, &hip).0
                };
                need = need.max(above(paces, &(hip - ankle), KNEE));
            }
            let at = i as f64 / INSTANTS as f64;
            // In full next to it, and before and after it in part, so that the body goes down and up softly.
            for (k, hat) in needs.iter_mut().enumerate().skip(2) {
                let apart = ((at - k as f64).abs() - 1.0) / SOFTLY;
                *hat = hat.max(need * (1.0 - step::cubic(apart).position));
            }
        }
        self.lowered = needs;
    }
}

/// How far a hip is above the height at which its knee is so bent (m).
pub(super) fn above(paces: &Paces, hip: &Vector3<f64>, knee: f64) -> f64 {
    let left = paces.body.leg.reach_squared(knee) - hip.x * hip.x - hip.z * hip.z;
    hip.y - left.max(0.01).sqrt()
}
