//! The foot that is not the root: pinned to the ground, or swinging over it.

use crate::determinants::{LegAngles, Proportions, Root};
use crate::foot::FootPlane;
use crate::leg::{LegGeometry, LegPose};
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
}

/// Part of a phase in which a swinging foot comes to its height.
const RISE: f64 = 0.3;
/// Width of the passage from no lift to lift (m), in the middle of a phase.
const PASSAGE: f64 = 0.01;

impl Lift {
    /// A foot that comes down from the air goes straight down; any other is at least `clearance` high between its ends.
    pub(super) fn new(from: f64, to: f64, clearance: f64) -> Self {
        let comes_down = from > 1e-6 && to < 1e-6;
        Self { from, to, between: if comes_down { 0.0 } else { clearance.max(from).max(to) } }
    }

    /// The height that is wanted, and the width of the passage, at a place in the phase.
    fn wanted(&self, clock: f64) -> (f64, f64) {
        let rising = self.from + (self.between - self.from) * (clock / RISE).min(1.0);
        let falling = self.to + (self.between - self.to) * ((1.0 - clock) / RISE).min(1.0);
        (rising.min(falling), PASSAGE * (4.0 * clock * (1.0 - clock)).powi(2))
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

/// The leg over its foot: `hip` and the foot's line (m), as a left leg's; pitches between the two postures.
pub(super) fn raised(
    leg: &LegGeometry,
    p: &Proportions,
    plane: &FootPlane,
    (hip, line): (Vector3<f64>, f64),
    angles: &LegAngles,
    (free, clock): (&Free, f64),
) -> LegPose {
    let LegAngles { foot, toes, .. } = *angles;
    let from_ankle = |[z, y]: [f64; 2]| Vector3::new(hip.x - line, hip.y - y, hip.z - z);
    match free {
        Free::Pinned { point, at } => {
            let ankle = |foot: f64| {
                let joints = LegAngles { foot, ..*angles }.joints(p, [0.0, 0.0]);
                let from = if *point == Root::Tip { joints.tip } else { joints.ball };
                [at[0] + joints.ankle[0] - from[0], at[1] + joints.ankle[1] - from[1]]
            };
            let to_hip = from_ankle(ankle(foot));
            let longest = leg.almost_straight_squared();
            if to_hip.norm_squared() <= longest {
                return plane.pose(leg, &to_hip, foot, toes);
            }
            // Too far: the heel rises until the straight leg reaches.
            let joints = angles.joints(p, [0.0, 0.0]);
            let ball = if *point == Root::Tip {
                [at[0] + joints.ball[0] - joints.tip[0], at[1] + joints.ball[1] - joints.tip[1]]
            } else {
                *at
            };
            let hip_over_ball = [hip.x - line, hip.y - ball[1], hip.z - ball[0]];
            let foot = leg.pitch_about_ball(hip_over_ball, leg.knee_for(longest));
            plane.pose(leg, &from_ankle(ankle(foot)), foot, toes)
        }
        Free::Swings(height) => {
            // In the leg's plane, which leans to the foot's line.
            let joints = angles.joints(p, [0.0, 0.0]);
            let (below, off) = (-joints.ankle[1], hip.x - line);
            let upright = (below * below - off * off).max(0.0).sqrt();
            let ankle = [hip.z + joints.ankle[0], hip.y - upright];
            let (wanted, passage) = height.wanted(clock);
            let lifted = lift(wanted - leg.lowest(ankle[1], foot, toes), passage);
            if lifted > 0.0 {
                plane.pose(leg, &from_ankle([ankle[0], ankle[1] + lifted]), foot, toes)
            } else {
                LegPose { side: off.atan2(upright), ..angles.pose(leg.thigh_lean, leg.shank_lean) }
            }
        }
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
