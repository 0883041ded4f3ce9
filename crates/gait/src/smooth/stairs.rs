//! What a style changes on stairs.

use super::stair_numbers::StairNumbers;
use super::style::Style;
use crate::body::LegGeometry;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Stairs that strides were tried on: rise and tread of a step (m).
pub const STAIRS: ((f64, f64), (f64, f64)) = ((0.10, 0.20), (0.25, 0.35));

/// The rise that was fitted to (m), and thigh and shank of who walked there (m).
const FITTED_RISE: f64 = 0.17;
const FITTED_LEG: f64 = 0.86;
/// For a leg that is so much shorter than that one, in parts of it: how much the leg on the higher tread is shortened, in parts of that rise (up, down), and on the
/// way up how much less the knee of the other one is bent at toe-off (rad), and how much slower it bends then (rad by u).
const SHORT_LEG: (f64, f64) = (1.5, 1.35);
const SHORT_TOE_OFF: (f64, f64) = (60.0 * DEGREE, 500.0 * DEGREE);

impl Style {
    /// The style on stairs whose steps rise by `rise` (m, negative on the way down), for a figure of this height (m) with this leg; the step
    /// length is the tread.
    ///
    /// Fitted offline to what people do on stairs of 0.17 m over 0.29 m (docs/slopes.md). The leg on the higher tread, ahead on the way up and
    /// behind on the way down, is bent by how far the body is below its height there: on lower stairs it is as much longer as they are lower. For
    /// shorter legs the same stairs are higher: the leg on the higher tread is bent more, so that the other ankle need neither bend by more nor push from farther up than
    /// ankles do.
    #[must_use]
    pub fn on_stairs(&self, leg: &LegGeometry, height: f64, rise: f64) -> Self {
        let up = rise > 0.0;
        // A leg that lands on a higher stair than the fitted ones bends by itself.
        let longer = if up { (FITTED_RISE - rise).max(0.0) } else { FITTED_RISE + rise };
        let short = (1.0 - (leg.thigh + leg.shank) / FITTED_LEG).max(0.0);
        let longer = longer - short * FITTED_RISE * if up { SHORT_LEG.0 } else { SHORT_LEG.1 };
        let (less, slower) = if up { SHORT_TOE_OFF } else { (0.0, 0.0) };
        let stretched = |knee: f64| {
            if longer == 0.0 { knee } else { leg.knee_for((leg.reach_squared(knee).sqrt() + longer).powi(2)) }
        };
        let ahead = if up { stretched(60.0 * DEGREE) } else { 16.13 * DEGREE };
        let behind = |knee: f64| if up { knee } else { stretched(knee) };
        let of = |numbers: (f64, f64)| if up { numbers.0 } else { numbers.1 };
        let angle = |numbers: (f64, f64)| of(numbers) * DEGREE;
        Self {
            double_support: of((0.12, 0.11)),
            height1: of((0.0081, 0.014)),
            height1_phase: of((0.029_13, 0.0714)),
            height2_cos: of((-0.000_17, -0.003_08)),
            height2_sin: of((-0.000_51, 0.001_45)),
            height3_cos: of((-0.001_49, -0.000_08)),
            height3_sin: of((0.000_27, -0.0006)),
            pelvic_obliquity: 2.5 * DEGREE,
            obliquity_phase: of((-0.039_08, 0.138)),
            pelvic_rotation: 3.0 * DEGREE,
            foot_flat: of((0.042_98, 0.1566)),
            heel_strike_angle: 0.0,
            knee_contact: ahead,
            knee_push: behind(angle((12.25, 54.24))),
            knee_toe_off: behind(angle((34.25, 81.06))) - short * less,
            knee_toe_off_rate: angle((249.27, 277.66)) - short * slower,
            knee_toe_off_acc: angle((-1112.91, 881.23)),
            toe_roll: angle((30.62, 0.0)),
            cop_middle: of((0.6584, 0.7693)),
            cop_50: of((0.7542, 0.79)),
            heel_off: of((0.3718, 0.2943)),
            thorax_lean: angle((12.0, 1.0)),
            anterior_tilt: angle((9.0, 4.0)),
            share_exponent: of((0.9563, 0.6026)),
            tip_roll: of((0.2787, 0.5604)),
            pivot: of((1.4609, 1.3768)),
            arm_swing: 12.0 * DEGREE,
            thorax_bend_sin: 3.0 * DEGREE,
            thorax_bend_cos: -1.5 * DEGREE,
            thorax_yaw: 3.0 * DEGREE,
            least_knee: angle((17.27, 12.0)),
            step_width: 0.11 * height / 1.75,
            clearance: 0.015 * height / crate::body::REFERENCE_HEIGHT,
            toe_off_most: 95.0 * DEGREE,
            stairs: Some(StairNumbers {
                rise,
                landing_pitch: angle((4.76, 20.19)),
                landing_rate: of((1.1661, 2.28)),
                cop_contact: 0.76,
                cop_flat: of((0.6429, 0.6636)),
                cop_middle: (of((0.2728, 0.195)), of((0.3054, 0.6595))),
                cop_end: of((1.0, 0.8)),
                passings: [
                    (of((0.7558, 0.77)), of((0.029_63, 0.0894)), angle((53.66, 36.26))),
                    (of((0.8533, 0.8665)), of((0.029_17, 0.029_67)), angle((18.68, 16.54))),
                ],
            }),
            ..*self
        }
    }
}
