//! The file of reference numbers, and the law that errors obey.

use serde_json::Value;
use solaris_profiles::{Answers, Curve, Dual, Elementary, Turn};
use std::sync::LazyLock;

static FILE: LazyLock<Value> = LazyLock::new(|| {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/reference/profiles.json");
    serde_json::from_str(&std::fs::read_to_string(path).expect("the file")).expect("JSON")
});

/// The entries of one list of the file: `cases`, `blends`, `blended`, `tcb`.
pub(crate) fn list(name: &str) -> &'static [Value] {
    FILE[name].as_array().expect("a list")
}

/// The cases of one profile; never none.
pub(crate) fn cases(profile: &str) -> Vec<&'static Value> {
    let cases: Vec<_> = list("cases").iter().filter(|case| case["profile"] == profile).collect();
    assert!(!cases.is_empty(), "no case of {profile}");
    cases
}

/// A number, be it written as one or as a string of digits.
pub(crate) fn number(value: &Value) -> f64 {
    match value {
        Value::String(digits) => digits.parse().expect("a number"),
        other => other.as_f64().expect("a number"),
    }
}

/// The numbers of a list.
pub(crate) fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(number).collect()
}

/// A parameter of a case in the scalar of the curve.
pub(crate) fn parameter<F: Elementary>(case: &Value, name: &str) -> F {
    F::from_f64(number(&case["params"][name]))
}

/// Half the distance from 1 to the next number.
pub(crate) fn unit<F: Elementary>() -> f64 {
    F::EPSILON / 2.0
}

/// |found − wanted| ≤ 8·ε·(cond + |wanted| + max |wanted|) for one column of numbers; answers the worst quotient.
pub(crate) fn check_column(what: &str, found: &[f64], wanted: &[f64], cond: &[f64], epsilon: f64) -> f64 {
    let largest = wanted.iter().filter(|x| x.is_finite()).fold(0.0_f64, |m, x| m.max(x.abs()));
    let mut worst = 0.0_f64;
    for (i, (&found, &wanted)) in found.iter().zip(wanted).enumerate() {
        if wanted.is_infinite() {
            assert!(
                found.is_infinite() && found.signum() * wanted > 0.0,
                "{what}[{i}]: {found}, not {wanted}"
            );
            continue;
        }
        let scale = cond.get(i).copied().unwrap_or(0.0) + wanted.abs() + largest;
        let error = (found - wanted).abs();
        assert!(
            error <= 8.0 * epsilon * scale,
            "{what}[{i}]: {found:e}, not {wanted:e}: {} of 8",
            error / (epsilon * scale)
        );
        if scale > 0.0 {
            worst = worst.max(error / (epsilon * scale));
        }
    }
    worst
}

/// Position, velocity and acceleration of a curve at the times of a case.
pub(crate) fn check<F: Elementary>(case: &Value, curve: &impl Curve<F>) {
    let id = format!("{} in {}", case["id"].as_str().unwrap_or("?"), std::any::type_name::<F>());
    let samples: Vec<_> = numbers(&case["t"]).into_iter().map(|t| curve.at_time(t)).collect();
    let columns: [(&str, &str, Vec<f64>); 3] = [
        ("theta", "cond_theta", samples.iter().map(|s| s.position.value()).collect()),
        ("v", "cond_v", samples.iter().map(|s| s.velocity.value()).collect()),
        ("a", "cond_a", samples.iter().map(|s| s.acceleration.value()).collect()),
    ];
    for (name, cond, found) in columns {
        let cond = case.get(cond).map(numbers).unwrap_or_default();
        let worst = check_column(&format!("{id}: {name}"), &found, &numbers(&case[name]), &cond, unit::<F>());
        println!("{id}: {name} {worst:.2}");
    }
}

/// The stationary points of a case: none missing, none extra, within 2e-12·T.
pub(crate) fn check_stationary(case: &Value, curve: &impl Answers) {
    let id = case["id"].as_str().unwrap_or("?");
    let wanted = case["stationary"].as_array().expect("a list");
    let found = curve.stationary();
    assert_eq!(found.points.len(), wanted.len(), "{id}: {found:?}, not {wanted:?}");
    assert!(found.rests.is_empty(), "{id}: {found:?}");
    for (found, wanted) in found.points.iter().zip(wanted) {
        let error = (found.time - number(&wanted["t"])).abs();
        assert!(error <= 2e-12 * curve.duration(), "{id}: {} is {error:e} off", found.time);
        let turn = if wanted["kind"] == "touch" { Turn::Touch } else { Turn::Reversal };
        assert_eq!(found.turn, turn, "{id} at {}", found.time);
    }
}

/// Velocity, acceleration and jerk against the derivatives of dual numbers of the one before, inside of the span.
pub(crate) fn check_derivatives(case: &Value, curve: &impl Curve<Dual<1>>) {
    let id = case["id"].as_str().unwrap_or("?");
    let times = numbers(&case["t"]);
    let samples: Vec<_> =
        times[1..times.len() - 1].iter().map(|&t| curve.at(Dual::variable(t, 0)).to_array()).collect();
    for order in 0..3 {
        let wanted: Vec<f64> = samples.iter().map(|sample| sample[order].partial(0)).collect();
        let largest = wanted.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        // Where what is differentiated hardly changes, its own rounding errors are seen.
        let noise = samples.iter().fold(0.0_f64, |m, sample| m.max(sample[order].value().abs()));
        let noise = 16.0 * unit::<f64>() * noise / curve.duration().value();
        for ((t, sample), wanted) in times[1..].iter().zip(&samples).zip(&wanted) {
            let found = sample[order + 1].value();
            assert!(
                (found - wanted).abs() <= 1e-11 * largest + noise,
                "{id} at {t}: derivative {} is {found:e}, not {wanted:e}",
                order + 1
            );
        }
    }
}
