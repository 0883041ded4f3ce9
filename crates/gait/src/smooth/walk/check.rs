//! The legs of a plan at its nodes: how straight, how low, how far too short they are.

use super::plan::WalkPlan;

/// What the legs do in a plan, at its nodes.
pub(crate) struct LegsCheck {
    /// Least knee flexion (rad), and its clock.
    pub(crate) least_knee: (f64, f64),
    /// Lowest point of a foot over the ground (m), and its clock.
    pub(crate) lowest: (f64, f64),
    /// Greatest distance by which a leg is too short for its planted foot (m), and its clock.
    pub(crate) short: (f64, f64),
}

impl WalkPlan {
    pub(crate) fn legs(&self) -> LegsCheck {
        let leg = &self.body.leg;
        let toe = leg.toe_polar();
        let none = (f64::INFINITY, 0.0);
        let mut check = LegsCheck { least_knee: none, lowest: none, short: (0.0, 0.0) };
        let (_, (first, last)) = self.nodes();
        for u in (first..=last).map(|node| self.clock(node)) {
            let (hips, legs) = self.hips_and_legs(u);
            for side in [0, 1] {
                let (hip, pose) = (hips[side], legs[side]);
                check.least_knee = least(check.least_knee, (pose.knee, u));
                let ankle = hip.y - leg.ankle_below_hip(&pose) * pose.side.cos();
                check.lowest = least(check.lowest, (leg.lowest(toe, ankle, pose.pitch, pose.toes), u));
                let short = self.feet[side].short(&self.laws, u, &hip);
                let (longest, at) = least((-check.short.0, check.short.1), (-short, u));
                check.short = (-longest, at);
            }
        }
        check
    }
}

/// The smaller one; NaN wins, so that it is found.
fn least(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    if a.0 <= b.0 || a.0.is_nan() { a } else { b }
}
