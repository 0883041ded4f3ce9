//! The natural quintic spline against another program's, and what must hold of it for any samples.

use approx::assert_relative_eq;
use proptest::prelude::*;
use solaris_profiles::{NaturalSpline, ProfileError, Sample};

fn spline(knots: &[f64], values: &[f64]) -> NaturalSpline {
    NaturalSpline::new(knots, values).expect("rising knots")
}

/// Ten unequal knots and a wave with two frequencies.
fn wave() -> NaturalSpline {
    let knots = [0.0, 0.1, 0.25, 0.3, 0.5, 0.55, 0.8, 1.0, 1.3, 1.35];
    spline(&knots, &knots.map(|t: f64| (3.0 * t).sin() + 0.3 * (11.0 * t).cos()))
}

/// Computed with `scipy` 1.17.1, `make_interp_spline(k=5)` with third and fourth derivatives zero at both ends.
#[test]
fn a_time_that_is_no_number_gives_none() {
    let curve = NaturalSpline::new(&[0.0, 1.0, 2.0, 4.0], &[0.0, 1.0, 0.5, 2.0]).expect("a spline");
    assert!(curve.at(f64::NAN).to_array().iter().all(|x| x.is_nan()));
}

#[test]
#[rustfmt::skip]
fn derivatives_are_those_of_scipy() {
    let velocity = [
        2.691_054_516_850_77, 0.061_824_461_759_164_6, 0.906_475_747_792_699, 2.402_224_144_376_77, 2.582_587_049_454_24,
        0.451_097_789_753_753, -3.579_039_117_741_85, -0.690_655_179_071_15, -4.797_146_460_138, -5.132_163_123_030_24,
    ];
    let acceleration = [
        -28.307_269_164_744_1, -20.247_394_709_431_9, 28.862_065_849_165_6, 28.881_822_237_599_8, -35.052_295_419_897_2,
        -48.251_999_222_844_5, 26.564_975_418_350_6, -8.877_555_364_467_07, -7.043_995_417_083_84, -6.585_779_204_763_64,
    ];
    let curve = wave();
    for (i, node) in curve.nodes().iter().enumerate() {
        assert_relative_eq!(node.velocity, velocity[i], max_relative = 2e-12);
        assert_relative_eq!(node.acceleration, acceleration[i], max_relative = 2e-12);
    }
    let between = [
        (0.05, [0.399_294_574_924_972_83, 1.288_284_612_449_991, -27.299_784_857_830_133, 60.449_058_414_842_46]),
        (0.4, [0.839_096_562_250_521_2, 4.197_803_182_057_783, 2.895_340_083_655_377_3, -362.488_445_769_426_6]),
        (0.9, [0.208_084_136_344_688_53, -1.069_345_427_002_968_3, 17.241_024_526_554_373, -248.988_034_647_424_29]),
        (1.32, [-0.833_722_306_065_725_3, -4.933_847_436_623_337, -6.684_753_906_625_929, 9.897_470_186_100_69]),
    ];
    for (t, expected) in between {
        for (ours, theirs) in numbers(&curve.at(t)).iter().zip(expected) {
            assert_relative_eq!(*ours, theirs, max_relative = 1e-10);
        }
    }
}

fn numbers(sample: &Sample) -> [f64; 4] {
    [sample.position, sample.velocity, sample.acceleration, sample.jerk]
}

#[test]
fn one_sample_rests_two_are_a_line_three_a_parabola() {
    let one = numbers(&spline(&[2.0], &[7.0]).at(5.0)).map(f64::to_bits);
    assert_eq!(one, [7.0, 0.0, 0.0, 0.0_f64].map(f64::to_bits));
    let two = numbers(&spline(&[2.0, 4.0], &[1.0, 2.0]).at(8.0)).map(f64::to_bits);
    assert_eq!(two, [4.0, 0.5, 0.0, 0.0_f64].map(f64::to_bits));
    let parabola = |t: f64| 1.0 - 2.0 * t + 3.0 * t * t;
    let knots = [0.0, 0.5, 2.0];
    let sample = spline(&knots, &knots.map(parabola)).at(1.0);
    for (ours, exact) in numbers(&sample).into_iter().zip([2.0, 4.0, 6.0, 0.0]) {
        assert_relative_eq!(ours, exact, epsilon = 1e-12);
    }
}

#[test]
fn the_jerk_and_its_rate_vanish_at_the_ends() {
    let curve = wave();
    for (end, inside) in [(0.0, 1e-4), (1.35, 1.35 - 1e-4)] {
        assert_relative_eq!(curve.at(inside + (inside - end) * 1e-9).jerk, 0.0, epsilon = 1e-3);
        assert_eq!(curve.at(end).jerk.to_bits() << 1, 0);
    }
}

/// Order of convergence in the middle: sixth, fifth, fourth. Over ten knots from an end the ends' own error is gone.
#[test]
fn inside_it_converges_with_the_sixth_fifth_and_fourth_power() {
    let worst = |n: usize| {
        // Steps alternate 2 : 3, so that nothing rests on their being equal.
        let mut knots = vec![0.0];
        for i in 0..n {
            knots.push(knots[i] + if i % 2 == 0 { 0.8 } else { 1.2 } / n as f64);
        }
        let values: Vec<f64> = knots.iter().map(|t| (4.0 * t).sin()).collect();
        let curve = spline(&knots, &values);
        let mut error = [0.0_f64; 3];
        for k in 0..=100 {
            let t = 0.4 + 0.002 * f64::from(k);
            let (sine, cosine) = (4.0 * t).sin_cos();
            let exact = [sine, 4.0 * cosine, -16.0 * sine];
            for (error, (ours, exact)) in error.iter_mut().zip(numbers(&curve.at(t)).into_iter().zip(exact)) {
                *error = error.max((ours - exact).abs());
            }
        }
        error
    };
    let (coarse, fine) = (worst(60), worst(120));
    for (order, (coarse, fine)) in [6.0, 5.0, 4.0].into_iter().zip(coarse.into_iter().zip(fine)) {
        let found = (coarse / fine).log2();
        assert!((found - order).abs() < 0.3, "order {found} for {order}: {coarse:e} to {fine:e}");
    }
}

/// A million samples: time in proportion, and rounding that does not grow along the record.
#[test]
fn a_million_samples_are_as_good_as_a_thousand() {
    let error = |n: usize| {
        let step = 1e-3;
        let knots: Vec<f64> = (0..n).map(|i| (i as f64 + 0.2 * (i as f64).sin()) * step).collect();
        let values: Vec<f64> = knots.iter().map(|t| (5.0 * t).sin()).collect();
        let curve = spline(&knots, &values);
        let inside = knots.iter().zip(curve.nodes()).skip(60).take(n - 120);
        inside.map(|(t, node)| (node.acceleration + 25.0 * (5.0 * t).sin()).abs()).fold(0.0, f64::max)
    };
    let (thousand, million) = (error(1000), error(1_000_000));
    // The samples themselves hold 2.2e-16/2, which 1/step² makes 1e-10 and a spline's norm some times more; the time of a
    // sample late in the record has fewer digits still: 1000 s · 1.1e-16 · 5 rad/s / step².
    assert!(thousand < 1e-8 && million < 2e-5, "{thousand:e}, {million:e}");
}

#[test]
fn what_is_no_record_is_refused() {
    let error =
        |knots: &[f64], values: &[f64]| NaturalSpline::new(knots, values).expect_err("none").to_string();
    assert_eq!(error(&[], &[]), "samples: 0 given, 1 needed");
    assert_eq!(error(&[0.0, 1.0], &[0.0]), "values: 1 given, 2 needed");
    let message = error(&[0.0, 1.0, 1.0], &[0.0; 3]);
    assert_eq!(message, "time 1 (number 3) does not lie after the one before it, 1; times must rise");
    let error = NaturalSpline::new(&[0.0, 1.0], &[0.0, f64::NAN]);
    assert!(matches!(error, Err(ProfileError::NotFinite { .. })));
}

fn record() -> impl Strategy<Value = (Vec<f64>, Vec<f64>)> {
    prop::collection::vec((0.05..1.0_f64, -1.0..1.0_f64), 3..40).prop_map(|rows| {
        let mut t = -2.0;
        rows.into_iter()
            .map(|(step, value)| {
                t += step;
                (t, value)
            })
            .unzip()
    })
}

proptest! {
    #[test]
    fn it_goes_through_its_samples_and_is_smooth_over_them((knots, values) in record()) {
        let curve = spline(&knots, &values);
        for (i, (&t, &x)) in knots.iter().zip(&values).enumerate() {
            let at = curve.at(t);
            prop_assert_eq!(at.position.to_bits(), x.to_bits());
            // From both sides: the value just before, carried on by the Taylor series.
            let before = curve.at(t - 1e-7);
            let scale = 1.0 + curve.nodes().iter().map(|node| node.acceleration.abs()).fold(0.0, f64::max);
            prop_assert!((before.velocity + 1e-7 * before.acceleration - at.velocity).abs() < 1e-7 * scale);
            prop_assert!((before.acceleration + 1e-7 * before.jerk - at.acceleration).abs() < 1e-6 * scale / 0.05);
            prop_assert!((before.jerk - at.jerk).abs() < 1e-4 * scale / 0.0025, "knot {i}: {} {}", before.jerk, at.jerk);
        }
    }

    #[test]
    fn parabolas_come_back((knots, _) in record(), c in prop::array::uniform3(-3.0..3.0_f64)) {
        let values: Vec<f64> = knots.iter().map(|t| c[0] + t * (c[1] + t * c[2])).collect();
        let curve = spline(&knots, &values);
        let scale = 1e-10 * (1.0 + knots.last().map_or(0.0, |t| t * t));
        for t in knots.iter().flat_map(|t| [*t, t + 0.02, t - 40.0]) {
            let at = curve.at(t);
            let far = 1.0 + t * t;
            prop_assert!((at.position - c[0] - t * (c[1] + t * c[2])).abs() < scale * far);
            prop_assert!((at.velocity - c[1] - 2.0 * t * c[2]).abs() < scale * far);
            prop_assert!((at.acceleration - 2.0 * c[2]).abs() < 1e3 * scale);
        }
    }

    /// Backwards in time and upside down: velocities keep their sign, accelerations change it.
    #[test]
    fn a_mirrored_record_has_a_mirrored_curve((knots, values) in record()) {
        let there = spline(&knots, &values);
        let reversed: Vec<f64> = knots.iter().rev().map(|t| -t).collect();
        let down: Vec<f64> = values.iter().rev().map(|x| -x).collect();
        let back = spline(&reversed, &down);
        let scale = 1.0 + there.nodes().iter().map(|node| node.acceleration.abs()).fold(0.0, f64::max);
        for (a, b) in there.nodes().iter().zip(back.nodes().iter().rev()) {
            prop_assert!((a.velocity - b.velocity).abs() < 1e-10 * scale);
            prop_assert!((a.acceleration + b.acceleration).abs() < 1e-9 * scale);
        }
    }
}
