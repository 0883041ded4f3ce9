//! The curves for displacement, and the thesis's own hyperbolic basis.

use crate::harness::{
    cases, check, check_column, check_derivatives, check_stationary, number, numbers, parameter, unit,
};
use serde_json::Value;
use solaris_profiles::displacement::{
    Exponential, ExponentialVelocities, Hyperbolic, Line, Power, Tension, Trigonometric,
    TrigonometricVelocities,
};
use solaris_profiles::{Curve, Elementary, ProfileError, legacy};

fn whole(case: &Value, name: &str) -> u32 {
    number(&case["params"][name]) as u32
}

/// Duration, start and end positions.
fn motion<F: Elementary>(case: &Value) -> (F, F, F) {
    (parameter(case, "T"), parameter(case, "th0"), parameter(case, "th1"))
}

/// Duration, start and end with their velocities.
fn motion_with_velocities<F: Elementary>(case: &Value) -> (F, (F, F), (F, F)) {
    let (duration, from, to) = motion(case);
    (duration, (from, parameter(case, "v0")), (to, parameter(case, "v1")))
}

macro_rules! families {
    ($($test:ident: $profile:literal, $curve:ident, |$case:ident| $make:expr;)*) => {
        $(
            #[test]
            fn $test() {
                fn curve<F: Elementary>($case: &Value) -> $curve<F> {
                    $make.expect("a curve")
                }
                for case in cases($profile) {
                    check::<f64>(case, &curve(case));
                    check::<f32>(case, &curve(case));
                    check_stationary(case, &curve(case));
                    check_derivatives(case, &curve(case));
                }
            }
        )*
    };
}

families! {
    line: "disp_line", Line, |case| {
        let (duration, from, to) = motion(case);
        Line::new(duration, from, to)
    };
    trigonometric: "disp_trig", Trigonometric, |case| {
        let (duration, from, to) = motion(case);
        Trigonometric::new(duration, from, to)
    };
    trigonometric_with_velocities: "disp_trig_vel", TrigonometricVelocities, |case| {
        let (duration, start, end) = motion_with_velocities(case);
        TrigonometricVelocities::new(duration, start, end)
    };
    power: "disp_pow", Power, |case| {
        let (duration, from, to) = motion(case);
        Power::new(duration, from, to, parameter(case, "n"))
    };
    exponential: "disp_exp_s", Exponential, |case| {
        let (duration, from, to) = motion(case);
        Exponential::new(duration, from, to, parameter(case, "n"), parameter(case, "s"))
    };
    exponential_with_velocities: "disp_exp_vel", ExponentialVelocities, |case| {
        let (duration, start, end) = motion_with_velocities(case);
        ExponentialVelocities::new(duration, start, end, whole(case, "n"), parameter(case, "s"))
    };
    hyperbolic: "disp_sinh", Hyperbolic, |case| {
        let (duration, from, to) = motion(case);
        Hyperbolic::new(duration, from, to, parameter(case, "k"))
    };
    tension: "disp_tension", Tension, |case| {
        let (duration, start, end) = motion_with_velocities(case);
        Tension::new(duration, start, end, parameter(case, "k"))
    };
}

/// The thesis's basis has a linear system to be solved, which amplifies the errors: 8·ε·κ, with κ the condition number of
/// the system of the four unknowns, each column divided by its greatest entry.
#[test]
fn legacy_hyperbolic() {
    fn curve<F: Elementary>(case: &Value) -> Result<legacy::Hyperbolic<F>, ProfileError> {
        let (duration, start, end) = motion_with_velocities(case);
        legacy::Hyperbolic::new(duration, start, end)
    }
    fn check_one<F: Elementary>(case: &Value)
    where
        legacy::Hyperbolic<F>: Curve<F>,
    {
        let curve = curve::<F>(case).expect("a curve");
        let kappa = condition(number(&case["params"]["T"]));
        let samples: Vec<_> = numbers(&case["t"]).into_iter().map(|t| curve.at_time(t)).collect();
        let columns: [(&str, Vec<f64>); 3] = [
            ("theta", samples.iter().map(|s| s.position.value()).collect()),
            ("v", samples.iter().map(|s| s.velocity.value()).collect()),
            ("a", samples.iter().map(|s| s.acceleration.value()).collect()),
        ];
        for (name, found) in columns {
            let what = format!("{}: {name}", case["id"]);
            check_column(&what, &found, &numbers(&case[name]), &[], unit::<F>() * kappa);
        }
    }
    for case in cases("disp_sinh_vel_thesis") {
        check_one::<f64>(case);
        check_one::<f32>(case);
        check_stationary(case, &curve(case).expect("a curve"));
        check_derivatives(case, &curve(case).expect("a curve"));
    }
}

/// κ∞ of the system for the factors of sinh(t/T), t·sinh t, sinh t, 1, by its inverse.
fn condition(t: f64) -> f64 {
    let mut rows = vec![
        vec![0.0, 0.0, 0.0, 1.0],
        vec![1.0_f64.sinh(), t * t.sinh(), t.sinh(), 1.0],
        vec![1.0 / t, 0.0, 1.0, 0.0],
        vec![1.0_f64.cosh() / t, t.sinh() + t * t.cosh(), t.cosh(), 0.0],
    ];
    for column in 0..4 {
        let largest = rows.iter().fold(0.0_f64, |m, row| m.max(row[column].abs()));
        for row in &mut rows {
            row[column] /= largest;
        }
    }
    let norm =
        |rows: &[Vec<f64>]| rows.iter().map(|row| row.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max);
    let size: f64 = norm(&rows);
    for (i, row) in rows.iter_mut().enumerate() {
        row.extend((0..4).map(|j| f64::from(u8::from(i == j))));
    }
    // Gauss and Jordan, with the greatest pivot.
    for i in 0..4 {
        let pivot = (i..4).max_by(|&a, &b| rows[a][i].abs().total_cmp(&rows[b][i].abs())).expect("a row");
        rows.swap(i, pivot);
        let head = rows[i][i];
        rows[i].iter_mut().for_each(|x| *x /= head);
        let row = rows[i].clone();
        for j in (0..4).filter(|&j| j != i) {
            let factor = rows[j][i];
            rows[j].iter_mut().zip(&row).for_each(|(x, y)| *x -= factor * y);
        }
    }
    let inverse: Vec<Vec<f64>> = rows.iter().map(|row| row[4..].to_vec()).collect();
    size * norm(&inverse)
}

#[test]
fn the_thesis_basis_is_refused_where_it_has_no_solution() {
    let pole = 2.827_181_757_169_648;
    for duration in [1.0, 1.0 + 1e-12, pole, pole + 1e-12, 711.0, 1e4] {
        let error = legacy::Hyperbolic::new(duration, (0.0, 1.0), (5.0, 1.0)).expect_err("none");
        let text = error.to_string();
        assert!(text.contains("duration") && text.contains("2.827181757169648"), "{text}");
    }
    assert!(legacy::Hyperbolic::new(1.0 + 1e-8, (0.0, 1.0), (5.0, 1.0)).is_ok());
    assert!(legacy::Hyperbolic::<f32>::new(90.0, (0.0, 1.0), (5.0, 1.0)).is_err());
}
