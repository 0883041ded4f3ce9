//! The laws of pelvis, trunk and arms. The thorax' own is only what it is drawn to: its angles follow from the angular momentum.

use super::style::RunStyle;
use crate::body::posture::ArmCarriage;
use crate::body::rotations::Euler;
use std::f64::consts::TAU;

/// Phases (u) of the pelvis' obliquity, turn and tilt, of the thorax' turn, of shoulders and of elbows after them.
const OBLIQUITY_AT: f64 = 0.13;
const TURN_AT: f64 = 0.88;
const TILT_AT: f64 = 0.11;
const THORAX_AT: f64 = 0.88;
const ARMS_AT: f64 = 0.40;
const ELBOWS_AFTER: f64 = 0.03;
/// Part of the thorax' angles that neck and head have; the abdomen is half way from pelvis to thorax.
const NECK: f64 = 0.5;
const HEAD: Euler = [0.1, 0.1, 0.15];

/// How a runner's arms hang.
pub(super) fn carriage(style: &RunStyle) -> ArmCarriage {
    ArmCarriage {
        abduction: style.arm_abduction,
        inward: style.arm_inward,
        clavicle: 0.0,
        wrist: 0.0,
        lean: 0.0,
    }
}

/// World orientation of the pelvis.
pub(super) fn pelvis(style: &RunStyle, u: f64) -> Euler {
    [
        style.pelvic_obliquity * cos(u - OBLIQUITY_AT),
        -style.pelvic_rotation * cos(u - TURN_AT),
        style.anterior_tilt - style.tilt_swing * cos(2.0 * (u - TILT_AT)),
    ]
}

/// World orientation that the thorax is drawn to.
pub(super) fn thorax(style: &RunStyle, u: f64) -> Euler {
    [0.0, style.thorax_yaw * cos(u - THORAX_AT), style.thorax_lean]
}

/// World orientations of pelvis, abdomen, thorax, neck and head, for the thorax that the angular momentum asks for.
pub(super) fn trunk(style: &RunStyle, u: f64, thorax: Euler) -> [Euler; 5] {
    let pelvis = pelvis(style, u);
    let abdomen = std::array::from_fn(|i| 0.5 * (pelvis[i] + thorax[i]));
    [pelvis, abdomen, thorax, thorax.map(|x| NECK * x), std::array::from_fn(|i| HEAD[i] * thorax[i])]
}

/// Rotations about x of shoulders and elbows, left and right: the right arm's are the left one's half a stride later.
pub(super) fn arms(style: &RunStyle, u: f64) -> [[f64; 2]; 2] {
    [arm(style, u), arm(style, u + 0.5)]
}

fn arm(style: &RunStyle, u: f64) -> [f64; 2] {
    [
        -(style.arm_mean + style.arm_swing * cos(u - ARMS_AT)),
        -(style.elbow + style.elbow_swing * cos(u - ARMS_AT - ELBOWS_AFTER)),
    ]
}

fn cos(turns: f64) -> f64 {
    (TAU * turns).cos()
}
