//! Laws of the quintic and the cubic that meet boundary values.

#![allow(clippy::float_cmp, reason = "what is to be met exactly is compared exactly")]

use proptest::prelude::*;
use solaris_profiles::{
    Answers, Boundary, CubicHermite, Curve, Dual, Elementary, Polynomial, Quantity, Quintic, Sample, Turn,
};

fn number() -> impl Strategy<Value = f64> {
    -10.0..10.0
}

fn duration() -> impl Strategy<Value = f64> {
    0.01..100.0
}

fn boundary() -> impl Strategy<Value = Boundary> {
    (number(), number(), number()).prop_map(|(x, v, a)| Boundary::new(x, v, a))
}

fn state(sample: Sample) -> Boundary {
    Boundary::new(sample.position, sample.velocity, sample.acceleration)
}

/// In the direction of the parameter, and its value.
fn lifted<F: Elementary>(b: &Boundary) -> Boundary<F> {
    Boundary::new(F::from_f64(b.position), F::from_f64(b.velocity), F::from_f64(b.acceleration))
}

/// No turn is missed by close sampling, each found one is one, and ranges hold all samples.
fn answers_agree(curve: &impl Answers, most: usize) -> Result<(), TestCaseError> {
    let t = curve.duration();
    let n = 300;
    let times: Vec<f64> = (0..=n).map(|i| t * f64::from(i) / f64::from(n)).collect();
    let samples: Vec<Sample> = times.iter().map(|&t| curve.at(t)).collect();
    let turns = samples.windows(2).filter(|pair| pair[0].velocity * pair[1].velocity < 0.0).count();
    let found = curve.stationary().points;
    prop_assert!(found.len() >= turns && found.len() <= most, "{found:?} {turns}");
    let scale = curve.peaks().velocity.value;
    for point in &found {
        prop_assert!(curve.at(point.time).velocity.abs() <= 1e-12 * scale);
        prop_assert_eq!(point.turn, Turn::Reversal);
    }
    for quantity in [Quantity::Position, Quantity::Velocity, Quantity::Acceleration, Quantity::Jerk] {
        let (low, high) = curve.range(quantity, 0.0, t);
        let slack = 1e-13 * low.abs().max(high.abs());
        for x in samples.iter().map(|sample| quantity.of(sample)) {
            prop_assert!(low - slack <= x && x <= high + slack, "{quantity:?}: {low} {x} {high}");
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn a_quintic_meets_both_ends_to_the_last_digit(t in duration(), start in boundary(), end in boundary()) {
        let curve = Quintic::new(t, start, end).expect("valid");
        prop_assert_eq!((state(curve.at(0.0)), state(curve.at(t))), (start, end));
        let (start, end) = (lifted::<f32>(&start), lifted::<f32>(&end));
        let curve = Quintic::new(t as f32, start, end).expect("valid");
        prop_assert_eq!((curve.at(0.0).position, curve.at(t as f32).position), (start.position, end.position));
        prop_assert_eq!((curve.at(0.0).velocity, curve.at(t as f32).velocity), (start.velocity, end.velocity));
    }

    #[test]
    fn a_cubic_meets_both_ends_to_rounding(
        t in duration(), x0 in number(), v0 in number(), x1 in number(), v1 in number(),
    ) {
        let curve = CubicHermite::new(t, (x0, v0), (x1, v1)).expect("valid");
        prop_assert_eq!((curve.at(0.0).position, curve.at(t).position), (x0, x1));
        for (found, wanted) in [(curve.at(0.0).velocity, v0), (curve.at(t).velocity, v1)] {
            prop_assert!((found - wanted).abs() <= 2.0 * f64::EPSILON * wanted.abs());
        }
        answers_agree(&curve, 2)?;
    }

    #[test]
    fn both_halves_are_one_polynomial(t in duration(), start in boundary(), end in boundary(), share in -0.5..1.5) {
        let curve = Quintic::new(t, start, end).expect("valid");
        // Its Taylor series about its own middle.
        let (middle, h) = (curve.at(0.5 * t), 1e-3 * t);
        let fifth = {
            let [a, b, c] = [0.5 * t - h, 0.5 * t, 0.5 * t + h].map(|t| curve.at(t).jerk);
            [(c - a) / (2.0 * h), (a - 2.0 * b + c) / (h * h)]
        };
        let series = Polynomial([
            middle.position, middle.velocity, middle.acceleration / 2.0,
            middle.jerk / 6.0, fifth[0] / 24.0, fifth[1] / 120.0,
        ]);
        let (found, wanted) = (curve.extrapolated(share * t), series.at((share - 0.5) * t));
        let size = 1.0 + (start.velocity.abs() + end.velocity.abs()) * t
            + (start.acceleration.abs() + end.acceleration.abs()) * t * t
            + start.position.abs() + end.position.abs();
        prop_assert!((found.position - wanted.position).abs() <= 1e-7 * size, "{found:?} {wanted:?}");
    }

    #[test]
    fn each_derivative_is_that_of_the_one_before(
        t in duration(), start in boundary(), end in boundary(), share in -0.2..1.2,
    ) {
        let constant = Dual::<1>::constant;
        let quintic = Quintic::new(constant(t), lifted(&start), lifted(&end)).expect("valid");
        let ends = [&start, &end].map(|b| (constant(b.position), constant(b.velocity)));
        let cubic = CubicHermite::new(constant(t), ends[0], ends[1]).expect("valid");
        let at = Dual::variable(share * t, 0);
        for samples in [quintic.extrapolated(at).to_array(), cubic.extrapolated(at).to_array()] {
            let size = 100.0 * (20.0 + 20.0 * t + 20.0 * t * t);
            for order in 0..3 {
                let (found, wanted) = (samples[order + 1].value(), samples[order].partial(0));
                let scale = size / t.powi(order as i32 + 1);
                prop_assert!((found - wanted).abs() <= 1e-14 * scale, "{order}: {found} {wanted}");
            }
        }
    }

    #[test]
    fn a_quintic_is_the_same_backwards_and_mirrored(
        t in duration(), start in boundary(), end in boundary(), share in 0.0..0.49,
    ) {
        let turned = |b: Boundary| Boundary { velocity: -b.velocity, ..b };
        let curve = Quintic::new(t, start, end).expect("valid");
        let back = Quintic::new(t, turned(end), turned(start)).expect("valid");
        let at = curve.at(t - share * t);
        let reversed = back.at(t - (t - share * t)).reversed();
        // The same polynomial of −w, but for how the time is rounded; the jerk is the steepest.
        let scales = [(start, end), (end, start)].map(|(b, _)| b.position.abs() + t * (b.velocity.abs() + t * b.acceleration.abs()));
        let scale = scales[0] + scales[1];
        for (i, (x, y)) in at.to_array().into_iter().zip(reversed.to_array()).enumerate() {
            prop_assert!((x - y).abs() <= 1e-12 * scale / t.powi(i as i32), "{at:?} {reversed:?}");
        }
        let negated = |b: Boundary| Boundary::new(-b.position, -b.velocity, -b.acceleration);
        let mirror = Quintic::new(t, negated(start), negated(end)).expect("valid").at(share * t);
        prop_assert_eq!(curve.at(share * t).to_array(), mirror.to_array().map(|x| -x));
    }

    #[test]
    fn a_quintic_answers_for_all_of_itself(t in duration(), start in boundary(), end in boundary()) {
        answers_agree(&Quintic::new(t, start, end).expect("valid"), 4)?;
    }

    #[test]
    fn derivatives_by_boundary_values_are_exact(start in boundary(), end in boundary(), share in 0.0..1.0) {
        let t = 1.7;
        let variable = Dual::<6>::variable;
        let lift = |b: &Boundary, i: usize| {
            Boundary::new(variable(b.position, i), variable(b.velocity, i + 1), variable(b.acceleration, i + 2))
        };
        let dual = Quintic::new(Dual::constant(t), lift(&start, 0), lift(&end, 3)).expect("valid");
        let partials = dual.at(Dual::constant(share * t)).position.partials();
        // The curve is linear in its boundary values.
        let values = [start.position, start.velocity, start.acceleration, end.position, end.velocity, end.acceleration];
        let sum: f64 = partials.iter().zip(values).map(|(p, x)| p * x).sum();
        let curve = Quintic::new(t, start, end).expect("valid");
        prop_assert!((sum - curve.at(share * t).position).abs() <= 1e-12);
    }
}

#[test]
fn the_least_jerk_from_rest_to_rest_is_the_known_one() {
    let curve = Quintic::minimum_jerk(2.0, 1.0, 4.0).expect("valid");
    let peaks = curve.peaks();
    assert_eq!(peaks.velocity.time, 1.0);
    assert!((peaks.velocity.value - 15.0 / 8.0 * 1.5).abs() < 1e-15);
    // 10·D/(√3·T²), at (3 − √3)/6 of the duration.
    assert!((peaks.acceleration.value - 30.0 / 3.0_f64.sqrt() / 4.0).abs() < 1e-14);
    assert!((peaks.acceleration.time - (3.0 - 3.0_f64.sqrt()) / 3.0).abs() < 1e-14);
    assert!((peaks.jerk.value - 60.0 * 3.0 / 8.0).abs() < 1e-13 && peaks.jerk.time == 0.0);
    assert!(curve.is_monotone() && curve.stationary().points.is_empty());
}

#[test]
fn a_velocity_that_touches_zero_is_found_as_a_touch() {
    // x = (u − 1/2)³ with u = t/2: v = 3/2·(u − 1/2)², a = 3/2·(u − 1/2).
    let end = |sign: f64| Boundary::new(sign / 8.0, 3.0 / 8.0, sign * 3.0 / 4.0);
    let curve = Quintic::new(2.0, end(-1.0), end(1.0)).expect("valid");
    let points = curve.stationary().points;
    assert_eq!((points.len(), points[0].turn), (1, Turn::Touch), "{points:?}");
    assert!((points[0].time - 1.0).abs() < 1e-7 && curve.is_monotone());
}

#[test]
fn beyond_its_ends_a_polynomial_goes_on() {
    // t², told by its values.
    let curve = CubicHermite::new(2.0, (0.0, 0.0), (4.0, 4.0)).expect("valid");
    assert_eq!((curve.extrapolated(3.0).position, curve.extrapolated(-1.0).position), (9.0, 1.0));
    let end = Boundary::new(4.0, 4.0, 2.0);
    let curve = Quintic::new(2.0, Boundary::new(0.0, 0.0, 2.0), end).expect("valid");
    assert_eq!((curve.extrapolated(3.0).position, curve.extrapolated(-1.0).position), (9.0, 1.0));
    assert_eq!((curve.at(3.0).position, curve.at(-1.0).velocity), (4.0, 0.0));
}
