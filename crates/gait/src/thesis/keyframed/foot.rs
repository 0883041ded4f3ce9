//! The foot that is not the root: pinned to the ground, or swinging over it.

use crate::body::foot::FootPlane;
use crate::body::leg::{LegGeometry, LegPose};
use crate::thesis::determinants::{LegAngles, Proportions, Root};
use nalgebra::Vector3;

/// What the other foot does during a phase.
#[derive(Clone, Copy, Debug)]
pub(super) enum Free {
    /// A point of it stays where it is: forward, up (m).
    Pinned { point: Root, at: [f64; 2] },
    /// It is in the air.
    Swings(Lift),
}

/// How high a swinging foot is to be.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Lift {
    /// Its lowest point at the beginning, at the end, and between (m).
    from: f64,
    to: f64,
    between: f64,
    /// Width of the passage from no lift to lift (m), in the middle of the phase.
    passage: f64,
}

/// How near two places of a foot have to be to count as one, over the height: more than rounding, less than any slide that a
/// planted point may show.
pub(super) const SAME_PLACE: f64 = 1e-9;
/// Part of a phase in which a swinging foot comes to its height.
const RISE: f64 = 0.3;
/// Width of the passage from no lift to lift, over the height: 1 cm at 1.75 m.
const PASSAGE: f64 = 0.01 / 1.75;

impl Lift {
    /// A foot that comes down from the air goes straight down; any other is at least `clearance` high between its ends.
    pub(super) fn new(p: &Proportions, from: f64, to: f64, clearance: f64) -> Self {
        let on_ground = SAME_PLACE * p.height;
        let comes_down = from > on_ground && to < on_ground;
        let between = if comes_down { 0.0 } else { clearance.max(from).max(to) };
        Self { from, to, between, passage: PASSAGE * p.height }
    }

    /// The height that is wanted, and the width of the passage, at a place in the phase.
    fn wanted(&self, clock: f64) -> (f64, f64) {
        let rising = self.from + (self.between - self.from) * (clock / RISE).min(1.0);
        let falling = self.to + (self.between - self.to) * ((1.0 - clock) / RISE).min(1.0);
        (rising.min(falling), self.passage * (4.0 * clock * (1.0 - clock)).powi(2))
    }
}

/// By how much to lift what lacks `lack` (m): never less than the lack, twice differentiable within a passage of half-width
/// `w`, nothing below it.
///
/// ```text
/// f(x) = (x + w)³ (3 w − x)/(16 w³)   for |x| < w        f(−w) = f′(−w) = f″(−w) = 0,  f(w) = w, f′(w) = 1, f″(w) = 0
/// ```
fn lift(lack: f64, w: f64) -> f64 {
    if lack >= w {
        lack.max(0.0)
    } else if lack <= -w {
        0.0
    } else {
        (lack + w).powi(3) * (3.0 * w - lack) / (16.0 * w.powi(3))
    }
}

/// A leg as the planar model has it, and how far its hip is to the side of its foot.
#[derive(Clone, Copy, Debug)]
pub(super) struct SideLeg {
    /// 0 left, 1 right.
    pub(super) side: usize,
    pub(super) angles: LegAngles,
    /// Hip and ankle in the model's plane: forward, up (m).
    pub(super) hip: [f64; 2],
    pub(super) ankle: [f64; 2],
    /// Where the hip is across (m).
    pub(super) across: f64,
    /// The hip against the line of the foot, outward (m).
    pub(super) off: f64,
}

impl SideLeg {
    /// Height of the hip above the ankle where the leg's plane leans to the side by η: v·cos η of v.
    fn upright(&self) -> f64 {
        let below = self.hip[1] - self.ankle[1];
        (below * below - self.off * self.off).max(0.0).sqrt()
    }

    /// How much lower the hip is for that.
    pub(super) fn drop(&self) -> f64 {
        self.hip[1] - self.ankle[1] - self.upright()
    }

    /// The pose, with the hip lower by `drop` (m); for the leg that is not the root's, what its foot does and the place in the
    /// phase. Each leg is posed as a left one: the right one in the mirror.
    pub(super) fn pose(
        &self,
        leg: &LegGeometry,
        p: &Proportions,
        plane: &FootPlane,
        drop: f64,
        free: Option<(&Free, f64)>,
    ) -> LegPose {
        let LegAngles { foot, toes, .. } = self.angles;
        let hip = [self.hip[0], self.hip[1] - drop];
        let from_ankle = |[z, y]: [f64; 2]| Vector3::new(self.off, hip[1] - y, hip[0] - z);
        let (mut ankle, mut is_planned) = (self.ankle, (drop - self.drop()).abs() < 1e-15);
        match free {
            None => {}
            Some((Free::Pinned { point, at }, _)) => return self.pinned(leg, p, plane, hip, (*point, *at)),
            Some((Free::Swings(height), clock)) => {
                let (wanted, passage) = height.wanted(clock);
                let lifted = lift(wanted - leg.lowest(leg.toe_polar(), ankle[1], foot, toes), passage);
                ankle[1] += lifted;
                is_planned = is_planned && lifted <= 0.0;
            }
        }
        if is_planned {
            let side = self.off.atan2(self.upright());
            LegPose { side, ..self.angles.pose(leg.thigh_lean, leg.shank_lean) }
        } else {
            plane.pose(leg, &from_ankle(ankle), foot, toes)
        }
    }

    /// The pose over a foot of which a point is pinned. Where the leg is too short for it the heel rises until the straight leg
    /// reaches.
    fn pinned(
        &self,
        leg: &LegGeometry,
        p: &Proportions,
        plane: &FootPlane,
        hip: [f64; 2],
        (point, at): (Root, [f64; 2]),
    ) -> LegPose {
        let toes = self.angles.toes;
        let placed = |foot: f64| LegAngles { foot, ..self.angles }.joints(p, [0.0, 0.0]);
        let to_hip = |foot: f64| {
            let joints = placed(foot);
            let from = if point == Root::Tip { joints.tip } else { joints.ball };
            let ankle = [at[0] + joints.ankle[0] - from[0], at[1] + joints.ankle[1] - from[1]];
            Vector3::new(self.off, hip[1] - ankle[1], hip[0] - ankle[0])
        };
        let foot = self.angles.foot;
        let longest = (leg.thigh + leg.shank).powi(2);
        if to_hip(foot).norm_squared() <= longest {
            return plane.pose(leg, &to_hip(foot), foot, toes);
        }
        let joints = placed(foot);
        let from = if point == Root::Tip { joints.tip } else { joints.ball };
        let ball = [at[0] + joints.ball[0] - from[0], at[1] + joints.ball[1] - from[1]];
        let foot =
            leg.pitch_about_ball([self.off, hip[1] - ball[1], hip[0] - ball[0]], leg.knee_for(longest));
        plane.pose(leg, &to_hip(foot), foot, toes)
    }
}

#[cfg(test)]
mod tests {
    use super::lift;

    #[test]
    fn a_lift_is_never_less_than_what_is_lacking() {
        for w in [0.0, 1e-6, 0.01] {
            for k in -40..=40 {
                let lack = 1e-3 * f64::from(k);
                assert!(lift(lack, w) >= lack.max(0.0), "{lack} {w}");
            }
            assert!(lift(-0.02, w).abs() < 1e-15);
        }
    }
}
