//! Laws of the curves that are given by their velocity.

#![allow(clippy::float_cmp, reason = "what is to be met exactly is compared exactly")]

use proptest::prelude::*;
use solaris_profiles::velocity::{Circle, Faired, Line};
use solaris_profiles::{Answers, Curve, Dual, Elementary, Quantity, Range, Ranges, Sample, Turn};
use std::ops::Bound;

fn number() -> impl Strategy<Value = f64> {
    -10.0..10.0
}

fn duration() -> impl Strategy<Value = f64> {
    0.05..20.0
}

/// Duration, end velocities and third point of an arc, the third velocity `lift` of the way from the lowest to the
/// highest.
fn arc() -> impl Strategy<Value = (f64, (f64, f64), (f64, f64))> {
    (duration(), (number(), number()), 0.01..0.99, 0.02..0.98).prop_map(|(t, ends, share, lift)| {
        let ranges = Circle::feasible_third_velocity(t, ends, share * t).expect("valid");
        let (low, high) = bounds(ranges.as_slice()[0]);
        (t, ends, (share * t, low + lift * (high - low)))
    })
}

fn bounds(range: Range) -> (f64, f64) {
    match (range.low, range.high) {
        (Bound::Included(low) | Bound::Excluded(low), Bound::Included(high) | Bound::Excluded(high)) => {
            (low, high)
        }
        _ => panic!("{range}"),
    }
}

fn derivatives_agree(samples: [Dual<1>; 4], scale: f64) -> Result<(), TestCaseError> {
    for order in 0..3 {
        let (found, wanted) = (samples[order + 1].value(), samples[order].partial(0));
        prop_assert!((found - wanted).abs() <= 1e-12 * (scale + wanted.abs()), "{order}: {found} {wanted}");
    }
    Ok(())
}

/// Where a closely sampled velocity changes its sign.
fn sampled_turns(curve: &impl Curve, n: u32) -> usize {
    let signs: Vec<bool> =
        (0..=n).map(|i| curve.at(curve.duration() * f64::from(i) / f64::from(n)).velocity > 0.0).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

proptest! {
    #[test]
    fn a_line_goes_from_one_velocity_to_the_other(
        t in duration(), x in number(), v0 in number(), v1 in number(), share in 0.0..1.0,
    ) {
        let line = Line::new(t, x, (v0, v1)).expect("valid");
        prop_assert_eq!((line.at(0.0).position, line.at(0.0).velocity, line.at(t).velocity), (x, v0, v1));
        let constant = Dual::<1>::constant;
        let dual = Line::new(constant(t), constant(x), (constant(v0), constant(v1))).expect("valid");
        derivatives_agree(dual.at(Dual::variable(share * t, 0)).to_array(), v0.abs() + v1.abs())?;
        prop_assert_eq!(line.is_monotone(), v0 * v1 >= 0.0);
        prop_assert_eq!(Line::feasible_start_velocity(v1).expect("finite").contains(v0), line.is_monotone());
        prop_assert_eq!(Line::feasible_end_velocity(v0).expect("finite").contains(v1), line.is_monotone());
        for turn in line.stationary().points {
            prop_assert!(line.at(turn.time).velocity.abs() <= 1e-14 * (v0.abs() + v1.abs()));
        }
        let reaching = Line::reaching(t, (x, v0), v1).expect("valid").at(t).position;
        prop_assert!((reaching - v1).abs() <= 4.0 * f64::EPSILON * (x.abs() + v1.abs() + v0.abs() * t));
    }

    #[test]
    fn a_circle_meets_its_three_points((t, ends, third) in arc(), x in number()) {
        let circle = Circle::new(t, x, ends, third).expect("feasible");
        prop_assert_eq!((circle.at(0.0).position, circle.at(0.0).velocity), (x, ends.0));
        let scale = ends.0.abs() + ends.1.abs() + third.1.abs();
        prop_assert!((circle.at(t).velocity - ends.1).abs() <= 4.0 * f64::EPSILON * scale);
        // The steeper the arc, the more a rounded time moves it.
        let at_third = circle.at(third.0);
        let slack = 4.0 * f64::EPSILON * (scale + t + at_third.acceleration.abs() * t);
        prop_assert!((at_third.velocity - third.1).abs() <= 10.0 * slack, "{at_third:?} {third:?}");
    }

    #[test]
    fn all_points_of_a_circle_are_equally_far_from_its_centre((t, ends, third) in arc(), share in 0.01..0.99) {
        let circle = Circle::new(t, 0.0, ends, third).expect("feasible");
        // The radius of curvature of the velocity's graph.
        let radius = |s: Sample| (1.0 + s.acceleration * s.acceleration).powf(1.5) / s.jerk;
        let (here, there) = (radius(circle.at(share * t)), radius(circle.at(0.5 * t)));
        prop_assert!((here - there).abs() <= 1e-9 * there.abs(), "{here} {there}");
        let constant = Dual::<1>::constant;
        let dual = Circle::new(
            constant(t), constant(0.0), (constant(ends.0), constant(ends.1)), (constant(third.0), constant(third.1)),
        ).expect("feasible");
        let samples = dual.at(Dual::variable(share * t, 0)).to_array();
        let scale = ends.0.abs() + ends.1.abs() + t;
        derivatives_agree(samples, scale * 10.0)?;
    }

    #[test]
    fn a_circle_has_its_feasible_third_velocities(
        t in duration(), ends in (number(), number()), share in 0.01..0.99, beyond in 0.001..1.0,
    ) {
        let ranges = Circle::feasible_third_velocity(t, ends, share * t).expect("valid");
        let (low, high) = bounds(ranges.as_slice()[0]);
        let new = |vm: f64| Circle::new(t, 0.0, ends, (share * t, vm));
        prop_assert!(new(low).is_ok() && new(high).is_ok(), "{low} {high}");
        prop_assert!(new(low - beyond * (high - low)).is_err() && new(high + beyond * (high - low)).is_err());
        // At both bounds the arc is vertical at one end.
        for bound in [low, high] {
            let circle = new(bound).expect("feasible");
            let steepest = circle.at(0.0).acceleration.abs().max(circle.at(t).acceleration.abs());
            prop_assert!(steepest > 1e6, "{steepest}");
        }
    }

    #[test]
    fn a_circle_has_its_feasible_third_times(
        t in duration(), ends in (number(), number()), vm in number(), share in 0.0..1.0,
    ) {
        let ranges = Circle::feasible_third_time(t, ends, vm).expect("valid");
        prop_assert!(ranges.as_slice().len() <= 1);
        let time: f64 = share * t;
        prop_assume!(time > 0.0);
        let bound = ranges.as_slice().first().map(|&range| bounds(range));
        // Rounding decides within it of a bound.
        let near = bound.is_some_and(|(a, b)| (time - a).abs() < 1e-9 * t || (time - b).abs() < 1e-9 * t);
        prop_assume!(!near);
        prop_assert_eq!(ranges.contains(time), Circle::new(t, 0.0, ends, (time, vm)).is_ok(), "{}", ranges);
    }

    #[test]
    fn a_circle_turns_where_its_velocity_changes_sign((t, ends, third) in arc()) {
        let circle = Circle::new(t, 0.0, ends, third).expect("feasible");
        let found = circle.stationary().points;
        prop_assert!(found.len() >= sampled_turns(&circle, 400) && found.len() <= 2);
        for point in &found {
            prop_assert_eq!(point.turn, Turn::Reversal);
            let (before, after) = (circle.at(point.time - 1e-9 * t).velocity, circle.at(point.time + 1e-9 * t).velocity);
            prop_assert!(before * after <= 0.0, "{before} {after}");
        }
        let (low, high) = circle.range(Quantity::Velocity, 0.0, t);
        for i in 0..=50 {
            let v = circle.at(t * f64::from(i) / 50.0).velocity;
            prop_assert!(low <= v && v <= high, "{low} {v} {high}");
        }
    }

    #[test]
    fn a_circle_is_the_same_backwards((t, (v0, v1), (third, vm)) in arc(), share in 0.0..1.0) {
        let there = Circle::new(t, 0.0, (v0, v1), (third, vm)).expect("feasible");
        let back = Circle::new(t, 0.0, (v1, v0), (t - third, vm)).expect("feasible");
        let whole = there.at(t).position;
        let (s, r) = (there.at(share * t), back.at(t - share * t));
        let scale = 1e-11 * (v0.abs() + v1.abs() + vm.abs() + t);
        prop_assert!((s.velocity - r.velocity).abs() <= scale * (1.0 + s.acceleration.abs()));
        prop_assert!((s.position + r.position - whole).abs() <= scale * t);
    }

    #[test]
    fn a_faired_motion_eases_in_and_out(
        t in duration(), x in number(), to in number(), corners in (0.0..1.0, 0.0..1.0), share in 0.0..1.0,
    ) {
        let (rise, fall) = (f64::min(corners.0, corners.1) * t, f64::max(corners.0, corners.1) * t);
        prop_assume!(rise > 1e-3 && t - fall > 1e-3 && to != x);
        let motion = Faired::reaching(t, x, to, (rise, fall)).expect("valid");
        prop_assert_eq!((motion.at(0.0).position, motion.at(t).position), (x, to));
        prop_assert_eq!((motion.at(0.0).velocity, motion.at(t).velocity), (0.0, 0.0));
        let v = motion.velocity();
        prop_assert!(motion.peaks().velocity.value <= v.abs() * (1.0 + 1e-15));
        for corner in [rise, fall] {
            let (before, after) = (motion.before(corner), motion.at(corner));
            prop_assert!((before.position - after.position).abs() <= 1e-14 * (x.abs() + to.abs()));
            prop_assert!((before.velocity - after.velocity).abs() <= 1e-15 * v.abs());
            let rate = 1.0 / rise + 1.0 / (t - fall);
            prop_assert!((before.acceleration - after.acceleration).abs() <= 4.0 * f64::EPSILON * v.abs() * rate);
        }
        let same = Faired::new(t, x, v, (rise, fall)).expect("valid").at(t).position;
        prop_assert!((same - to).abs() <= 1e-14 * (x.abs() + to.abs()));
        prop_assert!(motion.is_monotone() && motion.stationary().points.is_empty());
        let constant = Dual::<1>::constant;
        let corners = (constant(rise), constant(fall));
        let dual = Faired::reaching(constant(t), constant(x), constant(to), corners).expect("valid");
        let scale = v.abs() * (1.0 + 1.0 / rise + 1.0 / (t - fall)).powi(3);
        derivatives_agree(dual.at(Dual::variable(share * t, 0)).to_array(), scale)?;
    }
}

#[test]
fn the_example_of_the_thesis_has_two_ranges_about_a_line() {
    // (0, 1), (T₁, 2), (1, 3): (5 − √21)/2 to (√21 − 3)/2, with the line at 1/2.
    let ranges = Circle::feasible_third_time(1.0, (1.0, 3.0), 2.0).expect("valid");
    let (low, high) = bounds(ranges.as_slice()[0]);
    let root = 21.0_f64.sqrt();
    assert!(
        (low - (5.0 - root) / 2.0).abs() < 1e-15 && (high - (root - 3.0) / 2.0).abs() < 1e-15,
        "{ranges}"
    );
    assert!(Circle::feasible_third_time(1.0, (0.0, 0.0), 0.6).expect("valid").is_empty());
    let level = Circle::feasible_third_time(1.0, (2.0, 2.0), 2.0).expect("valid");
    assert_eq!(level, Ranges::from(Range::new(Bound::Excluded(0.0), Bound::Excluded(1.0))));
}

#[test]
fn the_corners_of_a_faired_motion_have_two_sides() {
    let motion = Faired::new(3.0, 0.0, 2.0, (1.0, 2.0)).expect("valid");
    let rate = std::f64::consts::FRAC_PI_2;
    assert_eq!(motion.at(1.0).jerk, 0.0);
    assert!((motion.before(1.0).jerk + 2.0 * rate * rate).abs() < 1e-14);
    assert_eq!(motion.before(2.0).jerk, 0.0);
    assert!((motion.at(2.0).jerk + 2.0 * rate * rate).abs() < 1e-14);
    assert!((motion.peaks().acceleration.value - 2.0 * rate).abs() < 1e-14);
    assert!(Elementary::abs(motion.at(3.0).velocity) <= 0.0);
}
