//! Every kind of profile as a value: named, made from its parameters, written, read, evaluated, asked.

use solaris_profiles::blend::{Fade, FadeKind, Leaving};
use solaris_profiles::{Answers, Curve, Family, Kind, Parameter, Profile, ProfileError, ProfileLayer, Turn};

const KEYS: [(f64, f64); 4] = [(0.0, 1.0), (0.5, 3.0), (2.0, -1.0), (3.0, 0.5)];

/// A value of each parameter that is good together with the others.
fn value(parameter: &Parameter) -> f64 {
    match parameter.name {
        "from" | "rise" => 0.5,
        "to" => 2.5,
        "duration" => 2.0,
        "start velocity" => 0.25,
        "end velocity" | "third time" => 0.75,
        "exponent" => 4.0,
        "shape" => -0.5,
        "third velocity" => 0.625,
        "fall" => 1.25,
        _ => 1.5,
    }
}

/// The profile of a kind with these values, but for one.
fn with(kind: &Kind, other: &Parameter, x: f64) -> Profile {
    let value = |parameter: &Parameter| Some(if parameter == other { x } else { value(parameter) });
    kind.profile(value, KEYS.to_vec()).expect("complete")
}

fn every() -> impl Iterator<Item = (&'static Kind, Profile)> {
    Profile::KINDS.iter().map(|kind| {
        (kind, kind.profile(|parameter| Some(value(parameter)), KEYS.to_vec()).expect("complete"))
    })
}

#[test]
fn there_are_kinds_enough_and_each_has_its_own_name() {
    let mut names: Vec<&str> = Profile::KINDS.iter().map(|kind| kind.name).collect();
    assert!(names.len() >= 24, "{}", names.len());
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), Profile::KINDS.len());
    for kind in Profile::KINDS {
        assert_eq!(Kind::named(kind.name).expect("found").variant, kind.variant);
        let mut symbols: Vec<&str> = kind.parameters().map(|parameter| parameter.symbol).collect();
        symbols.sort_unstable();
        let count = symbols.len();
        symbols.dedup();
        assert_eq!(symbols.len(), count, "{}: two parameters with one symbol", kind.name);
    }
}

#[test]
fn every_kind_makes_a_curve_that_obeys_its_ends_and_can_be_asked() {
    for (kind, profile) in every() {
        assert_eq!(profile.kind().expect("a kind").name, kind.name);
        let curve = profile.curve::<f64>().unwrap_or_else(|error| panic!("{}: {error}", kind.name));
        let (start, end) = (curve.at(0.0), curve.at(curve.duration()));
        let (first, last) = match kind.family {
            Family::Keys => (KEYS[0].1, Some(KEYS[3].1)),
            Family::Acceleration | Family::Velocity => (0.5, None),
            _ => (0.5, Some(2.5)),
        };
        assert!((start.position - first).abs() < 1e-15, "{}: {start:?}", kind.name);
        assert!(last.is_none_or(|last| (end.position - last).abs() < 4e-15), "{}: {end:?}", kind.name);
        let peaks = curve.peaks();
        assert!(peaks.velocity.value.is_finite() && peaks.acceleration.value > -1.0, "{}", kind.name);
        let single = profile.curve::<f32>().expect("in f32 as well");
        let (x, y) = (curve.at(0.9).position, f64::from(single.at(0.9).position));
        assert!((x - y).abs() < 1e-5, "{}: {x} {y}", kind.name);
    }
}

#[test]
fn the_greatest_values_are_those_of_a_scan() {
    for (kind, profile) in every() {
        let curve = profile.curve::<f64>().expect("a curve");
        let peaks = curve.peaks();
        let mut greatest = [0.0_f64; 3];
        for i in 0..=20_000 {
            let sample = curve.at(f64::from(i) / 20_000.0 * curve.duration());
            for (greatest, x) in greatest.iter_mut().zip([sample.velocity, sample.acceleration, sample.jerk])
            {
                *greatest = greatest.max(x.abs());
            }
        }
        for (peak, scanned) in [peaks.velocity, peaks.acceleration, peaks.jerk].iter().zip(greatest) {
            if peak.value.is_infinite() {
                continue;
            }
            assert!(scanned <= peak.value * (1.0 + 1e-12) + 1e-12, "{}: {scanned} > {peak:?}", kind.name);
            // Just before a jump the scan comes no closer than its step.
            assert!(scanned >= peak.value * (1.0 - 1e-3) - 1e-9, "{}: {scanned} < {peak:?}", kind.name);
        }
    }
}

#[test]
fn every_parameter_that_is_not_a_number_is_refused() {
    for kind in Profile::KINDS {
        for wrong in kind.parameters() {
            for bad in [f64::NAN, f64::INFINITY] {
                let error = with(kind, wrong, bad).curve::<f64>().expect_err(kind.name);
                let text = error.to_string();
                let named = text.contains(wrong.name) || text.contains("start") || text.contains("end");
                assert!(named, "{}, {}: {text}", kind.name, wrong.name);
            }
        }
    }
}

#[test]
fn a_parameter_outside_of_its_range_is_refused_and_one_inside_is_not_refused_for_it() {
    for kind in Profile::KINDS {
        for wrong in kind.parameters() {
            for x in [-2.5, -1.0, 0.0, 0.5, 1e-3, 101.0] {
                let curve = with(kind, wrong, x).curve::<f64>();
                if !wrong.range.contains(x) {
                    let error = curve.expect_err(kind.name).to_string();
                    assert!(error.contains(&x.to_string()), "{}, {} = {x}: {error}", kind.name, wrong.name);
                } else if let Err(ProfileError::OutOfRange { what, range, .. }) = curve {
                    // Another parameter's bound may depend on this one.
                    assert!(what != wrong.name || !range.contains(x), "{}: {what} = {x}", kind.name);
                }
            }
        }
    }
}

#[test]
fn what_is_missing_is_named() {
    let none = |_: &Parameter| None;
    let error = Kind::named("power").expect("a kind").profile(none, Vec::new()).expect_err("nothing given");
    assert_eq!(error.to_string(), "power needs its from");
}

#[test]
fn free_parameters_have_intervals_or_say_which_have() {
    for (kind, profile) in every() {
        for free in kind.parameters() {
            match profile.feasible(free) {
                Ok(feasible) => {
                    // A value well inside of the interval never turns round, or has an arc at all.
                    for x in [-3.0, -0.5, 0.0, 0.3, 0.6, 1.0, 2.0, 4.0] {
                        let Ok(curve) = with(kind, free, x).curve::<f64>() else {
                            assert!(!feasible.contains(x), "{}: {} = {x}", kind.name, free.name);
                            continue;
                        };
                        let arc = kind.name == "circular-velocity"
                            && free.measure != Parameter::START_VELOCITY.measure;
                        if !arc && !free.symbol.starts_with('T') && free.symbol != "vm" {
                            assert_eq!(
                                curve.is_monotone(),
                                feasible.contains(x),
                                "{}: {} = {x}",
                                kind.name,
                                free.name
                            );
                        }
                    }
                }
                Err(ProfileError::NotFree { instead, .. }) => assert!(instead.contains("free")),
                Err(error) => panic!("{}, {}: {error}", kind.name, free.name),
            }
        }
    }
}

#[test]
fn the_other_parameters_are_checked_where_one_is_free() {
    let wrong = Profile::Exponential { from: f64::NAN, to: 1.0, duration: 1.0, exponent: 3.0, shape: 0.0 };
    assert!(wrong.feasible(&Parameter::SHAPE).is_err());
    let wrong = Profile::LinearVelocity { from: 0.0, duration: -1.0, start_velocity: 0.0, end_velocity: 1.0 };
    let text = wrong.feasible(&Parameter::START_VELOCITY).expect_err("a negative duration").to_string();
    assert_eq!(text, "duration is -1; it must be more than 0");
}

#[test]
fn a_reversal_is_refused_with_what_would_do() {
    let (from, to, duration) = (0.0, 5.0, 2.0);
    let profile = Profile::CubicHermite { from, to, duration, start_velocity: -1.0, end_velocity: 5.0 };
    let text = profile.refuse_reversal().expect_err("it turns").to_string();
    assert_eq!(
        text,
        "start velocity is -1: the motion turns round; it may be at least 0 and less than 9.330127018922195"
    );
    // No start velocity can help against an end velocity that points back.
    let profile = Profile::CubicHermite { from, to, duration, start_velocity: 1.0, end_velocity: -5.0 };
    let text = profile.refuse_reversal().expect_err("it turns").to_string();
    assert!(text.starts_with("end velocity is -5: the motion turns round; it may be at least 0"), "{text}");
    let profile = Profile::MinimumJerk { from, to, duration };
    assert_eq!(profile.refuse_reversal(), Ok(()));
    let profile = Profile::NaturalSpline { keys: KEYS.to_vec() };
    assert!(matches!(profile.refuse_reversal(), Err(ProfileError::TurnsRound { .. })));
}

#[test]
fn an_amplitude_reaches_its_target() {
    for (kind, profile) in every() {
        match profile.clone().reach(-3.25) {
            Ok(reaching) => {
                assert!(matches!(kind.family, Family::Acceleration | Family::Velocity), "{}", kind.name);
                let curve = reaching.curve::<f64>().expect("a curve");
                let end = curve.at(curve.duration()).position;
                assert!((end + 3.25).abs() < 1e-14, "{}: {end}", kind.name);
            }
            Err(error) => assert!(matches!(error, ProfileError::NotFree { .. }), "{}: {error}", kind.name),
        }
    }
}

#[test]
fn a_blend_of_kinds_is_a_curve_that_can_be_asked() {
    let (from, to, duration) = (0.0, 5.0, 2.0);
    let first = Profile::Trigonometric { from, to, duration };
    let second = Profile::Power { from, to, duration, exponent: 3.0 };
    let fade = Fade::new(FadeKind::Smooth, 0.5, 1.5).expect("a fade");
    let (first, second) = (Box::new(ProfileLayer::from(first)), Box::new(ProfileLayer::from(second)));
    let blend = Profile::Blend { first, second, fade, leaving: Leaving::Refuse };
    let curve = blend.curve::<f64>().expect("a blend");
    assert!((curve.at(2.0).position - 5.0).abs() < 1e-15 && (curve.duration() - 2.0).abs() < 1e-15);
    assert!(curve.stationary().points.iter().all(|point| point.turn == Turn::Reversal));
    assert!(blend.feasible(&Parameter::START_VELOCITY).is_err() && blend.kind().is_none());
}

#[cfg(feature = "serde")]
mod text {
    use super::*;

    #[test]
    fn every_kind_is_written_and_read_back() {
        for (kind, profile) in every() {
            let text = ron::to_string(&profile).expect("written");
            assert!(text.starts_with(kind.variant), "{text}");
            assert_eq!(ron::from_str::<Profile>(&text).expect("read"), profile, "{text}");
        }
    }

    #[test]
    fn what_is_zero_may_be_left_out_and_what_is_unknown_may_not_be_there() {
        let profile: Profile =
            ron::from_str("Tension(from: 0, to: 1.2, duration: 0.8, stiffness: 3)").expect("read");
        assert!(profile.values().iter().any(|(parameter, x)| parameter.symbol == "v0" && *x == 0.0_f64));
        assert!(ron::from_str::<Profile>("Line(from: 0, to: 1, duration: 1, speed: 2)").is_err());
        assert!(ron::from_str::<Profile>("Line(from: 0, to: 1)").is_err());
    }

    #[test]
    fn blends_are_written_and_read_back() {
        let text = "Weighted(layers: [
            (profile: MinimumJerk(from: 0.0, to: 1.0, duration: 1.0)),
            (profile: Line(from: 1.0, to: 0.4, duration: 2.0), start: 1.0, amount: 2.0,
             fade_in: Some((kind: Smooth, start: 0.5, end: 1.5))),
        ])";
        let profile: Profile = ron::from_str(text).expect("read");
        let curve = profile.curve::<f64>().expect("a curve");
        assert!((curve.duration() - 3.0).abs() < 1e-15);
        assert_eq!(
            ron::from_str::<Profile>(&ron::to_string(&profile).expect("written")).expect("read"),
            profile
        );
    }
}
