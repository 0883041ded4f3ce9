//! Exact derivatives, against differences and against each other.

use crate::questions::case::{Case, derivative, difference, unit};
use crate::support::random::{Joints, Random};
use nalgebra::{DMatrix, DVector, Vector3};
use proptest::prelude::*;
use solaris_dynamics::{Along, Derivatives, Partials, forward_dynamics, inverse_dynamics};
use solaris_model::{Axis, FigureBuilder, Inertia, Joint, LinkSpec};

/// Column by column, the slope of `f(q, v, x)` by its arguments.
fn slopes(
    case: &mut Case,
    x: &[f64],
    f: impl Fn(&mut Case, &[f64], &[f64], &[f64]) -> DVector<f64>,
) -> [DMatrix<f64>; 3] {
    let n = case.nv();
    let (q, v) = (case.q.clone(), case.v.clone());
    let along = |values: &[f64], k: usize, t: f64| -> Vec<f64> {
        values.iter().zip(unit(n, k)).map(|(value, e)| value + e * t).collect()
    };
    let mut columns = |argument: usize| {
        let columns: Vec<DVector<f64>> = (0..n)
            .map(|k| {
                derivative(|t| match argument {
                    0 => {
                        let q = case.moved(&unit(n, k), t);
                        f(case, &q, &v, x)
                    }
                    1 => f(case, &q, &along(&v, k, t), x),
                    _ => f(case, &q, &v, &along(x, k, t)),
                })
            })
            .collect();
        DMatrix::from_fn(n, n, |i, k| columns[k][i])
    };
    [columns(0), columns(1), columns(2)]
}

fn inverse(case: &mut Case, q: &[f64], v: &[f64], a: &[f64]) -> DVector<f64> {
    let external = case.external.clone();
    DVector::from_vec(case.kernel.inverse(q, v, a, &external).expect("valid"))
}

fn forward(case: &mut Case, q: &[f64], v: &[f64], tau: &[f64]) -> DVector<f64> {
    let external = case.external.clone();
    DVector::from_vec(case.kernel.forward(q, v, tau, &external).expect("valid"))
}

/// The greatest errors of the three matrices.
fn errors(partials: &Partials, slopes: &[DMatrix<f64>; 3]) -> [f64; 3] {
    [
        difference(&partials.by_q, &slopes[0], 1.0),
        difference(&partials.by_v, &slopes[1], 1.0),
        difference(&partials.by_input, &slopes[2], 1.0),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn derivatives_of_inverse_dynamics_are_slopes(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let a = case.a.clone();
        let mut derivatives = Derivatives::new(&case.figure, case.gravity).expect("finite constants");
        let partials = derivatives.inverse_dynamics(&case.q, &case.v, &a, &case.external).expect("valid");
        let slopes = slopes(&mut case, &a, inverse);
        let worst = errors(partials, &slopes);
        prop_assert!(worst.iter().all(|error| *error < 1e-8), "{worst:?}");
        // The values are those of the plain numbers, bit for bit.
        let tau = case.kernel.inverse(&case.q, &case.v, &a, &case.external).expect("valid");
        prop_assert!(tau.iter().zip(&partials.value).all(|(a, b)| a.to_bits() == b.to_bits()));
        // The closed form is what dual numbers find.
        let closed = partials.clone();
        let partials = derivatives.of(inverse_dynamics, &case.q, &case.v, &a, &case.external).expect("valid");
        let worst = errors(&closed, &[partials.by_q.clone(), partials.by_v.clone(), partials.by_input.clone()]);
        prop_assert!(worst.iter().all(|error| *error < 1e-12), "{worst:?}");
    }

    #[test]
    fn derivatives_of_forward_dynamics_are_slopes(seed in any::<u64>()) {
        let mut case = Case::with(Joints::EveryArmed, seed);
        let tau = case.random.slice(case.nv(), 20.0);
        let mut derivatives = Derivatives::new(&case.figure, case.gravity).expect("finite constants");
        let partials = derivatives.forward_dynamics(&case.q, &case.v, &tau, &case.external).expect("valid");
        let slopes = slopes(&mut case, &tau, forward);
        let worst = errors(partials, &slopes);
        let inverse = partials.by_input.clone();
        let again = derivatives.of(forward_dynamics, &case.q, &case.v, &tau, &case.external).expect("valid");
        prop_assert!(difference(&again.by_input, &inverse, 1e-3) < 1e-10);
        prop_assert!(worst.iter().all(|error| *error < 1e-7), "{worst:?}");
    }

    /// Inverse and forward dynamics undo each other: `M·∂a/∂x = −∂tau/∂x`, and `M·∂a/∂tau = 1`.
    #[test]
    fn forward_derivatives_undo_inverse_derivatives(seed in any::<u64>()) {
        let mut case = Case::with(Joints::EveryArmed, seed);
        let tau = case.random.slice(case.nv(), 20.0);
        let mut derivatives = Derivatives::new(&case.figure, case.gravity).expect("finite constants");
        let ahead = derivatives.forward_dynamics(&case.q, &case.v, &tau, &case.external).expect("valid").clone();
        let back = derivatives.inverse_dynamics(&case.q, &case.v, &ahead.value, &case.external).expect("valid");
        let mass = &back.by_input;
        let n = case.nv();
        prop_assert!(difference(&(mass * &ahead.by_q), &-&back.by_q, 1.0) < 1e-10);
        prop_assert!(difference(&(mass * &ahead.by_v), &-&back.by_v, 1.0) < 1e-10);
        prop_assert!(difference(&(mass * &ahead.by_input), &DMatrix::identity(n, n), 1.0) < 1e-10);
        prop_assert!(difference(&DVector::from_row_slice(&back.value), &DVector::from_row_slice(&tau), 1.0) < 1e-10);
    }

    /// One direction is the product of the matrices with it.
    #[test]
    fn one_direction_is_a_product(seed in any::<u64>()) {
        let mut case = Case::with(Joints::EveryArmed, seed);
        let n = case.nv();
        let [by_q, by_v, by_input] = [0, 1, 2].map(|_| case.random.slice(n, 1.0));
        let direction = Along { q: &by_q, v: &by_v, input: &by_input };
        let mut whole = Derivatives::new(&case.figure, case.gravity).expect("finite constants");
        let mut single = Derivatives::<1>::of_width(&case.figure, case.gravity).expect("finite constants");
        for (operation, wide) in [
            (inverse_dynamics as solaris_dynamics::Operation<_>, inverse_dynamics as solaris_dynamics::Operation<_>),
            (forward_dynamics, forward_dynamics),
        ] {
            let (mut value, mut slope) = (vec![f64::NAN; n], vec![f64::NAN; n]);
            let (q, v, a, external) = (&case.q, &case.v, &case.a, &case.external);
            single.along(operation, q, v, a, external, &direction, &mut value, &mut slope).expect("valid");
            let partials = whole.of(wide, q, v, a, external).expect("valid");
            let product = &partials.by_q * DVector::from_row_slice(&by_q)
                + &partials.by_v * DVector::from_row_slice(&by_v)
                + &partials.by_input * DVector::from_row_slice(&by_input);
            let error = difference(&DVector::from_row_slice(&slope), &product, 1.0);
            prop_assert!(error < 1e-11, "{error:e}");
            prop_assert_eq!(&value, &partials.value);
        }
    }
}

/// A quaternion that is a little off unit length has the same derivatives: the kernel takes its direction.
/// Where columns are full and long, another way is taken.
#[test]
fn derivatives_of_a_long_chain_are_those_of_dual_numbers() {
    let mut random = Random::new(41);
    for links in [70, 71, 85, 120] {
        let mut builder = FigureBuilder::new("chain");
        for i in 0..links {
            let joint = Joint::new(format!("j{i}")).axis(Axis::rotation(random.vector(1.0).normalize()));
            let joint = joint.at(Vector3::new(0.2, 0.0, 0.0));
            let link = match i {
                0 => LinkSpec::root("l0", joint),
                _ => LinkSpec::child(format!("l{i}"), format!("l{}", i - 1), joint),
            };
            let link = link.mass(1.0 + 0.5 * (i as f64).sin()).com(random.vector(0.2));
            builder = builder.link(link.inertia(Inertia::diagonal(0.02, 0.03, 0.025)));
        }
        let figure = builder.build().expect("valid");
        let (q, v, tau) = (random.slice(links, 1.0), random.slice(links, 1.0), random.slice(links, 5.0));
        let mut derivatives =
            Derivatives::new(&figure, Vector3::new(0.0, -9.81, 0.0)).expect("finite constants");
        let closed = derivatives.forward_dynamics(&q, &v, &tau, &[]).expect("valid").clone();
        let partials = derivatives.of(forward_dynamics, &q, &v, &tau, &[]).expect("valid");
        let worst =
            errors(&closed, &[partials.by_q.clone(), partials.by_v.clone(), partials.by_input.clone()]);
        assert!(worst.iter().all(|error| *error < 1e-10), "{links} links: {worst:?}");
    }
}

#[test]
fn the_length_of_a_quaternion_does_not_matter() {
    let mut case = Case::of(
        solaris_model::FigureBuilder::new("top")
            .link(
                solaris_model::LinkSpec::root("top", solaris_model::Joint::free("air"))
                    .mass(2.0)
                    .com(Vector3::new(0.1, 0.2, 0.3)),
            )
            .build()
            .expect("a valid figure"),
        Vector3::new(1.0, 2.0, 3.0),
        Random::new(9),
    );
    let mut derivatives = Derivatives::new(&case.figure, case.gravity).expect("finite constants");
    let of = |derivatives: &mut Derivatives, case: &Case| {
        derivatives.inverse_dynamics(&case.q, &case.v, &case.a, &case.external).expect("valid").clone()
    };
    let unit = of(&mut derivatives, &case);
    case.q[3..].iter_mut().for_each(|x| *x *= 1.0003);
    let long = of(&mut derivatives, &case);
    assert!(difference(&long.by_q, &unit.by_q, 1.0) < 1e-14);
}
