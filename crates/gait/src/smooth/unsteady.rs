//! The style of steps that are not steady: those that begin and end a walk, that turn, and on ground that is not level.
//!
//! A leg that starts, stops or turns goes through arcs that no steady stride has, and the numbers of [`super::walk::WalkNumbers`] and of slopes
//! and stairs were tuned to these rows; what people's steady strides are held against says nothing of such steps.

use super::footfall::Footfall;
use super::style::{PelvicList, StyleTable};

impl StyleTable {
    /// The style of steps that are not steady.
    pub fn unsteady() -> Self {
        Self {
            rows: ROWS.map(|(_, row)| row),
            manner: None,
            footfall: Footfall::SMOOTH,
            list: PelvicList::RECIPE,
        }
    }
}

/// By the names of [`StyleTable::NUMBERS`], in their order. One offline least-squares fit over all speeds at once (docs/walking.md).
const ROWS: [(&str, [f64; 4]); StyleTable::NUMBERS.len()] = [
    ("heel_strike_angle", [17.42, 3.32, 0.23, 0.55]),
    ("height1", [0.01687, 0.00139, 0.00032, 0.00029]),
    ("height1_phase", [0.0121, -0.0059, 0.0129, 0.0406]),
    ("height2_cos", [-0.00118, 0.00093, 0.00004, -0.00024]),
    ("height2_sin", [0.00079, -0.00097, -0.00001, -0.00075]),
    ("height3_cos", [-0.00012, -0.00015, -0.00011, -0.00003]),
    ("height3_sin", [0.00014, 0.00037, -0.00010, -0.00025]),
    ("pelvic_obliquity", [3.90, 0.39, 0.02, 0.56]),
    ("obliquity_phase", [0.0346, 0.0178, -0.0005, 0.0255]),
    ("foot_flat", [0.0796, -0.0116, -0.0005, 0.0114]),
    ("knee_contact", [7.38, 0.91, 1.02, -3.24]),
    ("knee_contact_rate", [120.5, 39.5, 13.0, -4.9]),
    ("knee_contact_acc", [2215.0, 3049.0, 1997.0, 2120.0]),
    ("knee_push", [11.90, -3.54, -0.39, 6.65]),
    ("knee_toe_off", [41.50, -4.82, 1.23, -19.37]),
    ("knee_toe_off_rate", [363.1, 20.1, 26.2, -174.8]),
    ("knee_toe_off_acc", [-656.4, 672.9, 80.0, 784.4]),
    ("toe_roll", [34.78, -0.96, -0.14, 36.22]),
    ("knee_peak", [65.17, -4.87, -1.53, -0.55]),
    ("knee_peak_at", [0.7503, -0.0027, -0.0026, 0.0436]),
    ("thigh_swing", [28.80, -0.61, 1.24, -1.67]),
    ("ankle_swing", [6.17, -0.31, -0.41, 1.66]),
    ("cop_forward", [1.0609, 0.2194, -0.0662, 0.6133]),
    ("cop_middle", [0.7494, 0.0063, -0.0016, 0.0387]),
    ("cop_40", [0.7914, 0.0187, -0.0087, 0.0759]),
    ("cop_50", [0.7964, 0.0360, 0.0230, 0.0912]),
    ("heel_off", [0.3248, 0.0146, -0.0038, 0.0421]),
    ("thorax_lean", [-0.36, -1.55, 0.08, 0.69]),
    ("knee_late_swing", [4.48, 0.21, 1.76, 1.09]),
    ("thorax_bend_sin", [5.31, -0.03, 0.17, -0.79]),
    ("thorax_bend_cos", [-2.65, -1.71, 0.88, -0.58]),
    ("thorax_yaw", [7.06, 0.15, 0.08, -0.44]),
    ("arm_swing", [23.80, 7.65, -2.74, -31.84]),
    ("share_exponent", [0.7408, -0.0568, 0.0354, -0.2458]),
    ("step_width", [0.1117, -0.0016, -0.0056, -0.0858]),
    ("tip_roll", [0.4268, -0.1015, 0.0126, 0.2992]),
    ("pelvic_rotation", [5.82, 1.43, -0.18, -0.59]),
    ("pivot", [1.4592, -0.0340, -0.0140, 1.8694]),
    ("arm_lag", [-0.0213, 0.0353, -0.0045, 0.0037]),
    ("thorax_yaw_phase", [-0.0076, 0.0293, 0.0768, -0.0143]),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_in_the_order_of_the_numbers() {
        assert_eq!(ROWS.map(|(name, _)| name), StyleTable::NUMBERS.map(|(name, _)| name));
    }
}
