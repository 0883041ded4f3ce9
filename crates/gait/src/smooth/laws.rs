//! The prescribed laws: height, load share, centre of pressure, trunk and arms.
//!
//! `u` is the time since left heel contact over the stride's time; harmonics have the whole body's period of one stride.

use crate::body::rotations::Euler;
use crate::smooth::style::Style;
use solaris_profiles::spline::CubicSpline;
use solaris_profiles::{Clip, ProfileError};
use std::f64::consts::TAU;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// When the centre of pressure is looked at while the foot comes down, as a part of the time until it is flat.
const COP_LOADING: f64 = 0.6;
/// Its quick way forward: so long after the flat foot (u), and so far (parts of the foot's length, times the style's factor).
const COP_QUICK: (f64, f64) = (0.035, 0.33);
/// How long two places are apart at least (u).
const COP_APART: f64 = 0.01;
/// When (u) and where it is in single support, likewise.
const COP_SINGLE: (f64, f64) = (0.20, 0.56);
/// Where it is (parts of the foot's length) as the roll over the tip begins.
const COP_TIP_ROLL: f64 = 0.955;

/// How far behind its end (parts of the foot's length) it is then on stairs, up and down.
const COP_BEFORE_END: (f64, f64) = (0.03, 0.005);

/// Amplitude of the pelvis' forward tilt (rad), twice a stride, and its phase (u).
const TILT_SWING: (f64, f64) = (1.4 * DEGREE, 0.02);
/// When the body is over the left leg, highest and farthest to the left (u).
const SWAY_MOST: f64 = 0.30;
/// Part of the way from the one to the other: the abdomen between pelvis and thorax, the neck between the head, which stays
/// upright, and the thorax.
const HALFWAY: f64 = 0.5;
/// Lag of the elbows after the shoulders (u).
const ELBOW_LAG: f64 = 0.05;

/// See [`Style::height`].
pub(crate) fn height(style: &Style, leg: f64, u: f64) -> (f64, f64) {
    style.height(leg, u)
}

/// Rise of the load share after a contact, `v` after it: see [`crate::Footfall`].
pub(crate) fn share_rise(style: &Style, v: f64) -> f64 {
    style.footfall.share_risen(v / style.double_support, style.share_exponent)
}

/// Share of the foot whose contact is at 0, over one stance.
pub(crate) fn share(style: &Style, u: f64) -> f64 {
    if u < 0.0 {
        0.0
    } else if u < 0.5 {
        share_rise(style, u)
    } else {
        1.0 - share_rise(style, u - 0.5)
    }
}

/// Centre of pressure along the foot as a fraction of its length from the heel, by the foot's own clock.
pub(crate) fn cop(style: &Style) -> Result<Clip<CubicSpline>, ProfileError> {
    cop_of(style, style)
}

/// The same of a foot that lands in one style, and stands and pushes off in another.
pub(crate) fn cop_of(landing: &Style, style: &Style) -> Result<Clip<CubicSpline>, ProfileError> {
    let (flat, forward) = (landing.foot_flat, style.cop_forward);
    let mut keys = Vec::with_capacity(10);
    if let Some(stairs) = &landing.stairs {
        keys.extend([(0.0, stairs.cop_contact), (flat, stairs.cop_flat)]);
    } else {
        let [contact, loading, flat_at] = landing.footfall.cop_landing;
        keys.extend([(0.0, contact), (COP_LOADING * flat, loading), (flat, flat_at)]);
        keys.push((flat + COP_QUICK.0, COP_QUICK.1 * forward));
    }
    // Of short double supports the toes roll before that: quick steps up a steep slope have such.
    let late = if style.tip_roll_at() > 0.50 { 0.50 } else { style.tip_roll_at() - COP_APART };
    let at_toe_off = |before: f64, end: f64| [(style.tip_roll_at(), before), (style.toe_off(), end)];
    if let Some(stairs) = &style.stairs {
        // On the way down the toes do not roll.
        let before = if stairs.cop_end > 0.9 { COP_BEFORE_END.0 } else { COP_BEFORE_END.1 };
        keys.extend([stairs.cop_middle, (style.heel_off, style.cop_middle), (late, style.cop_50)]);
        keys.extend(at_toe_off(stairs.cop_end - before, stairs.cop_end));
    } else {
        let middle = style.footfall.cop_middle_at.unwrap_or(style.heel_off);
        // Where a foot is flat late, no sooner than after that.
        let single = COP_SINGLE.0.max(keys[keys.len() - 1].0 + COP_APART);
        keys.extend([(single, COP_SINGLE.1 * forward), (middle, style.cop_middle)]);
        keys.extend([(0.40, style.cop_40), (late, style.cop_50)]);
        keys.extend(at_toe_off(COP_TIP_ROLL, 1.0));
    }
    Ok(CubicSpline::monotone(&keys)?.into_clip())
}

/// How much of each swings: 0 at rest, 1 in a steady stride.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Swings {
    pub(crate) pelvis: f64,
    pub(crate) thorax: f64,
    pub(crate) arms: f64,
}

impl Swings {
    pub(crate) const ALL: Self = Self { pelvis: 1.0, thorax: 1.0, arms: 1.0 };
    pub(crate) const NONE: Self = Self { pelvis: 0.0, thorax: 0.0, arms: 0.0 };
}

/// World orientations of pelvis, abdomen, thorax, neck and head.
pub(crate) fn trunk(style: &Style, u: f64, swings: Swings) -> [Euler; 5] {
    let sin = |x: f64| (TAU * x).sin();
    let cos = |x: f64| (TAU * x).cos();
    let list = u - style.obliquity_phase;
    let pelvis = [
        swings.pelvis
            * style.pelvic_obliquity
            * (sin(list) + style.list.part * sin(3.0 * (list - style.list.lag)))
            + style.manner.pelvis_list,
        -swings.pelvis * style.pelvic_rotation * cos(u),
        style.anterior_tilt + swings.pelvis * TILT_SWING.0 * cos(2.0 * (u - TILT_SWING.1)),
    ];
    let thorax = [
        -swings.thorax * (style.thorax_bend_sin * sin(u) + style.thorax_bend_cos * cos(u))
            + style.manner.side_lean,
        swings.thorax * style.thorax_yaw * cos(u - style.thorax_yaw_phase),
        style.thorax_lean,
    ];
    let abdomen = std::array::from_fn(|i| HALFWAY * (pelvis[i] + thorax[i]));
    // The head rises twice a stride, most in mid-stance, and sways once, to the standing leg's side.
    let [pitch, turn] = style.manner.head;
    let head = [
        0.0,
        -swings.thorax * turn * cos(u - SWAY_MOST),
        style.manner.head_pitch + swings.thorax * pitch * cos(2.0 * (u - SWAY_MOST)),
    ];
    let neck = std::array::from_fn(|i| HALFWAY * (thorax[i] + head[i]));
    [pelvis, abdomen, thorax, neck, head]
}

/// Rotations about x of shoulders and elbows, left and right: the right arm's are the left one's half a stride later, but for what
/// the manner has by sides.
pub(crate) fn arms(style: &Style, u: f64, swings: Swings) -> [[f64; 2]; 2] {
    let [left, right] = style.manner.arm_sides;
    [arm(style, u, swings.arms, left), arm(style, u + 0.5, swings.arms, right)]
}

fn arm(style: &Style, u: f64, swing: f64, side: f64) -> [f64; 2] {
    let cos = |x: f64| (TAU * (x - 0.5 - style.arm_lag)).cos();
    let [standing, mean, amplitude] = style.manner.elbow;
    let elbow = standing + swing * (mean - standing + side * amplitude * cos(u - ELBOW_LAG));
    [-(style.manner.shoulder + swing * style.arm_swing * side * cos(u)), -elbow]
}
