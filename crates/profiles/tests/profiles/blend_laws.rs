//! Laws of blends: what they are made of, what they keep, and what they answer.

use proptest::prelude::*;
use solaris_profiles::blend::{Blend, Fade, FadeKind, Layer, Leaving};
use solaris_profiles::{
    Answers, Boundary, Clip, CubicHermite, Curve, Dual, Elementary, Outside, Quantity, Quintic, Turn,
};

fn number() -> impl Strategy<Value = f64> {
    -3.0..3.0
}

/// The six numbers of a quintic.
fn ends() -> impl Strategy<Value = [f64; 6]> {
    prop::array::uniform6(number())
}

fn quintic<F: Elementary>(duration: f64, ends: [f64; 6]) -> Quintic<F> {
    let [a, b, c, d, e, f] = ends.map(F::from_f64);
    Quintic::new(F::from_f64(duration), Boundary::new(a, b, c), Boundary::new(d, e, f)).expect("a curve")
}

/// Fades that stay between 0 and 1, and some that leave it.
fn kind() -> impl Strategy<Value = FadeKind> {
    prop_oneof![
        Just(FadeKind::Linear),
        (0.0..2.0).prop_map(|stiffness| FadeKind::Exponential { stiffness }),
        (0.0..8.0).prop_map(|stiffness| FadeKind::Sinh { stiffness }),
        (0.0..2.5).prop_map(|stiffness| FadeKind::Trigonometric { stiffness }),
        Just(FadeKind::Smooth),
    ]
}

fn fade() -> impl Strategy<Value = Fade> {
    (kind(), -0.5..1.5, 0.1..1.5)
        .prop_map(|(kind, start, length)| Fade::new(kind, start, start + length).expect("a fade"))
}

fn leaving() -> impl Strategy<Value = Leaving> {
    prop_oneof![Just(Leaving::Allow), Just(Leaving::Clamp)]
}

fn outside() -> impl Strategy<Value = Outside> {
    prop_oneof![Just(Outside::Hold), Just(Outside::Extrapolate), Just(Outside::Repeat), Just(Outside::Mirror),]
}

fn two<F: Elementary>(
    first: [f64; 6],
    second: [f64; 6],
    fade: Fade,
    leaving: Leaving,
) -> Blend<Quintic<F>, F> {
    let (first, second) = (Clip::new(quintic(2.0, first)), Clip::new(quintic(2.0, second)));
    Blend::between(first, second, fade, leaving).expect("a blend")
}

/// Three layers: one that is always there, one that fades in, one that fades in and out.
fn three<F: Elementary>(curves: [[f64; 6]; 3], amounts: [f64; 3]) -> Vec<Layer<Quintic<F>, F>> {
    let windows = [
        (None, None),
        (Some(Fade::new(FadeKind::Smooth, 0.3, 1.1).expect("a fade")), None),
        (
            Some(Fade::new(FadeKind::Sinh { stiffness: 2.0 }, 0.1, 0.9).expect("a fade")),
            Some(Fade::new(FadeKind::Linear, 0.7, 1.7).expect("a fade")),
        ),
    ];
    (0..3)
        .map(|i| Layer {
            amount: amounts[i],
            fade_in: windows[i].0,
            fade_out: windows[i].1,
            ..Layer::new(Clip::new(quintic(2.0, curves[i])))
        })
        .collect()
}

fn amounts() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(0.1..2.0)
}

/// All four quantities of two curves are the same within a tolerance of their sizes.
fn assert_same<F: Elementary>(one: &impl Curve<F>, other: &impl Curve<F>, scale: f64) {
    for i in 0..=40 {
        let t = f64::from(i) / 40.0 * one.duration().value();
        let (one, other) = (one.at_time(t).to_array(), other.at_time(t).to_array());
        for k in 0..4 {
            let (x, y) = (one[k].value(), other[k].value());
            // Derivatives of a short window's weights are large and cancel out.
            let tolerance = F::EPSILON * (100.0 * scale + 1e4 * y.abs());
            assert!((x - y).abs() <= tolerance, "{k} at {t}: {x}, not {y}");
        }
    }
}

/// Each derivative is that of the one before it, by dual numbers.
fn assert_derivatives(curve: &impl Curve<Dual<1>>) {
    let samples: Vec<_> = (1..200)
        .map(|i| curve.at(Dual::variable(f64::from(i) * 0.009_973, 0)).to_array())
        .filter(|sample| sample.iter().all(|x| x.value().is_finite()))
        .collect();
    for order in 0..3 {
        let size = |sample: &[Dual<1>; 4]| sample[order].partial(0).abs() + sample[order].value().abs();
        let largest = samples.iter().map(size).fold(0.0, f64::max);
        for sample in &samples {
            let (found, wanted) = (sample[order + 1].value(), sample[order].partial(0));
            assert!((found - wanted).abs() <= 1e-12 * largest, "order {order}: {found}, not {wanted}");
        }
    }
}

/// The reversals of a curve are where a scan finds its velocity to change sign, but for pairs that fall between two instants.
fn assert_stationary(curve: &impl Answers) {
    const STEPS: u32 = 4001;
    let found = curve.stationary();
    let duration = curve.duration();
    let scan: Vec<_> = (0..=STEPS)
        .map(|i| (f64::from(i) + 0.123) / (f64::from(STEPS) + 0.246) * duration)
        .map(|t| (t, curve.at(t).velocity))
        .collect();
    let largest = scan.iter().fold(0.0_f64, |largest, (_, v)| largest.max(v.abs()));
    let clear: Vec<_> = scan.into_iter().filter(|(_, v)| v.abs() > 1e-12 * largest).collect();
    for pair in clear.windows(2) {
        let ((from, before), (to, after)) = (pair[0], pair[1]);
        let turns = found
            .points
            .iter()
            .filter(|point| point.turn == Turn::Reversal && point.time > from && point.time <= to)
            .count();
        let expected = usize::from((before > 0.0) != (after > 0.0));
        assert_eq!(turns % 2, expected, "between {from} and {to}: {found:?}");
        assert!(turns <= expected + 2, "between {from} and {to}: {found:?}");
    }
    for point in &found.points {
        // A jump is where its clip's own time, rounded, says.
        let beside = |by: f64| curve.at(point.time + by * duration).velocity;
        let (before, after) = (beside(-1e-14), beside(1e-14));
        let is_zero = before.abs().min(after.abs()) <= 1e-9 * largest;
        assert!(is_zero || before * after < 0.0, "at {}: {before}, {after}", point.time);
    }
}

/// No instant of a scan is beyond the range of a quantity, and the range is reached.
fn assert_peaks(curve: &impl Answers) {
    let peaks = curve.peaks();
    for (quantity, peak) in [
        (Quantity::Velocity, peaks.velocity),
        (Quantity::Acceleration, peaks.acceleration),
        (Quantity::Jerk, peaks.jerk),
    ] {
        let scan = (0..=3000)
            .map(|i| quantity.of(&curve.at(f64::from(i) / 3000.0 * curve.duration())).abs())
            .fold(0.0, f64::max);
        assert!(peak.value >= scan * (1.0 - 1e-9), "{quantity:?}: {peak:?}, but {scan}");
        let there = quantity.of(&curve.at(peak.time)).abs().max(quantity.of(&curve.before(peak.time)).abs());
        assert!((there - peak.value).abs() <= 1e-9 * peak.value, "{quantity:?}: {peak:?}, but {there}");
    }
}

proptest! {
    #[test]
    fn a_blend_of_equal_curves_is_the_curve(
        ends in ends(), fade in fade(), leaving in leaving(), amounts in amounts(),
    ) {
        let curve = quintic::<f64>(2.0, ends);
        let scale = curve.peaks().jerk.value.max(1.0) * fade.largest();
        assert_same(&two::<f64>(ends, ends, fade, leaving), &curve, scale);
        let mean = Blend::weighted(three::<f64>([ends; 3], amounts)).expect("a blend");
        assert_same(&mean, &curve, scale);
        let curve = quintic::<f32>(2.0, ends);
        assert_same(&two::<f32>(ends, ends, fade, leaving), &curve, scale);
    }

    #[test]
    fn derivatives_are_those_of_the_position(
        curves in prop::array::uniform3(ends()), fade in fade(), leaving in leaving(), amounts in amounts(),
    ) {
        assert_derivatives(&two::<Dual<1>>(curves[0], curves[1], fade, leaving));
        assert_derivatives(&Blend::weighted(three::<Dual<1>>(curves, amounts)).expect("a blend"));
    }

    #[test]
    fn outside_of_the_window_there_is_one_motion(a in ends(), b in ends(), kind in kind()) {
        let fade = Fade::new(kind, 0.5, 1.5).expect("a fade");
        let blend = two::<f64>(a, b, fade, Leaving::Allow);
        prop_assert_eq!(blend.at(0.3), quintic(2.0, a).at(0.3));
        prop_assert_eq!(blend.before(0.5), quintic(2.0, a).at(0.5));
        prop_assert_eq!(blend.at(1.5), quintic(2.0, b).at(1.5));
        prop_assert_eq!(blend.at(2.0), quintic(2.0, b).at(2.0));
    }

    #[test]
    fn a_fade_keeps_what_it_says(a in ends(), b in ends(), kind in kind(), agreeing in 0_usize..=3) {
        let fade = Fade::new(kind, 0.0, 1.0).expect("a fade");
        let mut b = b;
        // They agree in the first quantities at both ends of the window.
        for k in 0..agreeing {
            (b[k], b[k + 3]) = (a[k], a[k + 3]);
        }
        let first = Clip::new(quintic::<f64>(1.0, a)).starting(1.0).expect("a time");
        let second = Clip::new(quintic(1.0, b)).starting(1.0).expect("a time").outside(Outside::Extrapolate);
        let window = Fade::new(kind, 1.0, 2.0).expect("a fade");
        let blend = Blend::between(first, second, window, Leaving::Allow).expect("a blend");
        let (inside, outside) = (blend.at(1.0).to_array(), quintic(1.0, a).at(0.0).to_array());
        let order = fade.keeps().order(agreeing).min(3);
        let scale = 1e3 * fade.largest();
        for k in 0..=order {
            prop_assert!((inside[k] - outside[k]).abs() <= 1e-12 * scale, "{} of {}: {} {}", k, order, inside[k], outside[k]);
        }
        let (inside, outside) = (blend.before(2.0).to_array(), quintic::<f64>(1.0, b).at(1.0).to_array());
        for k in 0..=order {
            prop_assert!((inside[k] - outside[k]).abs() <= 1e-12 * scale, "{} of {}: {} {}", k, order, inside[k], outside[k]);
        }
    }

    #[test]
    fn what_all_motions_are_moved_by_the_blend_is(
        curves in prop::array::uniform3(ends()), fade in fade(), amounts in amounts(), by in number(),
    ) {
        let moved = curves.map(|[a, b, c, d, e, f]| [a + by, b, c, d + by, e, f]);
        for t in [0.0, 0.2, 0.8, 1.3, 2.0] {
            let (here, there) = (two::<f64>(curves[0], curves[1], fade, Leaving::Allow), two::<f64>(moved[0], moved[1], fade, Leaving::Allow));
            prop_assert!((there.at(t).position - here.at(t).position - by).abs() < 1e-11);
            let mean = |curves| Blend::weighted(three::<f64>(curves, amounts)).expect("a blend").at(t);
            prop_assert!((mean(moved).position - mean(curves).position - by).abs() < 1e-12);
            prop_assert!((mean(moved).velocity - mean(curves).velocity).abs() < 1e-11);
        }
    }

    #[test]
    fn the_order_of_layers_does_not_matter(curves in prop::array::uniform3(ends()), amounts in amounts()) {
        let forwards = three::<f64>(curves, amounts);
        let backwards: Vec<_> = forwards.iter().rev().copied().collect();
        let (one, other) = (Blend::weighted(forwards), Blend::weighted(backwards));
        assert_same(&one.expect("a blend"), &other.expect("a blend"), 1e4);
    }

    #[test]
    fn a_blend_of_blends_has_products_of_shares(
        curves in prop::array::uniform3(ends()), a in fade(), b in fade(),
    ) {
        let [first, second, third] = curves.map(|ends| quintic::<f64>(2.0, ends));
        let inner = Blend::between(Clip::new(&first), Clip::new(&second), a, Leaving::Allow).expect("a blend");
        let curves: [&dyn Curve; 2] = [&inner, &third];
        let outer = Blend::between(Clip::new(curves[0]), Clip::new(curves[1]), b, Leaving::Allow).expect("a blend");
        for t in [0.0, 0.4, 0.9, 1.6] {
            let (a, b) = (a.alpha::<f64>(t)[0], b.alpha::<f64>(t)[0]);
            let expected = a * b * first.at(t).position
                + (1.0 - a) * b * second.at(t).position
                + (1.0 - b) * third.at(t).position;
            prop_assert!((outer.at(t).position - expected).abs() < 1e-12);
        }
    }

    #[test]
    fn two_layers_that_cross_are_a_fade(a in ends(), b in ends(), stiffness in 0.0..0.69) {
        let fade = Fade::new(FadeKind::Exponential { stiffness }, 0.4, 1.7).expect("a fade");
        let layers = vec![
            Layer { fade_out: Some(fade), ..Layer::new(Clip::new(quintic::<f64>(2.0, a))) },
            Layer { fade_in: Some(fade), ..Layer::new(Clip::new(quintic(2.0, b))) },
        ];
        let mean = Blend::weighted(layers).expect("a blend");
        assert_same(&mean, &two(a, b, fade, Leaving::Refuse), 1e4);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn stationary_points_are_all_found(a in ends(), b in ends(), fade in fade(), leaving in leaving()) {
        assert_stationary(&two::<f64>(a, b, fade, leaving));
    }

    #[test]
    fn stationary_points_of_weighted_motions_are_all_found(
        curves in prop::array::uniform3(ends()), amounts in amounts(),
    ) {
        assert_stationary(&Blend::weighted(three::<f64>(curves, amounts)).expect("a blend"));
    }

    #[test]
    fn stationary_points_outside_of_clips_are_found(
        a in ends(), b in ends(), policies in prop::array::uniform2(outside()), start in -1.0..1.0, fade in fade(),
    ) {
        let first = Clip::new(quintic::<f64>(0.7, a)).starting(start).expect("a time").outside(policies[0]);
        let second = Clip::new(quintic::<f64>(1.5, b)).starting(0.6).expect("a time").outside(policies[1]);
        assert_stationary(&Blend::between(first, second, fade, Leaving::Allow).expect("a blend"));
    }

    #[test]
    fn stationary_points_of_nested_blends_are_found(
        curves in prop::array::uniform3(ends()), a in fade(), b in fade(),
    ) {
        let [first, second, third] = curves.map(|ends| quintic::<f64>(2.0, ends));
        let inner = Blend::between(Clip::new(first), Clip::new(second), a, Leaving::Allow).expect("a blend");
        let curves: [&dyn Answers; 2] = [&inner, &third];
        let [inner, third] = curves.map(Clip::new);
        assert_stationary(&Blend::between(inner, third, b, Leaving::Allow).expect("a blend"));
    }

    #[test]
    fn peaks_are_the_greatest(a in ends(), b in ends(), fade in fade(), leaving in leaving()) {
        assert_peaks(&two::<f64>(a, b, fade, leaving));
    }

    #[test]
    fn ranges_hold_all_values(a in ends(), b in ends(), fade in fade(), from in 0.0..1.9, length in 0.0..1.0_f64) {
        let blend = two::<f64>(a, b, fade, Leaving::Allow);
        let to = f64::min(from + length, 2.0);
        for quantity in [Quantity::Position, Quantity::Velocity, Quantity::Acceleration, Quantity::Jerk] {
            let (low, high) = blend.range(quantity, from, to);
            for i in 0..=500 {
                let x = quantity.of(&blend.at(from + f64::from(i) / 500.0 * (to - from)));
                // At the end of a window and of the span, what holds before is the range's.
                let is_jump = i == 500;
                let slack = 1e-9 * (high - low).abs() + 1e-12;
                prop_assert!(is_jump || (x >= low - slack && x <= high + slack), "{:?}: {} not in {}..{}", quantity, x, low, high);
            }
        }
    }
}

#[test]
fn layers_may_have_lone_weights() {
    let cubic = CubicHermite::new(1.0, (0.0, 1.0), (2.0, 0.5)).expect("a curve");
    let blend =
        Blend::weighted(vec![Layer { amount: 0.3, ..Layer::new(Clip::new(cubic)) }]).expect("a blend");
    assert_eq!(blend.at(0.4), cubic.at(0.4));
    assert_eq!(blend.stationary(), cubic.stationary());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// All that a stiff fade does, it does within a small part of its window.
    #[test]
    fn stationary_points_of_stiff_fades_are_found(
        a in ends(), b in ends(), stiffness in 8.0..600.0, sinh in any::<bool>(), start in -0.5..1.5, length in 0.1..1.5,
    ) {
        let kind = if sinh { FadeKind::Sinh { stiffness } } else { FadeKind::Exponential { stiffness: 0.02 * stiffness } };
        assert_stationary(&two::<f64>(a, b, Fade::new(kind, start, start + length).expect("a fade"), Leaving::Allow));
    }
}
