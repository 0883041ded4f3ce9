//! The legs of a plan at its nodes: how straight, how low, how far too short they are.

use super::plan::WalkPlan;
use crate::body::leg::LegPose;
use nalgebra::Vector3;

/// What the legs do in a plan, at its nodes.
pub(crate) struct LegsCheck {
    /// Least knee flexion (rad), and its clock.
    pub(crate) least_knee: (f64, f64),
    /// Lowest point of a foot over the ground (m), and its clock.
    pub(crate) lowest: (f64, f64),
    /// Greatest distance by which a leg is too short for its planted foot (m), and its clock.
    pub(crate) short: (f64, f64),
    /// By how much the hand that holds a cane is farther from its tip than the cane is long (m), and its clock.
    pub(crate) cane: (f64, f64),
}

impl WalkPlan {
    pub(crate) fn legs(&self) -> LegsCheck {
        let toe = self.body.leg.toe_polar();
        let none = (f64::INFINITY, 0.0);
        let mut check = LegsCheck { least_knee: none, lowest: none, short: (0.0, 0.0), cane: (0.0, 0.0) };
        let (_, (first, last)) = self.nodes();
        for u in (first..=last).map(|node| self.clock(node)) {
            let (hips, legs) = self.hips_and_legs(u);
            let (apart, at) = least((-check.cane.0, check.cane.1), (-self.beyond_cane(u), u));
            check.cane = (-apart, at);
            for side in [0, 1] {
                let (hip, pose, leg) = (hips[side], legs[side], &self.body.sides[side]);
                check.least_knee = least(check.least_knee, (pose.knee, u));
                let lowest = if self.is_level() {
                    let ankle = hip.y - leg.ankle_below_hip(&pose) * pose.side.cos();
                    leg.lowest(toe, ankle, pose.pitch, pose.toes)
                } else {
                    self.lowest_over_ground(side, u, &hip, &pose)
                };
                check.lowest = least(check.lowest, (lowest, u));
                let short = self.feet[side].short(&self.laws, u, &hip);
                let (longest, at) = least((-check.short.0, check.short.1), (-short, u));
                check.short = (-longest, at);
            }
        }
        check
    }
}

impl WalkPlan {
    /// The least height of a point of a sole over ground that is not level (m); within `EDGE` of a riser either side of it counts.
    fn lowest_over_ground(&self, side: usize, u: f64, hip: &Vector3<f64>, pose: &LegPose) -> f64 {
        let Some(relief) = self.relief() else { return f64::NAN };
        let leg = &self.body.sides[side];
        let episode = self.laws.course.episode(side, self.laws.course.episode_at(side, u));
        let points = self.laws.plane.sole(leg, &episode.local(hip), pose, leg.ankle_below_hip(pose));
        let over = points.iter().map(|point| {
            let at = episode.print.world(side, point);
            at.y - relief.lowest_near(at.z, EDGE)
        });
        over.fold(f64::INFINITY, f64::min)
    }
}

/// How sharp an edge of the ground is (m).
const EDGE: f64 = 1e-3;

/// The smaller one; NaN wins, so that it is found.
fn least(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    if a.0 <= b.0 || a.0.is_nan() { a } else { b }
}
