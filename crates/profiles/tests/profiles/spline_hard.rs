//! Splines where numbers get hard: long times in few digits, spacings of all sizes, a million keys, what is no spline.

use solaris_profiles::spline::{Bend, CubicSpline, Key};
use solaris_profiles::{Answers, Clip, Curve, Elementary, Outside, ProfileError, Quantity};

/// A wave with a key every tenth of a second.
fn wave<F: Elementary>(start: f64, seconds: usize) -> Vec<(f64, F)> {
    let step = |i: usize| i as f64 / 10.0;
    (0..=10 * seconds).map(|i| (start + step(i), F::from_f64((0.7 * step(i)).sin()))).collect()
}

/// A time of 1e5 s in f32 has a step of 8 ms: a fifth of a clip of 40 ms.
#[test]
fn s10_in_f32_an_hour_into_a_clip_is_as_good_as_its_start() {
    let (single, double) = (
        CubicSpline::natural(&wave::<f32>(0.0, 3600)).expect("a spline"),
        CubicSpline::natural(&wave::<f64>(0.0, 3600)).expect("a spline"),
    );
    let worst = |from: f64| {
        let errors = (0..1000).map(|i| {
            let t = from + 0.01 * f64::from(i);
            let (found, wanted) = (single.at_time(t), double.at_time(t));
            let position = (f64::from(found.position) - wanted.position).abs();
            position.max((f64::from(found.velocity) - wanted.velocity).abs())
        });
        errors.fold(0.0, f64::max)
    };
    let (early, late) = (worst(0.0), worst(3580.0));
    assert!(early < 4e-6 && late < 4e-6, "{early:e} {late:e}");

    // The same in absolute time: a short clip that begins late.
    for start in [10.0, 1e3, 1e5] {
        let keys = [(start, 0.0_f32), (start + 0.02, 1.0), (start + 0.04, 0.0)];
        let clip = CubicSpline::catmull_rom(&keys).expect("a spline").into_clip();
        let reference = CubicSpline::catmull_rom(&keys.map(|(t, x)| (t, f64::from(x)))).expect("a spline");
        for i in 0..=40 {
            let t = (start + 0.001 * f64::from(i)).min(clip.end());
            let (found, wanted) = (clip.at(t).position, reference.at_time(t - start).position);
            assert!((f64::from(found) - wanted).abs() < 3e-7, "{start} + {i} ms: {found} {wanted}");
        }
        assert!((clip.start() - start).abs() < f64::MIN_POSITIVE);
    }
}

/// Subtracted from an absolute time in f32 as others do it, the same clip is wrong by what the times were rounded by.
#[test]
fn s10_an_absolute_time_in_f32_would_lose_a_clip() {
    let clip: Clip<CubicSpline<f32>, f32> =
        CubicSpline::catmull_rom(&[(1e5, 0.0_f32), (1e5 + 0.04, 1.0)]).expect("a spline").into_clip();
    let time = 1e5 + 0.0137;
    let (ours, theirs) = (clip.at(time).position, clip.at(f64::from(time as f32)).position);
    assert!(
        (f64::from(ours) - 0.3425).abs() < 1e-6 && (f64::from(theirs) - 0.3425).abs() > 0.01,
        "{ours} {theirs}"
    );
}

/// A long clip in f32 repeats with the period that its keys have, not with that rounded to f32 (0.1 ms off after an hour).
#[test]
fn s10_a_long_clip_in_f32_repeats_with_its_own_period() {
    let mut keys = wave::<f32>(0.0, 3600);
    keys.push((3600.123, 0.5));
    let clip = CubicSpline::natural(&keys).expect("a spline").into_clip().outside(Outside::Repeat);
    for t in [0.05, 1700.3, 3599.95] {
        let (first, tenth) = (clip.at(t), clip.at(t + 10.0 * 3600.123));
        assert!((first.position - tenth.position).abs() < 2e-7, "{t}: {first:?} {tenth:?}");
    }
    assert!((clip.end() - 3600.123).abs() < 1e-12);
}

#[test]
fn a_million_keys_are_found_and_met() {
    let keys: Vec<(f64, f64)> = (0..1_000_000)
        .map(|i| (f64::from(i) * 0.01 + 0.004 * f64::from(i).sin(), (0.001 * f64::from(i)).cos()))
        .collect();
    let curve = CubicSpline::natural(&keys).expect("a spline");
    for (i, key) in keys.iter().enumerate().step_by(997) {
        assert_eq!(curve.at(key.0 - keys[0].0).position.to_bits(), keys[i].1.to_bits());
    }
    let inside = keys.windows(2).zip(curve.keys()).step_by(991);
    for (pair, key) in inside.skip(30).take(900) {
        // The wave's own velocity, whose phase is that of the key's index.
        let middle = curve.at(0.5 * (pair[0].0 + pair[1].0) - keys[0].0);
        assert!(middle.position.abs() <= 1.0 + 1e-6 && (middle.velocity - key.velocity_out).abs() < 0.1);
    }
    assert_eq!(curve.stationary().points.len(), 318, "1000 rad hold that many multiples of pi");
}

/// A microsecond beside a year: each piece is as good as if it stood alone.
#[test]
fn tiny_and_huge_pieces_stand_side_by_side() {
    fn check<F: Elementary>() {
        let times = [0.0, 1e-9, 1e9, 1e9 + 1.0, 2e9, 2e9 + 1e-6];
        let positions = [0.0, 1.0, -1.0, 3.0, 3.0, 2.0];
        let keys: Vec<_> = times.into_iter().zip(positions.map(F::from_f64)).collect();
        let rest = F::from_f64(0.0);
        let bend = Bend { tension: F::from_f64(0.5), continuity: rest, bias: rest };
        let curves = [
            CubicSpline::catmull_rom(&keys),
            CubicSpline::centripetal(&keys),
            CubicSpline::monotone(&keys),
            CubicSpline::natural(&keys),
            CubicSpline::clamped(&keys, rest, rest),
            CubicSpline::kochanek_bartels(&keys, bend, (rest, rest)),
        ];
        for curve in curves {
            let curve = curve.expect("a spline");
            for (t, x) in times.into_iter().zip(positions) {
                let at = curve.at_time(t);
                assert!((at.position.value() - x).abs() <= F::EPSILON, "{at:?}, not {x}");
                assert!(at.to_array().iter().all(|number| number.is_finite()));
            }
        }
        let monotone = CubicSpline::monotone(&keys).expect("a spline");
        for pair in times.windows(2) {
            let (a, b) =
                (monotone.at_time(pair[0]).position.value(), monotone.at_time(pair[1]).position.value());
            for i in 0..=50 {
                let x =
                    monotone.at_time(pair[0] + (pair[1] - pair[0]) * f64::from(i) / 50.0).position.value();
                assert!(x >= a.min(b) - 4.0 * F::EPSILON && x <= a.max(b) + 4.0 * F::EPSILON, "{x}: {a} {b}");
            }
        }
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn monotone_slopes_hold_for_numbers_of_any_size() {
    for scale in [1e-300, 1e-160, 1.0, 1e150] {
        let keys = [(0.0, 0.0), (1.0, scale), (2.0, 3.0 * scale), (3.0, 3.5 * scale)];
        let curve = CubicSpline::monotone(&keys).expect("a spline");
        assert!(curve.is_monotone() && curve.stationary().points.is_empty());
        // Harmonic mean of 1 and 2.
        assert!((curve.at(1.0).velocity / scale - 4.0 / 3.0).abs() < 1e-12, "{scale:e}");
    }
}

fn error(keys: &[(f64, f64)]) -> ProfileError {
    let makers =
        [CubicSpline::catmull_rom, CubicSpline::centripetal, CubicSpline::monotone, CubicSpline::natural];
    let errors = makers.map(|make| make(keys).expect_err("no spline").to_string());
    let clamped = CubicSpline::clamped(keys, 0.0, 0.0).expect_err("no spline");
    let bent = CubicSpline::kochanek_bartels(keys, Bend::default(), (0.0, 0.0)).expect_err("no spline");
    let named: Vec<_> = keys.iter().map(|&(time, position)| Key::smooth(time, position, 0.0)).collect();
    let hermite = CubicSpline::hermite(&named).expect_err("no spline");
    for other in errors.iter().chain([&bent.to_string(), &hermite.to_string()]) {
        assert_eq!(*other, clamped.to_string());
    }
    clamped
}

#[test]
fn what_is_no_spline_is_refused_by_all_of_them_alike() {
    assert_eq!(error(&[]), ProfileError::Count { what: "keys", found: 0, needed: 2 });
    assert_eq!(error(&[(0.0, 1.0)]).to_string(), "keys: 1 given, 2 needed");
    let message = error(&[(0.0, 0.0), (2.0, 0.0), (1.0, 0.0)]).to_string();
    assert_eq!(message, "time 1 (number 3) does not lie after the one before it, 2; times must rise");
    assert_eq!(error(&[(4.0, 0.0), (4.0, 1.0)]), ProfileError::Knots { index: 1, time: 4.0, before: 4.0 });
    assert_eq!(
        error(&[(0.0, 0.0), (f64::INFINITY, 1.0)]).to_string(),
        "time of a key is inf; it must be a finite number"
    );
    assert!(matches!(
        error(&[(f64::NAN, 0.0), (1.0, 1.0)]),
        ProfileError::NotFinite { what: "time of a key", .. }
    ));
    assert!(matches!(error(&[(0.0, f64::NAN), (1.0, 1.0)]), ProfileError::NotFinite { what: "key", .. }));
    assert!(matches!(error(&[(-1e308, 0.0), (1e308, 1.0)]), ProfileError::Overflow { what: "duration", .. }));
    // Apart as given, but not as times since the first.
    let collapsed = error(&[(-1e9, 0.0), (0.0, 1.0), (1e-9, 2.0)]);
    assert_eq!(collapsed, ProfileError::Knots { index: 2, time: 1e9, before: 1e9 });
}

#[test]
fn what_leaves_the_range_of_numbers_is_refused() {
    let overflows =
        |result: Result<CubicSpline, ProfileError>| matches!(result, Err(ProfileError::Overflow { .. }));
    assert!(overflows(CubicSpline::monotone(&[(0.0, 0.0), (1e-300, 1e10)])));
    assert!(overflows(CubicSpline::clamped(&[(0.0, 0.0), (1e-200, 1.0)], 0.0, 0.0)));
    assert!(overflows(CubicSpline::monotone(&[(0.0, -1e308), (1.0, 1e308)])));
    assert!(overflows(CubicSpline::hermite(&[Key::smooth(0.0, 0.0, 1e200), Key::smooth(1e200, 0.0, 0.0)])));
    let single = CubicSpline::<f32>::natural(&[(0.0, 0.0), (1e-50, 1.0)]);
    assert!(matches!(single, Err(ProfileError::Overflow { .. })));
    let nan = |bend: Bend, ends| {
        CubicSpline::kochanek_bartels(&[(0.0, 0.0), (1.0, 1.0)], bend, ends).expect_err("none")
    };
    let bends = [
        (Bend { tension: f64::NAN, ..Bend::default() }, "tension"),
        (Bend { continuity: f64::INFINITY, ..Bend::default() }, "continuity"),
        (Bend { bias: f64::NAN, ..Bend::default() }, "bias"),
    ];
    for (bend, name) in bends {
        assert!(nan(bend, (0.0, 0.0)).to_string().starts_with(name));
    }
    assert_eq!(
        nan(Bend::default(), (f64::NAN, 0.0)).to_string(),
        "start velocity is NaN; it must be a finite number"
    );
    assert!(CubicSpline::clamped(&[(0.0, 0.0), (1.0, 1.0)], 0.0, f64::NAN).is_err());
    assert!(CubicSpline::hermite(&[Key::smooth(0.0, 0.0, f64::NAN), Key::smooth(1.0, 0.0, 0.0)]).is_err());
}

#[test]
fn the_last_digit_of_a_span_belongs_to_its_last_piece() {
    let curve: CubicSpline = CubicSpline::monotone(&[(0.1, 0.0), (0.2, 1.0), (0.3, 5.0)]).expect("a spline");
    let end: f64 = curve.duration();
    assert_eq!(curve.at(end).position.to_bits(), 5.0_f64.to_bits());
    assert!(curve.at(end.next_down()).position <= 5.0 && curve.at(end.next_up()) == curve.at(end));
}

/// With the parabola through three keys, whose times were not weighed, the first way swung out to −148.
#[test]
fn a_way_beside_a_short_and_steep_one_does_not_swing_out() {
    for keys in [[(0.0, 0.0), (10.0, 0.0), (10.1, 10.0)], [(-10.1, 10.0), (-10.0, 0.0), (0.0, 0.0)]] {
        let curve = CubicSpline::catmull_rom(&keys).expect("a spline");
        let (low, high) = curve.range(Quantity::Position, 0.0, curve.duration());
        assert!(low > -3.0 && high < 10.0 + 3.0, "{low} {high}");
    }
}
