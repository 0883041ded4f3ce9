//! What a style changes on a slope.

use super::footfall::Footfall;
use super::style::{Style, StyleTable};
use crate::body::{LegGeometry, REFERENCE_HEIGHT};
use crate::limbs::numbers::MOST_KNEE_TOE_OFF;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// The slopes that strides were tried on (rad): they are planned between them, steeper ground is walked on as these are.
pub const SLOPES: (f64, f64) = (-15.0 * DEGREE, 15.0 * DEGREE);

/// Step length on a slope over that on level ground, by the slope in degrees: shorter downhill, hardly longer uphill.
///
/// ```text
/// 1 + clip(0.016·slope°, −0.24, 0.04)
/// ```
///
/// After people who chose their steps at given speeds on slopes of ±9° (Franz and Kram 2012).
pub fn step_length_on_slope(slope: f64) -> f64 {
    1.0 + (0.016 * slope / DEGREE).clamp(-0.24, 0.04)
}

/// How far behind the ball the pressure may be once the heel has risen (m, for the reference height), and how much farther forward (parts
/// of the foot's length) the next two keys are.
const COP_BEHIND_BALL: f64 = 0.010;
const COP_APART: f64 = 0.01;

/// Slopes, either way, from which on the push is rounded off fully (rad), and by how much (rad).
const SOFT_FROM: f64 = 5.0 * DEGREE;
const SOFTNESS: f64 = DEGREE;

/// How much more than on level ground a knee may be bent at toe-off downhill, over the slope.
const MORE_KNEE_DOWNHILL: f64 = 1.2;

impl Style {
    /// The style on ground that rises by `slope` (rad) along the way, for a figure of this height (m): `q + c₁ b + c₂ b²` with `b` the slope over 10°.
    ///
    /// One offline fit over six slopes from −15° to 15°, at 100 steps/min (docs/slopes.md). The step length becomes
    /// [`step_length_on_slope`] times as long. Beyond the slopes that were tried the numbers are held.
    #[must_use]
    pub fn on_slope(&self, leg: &LegGeometry, height: f64, slope: f64) -> Self {
        let slope = slope.clamp(SLOPES.0, SLOPES.1);
        if slope == 0.0 {
            return *self;
        }
        let b = slope / (10.0 * DEGREE);
        let mut style = *self;
        style.slope = slope;
        style.step_length *= step_length_on_slope(slope);
        let change = |unit: f64, c1: f64, c2: f64| unit * b * (c1 + c2 * b);
        style.heel_strike_angle += change(DEGREE, -2.49, -2.35);
        style.knee_contact += change(DEGREE, -0.34, 1.27);
        style.knee_contact_rate += change(DEGREE, 63.14, -5.47);
        style.knee_contact_acc += change(DEGREE, -6388.05, 1933.75);
        style.knee_push += change(DEGREE, 1.73, -1.38);
        style.knee_toe_off += change(DEGREE, -14.5, 2.38);
        style.knee_toe_off_rate += change(DEGREE, 74.74, -118.28);
        style.knee_toe_off_acc += change(DEGREE, -1456.05, -379.94);
        style.toe_roll += change(DEGREE, 16.32, -2.22);
        style.knee_peak += change(DEGREE, -3.64, -1.35);
        style.knee_peak_at += change(1.0, -0.0031, -0.0029);
        style.thigh_swing += change(DEGREE, 14.77, 1.61);
        style.ankle_swing += change(DEGREE, -2.4, 6.37);
        style.knee_late_swing += change(DEGREE, 0.82, 7.43);
        style.heel_off += change(1.0, 0.026, -0.0026);
        style.cop_forward += change(1.0, -0.5207, -0.1094);
        style.cop_heel_off += change(1.0, -0.0654, 0.0057);
        style.cop_40 += change(1.0, -0.0808, -0.0075);
        style.cop_50 += change(1.0, -0.0344, -0.0103);
        style.height1 += change(1.0, -0.003_15, -0.0025);
        style.height1_phase += change(1.0, -0.0504, 0.023);
        style.height2_cos += change(1.0, -0.000_34, 0.000_35);
        style.height2_sin += change(1.0, -0.000_06, -0.000_62);
        style.height3_cos += change(1.0, 0.000_74, -0.000_24);
        style.height3_sin += change(1.0, -0.000_35, 0.000_28);
        style.share_exponent += change(1.0, 0.5109, 0.2083);
        style.foot_flat += change(1.0, 0.0214, 0.0169);
        style.tip_roll += change(1.0, -0.0745, -0.1144);
        style.pivot += change(1.0, 0.3537, -0.0917);
        style.least_knee += change(DEGREE, 1.85, 3.71);
        // Set, not fitted: people lean forward uphill and back downhill.
        style.thorax_lean += change(DEGREE, 5.0, 1.0);
        style.anterior_tilt += change(DEGREE, 3.0, 0.0);

        style.push_softness = SOFTNESS * (slope.abs() / SOFT_FROM).min(1.0);
        style.toe_off_most = MOST_KNEE_TOE_OFF + MORE_KNEE_DOWNHILL * (-slope).max(0.0);
        // Once the heel has risen the pressure is under the ball or ahead of it.
        let ball = leg.heel_behind + leg.ball_ahead - COP_BEHIND_BALL * height / REFERENCE_HEIGHT;
        let least = ball / leg.foot_length();
        let keys = [&mut style.cop_heel_off, &mut style.cop_40, &mut style.cop_50];
        for (i, key) in keys.into_iter().enumerate() {
            *key = key.max(least + COP_APART * i as f64);
        }
        style
    }
}

/// The table that the changes on slopes and stairs were fitted to: level strides of the recipe, in the order of [`StyleTable::NUMBERS`].
#[rustfmt::skip]
const TABLE: [[f64; 4]; 40] = [
    [17.42, 3.32, 0.23, 0.55], // heel_strike_angle
    [0.01687, 0.00139, 0.00032, 0.00029], // height1
    [0.0121, -0.0059, 0.0129, 0.0406], // height1_phase
    [-0.00118, 0.00093, 0.00004, -0.00024], // height2_cos
    [0.00079, -0.00097, -0.00001, -0.00075], // height2_sin
    [-0.00012, -0.00015, -0.00011, -0.00003], // height3_cos
    [0.00014, 0.00037, -0.00010, -0.00025], // height3_sin
    [3.90, 0.39, 0.02, 0.56], // pelvic_obliquity
    [0.0346, 0.0178, -0.0005, 0.0255], // obliquity_phase
    [0.0796, -0.0116, -0.0005, 0.0114], // foot_flat
    [7.38, 0.91, 1.02, -3.24], // knee_contact
    [120.5, 39.5, 13.0, -4.9], // knee_contact_rate
    [2215.0, 3049.0, 1997.0, 2120.0], // knee_contact_acc
    [11.90, -3.54, -0.39, 6.65], // knee_push
    [41.50, -4.82, 1.23, -19.37], // knee_toe_off
    [363.1, 20.1, 26.2, -174.8], // knee_toe_off_rate
    [-656.4, 672.9, 80.0, 784.4], // knee_toe_off_acc
    [34.78, -0.96, -0.14, 36.22], // toe_roll
    [65.17, -4.87, -1.53, -0.55], // knee_peak
    [0.7503, -0.0027, -0.0026, 0.0436], // knee_peak_at
    [28.80, -0.61, 1.24, -1.67], // thigh_swing
    [6.17, -0.31, -0.41, 1.66], // ankle_swing
    [1.0609, 0.2194, -0.0662, 0.6133], // cop_forward
    [0.7494, 0.0063, -0.0016, 0.0387], // cop_heel_off
    [0.7914, 0.0187, -0.0087, 0.0759], // cop_40
    [0.7964, 0.0360, 0.0230, 0.0912], // cop_50
    [0.3248, 0.0146, -0.0038, 0.0421], // heel_off
    [-0.36, -1.55, 0.08, 0.69], // thorax_lean
    [4.48, 0.21, 1.76, 1.09], // knee_late_swing
    [5.31, -0.03, 0.17, -0.79], // thorax_bend_sin
    [-2.65, -1.71, 0.88, -0.58], // thorax_bend_cos
    [7.06, 0.15, 0.08, -0.44], // thorax_yaw
    [23.80, 7.65, -2.74, -31.84], // arm_swing
    [0.7408, -0.0568, 0.0354, -0.2458], // share_exponent
    [0.1117, -0.0016, -0.0056, -0.0858], // step_width
    [0.4268, -0.1015, 0.0126, 0.2992], // tip_roll
    [5.82, 1.43, -0.18, -0.59], // pelvic_rotation
    [1.4592, -0.0340, -0.0140, 1.8694], // pivot
    [-0.0213, 0.0353, -0.0045, 0.0037], // arm_lag
    [-0.0076, 0.0293, 0.0768, -0.0143], // thorax_yaw_phase
];

impl StyleTable {
    /// The level style that walks over other ground are made of: what it changes on slopes and stairs was fitted to this one.
    pub fn on_ground() -> Self {
        Self { rows: TABLE, manner: None, footfall: Footfall::RECIPE }
    }
}
