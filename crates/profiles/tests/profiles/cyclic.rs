//! Sines and repeated curves against trigonometry and against the curve that is repeated.

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use proptest::prelude::*;
use solaris_profiles::cyclic::{Repeat, Sine};
use solaris_profiles::{Answers, Curve, Dual, Profile, Quantity, Quintic, Turn};

proptest! {
    #[test]
    fn a_sine_is_that_of_trigonometry_and_its_rates_are_derivatives(
        amplitude in -3.0..3.0_f64, period in 0.05..20.0_f64, cycles in 0.1..50.0_f64, phase in -10.0..10.0_f64,
        offset in -2.0..2.0_f64, share in 0.0..1.0_f64,
    ) {
        let sine = Sine::new(amplitude, period, cycles, phase, offset).expect("a sine");
        let t = share * sine.duration();
        let sample = sine.at(t);
        let angle = TAU * t / period + phase;
        prop_assert!((sample.position - (offset + amplitude * angle.sin())).abs() < 1e-12);
        let dual = Sine::new(
            Dual::<1>::constant(amplitude), Dual::constant(period), cycles, Dual::constant(phase), Dual::constant(offset),
        ).expect("a sine").at(Dual::variable(t, 0));
        let scale = TAU / period;
        for (rate, of, power) in [
            (sample.velocity, dual.position, 1), (sample.acceleration, dual.velocity, 2), (sample.jerk, dual.acceleration, 3),
        ] {
            prop_assert!((rate - of.partial(0)).abs() <= 1e-11 * scale.powi(power) * (1.0 + amplitude.abs()));
        }
    }

    #[test]
    fn a_repeated_curve_is_that_curve_in_each_of_its_laps(duration in 0.1..5.0_f64, times in 1_u32..20, share in 0.01..0.99_f64) {
        let curve = Quintic::minimum_jerk(duration, 0.3, -1.0).expect("a curve");
        let repeated = Repeat::new(curve, times).expect("repeats");
        prop_assert!((repeated.duration() - f64::from(times) * duration).abs() < 1e-12);
        for k in 0..times {
            let (found, own) = (repeated.at((f64::from(k) + share) * duration), curve.at(share * duration));
            prop_assert!((found.position - own.position).abs() < 1e-12);
            prop_assert!((found.acceleration - own.acceleration).abs() < 1e-9 * (1.0 + own.acceleration.abs() / duration));
            let joint = f64::from(k) * duration;
            prop_assert_eq!(repeated.at(joint).position.to_bits(), 0.3_f64.to_bits());
            if k > 0 {
                prop_assert_eq!(repeated.before(joint).position.to_bits(), (-1.0_f64).to_bits());
            }
        }
        prop_assert_eq!(repeated.at(repeated.duration()).position.to_bits(), (-1.0_f64).to_bits());
    }
}

#[test]
fn a_sine_turns_at_its_peaks_and_is_greatest_there() {
    // From 0.5 + 0.2·sin(π/6) on: peaks at π/2 and 3π/2 of each cycle, 2 s long.
    let sine = Sine::new(0.2, 2.0, 1.5, PI / 6.0, 0.5).expect("a sine");
    let times: Vec<f64> = sine.stationary().points.iter().map(|point| point.time).collect();
    let expected = [1.0 / 3.0, 4.0 / 3.0, 7.0 / 3.0];
    assert_eq!(times.len(), 3, "{times:?}");
    assert!(times.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{times:?}");
    assert!(sine.stationary().points.iter().all(|point| point.turn == Turn::Reversal));
    let (low, high) = sine.range(Quantity::Position, 0.0, sine.duration());
    assert!((low - 0.3).abs() < 1e-15 && (high - 0.7).abs() < 1e-15);
    assert!((sine.peaks().velocity.value - 0.2 * PI).abs() < 1e-14);
    // Its thousandth cycle is as good as its first.
    let long = Sine::new(1.0_f64, 0.3, 2000.0, 0.0, 0.0).expect("a sine");
    assert!((long.at(1000.25 * 0.3).position - 1.0_f64).abs() < 1e-12);
    assert!(Sine::new(1.0_f64, 1.0, 1.0, FRAC_PI_2, 0.0).expect("a sine").at(0.0).velocity.abs() < 1e-15);
}

#[test]
fn joints_are_told_as_what_they_are() {
    // To and fro: the motion turns at each joint, from rest to rest.
    let there = Quintic::minimum_jerk(1.0, 0.0, 1.0).expect("a curve");
    let turns = Repeat::new(there, 3).expect("repeats").stationary();
    let times: Vec<f64> = turns.points.iter().map(|point| point.time).collect();
    assert!(
        times.len() == 2 && (times[0] - 1.0).abs() < 1e-15 && (times[1] - 2.0).abs() < 1e-15,
        "{times:?}"
    );
    assert!(!turns.points.iter().any(|point| point.turn == Turn::Reversal));
    let critical = Repeat::new(there, 3).expect("repeats").critical(Quantity::Jerk);
    assert!([1.0, 2.0].iter().all(|joint| critical.contains(joint)));
}

#[test]
fn what_cannot_be_is_refused_by_its_name() {
    let sine =
        |amplitude, period, cycles| Profile::Sine { amplitude, period, cycles, phase: 0.0, offset: 0.0 };
    for (profile, said) in [
        (sine(f64::NAN, 1.0, 1.0), "amplitude"),
        (sine(1.0, 0.0, 1.0), "period"),
        (sine(1.0, 1.0, -1.0), "cycles"),
        (sine(1.0, 1.0, 1e9), "cycles"),
        (Profile::Repeat { of: Box::new(sine(1.0, 1.0, 1.0)), times: 0 }, "times"),
        (Profile::Repeat { of: Box::new(sine(1.0, 1.0, 1e4)), times: 1000 }, "times is 10000000"),
    ] {
        let error = profile.curve::<f64>().expect_err("refused").to_string();
        assert!(error.contains(said), "{said}: {error}");
    }
}

/// A phase of 1e154° kept the search for turns going for ever: half a turn more was no other number.
#[test]
fn a_phase_of_more_turns_than_can_be_told_apart_is_refused() {
    let sine = |phase| Profile::Sine { amplitude: 1.0, period: 1.0, cycles: 2.0, phase, offset: 0.0 };
    for phase in [1e6, -1e6] {
        let curve = sine(phase).curve::<f64>().expect("at the limit");
        let found = curve.stationary().points;
        assert_eq!(found.len(), 4, "{found:?}");
        assert!(found.iter().all(|point| curve.at(point.time).velocity.abs() < 1e-8), "{found:?}");
    }
    for phase in [1e6_f64.next_up(), -(1e6_f64.next_up()), 1e154_f64.to_radians()] {
        let error = sine(phase).curve::<f64>().expect_err("refused").to_string();
        assert!(
            error.starts_with("phase is ") && error.ends_with("at least -1000000 and at most 1000000"),
            "{error}"
        );
    }
}

#[cfg(feature = "text")]
#[test]
fn they_are_written_and_read() {
    use solaris_profiles::text::{read, write};
    let text = "Repeat(of: Sine(amplitude: deg(90), period: 2, cycles: 0.5, phase: deg(-90)), times: 4)";
    let profile = read(text).expect("a profile");
    assert_eq!(read(&write(&profile)).expect("written"), profile);
    let Profile::Repeat { of, times: 4 } = &profile else { panic!("{profile:?}") };
    let Profile::Sine { amplitude, phase, offset, .. } = **of else { panic!("{of:?}") };
    assert!(
        (amplitude - FRAC_PI_2).abs() < 1e-15 && (phase + FRAC_PI_2).abs() < 1e-15 && offset.abs() < 1e-300
    );
    for (text, said) in [
        ("Sine(amplitude: 1, period: 2)", "this Sine has no cycles; add cycles: 3"),
        ("Sine(amplitude: 1, priod: 2, cycles: 1)", "did you mean 'period'?"),
        ("Repeat(of: Line(from: 0, to: 1, duration: 1), times: 2.5)", "times is 2.5"),
        ("Repeet(of: 1)", "did you mean 'Repeat'?"),
    ] {
        let error = read(text).expect_err("refused").to_string();
        assert!(error.contains(said), "{error}");
    }
}

/// x = 0.5·t − t²/2 turns round half a second after each beginning.
#[test]
fn what_turns_within_a_curve_turns_in_each_of_its_repeats() {
    let curve = solaris_profiles::acceleration::Constant::new(1.0, (0.0, 0.5), -1.0).expect("a curve");
    let turns = Repeat::new(curve, 3).expect("repeats").stationary();
    let reversals = turns.points.iter().filter(|point| (point.time % 1.0 - 0.5).abs() < 1e-14);
    let times: Vec<f64> = reversals.map(|point| point.time).collect();
    assert!(times.iter().zip([0.5, 1.5, 2.5]).all(|(a, b)| (a - b).abs() < 1e-14), "{times:?}");
    assert_eq!(times.len(), 3);
}
