//! The quintic; the cubic is the tension curve of stiffness 0.

use crate::harness::{cases, check, check_derivatives, check_stationary, number, parameter};
use serde_json::Value;
use solaris_profiles::{Boundary, CubicHermite, Elementary, Quintic};

fn quintic<F: Elementary>(case: &Value) -> Quintic<F> {
    let at = |i: usize| {
        let names = [["th0", "v0", "a0"], ["th1", "v1", "a1"]][i];
        let [x, v, a] = names.map(|name| parameter(case, name));
        Boundary::new(x, v, a)
    };
    Quintic::new(parameter(case, "T"), at(0), at(1)).expect("valid")
}

fn cubic<F: Elementary>(case: &Value) -> CubicHermite<F> {
    let [duration, x0, v0, x1, v1] = ["T", "th0", "v0", "th1", "v1"].map(|name| parameter(case, name));
    CubicHermite::new(duration, (x0, v0), (x1, v1)).expect("valid")
}

#[test]
fn a_quintic_is_right_to_rounding() {
    for case in cases("quintic") {
        check(case, &quintic::<f64>(case));
        check(case, &quintic::<f32>(case));
        check_stationary(case, &quintic(case));
        check_derivatives(case, &quintic(case));
    }
}

#[test]
fn a_cubic_is_right_to_rounding() {
    let cubics: Vec<_> =
        cases("disp_tension").into_iter().filter(|case| number(&case["params"]["k"]).abs() <= 0.0).collect();
    assert!(!cubics.is_empty());
    for case in cubics {
        check(case, &cubic::<f64>(case));
        check(case, &cubic::<f32>(case));
        check_stationary(case, &cubic(case));
        check_derivatives(case, &cubic(case));
    }
}
