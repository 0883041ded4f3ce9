//! Cubic splines through keys, bent by tension, continuity and bias.

use crate::harness::{check, check_derivatives, check_stationary, list, number, numbers};
use serde_json::Value;
use solaris_profiles::Elementary;
use solaris_profiles::spline::{Bend, CubicSpline};

/// The cases, with times since the first key: a curve begins at 0.
fn cases() -> impl Iterator<Item = Value> {
    let cases = list("tcb");
    assert_eq!(cases.len(), 12);
    cases.iter().enumerate().map(|(i, case)| {
        let mut case = case.clone();
        let start = number(&case["keys_t"][0]);
        let since = |time: &Value| Value::from(number(time) - start);
        for name in ["keys_t", "t"] {
            case[name] = case[name].as_array().expect("times").iter().map(since).collect();
        }
        for point in case["stationary"].as_array_mut().expect("a list") {
            point["t"] = since(&point["t"]);
        }
        case["id"] = Value::from(format!("keys_{i}"));
        case
    })
}

fn spline<F: Elementary>(case: &Value) -> CubicSpline<F> {
    let positions = numbers(&case["keys"]).into_iter().map(F::from_f64);
    let keys: Vec<_> = numbers(&case["keys_t"]).into_iter().zip(positions).collect();
    let parameter = |name: &str| F::from_f64(number(&case[name]));
    let bend =
        Bend { tension: parameter("tension"), continuity: parameter("continuity"), bias: parameter("bias") };
    CubicSpline::kochanek_bartels(&keys, bend, (parameter("v_start"), parameter("v_end"))).expect("a spline")
}

#[test]
fn positions_velocities_and_accelerations_are_right_to_rounding() {
    for case in cases() {
        check::<f64>(&case, &spline(&case));
        check::<f32>(&case, &spline(&case));
    }
}

#[test]
fn every_turn_is_found_between_the_keys_and_at_them() {
    let mut kinds = std::collections::BTreeMap::new();
    for case in cases() {
        check_stationary(&case, &spline(&case));
        for point in case["stationary"].as_array().expect("a list") {
            *kinds.entry(point["kind"].as_str().expect("a kind").to_owned()).or_insert(0) += 1;
        }
    }
    assert!(kinds["knot"] > 0 && kinds["knot-jump"] > 0 && kinds["reversal"] > 0, "{kinds:?}");
}

#[test]
fn each_derivative_is_that_of_the_one_before() {
    for case in cases() {
        check_derivatives(&case, &spline(&case));
    }
}
