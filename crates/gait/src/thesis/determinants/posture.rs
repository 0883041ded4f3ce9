//! One key posture: pitches of the segments, and where they put the joints.

use super::proportions::Proportions;
use crate::body::leg::LegPose;

/// Pitches of a leg's segments (rad): positive where the lower end is behind, the toes down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LegAngles {
    /// Line from hip to knee.
    pub thigh: f64,
    /// Line from knee to ankle.
    pub shank: f64,
    /// Sole of the foot.
    pub foot: f64,
    /// Sole of the toes.
    pub toes: f64,
}

/// The pelvis of a posture (rad).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pelvis {
    /// By how much the swing leg's hip is lower (δ and its parts).
    pub tilt: f64,
    /// Turn about the vertical: positive where the stance leg's hip is ahead (ρ, τ and its parts).
    pub rotation: f64,
}

/// The arm of a side (rad).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ArmAngles {
    /// Flexion of the shoulder, forward.
    pub shoulder: f64,
    /// Flexion of the elbow.
    pub elbow: f64,
}

/// The trunk (rad).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrunkAngles {
    /// Side bend of the trunk about the pelvis, towards the stance leg (ν).
    pub pelvis_bend: f64,
    /// Side bend of the upper against the lower trunk, towards the stance leg (γ).
    pub torso_bend: f64,
    /// Lean forward (ζ).
    pub lean: f64,
}

/// A key posture. Of pairs, the stance leg's comes first.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct KeyPosture {
    /// What it is, in a word or two.
    pub name: &'static str,
    /// Stance and swing leg.
    pub legs: [LegAngles; 2],
    /// The pelvis.
    pub pelvis: Pelvis,
    /// The arms on the stance leg's and on the swing leg's side.
    pub arms: [ArmAngles; 2],
    /// The trunk.
    pub trunk: TrunkAngles,
}

/// The point of a foot that a posture is built up from: it is on the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Root {
    /// The heel of a foot that turns about it.
    Heel,
    /// The flat foot, by its ankle's foot point.
    Sole,
    /// The ball of a foot whose heel has risen; the toes are flat.
    Ball,
    /// The tip of the toes.
    Tip,
}

/// Where a leg's joints are: forward, up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Joints {
    /// Hip.
    pub hip: [f64; 2],
    /// Knee.
    pub knee: [f64; 2],
    /// Ankle.
    pub ankle: [f64; 2],
    /// Heel, on the sole.
    pub heel: [f64; 2],
    /// Ball: the joint of the toes.
    pub ball: [f64; 2],
    /// Tip of the toes, on the sole.
    pub tip: [f64; 2],
}

impl LegAngles {
    /// Knee flexion.
    pub fn knee(&self) -> f64 {
        self.shank - self.thigh
    }

    /// The joints, for a hip.
    pub fn joints(&self, p: &Proportions, hip: [f64; 2]) -> Joints {
        let along = |from: [f64; 2], length: f64, pitch: f64| {
            [from[0] - length * pitch.sin(), from[1] - length * pitch.cos()]
        };
        let knee = along(hip, p.thigh, self.thigh);
        let ankle = along(knee, p.shank, self.shank);
        // A point ahead of and below another, on a foot that is pitched.
        let on = |from: [f64; 2], ahead: f64, below: f64, pitch: f64| {
            let (sin, cos) = pitch.sin_cos();
            [from[0] + ahead * cos - below * sin, from[1] - ahead * sin - below * cos]
        };
        let ball = on(ankle, p.ball_ahead, p.ball_below, self.foot);
        Joints {
            hip,
            knee,
            ankle,
            heel: on(ankle, -p.heel_behind, p.ankle_height, self.foot),
            ball,
            tip: on(ball, p.toe, p.ball_height, self.toes),
        }
    }

    /// The hip, for a point of the foot: heel, ankle's foot point and tip lie on the ground at height 0 where `at` has that, the
    /// ball is `at` itself.
    pub fn hip_over(&self, p: &Proportions, root: Root, at: [f64; 2]) -> [f64; 2] {
        let joints = self.joints(p, [0.0, 0.0]);
        let from = match root {
            Root::Heel => joints.heel,
            Root::Sole => [joints.ankle[0], joints.ankle[1] - p.ankle_height],
            Root::Ball => joints.ball,
            Root::Tip => joints.tip,
        };
        [at[0] - from[0], at[1] - from[1]]
    }
}

impl LegAngles {
    /// As the closed forms of a figure's leg have it, whose axes lean against the lines between the joints.
    pub(crate) fn pose(&self, thigh_lean: f64, shank_lean: f64) -> LegPose {
        // A leg's posture counts forward, and from the axes: the line from hip to knee is at ζ₁ − α, that to the ankle at
        // ζ₂ − (α − k).
        let thigh = thigh_lean - self.thigh;
        let knee = thigh - (shank_lean - self.shank);
        LegPose { side: 0.0, thigh, knee, pitch: self.foot, toes: self.toes, tilt: 0.0 }
    }
}

impl KeyPosture {
    /// Hip of the swing leg against that of the stance leg, in the sagittal plane: behind by `L cos δ sin ρ`, lower by
    /// `L sin δ`.
    pub fn swing_hip(&self, p: &Proportions) -> [f64; 2] {
        let (sin, cos) = self.pelvis.tilt.sin_cos();
        [-p.hips * cos * self.pelvis.rotation.sin(), -p.hips * sin]
    }

    /// The joints of both legs, for the stance leg's hip.
    pub fn joints(&self, p: &Proportions, stance_hip: [f64; 2]) -> [Joints; 2] {
        let offset = self.swing_hip(p);
        let hip = [stance_hip[0] + offset[0], stance_hip[1] + offset[1]];
        [self.legs[0].joints(p, stance_hip), self.legs[1].joints(p, hip)]
    }

    /// The same with the legs' parts exchanged.
    #[must_use]
    pub fn exchanged(&self) -> Self {
        let [stance, swing] = self.legs;
        let [a, b] = self.arms;
        Self {
            legs: [swing, stance],
            pelvis: Pelvis { tilt: -self.pelvis.tilt, rotation: -self.pelvis.rotation },
            arms: [b, a],
            trunk: TrunkAngles {
                pelvis_bend: -self.trunk.pelvis_bend,
                torso_bend: -self.trunk.torso_bend,
                lean: self.trunk.lean,
            },
            ..*self
        }
    }
}
