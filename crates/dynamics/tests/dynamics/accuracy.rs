//! How many digits of forces and accelerations are right, beside what other programs lose.
//!
//! The figures, states and errors are those of docs/accuracy.md: `cargo lab report` tables what is measured here.

#[expect(dead_code, reason = "what other formulations of others lose stands on the page alone")]
mod cases;
mod measured;
mod samples;

use cases::{Case, HARD, ORDINARY};
use measured::{Accuracy, forward, inverse, inverse_of, measure};
use samples::{
    Random, Sample, chain, distant_chain, fast_chain, near_lock, person, person_near_lock, single,
    tipped_chain, uneven_chain,
};
use solaris_dynamics::scalar::DoubleDouble;
use solaris_dynamics::{Formulation, Scalar};
use std::sync::LazyLock;

/// How much more than other programs with the same formulation may be lost.
const FACTOR: f64 = 10.0;

static ORDINARILY: LazyLock<Vec<Accuracy>> = LazyLock::new(|| all(&ORDINARY));
static HARDLY: LazyLock<Vec<Accuracy>> = LazyLock::new(|| all(&HARD));

fn all(cases: &[Case]) -> Vec<Accuracy> {
    cases.iter().map(|case| measure(case).expect("every case has an answer")).collect()
}

fn measured() -> impl Iterator<Item = (&'static Case, &'static Accuracy)> {
    ORDINARY.iter().zip(&*ORDINARILY).chain(HARD.iter().zip(&*HARDLY))
}

#[test]
fn inverse_dynamics_loses_no_more_digits_than_others() {
    for (case, accuracy) in measured() {
        let Some(other) = case.inverse else { continue };
        for (formulation, errors) in Formulation::ALL.into_iter().zip(accuracy.inverse) {
            let others = if formulation == Formulation::NewtonEuler { other.local } else { other.lagrangian };
            for (error, other) in errors.into_iter().zip(others) {
                assert!(
                    error <= FACTOR * other,
                    "{}, {formulation:?}: {error:e}, others {other:e}",
                    case.name
                );
            }
        }
    }
}

#[test]
fn forward_dynamics_loses_no_more_digits_than_others() {
    for (case, accuracy) in measured() {
        let Some(other) = case.forward else { continue };
        for (error, other) in accuracy.forward.into_iter().zip(other.articulated) {
            assert!(error <= FACTOR * other, "{}: {error:e}, others {other:e}", case.name);
        }
    }
}

/// What nobody has published: inverse dynamics knows no gimbal lock, forward dynamics no speed and no distance.
#[test]
fn what_is_hard_for_others_is_not_hard() {
    let [double, single] = [f64::EPSILON, f64::from(f32::EPSILON)];
    for (case, accuracy) in measured().filter(|(case, _)| case.name.contains("lock")) {
        for [f64_error, f32_error] in accuracy.inverse {
            assert!(f64_error < 4.0 * double && f32_error < 4.0 * single, "{}: {accuracy:?}", case.name);
        }
    }
    for (case, accuracy) in measured()
        .filter(|(case, _)| case.name.starts_with("20, root") || case.name.starts_with("20, speeds"))
    {
        assert!(
            accuracy.forward[0] < 10.0 * double && accuracy.forward[1] < 10.0 * single,
            "{}: {accuracy:?}",
            case.name
        );
    }
}

/// A factor of the mass matrix loses digits with its condition; the recursion does not.
#[test]
fn forward_dynamics_keeps_digits_that_the_mass_matrix_loses() {
    for (case, accuracy) in
        measured().filter(|(_, accuracy)| accuracy.condition.is_some_and(|condition| condition > 1e6))
    {
        let [by_matrix, _] = accuracy.matrix.expect("as large as its condition");
        assert!(by_matrix > 5.0 * accuracy.forward[0], "{}: {accuracy:?}", case.name);
    }
}

/// The reference: other recursions give the same digits, and inverse dynamics takes forward dynamics back.
#[test]
fn the_reference_has_digits_to_spare() {
    let difference = |found: &[DoubleDouble], right: &[DoubleDouble]| {
        let largest = right.iter().map(|x| x.abs().to_f64()).fold(0.0, f64::max);
        found.iter().zip(right).map(|(a, b)| (*a - *b).abs().to_f64() / largest).fold(0.0, f64::max)
    };
    for case in ORDINARY.iter().chain(&HARD).filter(|case| !case.name.ends_with("1000")) {
        let sample = (case.sample)(&mut Random::new(7)).expect("a valid figure");
        let [chain_wise, tree_wise, newton_euler] = Formulation::ALL
            .map(|formulation| inverse::<DoubleDouble>(&sample, formulation).expect("a valid state"));
        // In chains some axes are parallel: the D-H angle between them is no multiple of 90°, and rounded to f64 when
        // the figure is compiled.
        let has_parallels = !case.name.contains("human") && !case.name.contains("lock");
        let tolerance = if has_parallels { 1e-14 } else { 1e-28 };
        assert!(difference(&chain_wise, &tree_wise) < 1e-25, "{}", case.name);
        assert!(difference(&tree_wise, &newton_euler) < tolerance, "{}", case.name);
        let a: Vec<DoubleDouble> = forward(&sample).expect("a valid state");
        let tau = inverse_of(&sample, Formulation::NewtonEuler, &a).expect("a valid state");
        let given: Vec<DoubleDouble> = sample.tau.iter().map(|x| Scalar::from_f64(*x)).collect();
        assert!(difference(&tau, &given) < 1e-19, "{}", case.name);
    }
}

/// Every number that a figure and a state are given by.
fn numbers(sample: &Sample) -> impl Iterator<Item = f64> {
    let links = sample.figure.links().iter().flat_map(|link| {
        let place = link.joint().placement();
        assert_eq!(place.rotation.angle().to_bits(), 0, "{}", link.name());
        let vectors = [place.translation.vector, *link.com()];
        vectors
            .into_iter()
            .flat_map(<[f64; 3]>::from)
            .chain([link.mass()])
            .chain(link.inertia().iter().copied().collect::<Vec<_>>())
    });
    let state = [&sample.q, &sample.v, &sample.a, &sample.tau].into_iter().flatten().copied();
    links.chain(state)
}

#[test]
fn every_number_is_exact_in_single_precision() {
    let mut random = Random::new(1);
    let samples = [
        chain(&mut random, 30),
        tipped_chain(&mut random, 10, 2.0_f64.powi(-20)),
        uneven_chain(&mut random, 20),
        fast_chain(&mut random, 20),
        distant_chain(&mut random, 20, 1e5),
        near_lock(&mut random, 1e-4),
        person(&mut random),
        person_near_lock(&mut random, 1e-4),
    ];
    for sample in samples {
        let sample = sample.expect("a valid figure");
        for x in numbers(&sample) {
            assert_eq!(x.to_bits(), single(x).to_bits(), "{x} in {}", sample.figure.name());
        }
    }
}

#[test]
fn the_rounded_human_is_a_human() {
    let sample = person(&mut Random::new(2)).expect("a valid figure");
    assert_eq!(sample.figure.layout().nv(), 66);
    assert!((sample.figure.mass() - 73.0).abs() < 0.5, "{} kg", sample.figure.mass());
}
