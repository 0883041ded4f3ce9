//! What holds for every curve for displacement, whatever its parameters.

use proptest::prelude::*;
use solaris_profiles::displacement::{
    Exponential, ExponentialVelocities, Hyperbolic, Line, Power, Tension, Trigonometric,
    TrigonometricVelocities,
};
use solaris_profiles::{
    Answers, CubicHermite, Curve, Dual, Elementary, ProfileError, Quantity, Sample, Turn, legacy,
};

/// A duration, two positions, two velocities.
type Motion<F> = (F, F, F, F, F);

fn motion() -> impl Strategy<Value = Motion<f64>> {
    (0.1..10.0, -5.0..5.0, -5.0..5.0, -8.0..8.0, -8.0..8.0)
}

/// Parameters of one curve of each family.
#[derive(Clone, Debug)]
struct Parameters {
    motion: Motion<f64>,
    power: f64,
    shape: f64,
    exponent: u32,
    stiffness: f64,
}

fn parameters() -> impl Strategy<Value = Parameters> {
    let stiffness = prop_oneof![Just(0.0), 0.0..20.0, (-9.0..3.0_f64).prop_map(|x| 10_f64.powf(x))];
    let shape = prop_oneof![Just(0.0), -3.0..0.9, (-9.0..-1.0_f64).prop_map(|x| 10_f64.powf(x))];
    (motion(), 3.0..12.0, shape, 3..10_u32, stiffness).prop_map(
        |(motion, power, shape, exponent, stiffness)| Parameters {
            motion,
            power,
            shape,
            exponent,
            stiffness,
        },
    )
}

type Curves<F> = Vec<(&'static str, Box<dyn Curve<F>>)>;

fn named<F: Elementary, C: Curve<F> + 'static>(
    name: &'static str,
    curve: Result<C, ProfileError>,
) -> (&'static str, Box<dyn Curve<F>>) {
    (name, Box::new(curve.expect("a curve")))
}

/// One curve of each family; every number may depend on something.
fn curves<F: Elementary>(p: &Parameters, (t, x0, x1, v0, v1): Motion<F>) -> Curves<F> {
    let (start, end) = ((x0, v0), (x1, v1));
    let [power, shape, stiffness] = [p.power, p.shape, p.stiffness].map(F::from_f64);
    vec![
        named("line", Line::new(t, x0, x1)),
        named("trigonometric", Trigonometric::new(t, x0, x1)),
        named("power", Power::new(t, x0, x1, power)),
        named("exponential", Exponential::new(t, x0, x1, power, shape)),
        named("hyperbolic", Hyperbolic::new(t, x0, x1, stiffness)),
        named("trigonometric velocities", TrigonometricVelocities::new(t, start, end)),
        named("exponential velocities", ExponentialVelocities::new(t, start, end, p.exponent, shape)),
        named("tension", Tension::new(t, start, end, stiffness)),
    ]
}

/// The last three have velocities.
const WITH_VELOCITIES: usize = 5;

const FRACTIONS: [f64; 9] = [0.0, 1e-9, 0.1, 0.3, 0.5, 0.500_1, 0.8, 0.999, 1.0];

/// The greatest of each of the four in magnitude.
fn sizes<F: Elementary>(curve: &dyn Curve<F>) -> [f64; 4] {
    let mut sizes = [0.0_f64; 4];
    for i in 0..=64 {
        let sample = curve.at(curve.duration() * F::from_f64(f64::from(i) / 64.0)).to_array();
        for (size, x) in sizes.iter_mut().zip(sample) {
            *size = size.max(x.value().abs());
        }
    }
    sizes
}

#[track_caller]
fn assert_close(what: &str, found: Sample, wanted: Sample, sizes: [f64; 4], tolerance: f64) {
    let pairs = found.to_array().into_iter().zip(wanted.to_array());
    for (order, ((found, wanted), size)) in pairs.zip(sizes).enumerate() {
        let error = (found - wanted).abs();
        assert!(error <= tolerance * size, "{what}: order {order}: {found:e}, not {wanted:e}, of {size:e}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, ..ProptestConfig::default() })]

    #[test]
    fn ends_are_met(p in parameters()) {
        let (duration, from, to, v0, v1) = p.motion;
        for (i, (name, curve)) in curves(&p, p.motion).iter().enumerate() {
            let ends = (curve.at(0.0), curve.at(duration));
            prop_assert_eq!((ends.0.position, ends.1.position), (from, to), "{}", name);
            if i >= WITH_VELOCITIES {
                let size = sizes(curve.as_ref())[1];
                prop_assert!((ends.0.velocity - v0).abs() <= 1e-15 * size, "{name}: {ends:?}");
                prop_assert!((ends.1.velocity - v1).abs() <= 1e-15 * size, "{name}: {ends:?}");
            }
            // Outside, what holds at the nearer end.
            prop_assert_eq!(curve.at(-1.0), ends.0);
            prop_assert_eq!(curve.at(2.0 * duration), ends.1);
            prop_assert!(curve.at(f64::NAN).position.is_nan());
        }
    }

    #[test]
    fn each_derivative_is_that_of_the_one_before(p in parameters()) {
        let (duration, from, to, v0, v1) = p.motion;
        let constants = [duration, from, to, v0, v1].map(Dual::<1>::constant);
        let [d0, d1, d2, d3, d4] = constants;
        for (name, curve) in curves(&p, (d0, d1, d2, d3, d4)) {
            let sizes = sizes(curve.as_ref());
            for u in &FRACTIONS[1..8] {
                let sample = curve.at(Dual::variable(u * duration, 0)).to_array();
                for order in 0..3 {
                    let (found, wanted) = (sample[order + 1].value(), sample[order].partial(0));
                    let scale = sizes[order + 1] + 1e-3 * sizes[order] / duration;
                    prop_assert!((found - wanted).abs() <= 1e-11 * scale, "{name} {order}: {found:e}, not {wanted:e}");
                }
            }
        }
    }

    #[test]
    fn both_halves_are_one_curve(p in parameters()) {
        let duration = p.motion.0;
        for (name, curve) in curves(&p, p.motion) {
            let (left, right) = (curve.at(0.5 * duration), curve.at(0.5 * duration * (1.0 + 4.0 * f64::EPSILON)));
            assert_close(name, right, left, sizes(curve.as_ref()), 1e-12);
        }
    }

    #[test]
    fn a_mirror_image_is_exact(p in parameters()) {
        let (duration, from, to, v0, v1) = p.motion;
        let mirrored = curves(&p, (duration, -from, -to, -v0, -v1));
        for ((name, curve), (_, mirror)) in curves(&p, p.motion).iter().zip(&mirrored) {
            for u in FRACTIONS {
                let (sample, image) = (curve.at(u * duration).to_array(), mirror.at(u * duration).to_array());
                for (x, image) in sample.into_iter().zip(image) {
                    prop_assert!((x + image).abs() <= 0.0, "{name}: {x:e} and {image:e}");
                }
            }
        }
    }

    #[test]
    fn some_curves_are_the_same_backwards(p in parameters()) {
        let (duration, from, to, v0, v1) = p.motion;
        let back = curves(&p, (duration, to, from, -v1, -v0));
        for ((name, curve), (_, back)) in curves(&p, p.motion).iter().zip(&back) {
            if !["line", "trigonometric", "trigonometric velocities", "tension"].contains(name) {
                continue;
            }
            for u in FRACTIONS {
                let (sample, image) = (curve.at(u * duration), back.at((1.0 - u) * duration).reversed());
                // The image of a time is rounded to half an ε of the duration, in which a stiff curve's end turns by stiffness·ε/2.
                let turned = if *name == "tension" { p.stiffness * f64::EPSILON } else { 0.0 };
                assert_close(name, image, sample, sizes(curve.as_ref()), 1e-13 + turned);
            }
        }
        // Backwards, 1 − s becomes 1/(1 − s).
        let back_shape = -p.shape / (1.0 - p.shape);
        let curve = ExponentialVelocities::new(duration, (from, v0), (to, v1), p.exponent, p.shape)?;
        let back = ExponentialVelocities::new(duration, (to, -v1), (from, -v0), p.exponent, back_shape)?;
        for u in FRACTIONS {
            let (sample, image) = (curve.at(u * duration), back.at((1.0 - u) * duration).reversed());
            assert_close("exponential velocities", image, sample, sizes(&curve), 1e-11);
        }
    }

    #[test]
    fn the_cubic_is_the_family_without_stiffness(p in parameters(), stiffness in 1e-12..1e-4_f64) {
        let (duration, from, to, v0, v1) = p.motion;
        let (start, end) = ((from, v0), (to, v1));
        let cubic = CubicHermite::new(duration, start, end)?;
        let none = Tension::new(duration, start, end, 0.0)?;
        let little = Tension::new(duration, start, end, stiffness)?;
        let straight = ExponentialVelocities::new(duration, start, end, p.exponent, 0.0)?;
        let third = ExponentialVelocities::new(duration, start, end, 3, p.shape)?;
        // Higher derivatives may cancel down to nothing, and a stiffness adds k² of what the velocity makes of them.
        let sizes = sizes(&none);
        let sizes = [0, 1, 2, 3].map(|i| sizes[i].max(sizes[1] / duration.powi(i as i32 - 1)));
        for u in FRACTIONS {
            let t = u * duration;
            let wanted = none.at(t);
            assert_close("cubic", cubic.at(t), wanted, sizes, 1e-13);
            assert_close("n = 3", third.at(t), wanted, sizes, 1e-13);
            assert_close("s = 0", straight.at(t), wanted, sizes, 1e-12);
            assert_close("little stiffness", little.at(t), wanted, sizes, 1e-13 + 4.0 * stiffness * stiffness);
        }
    }

    #[test]
    fn nothing_is_missed_where_a_motion_stands_still(p in parameters()) {
        let (duration, from, to, v0, v1) = p.motion;
        let (start, end) = ((from, v0), (to, v1));
        check_still(&TrigonometricVelocities::new(duration, start, end)?)?;
        check_still(&ExponentialVelocities::new(duration, start, end, p.exponent, p.shape)?)?;
        check_still(&Tension::new(duration, start, end, p.stiffness)?)?;
        if let Ok(curve) = legacy::Hyperbolic::new(duration, start, end) {
            check_still(&curve)?;
        }
        for shape in [1.3, 2.2, 4.0] {
            let curve = Exponential::new(duration, from, to, f64::from(p.exponent), shape)?;
            check_still(&curve)?;
            let curve = ExponentialVelocities::new(duration, start, end, p.exponent, shape)?;
            check_still(&curve)?;
        }
    }

    #[test]
    fn peaks_and_ranges_hold_all_samples(p in parameters()) {
        let (duration, from, to, v0, v1) = p.motion;
        let (start, end) = ((from, v0), (to, v1));
        check_ranges(&Trigonometric::new(duration, from, to)?)?;
        check_ranges(&Power::new(duration, from, to, p.power)?)?;
        check_ranges(&Exponential::new(duration, from, to, p.power, p.shape)?)?;
        check_ranges(&Exponential::new(duration, from, to, f64::from(p.exponent), 2.5)?)?;
        check_ranges(&Hyperbolic::new(duration, from, to, p.stiffness)?)?;
        check_ranges(&TrigonometricVelocities::new(duration, start, end)?)?;
        check_ranges(&ExponentialVelocities::new(duration, start, end, p.exponent, p.shape)?)?;
        check_ranges(&ExponentialVelocities::new(duration, start, end, p.exponent, 2.7)?)?;
        check_ranges(&Tension::new(duration, start, end, p.stiffness)?)?;
        if let Ok(curve) = legacy::Hyperbolic::new(duration, start, end) {
            check_ranges(&curve)?;
        }
    }

    #[test]
    fn derivatives_by_parameters_are_those_of_differences(p in parameters()) {
        // Of a moderate pace, so that differences say something.
        let p = Parameters { stiffness: p.stiffness.min(10.0), power: p.power.min(6.0), ..p };
        let (t, x0, x1, v0, v1) = p.motion;
        let numbers = [t + 0.5, x0, x1, v0, v1];
        let dual: Vec<Dual<5>> = numbers.iter().enumerate().map(|(i, &x)| Dual::variable(x, i)).collect();
        let curves_of = |n: [f64; 5]| curves(&p, (n[0], n[1], n[2], n[3], n[4]));
        let exact = curves(&p, (dual[0], dual[1], dual[2], dual[3], dual[4]));
        let (time, h) = (0.37 * numbers[0], 1e-5);
        for i in 0..5 {
            let (mut less, mut more) = (numbers, numbers);
            less[i] -= h;
            more[i] += h;
            let (less, more) = (curves_of(less), curves_of(more));
            for (j, (name, curve)) in exact.iter().enumerate() {
                let found = curve.at(Dual::constant(time)).to_array();
                let (less, more) = (less[j].1.at(time).to_array(), more[j].1.at(time).to_array());
                let sizes = sizes(curve.as_ref());
                for order in 0..4 {
                    let wanted = (more[order] - less[order]) / (2.0 * h);
                    let size = found[order].partials().iter().fold(sizes[order], |m, x| m.max(x.abs()));
                    let error = (found[order].partial(i) - wanted).abs();
                    prop_assert!(error <= 1e-6 * size, "{name}, parameter {i}, order {order}: {error:e} of {size:e}");
                }
            }
        }
    }
}

/// Every change of sign of the velocity on a fine grid is found, and every point that is found is one.
fn check_still(curve: &impl Answers) -> Result<(), TestCaseError> {
    let duration = curve.duration();
    let found = curve.stationary();
    let velocity = |t: f64| curve.at(t).velocity;
    let largest = sizes(curve)[1];
    let steps = 2000;
    for i in 0..steps {
        let (a, b) =
            (f64::from(i) / f64::from(steps) * duration, f64::from(i + 1) / f64::from(steps) * duration);
        let (va, vb) = (velocity(a), velocity(b));
        if va.abs().min(vb.abs()) > 1e-11 * largest && va * vb < 0.0 {
            let here = found.points.iter().filter(|x| x.time >= a && x.time <= b && x.turn == Turn::Reversal);
            prop_assert_eq!(here.count() % 2, 1, "between {} and {}: {:?}", a, b, found);
        }
    }
    for point in &found.points {
        let tolerance = 1e-11 * largest + curve.at(point.time).acceleration.abs() * 2e-12 * duration;
        prop_assert!(velocity(point.time).abs() <= tolerance, "{point:?}: {:e}", velocity(point.time));
    }
    Ok(())
}

/// No sample is outside of the range, and the range is reached.
fn check_ranges(curve: &impl Answers) -> Result<(), TestCaseError> {
    let duration = curve.duration();
    let (from, to) = (0.12 * duration, 0.93 * duration);
    let peaks = curve.peaks();
    let kinds = [
        (Quantity::Position, None),
        (Quantity::Velocity, Some(peaks.velocity)),
        (Quantity::Acceleration, Some(peaks.acceleration)),
        (Quantity::Jerk, Some(peaks.jerk)),
    ];
    for (quantity, peak) in kinds {
        let (low, high) = curve.range(quantity, from, to);
        let (mut least, mut most, mut size) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
        for i in 0..=1000 {
            let u = f64::from(i) / 1000.0;
            let x = quantity.of(&curve.at(from + u * (to - from)));
            (least, most) = (least.min(x), most.max(x));
            size = size.max(quantity.of(&curve.at(u * duration)).abs());
        }
        let slack = 1e-12 * size;
        prop_assert!(
            low <= least + slack && most <= high + slack,
            "{quantity:?}: {least}..{most} in {low}..{high}"
        );
        // A thousandth of the span apart, samples are close to every extreme.
        prop_assert!(least - low <= 1e-3 * size && high - most <= 1e-3 * size, "{quantity:?}: {low}..{high}");
        if let Some(peak) = peak {
            prop_assert!(
                (size - peak.value) <= slack && peak.value - size <= 1e-3 * size,
                "{quantity:?}: {peak:?}"
            );
        }
    }
    Ok(())
}
