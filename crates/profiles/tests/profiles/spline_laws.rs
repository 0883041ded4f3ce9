//! What must hold of every spline through any keys.

use approx::assert_relative_eq;
use proptest::prelude::*;
use solaris_profiles::spline::{Bend, CubicSpline, Key};
use solaris_profiles::{
    Answers, CubicHermite, Curve, Dual, Elementary, ProfileError, Quantity, Sample, Turn,
};

type Keys<F = f64> = Vec<(f64, F)>;
type Make<F> = fn(&[(f64, F)]) -> Result<CubicSpline<F>, ProfileError>;

/// Every constructor that takes keys, with end velocities and bends where it asks for them.
fn makers<F: Elementary>() -> [(&'static str, Make<F>); 7] {
    [
        ("catmull_rom", CubicSpline::catmull_rom),
        ("centripetal", CubicSpline::centripetal),
        ("monotone", CubicSpline::monotone),
        ("natural", CubicSpline::natural),
        ("clamped", |keys| CubicSpline::clamped(keys, F::from_f64(0.25), F::from_f64(-0.75))),
        ("bent", |keys| bent(keys, 0.0)),
        ("broken", |keys| bent(keys, 0.6)),
    ]
}

fn bent<F: Elementary>(keys: &[(f64, F)], continuity: f64) -> Result<CubicSpline<F>, ProfileError> {
    let [tension, continuity, bias, start, end] = [-0.3, continuity, 0.5, 0.25, -0.75].map(F::from_f64);
    CubicSpline::kochanek_bartels(keys, Bend { tension, continuity, bias }, (start, end))
}

fn record() -> impl Strategy<Value = Keys> {
    let key = (0.05..1.0_f64, prop_oneof![4 => -1.0..1.0_f64, 1 => Just(0.5)]);
    (-3.0..3.0_f64, prop::collection::vec(key, 2..20)).prop_map(|(mut time, rows)| {
        rows.into_iter()
            .map(|(step, position)| {
                time += step;
                (time, position)
            })
            .collect()
    })
}

/// The times of the keys since the first.
fn times(keys: &Keys) -> Vec<f64> {
    keys.iter().map(|key| key.0 - keys[0].0).collect()
}

fn bits(sample: &Sample) -> [u64; 4] {
    sample.to_array().map(f64::to_bits)
}

/// The greatest magnitudes of position, velocity, acceleration and jerk over the whole curve. A parabola has the jerk of its rounding.
fn scales(curve: &CubicSpline) -> [f64; 4] {
    let all = [Quantity::Position, Quantity::Velocity, Quantity::Acceleration, Quantity::Jerk];
    let [position, velocity, acceleration, jerk] = all.map(|quantity| {
        let (low, high) = curve.range(quantity, 0.0, curve.duration());
        1e-300 + high.max(-low)
    });
    [position, velocity, acceleration, jerk.max(acceleration / curve.duration())]
}

fn close(found: &Sample, wanted: &Sample, scales: [f64; 4], tolerance: f64) -> bool {
    let (found, wanted) = (found.to_array(), wanted.to_array());
    (0..4).all(|i| (found[i] - wanted[i]).abs() <= tolerance * scales[i])
}

proptest! {
    #[test]
    fn keys_and_their_velocities_are_met_to_the_bit_from_both_sides(keys in record()) {
        for (name, make) in makers::<f64>() {
            let curve = make(&keys).expect("a spline");
            let last = keys.len() - 1;
            prop_assert_eq!(curve.keys().len(), keys.len());
            for (i, (t, key)) in times(&keys).into_iter().zip(curve.keys()).enumerate() {
                let (before, at) = (curve.before(t), curve.at(t));
                prop_assert_eq!(at.position.to_bits(), keys[i].1.to_bits(), "{} at {}", name, t);
                prop_assert_eq!(before.position.to_bits(), keys[i].1.to_bits(), "{} before {}", name, t);
                prop_assert_eq!(at.velocity.to_bits(), key.velocity_out.to_bits(), "{} at {}", name, t);
                prop_assert_eq!(before.velocity.to_bits(), key.velocity_in.to_bits(), "{} before {}", name, t);
                prop_assert_eq!(key.position.to_bits(), keys[i].1.to_bits());
                prop_assert!((key.time - keys[i].0).abs() < 1e-14);
                if name != "broken" {
                    prop_assert_eq!(at.velocity.to_bits(), before.velocity.to_bits(), "{} is not C1 at {}", name, t);
                }
                if matches!(name, "clamped" | "bent" | "broken") && (i == 0 || i == last) {
                    let wanted = if i == 0 { 0.25_f64 } else { -0.75 };
                    prop_assert_eq!(at.velocity.to_bits(), wanted.to_bits());
                }
            }
            prop_assert_eq!(curve, CubicSpline::hermite(&make(&keys).expect("a spline").keys().zip(&keys).map(
                |(key, given)| Key { time: given.0, ..key }).collect::<Vec<_>>()).expect("a spline"));
        }
    }

    #[test]
    fn each_derivative_is_that_of_the_one_before(keys in record(), share in 0.0..1.0_f64) {
        let dual: Keys<Dual<1>> = keys.iter().map(|key| (key.0, Dual::constant(key.1))).collect();
        for ((name, make), (_, make_f64)) in makers::<Dual<1>>().into_iter().zip(makers::<f64>()) {
            let (curve, plain) = (make(&dual).expect("a spline"), make_f64(&keys).expect("a spline"));
            let (t, scales) = (share * plain.duration(), scales(&plain));
            let at = curve.at(Dual::variable(t, 0)).to_array();
            for order in 0..3 {
                let error = (at[order].partial(0) - at[order + 1].value()).abs();
                prop_assert!(error <= 1e-13 * scales[order + 1], "{name} {order}: {error:e}");
            }
            prop_assert_eq!(bits(&plain.at(t)), at.map(|x| x.value().to_bits()));
            prop_assert_eq!(bits(&plain.at_time(t)), bits(&plain.at(t)));
        }
    }

    #[test]
    fn the_acceleration_of_natural_and_clamped_splines_does_not_jump(keys in record()) {
        for (name, make) in makers::<f64>().into_iter().filter(|maker| matches!(maker.0, "natural" | "clamped")) {
            let curve = make(&keys).expect("a spline");
            let tolerance = 1e-12 * scales(&curve)[2];
            for &t in &times(&keys)[1..keys.len() - 1] {
                let (before, at) = (curve.before(t).acceleration, curve.at(t).acceleration);
                prop_assert!((before - at).abs() <= tolerance, "{name} at {t}: {before} {at}");
            }
            if name == "natural" {
                let ends = [curve.at(0.0).acceleration, curve.at(curve.duration()).acceleration];
                prop_assert!(ends.iter().all(|a| a.abs() <= tolerance.max(1e-13)), "{ends:?}");
            }
        }
    }

    #[test]
    fn of_all_curves_through_the_keys_the_natural_one_bends_least(keys in record()) {
        let bending = |curve: &CubicSpline| -> f64 {
            let times = times(&keys);
            // The acceleration is linear between keys.
            let pieces = times.windows(2).map(|pair| {
                let (a, b) = (curve.at(pair[0]).acceleration, curve.before(pair[1]).acceleration);
                (pair[1] - pair[0]) * (a * a + a * b + b * b) / 3.0
            });
            pieces.sum()
        };
        let least = bending(&CubicSpline::natural(&keys).expect("a spline"));
        // What breaks its velocity has no acceleration to be integrated there.
        for (name, make) in makers::<f64>().into_iter().filter(|maker| maker.0 != "broken") {
            prop_assert!(least <= bending(&make(&keys).expect("a spline")) * (1.0 + 1e-12) + 1e-24, "{name}");
        }
    }

    #[test]
    fn a_monotone_spline_turns_at_keys_alone_and_rests_between_equal_ones(keys in record()) {
        let curve = CubicSpline::monotone(&keys).expect("a spline");
        let times = times(&keys);
        let found = curve.stationary();
        for point in &found.points {
            prop_assert!(times.iter().any(|t| t.to_bits() == point.time.to_bits()), "{point:?} between {times:?}");
        }
        for i in 1..keys.len() {
            let (a, b) = (keys[i - 1].1, keys[i].1);
            let middle = 0.5 * (times[i - 1] + times[i]);
            let rests = found.rests.iter().any(|rest| rest.0 < middle && middle < rest.1);
            prop_assert_eq!(rests, a.to_bits() == b.to_bits());
            for k in 0..=20 {
                let x = curve.at(times[i - 1] + (times[i] - times[i - 1]) * f64::from(k) / 20.0).position;
                prop_assert!(x >= a.min(b) - 1e-15 && x <= a.max(b) + 1e-15, "{x} outside of {a} to {b}");
            }
        }
        let turns = |window: &[(f64, f64)]| (window[1].1 - window[0].1) * (window[2].1 - window[1].1) < 0.0;
        let reversed = found.points.iter().filter(|point| point.turn == Turn::Reversal).count();
        let mut apart = keys.clone();
        apart.dedup_by(|b, a| a.1.to_bits() == b.1.to_bits());
        prop_assert_eq!(reversed, apart.windows(3).filter(|window| turns(window)).count());
    }

    /// Between two stationary points the velocity has one sign; over a reversal it is another one, over a touch the same.
    #[test]
    fn no_stationary_point_is_missing_and_none_too_many(
        keys in record(), bend in prop::array::uniform3(-2.0..2.0_f64), ends in (-3.0..3.0_f64, -3.0..3.0_f64),
    ) {
        let [tension, continuity, bias] = bend;
        let curve = CubicSpline::kochanek_bartels(&keys, Bend { tension, continuity, bias }, ends).expect("a spline");
        let found = curve.stationary();
        let mut bounds = vec![(0.0, Turn::Touch)];
        bounds.extend(found.points.iter().map(|point| (point.time, point.turn)));
        bounds.push((curve.duration(), Turn::Touch));
        let mut sign = 0.0;
        let tolerance = 1e-13 * scales(&curve)[1];
        for pair in bounds.windows(2) {
            let (from, to) = (pair[0].0, pair[1].0);
            prop_assert!(from <= to);
            let here: Vec<f64> = (1..50).map(|k| curve.at(from + (to - from) * f64::from(k) / 50.0).velocity)
                .filter(|v| v.abs() > tolerance).map(f64::signum).collect();
            prop_assert!(here.iter().all(|s| (s - here[0]).abs() < 0.5), "between {from} and {to}: {here:?}");
            if let Some(&s) = here.first() {
                let turned = sign * s < 0.0;
                prop_assert!(sign.abs() < 0.5 || turned == (pair[0].1 == Turn::Reversal), "at {from}: {:?}", pair[0].1);
                sign = s;
            }
        }
    }

    #[test]
    fn no_sample_is_beyond_what_is_said_to_be_greatest(keys in record(), shares in prop::array::uniform2(0.0..1.0_f64)) {
        for (name, make) in makers::<f64>() {
            let curve = make(&keys).expect("a spline");
            let (peaks, scales) = (curve.peaks(), scales(&curve));
            let from = shares[0].min(shares[1]) * curve.duration();
            let to = shares[0].max(shares[1]) * curve.duration();
            let (low, high) = curve.range(Quantity::Position, from, to);
            for k in 0..=200 {
                let at = curve.at(curve.duration() * f64::from(k) / 200.0);
                prop_assert!(at.velocity.abs() <= peaks.velocity.value + 1e-14 * scales[1], "{name}");
                prop_assert!(at.acceleration.abs() <= peaks.acceleration.value + 1e-14 * scales[2], "{name}");
                prop_assert!(at.jerk.abs() <= peaks.jerk.value + 1e-14 * scales[3], "{name}");
                let x = curve.at(from + (to - from) * f64::from(k) / 200.0).position;
                prop_assert!(x >= low - 1e-14 * scales[0] && x <= high + 1e-14 * scales[0], "{name}");
            }
        }
    }

    #[test]
    fn backwards_in_time_it_is_the_same_curve(keys in record(), share in 0.0..1.0_f64) {
        let back: Keys = keys.iter().rev().map(|key| (-key.0, key.1)).collect();
        for (name, make) in makers::<f64>() {
            let curve = make(&keys).expect("a spline");
            let mirrored = match name {
                "clamped" => CubicSpline::clamped(&back, 0.75, -0.25),
                "bent" | "broken" => {
                    let continuity = if name == "bent" { 0.0 } else { 0.6 };
                    let bend = Bend { tension: -0.3, continuity, bias: -0.5 };
                    CubicSpline::kochanek_bartels(&back, bend, (0.75, -0.25))
                }
                _ => make(&back),
            };
            let t = share * curve.duration();
            let (there, back) = (curve.at(t), mirrored.expect("a spline").at(curve.duration() - t).reversed());
            // A key's time since the first and until the last differ in rounding.
            let near_key = times(&keys).iter().any(|key| (key - t).abs() < 1e-9);
            prop_assert!(near_key || close(&there, &back, scales(&curve), 1e-11), "{name}: {there:?} {back:?}");
        }
    }

    #[test]
    fn cubics_come_back_from_their_keys_and_end_velocities(
        keys in record(), c in prop::array::uniform4(-2.0..2.0_f64), share in 0.0..1.0_f64,
    ) {
        let cubic = |t: f64| Sample {
            position: c[0] + t * (c[1] + t * (c[2] + t * c[3])),
            velocity: c[1] + t * (2.0 * c[2] + t * 3.0 * c[3]),
            acceleration: 2.0 * c[2] + t * 6.0 * c[3],
            jerk: 6.0 * c[3],
        };
        let times = times(&keys);
        let keys: Keys = times.iter().map(|&t| (t, cubic(t).position)).collect();
        let end = times[times.len() - 1];
        let clamped = CubicSpline::clamped(&keys, c[1], cubic(end).velocity).expect("a spline");
        let smooth: Vec<_> = keys.iter().map(|&(t, x)| Key::smooth(t, x, cubic(t).velocity)).collect();
        let hermite = CubicSpline::hermite(&smooth).expect("a spline");
        let t = share * end;
        let scales = [1.0, 1.0, 20.0, 400.0].map(|steps| steps * (1.0 + end.powi(3)));
        prop_assert!(close(&clamped.at(t), &cubic(t), scales, 1e-12), "{:?} {:?}", clamped.at(t), cubic(t));
        prop_assert!(close(&hermite.at(t), &cubic(t), scales, 1e-12), "{:?} {:?}", hermite.at(t), cubic(t));
    }

    #[test]
    fn lines_come_back_from_every_spline(keys in record(), slope in -3.0..3.0_f64, share in 0.0..1.0_f64) {
        let line: Keys = keys.iter().map(|key| (key.0, 0.5 + slope * key.0)).collect();
        for (name, make) in makers::<f64>().into_iter().take(5) {
            let curve = if name == "clamped" { CubicSpline::clamped(&line, slope, slope) } else { make(&line) };
            let curve = curve.expect("a spline");
            let at = curve.at(share * curve.duration());
            let wanted = slope * (share * curve.duration() + line[0].0) + 0.5;
            prop_assert!((at.position - wanted).abs() < 1e-13, "{name}");
            prop_assert!((at.velocity - slope).abs() < 1e-12 && at.acceleration.abs() < 1e-10, "{name} {at:?}");
        }
    }

    #[test]
    fn parabolas_come_back_from_equally_spaced_catmull_rom_keys(c in prop::array::uniform3(-2.0..2.0_f64), n in 3..12_u32) {
        let x = |t: f64| c[0] + t * (c[1] + t * c[2]);
        let keys: Keys = (0..n).map(|i| (0.25 * f64::from(i), x(0.25 * f64::from(i)))).collect();
        let curve = CubicSpline::catmull_rom(&keys).expect("a spline");
        for k in 0..=40 {
            let t = curve.duration() * f64::from(k) / 40.0;
            prop_assert!((curve.at(t).position - x(t)).abs() < 1e-13);
            prop_assert!((curve.at(t).acceleration - 2.0 * c[2]).abs() < 1e-10);
        }
    }

    /// A natural spline is linear in its keys: its derivative by one of them is the spline of that key alone.
    #[test]
    fn derivatives_by_a_key_are_the_response_to_it(keys in record(), which in 0..20_usize, share in 0.0..1.0_f64) {
        let which = which % keys.len();
        let dual: Keys<Dual<1>> = keys.iter().enumerate().map(|(i, &(t, x))| {
            (t, if i == which { Dual::variable(x, 0) } else { Dual::constant(x) })
        }).collect();
        let one: Keys = keys.iter().enumerate().map(|(i, key)| (key.0, f64::from(u8::from(i == which)))).collect();
        let response = CubicSpline::natural(&one).expect("a spline");
        let t = share * response.duration();
        let at = CubicSpline::natural(&dual).expect("a spline").at(Dual::constant(t)).to_array();
        let partial = Sample::from_array(at.map(|x| x.partial(0)));
        prop_assert!(close(&partial, &response.at(t), scales(&response), 1e-13));
    }

    #[test]
    fn the_centripetal_curve_does_not_depend_on_units(keys in record(), by in 1e-3..1e3_f64, share in 0.0..1.0_f64) {
        let scaled: Keys = keys.iter().map(|key| (key.0, by * key.1)).collect();
        let (one, other) = (CubicSpline::centripetal(&keys), CubicSpline::centripetal(&scaled));
        let (one, other) = (one.expect("a spline"), other.expect("a spline"));
        let t = share * one.duration();
        let back = Sample::from_array(other.at(t).to_array().map(|x| x / by));
        prop_assert!(close(&one.at(t), &back, scales(&one), 1e-13));
        for i in 1..keys.len() {
            if keys[i - 1].1.to_bits() == keys[i].1.to_bits() && i > 1 && i + 1 < keys.len() {
                let middle = 0.5 * (times(&keys)[i - 1] + times(&keys)[i]);
                prop_assert_eq!(one.at(middle), Sample::rest(keys[i].1), "a hold holds");
            }
        }
    }

    #[test]
    fn a_cursor_answers_as_the_spline_does(keys in record(), shares in prop::collection::vec(-0.2..1.2_f64, 30)) {
        let curve = CubicSpline::natural(&keys).expect("a spline");
        let mut cursor = curve.cursor();
        for t in shares.iter().map(|share| share * curve.duration()).chain(times(&keys)).chain(times(&keys)) {
            prop_assert_eq!(bits(&cursor.at_time(t)), bits(&curve.at_time(t)), "{}", t);
        }
    }
}

#[test]
fn two_keys_are_a_line_and_with_end_velocities_the_cubic() {
    let keys = [(1.0, 2.0), (3.0, 5.0)];
    for (name, make) in makers::<f64>().into_iter().take(4) {
        let at = make(&keys).expect("a spline").at(0.5);
        assert_eq!(at, Sample { velocity: 1.5, ..Sample::rest(2.75) }, "{name}");
    }
    let cubic = CubicHermite::new(2.0, (2.0, 0.25), (5.0, -0.75)).expect("a cubic");
    for (name, make) in makers::<f64>().into_iter().skip(4) {
        for t in [0.0, 0.3, 1.0, 1.9, 2.0] {
            let (found, wanted) = (make(&keys).expect("a spline").at(t), Curve::at(&cubic, t));
            assert!(close(&found, &wanted, [5.0, 5.0, 20.0, 40.0], 1e-15), "{name}: {found:?} {wanted:?}");
        }
    }
}

#[test]
fn outside_it_stays_at_its_ends_or_goes_on_as_its_tangent() {
    let curve = CubicSpline::catmull_rom(&[(5.0, 1.0), (6.0, 3.0), (8.0, 2.0)]).expect("a spline");
    assert_eq!(curve.start().to_bits(), 5.0_f64.to_bits());
    assert_eq!(curve.at(-1.0), curve.at(0.0));
    assert_eq!(curve.at(9.0), curve.at(3.0));
    let (start, end) = (curve.at(0.0), curve.at(3.0));
    assert_eq!(curve.extrapolated(-2.0), start.straight_on(-2.0));
    assert_eq!(curve.extrapolated(4.0), end.straight_on(1.0));
    let clip = curve.clone().into_clip();
    assert_eq!(clip.at(6.5), curve.at(1.5));
    assert_eq!(clip.at(100.0), Sample::rest(2.0));
    for t in [f64::NAN, -f64::NAN] {
        assert!(curve.at(t).to_array().iter().all(|x| x.is_nan()));
        assert!(
            curve
                .before(t)
                .to_array()
                .iter()
                .chain(&curve.cursor().at_time(t).to_array())
                .all(|x| x.is_nan())
        );
    }
}

#[test]
fn a_key_is_a_stationary_point_by_what_the_velocity_does_there() {
    let spline = |velocities: [(f64, f64); 3], positions: [f64; 3]| {
        let keys: Vec<_> = (0..3)
            .map(|i| {
                let (velocity_in, velocity_out) = velocities[i];
                Key { time: i as f64, position: positions[i], velocity_in, velocity_out }
            })
            .collect();
        CubicSpline::hermite(&keys).expect("a spline").stationary()
    };
    let at_key = |velocities: (f64, f64), turn: Option<Turn>, positions: [f64; 3]| {
        let found =
            spline([(1.0, 1.0), velocities, (0.0, (positions[2] - positions[1]).signum())], positions);
        let there: Vec<_> = found.points.iter().filter(|point| (point.time - 1.0).abs() < 1e-12).collect();
        assert_eq!(there.first().map(|point| point.turn), turn, "{velocities:?}: {found:?}");
        assert!(there.len() < 2 && found.rests.is_empty(), "{found:?}");
    };
    let (rising, turning) = ([0.0, 1.0, 2.0], [0.0, 1.0, 0.0]);
    at_key((1.0, -1.0), Some(Turn::Reversal), turning);
    at_key((0.0, 0.0), Some(Turn::Reversal), turning);
    at_key((0.0, -1.0), Some(Turn::Reversal), turning);
    at_key((1.0, 0.0), Some(Turn::Reversal), turning);
    at_key((0.0, 0.0), Some(Turn::Touch), rising);
    at_key((1.0, 0.0), Some(Turn::Touch), rising);
    at_key((0.0, 1.0), Some(Turn::Touch), rising);
    at_key((1.0, 2.0), None, rising);
}

#[test]
fn a_motion_that_comes_back_after_a_rest_turned_when_the_rest_began() {
    let keys =
        |positions: [f64; 6]| -> Keys { (0..6).map(|i| (f64::from(i), positions[i as usize])).collect() };
    let answer = |positions| CubicSpline::monotone(&keys(positions)).expect("a spline").stationary();
    let there_and_back = answer([0.0, 1.0, 1.0, 1.0, 0.5, 0.0]);
    assert_eq!(there_and_back.rests, [(1.0, 3.0)]);
    let times: Vec<_> = there_and_back.points.iter().map(|point| (point.time, point.turn)).collect();
    assert_eq!(times, [(1.0, Turn::Reversal)]);
    let on = answer([0.0, 0.0, 1.0, 1.0, 2.0, 2.0]);
    assert_eq!((on.rests, on.points.len()), (vec![(0.0, 1.0), (2.0, 3.0), (4.0, 5.0)], 0));
    let rest = answer([3.0; 6]);
    assert_eq!((rest.rests, rest.points.len()), (vec![(0.0, 5.0)], 0));
}

/// Three keys, with which every formula can be followed by hand.
#[test]
fn velocities_at_a_key_are_what_the_formulas_say() {
    // Ways 4 in 1 s and 1 in 2 s: mean velocities 4 and 1/2.
    let keys = [(0.0, 0.0), (1.0, 4.0), (3.0, 5.0)];
    let velocities = |make: Make<f64>| {
        make(&keys).expect("a spline").keys().map(|key| key.velocity_out).collect::<Vec<_>>()
    };
    let check = |make: Make<f64>, wanted: [f64; 3]| {
        for (found, wanted) in velocities(make).into_iter().zip(wanted) {
            assert_relative_eq!(found, wanted, max_relative = 1e-15, epsilon = 1e-15);
        }
    };
    // 5/3; at the ends 2·4 − 5/3 and 2·½ − 5/3. The monotone one's are 4 + (4 − ½)/3 and ½ + (½ − 4)·2/3, of which that may not be
    // negative.
    check(CubicSpline::catmull_rom, [19.0 / 3.0, 5.0 / 3.0, -2.0 / 3.0]);
    // (1·4 + 2·½)/(2 + 1)
    check(CubicSpline::centripetal, [4.0, 5.0 / 3.0, 0.5]);
    // 9/(5/4 + 4/½)
    check(CubicSpline::monotone, [31.0 / 6.0, 9.0 / 9.25, 0.0]);
    // 2v₀ + v₁ = 12, ⅔v₀ + 2v₁ + ⅓v₂ = 3(⅔·4 + ⅓·½), v₁ + 2v₂ = 3/2
    check(CubicSpline::natural, [55.0 / 12.0, 17.0 / 6.0, -2.0 / 3.0]);
}
