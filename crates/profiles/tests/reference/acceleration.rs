//! Curves given by their acceleration.

use crate::harness::{cases, check, check_derivatives, check_stationary, parameter};
use serde_json::Value;
use solaris_profiles::Elementary;
use solaris_profiles::acceleration::{Constant, Ellipse, Trigonometric};

/// Duration, and position and velocity at the start.
fn start<F: Elementary>(case: &Value) -> (F, (F, F)) {
    (parameter(case, "T"), (parameter(case, "th0"), parameter(case, "v0")))
}

fn constant<F: Elementary>(case: &Value) -> Constant<F> {
    let (duration, start) = start(case);
    Constant::new(duration, start, parameter(case, "a")).expect("valid")
}

fn trigonometric<F: Elementary>(case: &Value) -> Trigonometric<F> {
    let (duration, start) = start(case);
    Trigonometric::new(duration, start, parameter(case, "am")).expect("valid")
}

fn quarter<F: Elementary>(case: &Value) -> Ellipse<F> {
    let (duration, start) = start(case);
    Ellipse::quarter(duration, start, parameter(case, "am")).expect("valid")
}

fn half<F: Elementary>(case: &Value) -> Ellipse<F> {
    let (duration, start) = start(case);
    Ellipse::half(duration, start, parameter(case, "am")).expect("valid")
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

reference!(constant_acceleration_is_right_to_rounding, "acc_const", constant);
reference!(a_half_sine_of_acceleration_is_right_to_rounding, "acc_trig", trigonometric);
reference!(a_quarter_ellipse_is_right_to_rounding, "acc_ellipse_quarter", quarter);
reference!(a_half_ellipse_is_right_to_rounding, "acc_ellipse_semi", half);
