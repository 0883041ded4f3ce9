//! Laws of the curves that are given by their acceleration.

#![allow(clippy::float_cmp, reason = "what is to be met exactly is compared exactly")]

use proptest::prelude::*;
use solaris_profiles::acceleration::{Constant, Ellipse, Trigonometric};
use solaris_profiles::{Answers, Curve, Dual, Elementary, ProfileError, Quantity, Ranges};

/// The four curves as functions of start velocity and amplitude.
const KINDS: usize = 4;

fn new<F: Elementary>(
    kind: usize,
    t: F,
    start: (F, F),
    amplitude: F,
) -> Result<Box<dyn Curve<F>>, ProfileError> {
    Ok(match kind {
        0 => Box::new(Constant::new(t, start, amplitude)?),
        1 => Box::new(Trigonometric::new(t, start, amplitude)?),
        2 => Box::new(Ellipse::quarter(t, start, amplitude)?),
        _ => Box::new(Ellipse::half(t, start, amplitude)?),
    })
}

fn answers(kind: usize, t: f64, start: (f64, f64), amplitude: f64) -> Box<dyn Answers> {
    match kind {
        0 => Box::new(Constant::new(t, start, amplitude).expect("valid")),
        1 => Box::new(Trigonometric::new(t, start, amplitude).expect("valid")),
        2 => Box::new(Ellipse::quarter(t, start, amplitude).expect("valid")),
        _ => Box::new(Ellipse::half(t, start, amplitude).expect("valid")),
    }
}

fn reaching(kind: usize, t: f64, start: (f64, f64), to: f64) -> Box<dyn Curve> {
    match kind {
        0 => Box::new(Constant::reaching(t, start, to).expect("valid")),
        1 => Box::new(Trigonometric::reaching(t, start, to).expect("valid")),
        2 => Box::new(Ellipse::quarter_reaching(t, start, to).expect("valid")),
        _ => Box::new(Ellipse::half_reaching(t, start, to).expect("valid")),
    }
}

fn feasible(kind: usize, t: f64, amplitude: f64) -> Ranges {
    match kind {
        0 => Constant::feasible_start_velocity(t, amplitude),
        1 => Trigonometric::feasible_start_velocity(t, amplitude),
        2 => Ellipse::quarter_feasible_start_velocity(t, amplitude),
        _ => Ellipse::half_feasible_start_velocity(t, amplitude),
    }
    .expect("valid")
}

fn kind() -> impl Strategy<Value = usize> {
    0..KINDS
}

fn number() -> impl Strategy<Value = f64> {
    -10.0..10.0
}

fn duration() -> impl Strategy<Value = f64> {
    0.05..20.0
}

proptest! {
    #[test]
    fn a_curve_begins_as_it_is_told_and_reaches_what_it_should(
        kind in kind(), t in duration(), from in number(), v0 in number(), to in number(),
    ) {
        let curve = reaching(kind, t, (from, v0), to);
        prop_assert_eq!((curve.at(0.0).position, curve.at(0.0).velocity), (from, v0));
        let scale = from.abs() + to.abs() + v0.abs() * t;
        prop_assert!((curve.at(t).position - to).abs() <= 4.0 * f64::EPSILON * scale);
    }

    #[test]
    fn half_time_has_the_amplitude(kind in kind(), t in duration(), v0 in number(), a in number()) {
        let curve = answers(kind, t, (0.0, v0), a);
        prop_assert!((curve.at(t / 2.0).acceleration - a).abs() <= 4.0 * f64::EPSILON * a.abs());
        let greatest = curve.peaks().acceleration.value;
        let quarter = if kind == 2 { 2.0 / 3.0_f64.sqrt() } else { 1.0 };
        prop_assert!((greatest - quarter * a.abs()).abs() <= 4.0 * f64::EPSILON * a.abs(), "{greatest}");
    }

    #[test]
    fn each_derivative_is_that_of_the_one_before(
        kind in kind(), t in duration(), v0 in number(), a in number(), share in 0.001..0.999,
    ) {
        let constant = Dual::<1>::constant;
        let curve = new(kind, constant(t), (constant(1.0), constant(v0)), constant(a)).expect("valid");
        let samples = curve.at(Dual::variable(share * t, 0)).to_array();
        for order in 0..3 {
            let (found, wanted) = (samples[order + 1].value(), samples[order].partial(0));
            // Near the vertical tangent of an ellipse the jerk is large.
            let scale = v0.abs() + a.abs() * (1.0 + t) + wanted.abs();
            prop_assert!((found - wanted).abs() <= 1e-13 * scale, "{order}: {found} {wanted}");
        }
    }

    #[test]
    fn derivatives_by_parameters_are_exact(
        kind in kind(), t in duration(), v0 in number(), a in number(), share in 0.0..1.0,
    ) {
        let at = |d: [f64; 4]| {
            let curve = new(kind, t + d[0], (1.0 + d[1], v0 + d[2]), a + d[3]).expect("valid");
            curve.at(share * t).position
        };
        let variable = Dual::<4>::variable;
        let curve = new(kind, variable(t, 0), (variable(1.0, 1), variable(v0, 2)), variable(a, 3)).expect("valid");
        let exact = curve.at(Dual::constant(share * t)).position;
        prop_assert!((exact.value() - at([0.0; 4])).abs() <= 1e-13 * (1.0 + v0.abs() * t + a.abs() * t * t));
        for i in 0..4 {
            let h = 1e-6 * if i == 0 { t } else { 1.0 };
            let mut step = [0.0; 4];
            step[i] = h;
            let difference = (at(step) - at(step.map(|x| -x))) / (2.0 * h);
            let scale = 1.0 + (v0.abs() + a.abs() * t) * (1.0 + t);
            prop_assert!((exact.partial(i) - difference).abs() <= 1e-7 * scale, "{i}: {exact:?} {difference}");
        }
    }

    #[test]
    fn stationary_points_are_where_the_velocity_changes_its_sign(
        kind in kind(), t in duration(), v0 in number(), a in number(),
    ) {
        let curve = answers(kind, t, (0.0, v0), a);
        let turns = curve.stationary().points;
        let (first, last) = (curve.at(0.0).velocity, curve.at(t).velocity);
        // The acceleration has one sign.
        prop_assert_eq!(turns.len(), usize::from(first * last < 0.0));
        for turn in turns {
            let velocity = curve.at(turn.time).velocity;
            let bound = 1e-12 * (v0.abs() + a.abs() * t);
            prop_assert!(velocity.abs() <= bound, "{velocity}");
        }
    }

    #[test]
    fn a_feasible_start_velocity_keeps_the_motion_from_turning(
        kind in kind(), t in duration(), a in number(), share in -2.0..1.0,
    ) {
        let ranges = feasible(kind, t, a);
        let v0 = share * a * t;
        prop_assert_eq!(ranges.contains(v0), answers(kind, t, (0.0, v0), a).is_monotone(), "{}", ranges);
        prop_assert!(ranges.contains(0.0));
    }

    #[test]
    fn a_mirrored_curve_is_the_mirror(
        kind in kind(), t in duration(), x in number(), v0 in number(), a in number(), share in 0.0..1.0,
    ) {
        let (one, other) = (answers(kind, t, (x, v0), a), answers(kind, t, (-x, -v0), -a));
        let (s, m) = (one.at(share * t), other.at(share * t));
        prop_assert_eq!(s.to_array(), m.to_array().map(|x| -x));
    }

    #[test]
    fn a_range_holds_all_samples(
        kind in kind(), t in duration(), v0 in number(), a in number(), ends in (0.0..1.0, 0.0..1.0), share in 0.0..1.0,
    ) {
        let curve = answers(kind, t, (0.0, v0), a);
        let (from, to) = (f64::min(ends.0, ends.1) * t, f64::max(ends.0, ends.1) * t);
        let sample = curve.at(from + share * (to - from));
        for quantity in [Quantity::Position, Quantity::Velocity, Quantity::Acceleration, Quantity::Jerk] {
            let (low, high) = curve.range(quantity, from, to);
            let x = quantity.of(&sample);
            let slack = 1e-12 * (x.abs() + v0.abs() * t + a.abs() * (1.0 + t * t));
            prop_assert!(low - slack <= x && x <= high + slack, "{quantity:?}: {low} {x} {high}");
        }
    }
}

/// x = t − t²/2 turns round at 1 s, half a metre away, in the middle of its span.
#[test]
fn what_turns_round_in_the_middle_is_farthest_there() {
    let curve = Constant::new(2.0, (0.0, 1.0), -1.0).expect("valid");
    assert_eq!(curve.critical(Quantity::Position), [1.0]);
    assert_eq!(curve.range(Quantity::Position, 0.0, 2.0), (0.0, 0.5));
}

/// Twice the amplitude over the duration bounds the velocity: 2.4e308 is no number.
#[test]
fn an_amplitude_whose_velocity_overflows_is_refused() {
    for kind in 0..KINDS {
        assert!(matches!(new(kind, 1.0, (0.0, 0.0), 1.2e308), Err(ProfileError::Overflow { .. })), "{kind}");
    }
}
