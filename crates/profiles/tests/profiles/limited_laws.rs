//! Motions between limits: the least time by independent closed forms, no limit exceeded and one always reached.

#![allow(clippy::float_cmp, reason = "what is to be met exactly is compared exactly")]

use proptest::prelude::*;
use solaris_profiles::limited::{SCurve, Trapezoidal};
use solaris_profiles::{Answers, Curve, Dual, Elementary, ProfileError, Quantity, Range, Sample, Scalar};

fn close(found: f64, wanted: f64, scale: f64) -> bool {
    (found - wanted).abs() <= 1e-13 * scale
}

/// Positive numbers of very different sizes.
fn limit() -> impl Strategy<Value = f64> {
    (-3.0..3.0).prop_map(|exponent: f64| 10.0_f64.powf(exponent))
}

/// Least time with limited velocity and acceleration, from the area under the trapezium.
fn trapezoidal_time(way: f64, v: f64, a: f64) -> f64 {
    if way >= v * v / a { way / v + v / a } else { 2.0 * (way / a).sqrt() }
}

/// Least time with a limited jerk too: the greatest speed that the way leaves time to reach, found by bisection.
fn s_curve_time(way: f64, v: f64, a: f64, j: f64) -> f64 {
    let ramp = |speed: f64| if speed >= a * a / j { speed / a + a / j } else { 2.0 * (speed / j).sqrt() };
    if v * ramp(v) <= way {
        return ramp(v) + way / v;
    }
    let (mut low, mut high) = (0.0, v);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle * ramp(middle) <= way { low = middle } else { high = middle }
    }
    2.0 * ramp(low)
}

/// The samples just after the beginning and just before the end of each phase, and in its middle.
fn of_phases<C: Curve>(curve: &C, phases: &[f64]) -> Vec<[Sample; 3]> {
    let mut start = 0.0;
    let mut samples = Vec::new();
    for phase in phases {
        let end = start + phase;
        if *phase > 1e-9 * curve.duration() {
            samples.push([0.01, 0.5, 0.99].map(|share| curve.at(start + share * (end - start))));
        }
        start = end;
    }
    samples
}

/// Position, velocity and acceleration do not jump where a phase ends, up to the order `smooth`, and the jumps of the
/// others are those of `before` and `at`.
fn joins(curve: &impl Answers, smooth: usize, scale: [f64; 4]) -> Result<(), TestCaseError> {
    for t in curve.critical(Quantity::Acceleration) {
        let (before, after) = (curve.before(t).to_array(), curve.at(t).to_array());
        for order in 0..smooth {
            // The time of the joint is rounded, by which the next derivative changes this one.
            let slack = 4.0 * f64::EPSILON * curve.duration() * scale[order + 1];
            let error = (before[order] - after[order]).abs();
            prop_assert!(error <= 1e-14 * scale[order] + slack, "{t}: {before:?} {after:?}");
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn a_trapezoidal_motion_is_the_fastest(from in -10.0..10.0, way in -10.0..10.0, v in limit(), a in limit()) {
        prop_assume!(way != 0.0);
        let motion = Trapezoidal::new(from, from + way, v, a).expect("valid");
        let way: f64 = (from + way) - from;
        let least = trapezoidal_time(way.abs(), v, a);
        prop_assert!(close(motion.duration(), least, least), "{} {least}", motion.duration());
        prop_assert_eq!(motion.at(0.0).position, from);
        prop_assert_eq!(motion.at(motion.duration()).position, from + way);
        prop_assert!(close(motion.phases().iter().sum(), least, least));
        for [first, middle, last] in of_phases(&motion, &motion.phases()) {
            let at_limit = |s: &Sample| close(s.velocity.abs(), v, v) || close(s.acceleration.abs(), a, a);
            prop_assert!(at_limit(&first) && at_limit(&middle) && at_limit(&last));
        }
        let peaks = motion.peaks();
        prop_assert!(peaks.velocity.value <= v * (1.0 + 1e-15) && peaks.acceleration.value <= a);
        joins(&motion, 2, [20.0, v, a, 0.0])?;
        prop_assert!(motion.stationary().points.is_empty() && motion.is_monotone());
    }

    #[test]
    fn an_s_curve_is_the_fastest(from in -10.0..10.0, way in -10.0..10.0, v in limit(), a in limit(), j in limit()) {
        prop_assume!(way != 0.0);
        let motion = SCurve::new(from, from + way, v, a, j).expect("valid");
        let way: f64 = (from + way) - from;
        let least = s_curve_time(way.abs(), v, a, j);
        prop_assert!(close(motion.duration(), least, 10.0 * least), "{} {least}", motion.duration());
        prop_assert_eq!(motion.at(0.0), Sample { jerk: j * way.signum(), ..Sample::rest(from) });
        prop_assert_eq!(motion.at(motion.duration()).position, from + way);
        prop_assert_eq!(motion.at(motion.duration()).velocity, 0.0);
        prop_assert!(close(motion.phases().iter().sum(), least, 10.0 * least));
        for [first, middle, last] in of_phases(&motion, &motion.phases()) {
            let reached = |x: f64, limit: f64| close(x.abs(), limit, 10.0 * limit);
            let at_limit = |s: &Sample| {
                reached(s.velocity, v) || reached(s.acceleration, a) || reached(s.jerk, j)
            };
            prop_assert!(at_limit(&first) && at_limit(&middle) && at_limit(&last));
        }
        let peaks = motion.peaks();
        prop_assert!(peaks.velocity.value <= v * (1.0 + 1e-14), "{peaks:?}");
        prop_assert!(peaks.acceleration.value <= a * (1.0 + 1e-14), "{peaks:?}");
        prop_assert!(peaks.jerk.value <= j, "{peaks:?}");
        joins(&motion, 3, [20.0, v, a, j])?;
    }

    #[test]
    fn derivatives_are_those_of_the_position(
        way in 0.1..10.0, v in limit(), a in limit(), j in limit(), share in 0.001..0.999,
    ) {
        let dual = Dual::<1>::constant;
        let t = |duration: Dual<1>| Dual::variable(duration.value() * share, 0);
        let s_curve = SCurve::new(dual(1.0), dual(1.0 + way), dual(v), dual(a), dual(j)).expect("valid");
        let trapezoidal = Trapezoidal::new(dual(1.0), dual(1.0 + way), dual(v), dual(a)).expect("valid");
        for sample in [s_curve.at(t(s_curve.duration())), trapezoidal.at(t(trapezoidal.duration()))] {
            for (lower, upper) in sample.to_array().into_iter().zip(&sample.to_array()[1..]) {
                let scale = upper.value().abs() + v + a;
                prop_assert!(close(lower.partial(0), upper.value(), 10.0 * scale), "{sample:?}");
            }
        }
    }

    #[test]
    fn a_motion_is_the_same_backwards(way in 0.1..10.0, v in limit(), a in limit(), j in limit(), share in 0.0..1.0) {
        let (there, back) = (
            SCurve::new(0.0, way, v, a, j).expect("valid"), SCurve::new(way, 0.0, v, a, j).expect("valid"),
        );
        let t = share * there.duration();
        let (s, r) = (there.at(t), back.before(there.duration() - t).reversed());
        for (found, wanted, scale) in [
            (s.position, r.position, way), (s.velocity, r.velocity, v), (s.acceleration, r.acceleration, a),
        ] {
            // Time itself is rounded.
            let slack = 4.0 * f64::EPSILON * there.duration() * (v + a + j);
            prop_assert!((found - wanted).abs() <= 1e-13 * scale + slack, "{s:?} {r:?}");
        }
    }

    #[test]
    fn a_slower_motion_goes_the_same_way_in_the_time_asked_for(
        way in -10.0..10.0, v in limit(), a in limit(), j in limit(), n in 1.0..50.0, share in 0.0..1.0,
    ) {
        prop_assume!(way != 0.0);
        let fast = SCurve::new(2.0, 2.0 + way, v, a, j).expect("valid");
        let duration = n * fast.duration();
        let slow = fast.lasting(duration).expect("longer");
        prop_assert_eq!(slow.duration(), duration);
        prop_assert_eq!(slow.at(duration).position, 2.0 + way);
        let (s, f) = (slow.at(share * duration), fast.at(share * fast.duration()));
        prop_assert!(close(s.position, f.position, 200.0), "{s:?} {f:?}");
        prop_assert!(close(s.velocity * n, f.velocity, 100.0 * (v + fast.duration() * a)));
        prop_assert!(slow.peaks().jerk.value <= j * (1.0 + 1e-14));

        let fast = Trapezoidal::new(2.0, 2.0 + way, v, a).expect("valid");
        let slow = fast.lasting(n * fast.duration()).expect("longer");
        prop_assert_eq!(slow.duration(), n * fast.duration());
        let (s, f) = (slow.at(share * slow.duration()), fast.at(share * fast.duration()));
        prop_assert!(close(s.position, f.position, 200.0));
        prop_assert!(close(s.velocity * n, f.velocity, 100.0 * (v + fast.duration() * a)));
    }
}

#[test]
fn each_pattern_of_phases_is_found() {
    // By hand, V = 2, A = 1, J = 1: A is reached (V ≥ A²/J), V from D = V·(V/A + A/J) = 6 on, A from D = 2A³/J² = 2 on.
    let phases = |way| SCurve::new(0.0, way, 2.0, 1.0, 1.0).expect("valid").phases();
    assert_eq!(phases(8.0), [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0]);
    assert_eq!(phases(6.0), [1.0, 1.0, 1.0, 0.0, 1.0, 1.0, 1.0]);
    // t² + 3t + 2 = D: (1 + t)(2 + t) = 3.75 with t = 0.5.
    assert_eq!(phases(3.75), [1.0, 0.5, 1.0, 0.0, 1.0, 0.5, 1.0]);
    assert_eq!(phases(2.0), [1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0]);
    let half = phases(0.25);
    assert!((half[0] - 0.5).abs() < 1e-15 && half[1..=1] == [0.0] && half[3] == 0.0, "{half:?}");
    // V is reached, A is not.
    assert_eq!(
        SCurve::new(0.0, 1.5, 1.0, 10.0, 4.0).expect("valid").phases(),
        [0.5, 0.0, 0.5, 0.5, 0.5, 0.0, 0.5]
    );
    // The triangle.
    assert_eq!(Trapezoidal::new(1.0, 0.0, 5.0, 4.0).expect("valid").phases(), [0.5, 0.0, 0.5]);
    let top = Trapezoidal::new(1.0, 0.0, 5.0, 4.0).expect("valid");
    assert_eq!((top.before(0.5).acceleration, top.at(0.5).acceleration), (-4.0, 4.0));
    assert_eq!(top.at(0.5).velocity, -2.0);
}

#[test]
fn no_way_takes_no_time() {
    let motion = SCurve::new(3.0, 3.0, 1.0, 1.0, 1.0).expect("valid");
    assert_eq!((motion.duration(), motion.at(0.0)), (0.0, Sample::rest(3.0)));
    assert_eq!(motion.before(0.0), Sample::rest(3.0));
    assert_eq!(motion.at(1.0), Sample::rest(3.0));
    assert!(motion.stationary().rests.is_empty() && motion.critical(Quantity::Jerk).is_empty());
    let rest = motion.lasting(2.0).expect("any time will do");
    assert_eq!((rest.duration(), rest.at(1.0)), (2.0, Sample::rest(3.0)));
    assert_eq!(rest.stationary().rests, [(0.0, 2.0)]);
    let motion = Trapezoidal::new(3.0, 3.0, 1.0, 1.0).expect("valid");
    assert_eq!((motion.duration(), motion.at(0.0)), (0.0, Sample::rest(3.0)));
    assert_eq!(motion.lasting(2.0).expect("any time will do").at(1.5), Sample::rest(3.0));
}

#[test]
fn what_cannot_be_is_refused() {
    let zero = Trapezoidal::new(0.0, 1.0, 0.0, 1.0);
    assert_eq!(
        zero,
        Err(ProfileError::OutOfRange { what: "largest velocity", value: 0.0, range: Range::POSITIVE })
    );
    assert!(matches!(
        SCurve::new(0.0, f64::NAN, 1.0, 1.0, 1.0),
        Err(ProfileError::NotFinite { what: "to", .. })
    ));
    assert!(matches!(
        SCurve::new(0.0, 1.0, 1.0, 1.0, f64::INFINITY),
        Err(ProfileError::NotFinite { what: "largest jerk", .. })
    ));
    assert!(matches!(SCurve::new(-1e308, 1e308, 1.0, 1.0, 1.0), Err(ProfileError::Overflow { .. })));
    assert!(matches!(Trapezoidal::new(0.0, 1e300, 1e-300, 1.0), Err(ProfileError::Overflow { .. })));
    let motion = Trapezoidal::new(0.0, 3.0, 1.0, 2.0).expect("valid");
    let refused = motion.lasting(3.0).expect_err("too short");
    assert_eq!(refused.to_string(), "duration is 3; it must be at least 3.5");
    // Jerk goes with the cube of the time.
    assert!(matches!(motion.lasting(1e120), Err(ProfileError::Overflow { .. })));
    assert!(motion.lasting(f64::NAN).is_err() && motion.lasting(-1.0).is_err());
}

#[test]
fn single_precision_and_extreme_limits_do() {
    let motion = SCurve::<f32>::new(0.0, 1.0, 0.7, 3.0, 20.0).expect("valid");
    assert!((f64::from(motion.duration()) - s_curve_time(1.0, 0.7, 3.0, 20.0)).abs() < 1e-6);
    assert!((motion.at(motion.duration()).position - 1.0).abs() < f32::EPSILON);
    for (way, v, a, j) in
        [(1e-9, 1.0, 1e6, 1e12), (1e9, 1e-3, 1e-3, 1e-3), (1.0, 1e9, 1e-9, 1e9), (1e-30, 1e9, 1e9, 1e-9)]
    {
        let motion = SCurve::new(0.0, way, v, a, j).expect("valid");
        let least = s_curve_time(way, v, a, j);
        assert!((motion.duration() - least).abs() <= 1e-12 * least, "{} {least}", motion.duration());
        let middle = motion.at(0.5 * motion.duration());
        assert!((middle.position - 0.5 * way).abs() <= 1e-14 * way, "{middle:?}");
        assert!(Scalar::is_finite(middle.jerk));
    }
    let not_a_time = SCurve::new(0.0, 1.0, 1.0, 1.0, 1.0).expect("valid").at(f64::NAN);
    assert!(not_a_time.to_array().iter().all(|x| x.is_nan()));
}

/// An acceleration that is as good as unlimited leaves velocity and jerk alone to decide.
#[test]
fn unlimited_accelerations_do_no_harm() {
    let wanted = SCurve::new(0.0, 0.01, 1.0, 1e6, 10.0).expect("a motion").duration();
    for most in [1e100, 1e200, f64::MAX] {
        let motion = SCurve::new(0.0, 0.01, 1.0, most, 10.0).expect("a motion");
        assert!((motion.duration() - wanted).abs() < 1e-15 * wanted, "{most}: {}", motion.duration());
    }
    let single = SCurve::<f32>::new(0.0, 0.01, 1e10, 1e18, 0.01).expect("a motion");
    let (duration, middle) = (single.duration(), single.at(0.5 * single.duration()).position);
    assert!(
        (duration - 4.0 * 0.5_f32.powf(1.0 / 3.0)).abs() < 1e-5 && (middle - 0.005).abs() < 1e-8,
        "{duration} {middle}"
    );
    let slow = SCurve::new(0.0, 0.01, 1e90, 1e100, 1e-60).expect("a motion");
    assert!((slow.at(0.5 * slow.duration()).position - 0.005).abs() < 1e-16);
}

#[test]
fn what_is_made_to_last_longer_lasts_so_long_in_all_its_phases() {
    let motion = Trapezoidal::new(0.0, 3.0, 1.0, 2.0).expect("valid");
    let slow = motion.lasting(7.0).expect("longer");
    assert_eq!((slow.duration(), slow.phases()), (7.0, motion.phases().map(|phase| 2.0 * phase)));
    assert_eq!(
        Trapezoidal::new(1.0, 1.0, 1.0, 2.0).expect("no way").lasting(2.0).expect("any").duration(),
        2.0
    );
    let sample = Sample::from_array([1.0, 2.0, 3.0, 4.0]).straight_on(0.5);
    assert_eq!(sample, Sample::from_array([2.0, 2.0, 0.0, 0.0]));
}
