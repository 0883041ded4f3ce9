//! Hard cases of blends: where printed formulas lose their digits, and what is refused.

use solaris_profiles::blend::{Blend, Fade, FadeKind, Layer, Leaving};
use solaris_profiles::displacement::Line;
use solaris_profiles::{
    Answers, Clip, CubicHermite, Curve, Elementary, Outside, ProfileError, Quintic, StationaryPoint, Turn,
};
use std::f64::consts::{FRAC_PI_2, LN_2, PI};

/// A fade late in time is the one at time 0, to the last digits of its time within the window.
fn assert_late<F: Elementary>(kind: FadeKind, starts: &[f64], length: f64) {
    let early = Fade::new(kind, 0.0, length).expect("a fade");
    for &start in starts {
        let late = Fade::new(kind, start, start + length).expect("a fade");
        for i in 0..=16 {
            let time = start + length * f64::from(i) / 16.0;
            let (found, wanted) = (late.alpha::<F>(time), early.alpha::<f64>(time - start));
            for k in 0..4 {
                let scale = early.largest()
                    * 8.0
                    * (kind.stiffness().unwrap_or(1.0).max(1.0) / length).powi(k as i32);
                let error = (found[k].value() - wanted[k]).abs();
                assert!(error <= 4.0 * F::EPSILON * scale, "{late:?} at {time}: {found:?}, not {wanted:?}");
            }
        }
    }
}

#[test]
fn s8_sinh_fades_lose_nothing_late_in_time() {
    for stiffness in [1e-12, 1.0, 30.0] {
        let kind = FadeKind::Sinh { stiffness };
        assert_late::<f64>(kind, &[5.0, 10.0, 20.0, 360.0, 86_400.0], 1.0);
        assert_late::<f32>(kind, &[5.0, 10.0, 20.0, 360.0, 86_400.0], 1.0);
    }
    // sinh(1/2)/sinh(1).
    let fade = Fade::thesis(FadeKind::Sinh { stiffness: 0.0 }, 360.0, 361.0).expect("a fade");
    assert!((fade.alpha::<f64>(360.5)[0] - 0.443_409_441_985_037).abs() < 1e-15);
}

#[test]
fn s8b_exponential_fades_neither_overflow_nor_lose_short_windows() {
    for start in [355.0, 1e4] {
        assert_late::<f64>(FadeKind::Exponential { stiffness: 1.0 }, &[start], 1.0);
        assert_late::<f32>(FadeKind::Exponential { stiffness: 1.0 }, &[44.0, start], 1.0);
    }
    // e^(2kw)·(e^(k(1 − w)) − 1)/(eᵏ − 1) with k = 1e-6 and w = 1/2 is (1 + 5k/4 − …)/2: by its series,
    // ½·(1 + k)·(1 + k/4)/(1 + k/2) to the first order.
    let fade = Fade::thesis(FadeKind::Exponential { stiffness: 0.0 }, 0.0, 1e-6).expect("a fade");
    let k: f64 = 1e-6;
    let (double, ahead, whole) = (k.exp(), (0.5 * k).exp_m1(), k.exp_m1());
    let expected = double * ahead / whole;
    assert!((fade.alpha::<f64>(0.5e-6)[0] - expected).abs() < 2e-16);
    assert!((f64::from(fade.alpha::<f32>(0.5e-6)[0]) - expected).abs() < 4e-8);
}

#[test]
fn s8c_trigonometric_fades_are_good_at_any_time_and_end_at_pi() {
    for stiffness in [1e-12, 0.5, FRAC_PI_2, 3.0] {
        let kind = FadeKind::Trigonometric { stiffness };
        assert_late::<f64>(kind, &[0.25, 20.0, 1e4], 1.0);
        assert_late::<f32>(kind, &[0.25, 20.0, 1e4], 1.0);
    }
    for stiffness in [PI, 4.0, 2.0 * PI, 1e9] {
        let refused = Fade::new(FadeKind::Trigonometric { stiffness }, 0.0, 1.0);
        assert!(matches!(refused, Err(ProfileError::OutOfRange { what: "stiffness", .. })), "{refused:?}");
    }
    // Just below π, α is as great as the thesis's is there: 1/sin 3.1415926.
    let fade = Fade::thesis(FadeKind::Trigonometric { stiffness: 0.0 }, 0.0, PI - 5.359e-8).expect("a fade");
    assert!((fade.largest() / 1.866_e7 - 1.0).abs() < 1e-3, "{}", fade.largest());
    assert!(Fade::thesis(FadeKind::Trigonometric { stiffness: 0.0 }, 0.0, 3.5).is_err());
}

#[test]
fn stiff_fades_do_not_overflow() {
    let fade = Fade::new(FadeKind::Sinh { stiffness: 1e4 }, 0.0, 1.0).expect("a fade");
    // At w = 1e-4, e⁻¹.
    assert!((fade.alpha::<f64>(1e-4)[0] - (-1.0_f64).exp()).abs() < 1e-15);
    assert!(fade.alpha::<f64>(0.9).iter().all(|x| x.is_finite()));
    assert!(fade.alpha::<f32>(0.9).iter().all(|x| x.is_finite()));
    let line = Clip::new(Line::new(1.0, 0.0, 1.0).expect("a curve"));
    let rest = Clip::new(Line::new(1.0, 2.0, 2.0).expect("a curve"));
    let blend = Blend::between(line, rest, fade, Leaving::Refuse).expect("a blend");
    // v = α − (2 − t)·α′ with α′ = −k·α is positive all the time, as far as it can be told from zero.
    let stationary = blend.stationary();
    assert!(stationary.points.is_empty(), "{stationary:?}");
    assert!(stationary.rests.iter().all(|rest| rest.0 > 0.002), "{stationary:?}");
    assert!((blend.peaks().velocity.value / 20_001.0 - 1.0).abs() < 1e-12);
    let too_stiff = Fade::new(FadeKind::Exponential { stiffness: 800.0 }, 0.0, 1.0);
    assert!(matches!(too_stiff, Err(ProfileError::Overflow { .. })), "{too_stiff:?}");
}

#[test]
fn fades_with_ends_of_both_scalars_are_exact() {
    for kind in [
        FadeKind::Linear,
        FadeKind::Exponential { stiffness: 0.6 },
        FadeKind::Sinh { stiffness: 7.0 },
        FadeKind::Trigonometric { stiffness: 1.5 },
        FadeKind::Smooth,
    ] {
        let fade = Fade::new(kind, 0.1, 0.7).expect("a fade");
        assert!((fade.alpha::<f64>(0.1)[0] - 1.0).abs() <= 0.0 && fade.alpha::<f64>(0.7)[0].abs() <= 0.0);
        assert!((fade.alpha::<f32>(0.1)[0] - 1.0).abs() <= 0.0 && fade.alpha::<f32>(0.7)[0].abs() <= 0.0);
    }
}

#[test]
fn windows_that_are_none_are_refused() {
    for (start, end) in [(1.0, 1.0), (2.0, 1.0), (0.0, -0.0)] {
        let refused = Fade::new(FadeKind::Smooth, start, end);
        let Err(error) = refused else { panic!("{start} to {end} is no window") };
        assert!(matches!(error, ProfileError::OutOfRange { what: "end of the window", .. }), "{error}");
    }
    for (start, end) in [(f64::NAN, 1.0), (0.0, f64::NAN), (0.0, f64::INFINITY)] {
        assert!(matches!(Fade::new(FadeKind::Linear, start, end), Err(ProfileError::NotFinite { .. })));
    }
    assert!(matches!(Fade::new(FadeKind::Smooth, 0.0, 1e-200), Err(ProfileError::Overflow { .. })));
    assert!(matches!(Fade::new(FadeKind::Linear, -1e308, 1e308), Err(ProfileError::Overflow { .. })));
    for stiffness in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(Fade::new(FadeKind::Sinh { stiffness }, 0.0, 1.0).is_err());
        assert!(Fade::new(FadeKind::Exponential { stiffness }, 0.0, 1.0).is_err());
    }
}

fn lines() -> [Clip<Line>; 2] {
    [1.0, -1.0].map(|to| Clip::new(Line::new(2.0, 0.0, to).expect("a curve")))
}

#[test]
fn fades_that_leave_zero_to_one_are_refused_clamped_or_let_be() {
    let [first, second] = lines();
    for (kind, largest) in [
        (FadeKind::Exponential { stiffness: 1.0 }, LN_2),
        (FadeKind::Trigonometric { stiffness: 2.0 }, FRAC_PI_2),
    ] {
        let fade = Fade::new(kind, 0.0, 2.0).expect("a fade");
        assert!(!fade.is_monotone());
        let refused = Blend::between(first, second, fade, Leaving::Refuse).expect_err("it leaves");
        let said = refused.to_string();
        assert!(said.contains("stiffness") && said.contains(&largest.to_string()), "{said}");
        let clamped = Blend::between(first, second, fade, Leaving::Clamp).expect("a blend");
        assert!((clamped.at(0.2).position - 0.1).abs() < 1e-15);
        let allowed = Blend::between(first, second, fade, Leaving::Allow).expect("a blend");
        assert!(allowed.at(0.2).position > 0.1);
        let within = Fade::new(kind.with_stiffness(largest), 0.0, 2.0).expect("a fade");
        assert!(within.is_monotone() && Blend::between(first, second, within, Leaving::Refuse).is_ok());
        let layers = vec![Layer { fade_in: Some(fade), ..Layer::new(first) }, Layer::new(second)];
        assert!(matches!(Blend::weighted(layers), Err(ProfileError::OutOfRange { .. })));
    }
}

#[test]
fn weights_that_vanish_together_are_refused() {
    let [first, second] = lines();
    let out = Fade::new(FadeKind::Smooth, 0.0, 1.0).expect("a fade");
    let layers = |start: f64| {
        let rise = Fade::new(FadeKind::Smooth, start, start + 0.5).expect("a fade");
        vec![
            Layer { fade_out: Some(out), ..Layer::new(first) },
            Layer { fade_in: Some(rise), ..Layer::new(second) },
        ]
    };
    assert!(Blend::weighted(layers(0.8)).is_ok());
    for start in [1.0, 1.2, 5.0] {
        let Err(ProfileError::Weightless { time }) = Blend::weighted(layers(start)) else {
            panic!("nothing is left after 1")
        };
        assert!((time - 1.0).abs() < 0.02, "{time}");
    }
    assert!(matches!(Blend::<Line>::weighted(vec![]), Err(ProfileError::Count { found: 0, .. })));
    for amount in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(Blend::weighted(vec![Layer { amount, ..Layer::new(first) }]).is_err());
    }
    let none = vec![Layer { amount: 0.0, ..Layer::new(first) }];
    assert!(matches!(Blend::weighted(none), Err(ProfileError::Weightless { .. })));
}

#[test]
fn clips_must_end_after_time_zero() {
    let fade = Fade::new(FadeKind::Linear, 0.0, 1.0).expect("a fade");
    let early = lines().map(|clip| clip.starting(-3.0).expect("a time"));
    assert!(matches!(
        Blend::between(early[0], early[1], fade, Leaving::Refuse),
        Err(ProfileError::Duration { .. })
    ));
}

#[test]
fn a_time_that_is_nan_gives_nan() {
    let [first, second] = lines();
    let fade = Fade::new(FadeKind::Linear, 0.0, 1.0).expect("a fade");
    let blend = Blend::between(first, second, fade, Leaving::Refuse).expect("a blend");
    let mean = Blend::weighted(vec![Layer::new(first), Layer::new(second)]).expect("a blend");
    for sample in [blend.at(f64::NAN), blend.before(f64::NAN), blend.at_time(f64::NAN), mean.at(f64::NAN)] {
        assert!(sample.to_array().iter().all(|x| x.is_nan()), "{sample:?}");
    }
    assert!(blend.try_at(f64::NAN).is_err() && blend.try_at(3.0).is_err());
}

#[test]
fn outside_of_its_span_a_blend_holds_its_ends() {
    let [first, second] = lines();
    let fade = Fade::new(FadeKind::Smooth, 0.5, 1.5).expect("a fade");
    let blend = Blend::between(first, second, fade, Leaving::Refuse).expect("a blend");
    assert_eq!(blend.at(-7.0), blend.at(0.0));
    assert_eq!(blend.at(7.0), blend.at(2.0));
}

/// x = t³/3 − t² + t + b·t²/2 over [0, 2]: its velocity is (t − 1)² + b·t.
fn bent(b: f64) -> CubicHermite {
    let velocity = |t: f64| (t - 1.0) * (t - 1.0) + b * t;
    CubicHermite::new(2.0, (0.0, velocity(0.0)), (2.0 / 3.0 + 2.0 * b, velocity(2.0))).expect("a curve")
}

#[test]
fn a_velocity_that_touches_zero_is_a_touch() {
    let mean = |by: f64| {
        let layers = [bent(0.75), bent(-0.75 + by)].map(|curve| Layer::new(Clip::new(curve))).to_vec();
        Blend::weighted(layers).expect("a blend").stationary().points
    };
    let touch = mean(0.0);
    assert_eq!(touch.len(), 1, "{touch:?}");
    assert!(touch[0].turn == Turn::Touch && (touch[0].time - 1.0).abs() < 1e-9, "{touch:?}");
    // A little more, and there is none; a little less, and there are two: (t − 1)² = 2δ·t with half the difference each.
    assert_eq!(mean(1e-9), []);
    let two: Vec<StationaryPoint> = mean(-2e-9);
    assert_eq!(two.len(), 2, "{two:?}");
    let root = 1e-9_f64.sqrt();
    for (point, expected) in two.iter().zip([1.0 - root, 1.0 + root]) {
        assert!(point.turn == Turn::Reversal && (point.time - expected).abs() < 1e-8, "{point:?}");
    }
}

#[test]
fn motions_that_cancel_out_rest() {
    // R = 0 only as a sum of numbers that are not zero.
    let curve = |sign: f64| Clip::new(Quintic::minimum_jerk(2.0, sign, 3.0 * sign).expect("a curve"));
    let blend = Blend::weighted(vec![Layer::new(curve(1.0)), Layer::new(curve(-1.0))]).expect("a blend");
    let stationary = blend.stationary();
    assert!(stationary.points.is_empty(), "{stationary:?}");
    let rested: f64 = stationary.rests.iter().map(|(from, to)| to - from).sum();
    assert!((rested - 2.0).abs() < 0.01, "{stationary:?}");
}

#[test]
fn held_ends_are_rests() {
    let up = Clip::new(Quintic::minimum_jerk(1.0, 0.0, 1.0).expect("a curve"));
    let down =
        Clip::new(Quintic::minimum_jerk(1.0, 1.0, 0.0).expect("a curve")).starting(3.0).expect("a time");
    let fade = Fade::new(FadeKind::Smooth, 1.2, 2.0).expect("a fade");
    let stationary = Blend::between(up, down, fade, Leaving::Refuse).expect("a blend").stationary();
    // It goes up, rests from 1 to 3, and goes down: it turns round at the rest.
    assert_eq!(stationary.points, [StationaryPoint { time: 1.0, turn: Turn::Reversal }]);
    assert_eq!(stationary.rests, [(1.0, 3.0)]);
    let still = Clip::new(Quintic::minimum_jerk(1.0, 1.0, 1.0).expect("a curve"));
    let blend = Blend::between(still, still, fade, Leaving::Refuse).expect("a blend");
    assert_eq!(blend.stationary().rests, [(0.0, 1.0)]);
}

#[test]
fn infinite_accelerations_at_an_end_stay_there() {
    use solaris_profiles::displacement::Power;
    let power = |to: f64| Clip::new(Power::new(1.0, 0.0, to, 1.5).expect("a curve"));
    let fade = Fade::new(FadeKind::Smooth, 0.0, 1.0).expect("a fade");
    let blend = Blend::between(power(1.0), power(2.0), fade, Leaving::Refuse).expect("a blend");
    assert!(blend.at(0.5).to_array().iter().all(|x| x.is_finite()));
    assert_eq!(blend.stationary().points, []);
    assert!(blend.peaks().velocity.value.is_finite() && blend.peaks().acceleration.value.is_infinite());
}

#[test]
fn tiny_and_huge_times_blend_alike() {
    for length in [1e-9, 1.0, 1e9] {
        let curve = |to: f64| Clip::new(Quintic::minimum_jerk(2.0 * length, 0.0, to).expect("a curve"));
        let fade = Fade::new(FadeKind::Sinh { stiffness: 3.0 }, 0.2 * length, 1.4 * length).expect("a fade");
        let blend = Blend::between(curve(1.0), curve(-2.0), fade, Leaving::Refuse).expect("a blend");
        let points = blend.stationary().points;
        assert_eq!(points.len(), 1, "{points:?}");
        // As found by bisection of the velocity over a span of one.
        assert!((points[0].time / length - 0.256_539_550_697_7).abs() < 1e-12, "{points:?}");
    }
}

#[test]
fn a_blend_in_f32_loses_nothing_an_hour_into_a_clip() {
    let clip = |to: f32| {
        let curve = Quintic::<f32>::minimum_jerk(0.04, 0.0, to).expect("a curve");
        Clip::new(curve).starting(3600.0).expect("a time").outside(Outside::Hold)
    };
    let fade = Fade::new(FadeKind::Smooth, 3600.0, 3600.04).expect("a fade");
    let blend = Blend::between(clip(1.0), clip(2.0), fade, Leaving::Refuse).expect("a blend");
    // Half-way, 3/4.
    assert!((blend.at_time(3600.02).position - 0.75).abs() < 1e-6);
}

#[test]
fn clips_that_repeat_too_often_or_begin_too_far_away_are_refused() {
    let short = Quintic::minimum_jerk(1e-9, 0.0, 1.0).expect("a curve");
    let long = Quintic::minimum_jerk(1.0, 0.0, 1.0).expect("a curve");
    let fade = Fade::new(FadeKind::Linear, 0.0, 1.0).expect("a fade");
    let repeated = Clip::new(short).outside(Outside::Repeat);
    let error = Blend::between(repeated, Clip::new(long), fade, Leaving::Refuse).expect_err("1e9 repeats");
    assert!(error.to_string().starts_with("number of repeats in the blend is 999999999"), "{error}");
    let far = Clip::new(long).starting(-1e20).expect("a start").outside(Outside::Repeat);
    assert!(Blend::between(far, Clip::new(long), fade, Leaving::Refuse).is_err());
}

/// Between its breaks nothing of a blend jumps or turns: the seams of a clip that repeats are among them, all of them.
#[test]
fn the_seams_of_a_repeated_clip_are_breaks() {
    let curve = |duration| Line::new(duration, 0.0, 1.0).expect("a line");
    for (start, first) in [(0.0, 1), (0.1, 0)] {
        let repeated = Clip::new(curve(0.3)).starting(start).expect("a start").outside(Outside::Repeat);
        let blend =
            Blend::weighted(vec![Layer::new(repeated), Layer::new(Clip::new(curve(2.0)))]).expect("a blend");
        let breaks = blend.breaks();
        for seam in (first..6).map(|k| start + 0.3 * f64::from(k)) {
            assert!(breaks.iter().any(|time| (time - seam).abs() < 1e-12), "{seam} of {breaks:?}");
        }
    }
}
