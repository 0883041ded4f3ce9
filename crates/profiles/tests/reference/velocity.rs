//! Curves given by their velocity.

use crate::harness::{cases, check, check_derivatives, check_stationary, parameter};
use serde_json::Value;
use solaris_profiles::Elementary;
use solaris_profiles::velocity::{Circle, Faired, Line};

fn line<F: Elementary>(case: &Value) -> Line<F> {
    let [duration, from, v0, v1] = ["T", "th0", "v0", "v1"].map(|name| parameter(case, name));
    Line::new(duration, from, (v0, v1)).expect("valid")
}

fn circle<F: Elementary>(case: &Value) -> Circle<F> {
    let [duration, from, v0, v1] = ["T", "th0", "v0", "v1"].map(|name| parameter(case, name));
    let [time, velocity] = ["T1", "vm"].map(|name| parameter(case, name));
    Circle::new(duration, from, (v0, v1), (time, velocity)).expect("valid")
}

fn faired<F: Elementary>(case: &Value) -> Faired<F> {
    let [duration, from, velocity, rise, fall] =
        ["T", "th0", "V", "T1", "T2"].map(|name| parameter(case, name));
    Faired::new(duration, from, velocity, (rise, fall)).expect("valid")
}

macro_rules! reference {
    ($name:ident, $profile:literal, $curve:ident) => {
        #[test]
        fn $name() {
            for case in cases($profile) {
                check(case, &$curve::<f64>(case));
                check(case, &$curve::<f32>(case));
                check_stationary(case, &$curve(case));
                check_derivatives(case, &$curve(case));
            }
        }
    };
}

reference!(a_line_is_right_to_rounding, "vel_line", line);
reference!(a_circle_is_right_to_rounding, "vel_circle", circle);
reference!(a_faired_motion_is_right_to_rounding, "vel_fairing", faired);
