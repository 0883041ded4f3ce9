//! What a style changes on a slope.

use super::footfall::Footfall;
use super::style::{Style, StyleTable};
use crate::body::{LegGeometry, REFERENCE_HEIGHT};
use crate::limbs::numbers::{MOST_KNEE_TOE_OFF, ROUNDED};

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

/// The least factor of the pressure's quick way forward on a slope: that of slow steps is small on level ground, and uphill less by as much as that of all others.
const LEAST_COP_FORWARD: f64 = 0.2;

/// Slopes, either way, from which on the push is rounded off fully (rad).
const SOFT_FROM: f64 = 5.0 * DEGREE;

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
        style.cop_forward = (style.cop_forward + change(1.0, -0.5207, -0.1094)).max(LEAST_COP_FORWARD);
        style.cop_middle += change(1.0, -0.0654, 0.0057);
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

        style.push_softness = ROUNDED * (slope.abs() / SOFT_FROM).min(1.0);
        style.toe_off_most = MOST_KNEE_TOE_OFF + MORE_KNEE_DOWNHILL * (-slope).max(0.0);
        // Once the heel has risen the pressure is under the ball or ahead of it.
        let ball = leg.heel_behind + leg.ball_ahead - COP_BEHIND_BALL * height / REFERENCE_HEIGHT;
        let least = ball / leg.foot_length();
        let keys = [&mut style.cop_middle, &mut style.cop_40, &mut style.cop_50];
        for (i, key) in keys.into_iter().enumerate() {
            *key = key.max(least + COP_APART * i as f64);
        }
        style
    }
}

impl StyleTable {
    /// The level style that walks over other ground are made of.
    pub fn on_ground() -> Self {
        Self { footfall: Footfall::ON_GROUND, ..Self::unsteady() }
    }
}
