//! Laws that every curve obeys: derivatives are those of the position, joints are as smooth as promised.

use approx::assert_relative_eq;
use proptest::prelude::*;
use solaris_profiles::{
    Boundary, CubicHermite, Curve, Outside, Piecewise, ProfileError, Quintic, Sample, UniformSpline, step,
};

/// Velocity, acceleration and jerk against central differences of the one before.
fn derivatives_agree(curve: impl Fn(f64) -> Sample, t: f64, scale: f64) {
    let h = 1e-5;
    let (a, b, s) = (curve(t - h), curve(t + h), curve(t));
    let tolerance = 1e-6 * scale;
    assert_relative_eq!(
        (b.position - a.position) / (2.0 * h),
        s.velocity,
        epsilon = tolerance,
        max_relative = 1e-6
    );
    assert_relative_eq!(
        (b.velocity - a.velocity) / (2.0 * h),
        s.acceleration,
        epsilon = tolerance,
        max_relative = 1e-6
    );
    assert_relative_eq!(
        (b.acceleration - a.acceleration) / (2.0 * h),
        s.jerk,
        epsilon = tolerance,
        max_relative = 1e-6
    );
}

fn number() -> impl Strategy<Value = f64> {
    -10.0..10.0
}

fn boundary() -> impl Strategy<Value = Boundary> {
    (number(), number(), number()).prop_map(|(x, v, a)| Boundary::new(x, v, a))
}

proptest! {
    #[test]
    fn a_quintic_meets_all_six_boundary_values(h in 0.05..20.0, start in boundary(), end in boundary()) {
        let curve = Quintic::new(h, start, end).expect("valid");
        let (a, b) = (curve.at(0.0), curve.at(h));
        let scale = 100.0 * (1.0 + h * h);
        for (found, wanted) in [
            (a.position, start.position), (a.velocity, start.velocity), (a.acceleration, start.acceleration),
            (b.position, end.position), (b.velocity, end.velocity), (b.acceleration, end.acceleration),
        ] {
            prop_assert!((found - wanted).abs() < 1e-12 * scale / h.min(1.0).powi(2), "{found} {wanted}");
        }
        derivatives_agree(|t| curve.extrapolated(t), 0.37 * h, 1e4 / h.min(1.0).powi(4));
    }

    #[test]
    fn a_spline_is_c4_and_passes_its_values(
        steps in prop::collection::vec(0.05..1.0, 2..6), values in prop::collection::vec(number(), 6), start in boundary(), end in boundary(),
    ) {
        let knots: Vec<f64> = std::iter::once(0.0).chain(steps.iter().scan(0.0, |t, h| { *t += h; Some(*t) })).collect();
        let inner = &values[..knots.len() - 2];
        let curve = Piecewise::quintic_spline(&knots, inner, start, end).expect("valid");
        for (knot, value) in knots[1..].iter().zip(inner) {
            let e = 1e-7;
            let (before, at) = (curve.at(knot - e), curve.at(*knot));
            prop_assert!((at.position - value).abs() < 1e-9);
            let snap = |t: f64| (curve.at(t + e).jerk - curve.at(t).jerk) / e;
            let (left, right) = (snap(knot - 2.0 * e), snap(knot + e));
            prop_assert!((left - right).abs() < 1e-2 * (1e6 + left.abs()), "{left} {right}");
            // The snap is continuous too, so the jerk changes by snap·e only.
            let change = 2.0 * e * left.abs().max(right.abs()) + 1e-8 * (1e4 + at.jerk.abs());
            prop_assert!((before.jerk - at.jerk).abs() < change, "{} {}", before.jerk, at.jerk);
        }
        let (a, b) = (curve.at(0.0), curve.at(knots[knots.len() - 1]));
        prop_assert!((a.velocity - start.velocity).abs() < 1e-8 && (b.acceleration - end.acceleration).abs() < 1e-5);
    }

    #[test]
    fn steps_have_the_derivatives_they_say(t in 0.01..0.99) {
        derivatives_agree(step::cubic, t, 10.0);
        derivatives_agree(step::quintic, t, 100.0);
        derivatives_agree(step::bump, t, 1000.0);
    }
}

#[test]
fn a_cubic_meets_its_four_values() {
    let curve = CubicHermite::new(2.0, (1.0, -1.0), (3.0, 0.5)).expect("valid");
    assert_relative_eq!(curve.at(0.0).velocity, -1.0);
    assert_relative_eq!(curve.at(2.0).position, 3.0);
    assert_relative_eq!(curve.at(2.0).velocity, 0.5, epsilon = 1e-15);
    derivatives_agree(|t| curve.at(t), 1.3, 10.0);
}

#[test]
fn a_uniform_spline_reproduces_what_it_can() {
    // A sine with 40 samples a period: the error of the sixth-order spline is below (2π/40)⁶/… ≈ 1e-8.
    let n = 40;
    let tau = std::f64::consts::TAU;
    let samples: Vec<[f64; 2]> =
        (0..n).map(|i| (tau * f64::from(i) / f64::from(n)).sin_cos().into()).collect();
    let spline = UniformSpline::periodic(0.5, 1.0 / f64::from(n), &samples).expect("valid");
    for k in 0..97 {
        let t = 0.5 + f64::from(k) * 0.0313;
        let (s, c) = (tau * (t - 0.5)).sin_cos();
        let at = spline.at(0, t);
        assert_relative_eq!(at.position, s, epsilon = 2e-8);
        assert_relative_eq!(at.velocity, tau * c, epsilon = 2e-5);
        assert_relative_eq!(at.acceleration, -tau * tau * s, epsilon = 3e-3);
        assert_relative_eq!(spline.position(t)[1], c, epsilon = 2e-8);
        let jet = spline.jet(t);
        assert_relative_eq!(jet[1][0], at.velocity, epsilon = 1e-12);
        assert_relative_eq!(jet[2][0], at.acceleration, epsilon = 1e-10);
        derivatives_agree(|t| spline.at(1, t), t + 0.0001, 1e3);
    }
}

#[test]
fn a_resting_spline_rests() {
    let samples: Vec<[f64; 1]> =
        (0..60).map(|i| [step::quintic((f64::from(i) - 20.0) / 20.0).position]).collect();
    let spline = UniformSpline::resting(0.0, 0.1, &samples).expect("valid");
    for (i, sample) in samples.iter().enumerate() {
        assert_relative_eq!(spline.at(0, 0.1 * i as f64).position, sample[0], epsilon = 1e-14);
    }
    for t in [-100.0, -1.0, 0.0, 5.95, 7.0, 1e9] {
        let at = spline.at(0, t);
        assert_relative_eq!(at.position, f64::from(u8::from(t > 3.0)), epsilon = 1e-7);
        assert_relative_eq!(at.velocity, 0.0, epsilon = 1e-6);
    }
}

#[test]
fn outside_its_span_a_curve_holds_or_repeats() {
    let (start, end) = (Boundary::new(0.0, 1.0, 0.0), Boundary::new(0.5, -1.0, 0.0));
    let curve = Piecewise::quintic_spline(&[0.0, 1.0, 2.0], &[1.0], start, end).expect("valid");
    assert_eq!(curve.at(-3.0), Sample::default());
    assert_relative_eq!(curve.at(5.0).position, 0.5);
    assert_relative_eq!(curve.at(5.0).velocity, 0.0);
    let repeated = curve.clone().outside(Outside::Repeat);
    assert_relative_eq!(repeated.at(7.3).position, curve.at(1.3).position, epsilon = 1e-12);
}

#[test]
fn bad_input_is_refused() {
    let rest = Boundary::rest(0.0);
    assert_eq!(Quintic::new(0.0, rest, rest), Err(ProfileError::Duration { duration: 0.0 }));
    assert!(matches!(Quintic::new(1.0, Boundary::rest(f64::NAN), rest), Err(ProfileError::NotFinite { .. })));
    assert!(matches!(
        CubicHermite::new(f64::INFINITY, (0.0, 0.0), (1.0, 0.0)),
        Err(ProfileError::NotFinite { .. })
    ));
    // A span too short for its values.
    assert!(matches!(Quintic::new(1e-300, rest, Boundary::rest(1.0)), Err(ProfileError::Overflow { .. })));
    assert!(Piecewise::quintic_spline(&[0.0, 1e-200], &[], rest, Boundary::rest(1.0)).is_err());
    let unordered = Piecewise::quintic_spline(&[0.0, 1.0, 1.0], &[0.0], rest, rest);
    assert_eq!(unordered, Err(ProfileError::Knots { index: 2, time: 1.0, before: 1.0 }));
    let missing = Piecewise::quintic_spline(&[0.0, 1.0, 2.0], &[], rest, rest);
    assert_eq!(missing, Err(ProfileError::Count { what: "values at inner knots", found: 0, needed: 1 }));
    assert!(UniformSpline::<1>::resting(0.0, 1.0, &[]).is_err());
    assert!(UniformSpline::resting(0.0, -1.0, &[[0.0]]).is_err());
}
