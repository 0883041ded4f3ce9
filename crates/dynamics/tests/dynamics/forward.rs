//! Forward and hybrid dynamics against the numbers of another engine and against inverse dynamics.

use crate::support::random::{Joints, Random, random_configuration, tree_of};
use crate::support::reference::{external, figure, models};
use crate::support::{Kernel, largest, relative_error};
use nalgebra::{DMatrix, DVector, Vector3};
use proptest::prelude::*;
use solaris_dynamics::scalar::{Counted, DoubleDouble, Dual, Lanes};
use solaris_dynamics::{DynamicsError, Scalar, Wrench};
use solaris_model::{Axis, Figure, FigureBuilder, Inertia, Joint, LinkSpec};

/// Every quantity within `10·κ(M)·ε` of its largest entry; of what is left of it where `τ` and the bias cancel (in one of
/// the states of one degree of freedom, by a factor of 4).
#[test]
fn forward_and_hybrid_dynamics_agree_with_the_reference() {
    let mut compared = 0;
    for model in models() {
        let mut kernel = Kernel::<f64>::new(&figure(&model), Vector3::from(model.gravity));
        for (number, state) in model.states.iter().enumerate() {
            let left: Vec<f64> = state.tau_in.iter().zip(&state.bias).map(|(tau, bias)| tau - bias).collect();
            let cancelled = (largest(&state.bias) / largest(&left)).max(1.0);
            let tolerance = 10.0 * state.condition * f64::EPSILON * cancelled;
            let mut check = |what: &str, found: &[f64], expected: &[f64]| {
                let error = relative_error(found, expected);
                assert!(
                    error <= tolerance,
                    "{} state {number}: {what} {error:e} > {tolerance:e}",
                    model.name
                );
                compared += 1;
            };
            let (q, v) = (&state.q, &state.qd);
            check("a", &kernel.forward(q, v, &state.tau_in, &[]).expect("valid"), &state.qdd_fd);
            let hybrid = &state.hybrid;
            let given = [hybrid.qdd_p.as_slice(), &hybrid.tau_d];
            let [a, tau] = kernel.hybrid([q, v], &hybrid.prescribed, given, &[]).expect("valid");
            check("a of hybrid dynamics", &a, &hybrid.qdd);
            check("tau of hybrid dynamics", &tau, &hybrid.tau);
            if let (Some(fext), Some(expected)) = (&state.fext, &state.qdd_fd_ext) {
                let wrenches = external(&mut kernel, q, fext);
                let a = kernel.forward(q, v, &state.tau_in, &wrenches).expect("valid");
                check("a with wrenches", &a, expected);
            }
        }
    }
    assert_eq!(compared, 48 * (3 * 3 + 1), "every quantity is compared");
}

/// The least eigenvalue and the condition of a mass matrix, infinite where it is singular: random joints repeat axes.
fn spectrum(matrix: &DMatrix<f64>) -> (f64, f64) {
    if matrix.is_empty() {
        return (1.0, 1.0);
    }
    let eigenvalues = matrix.clone().symmetric_eigenvalues();
    let (least, most) = (eigenvalues.min(), eigenvalues.max());
    (least, if least > 0.0 { most / least } else { f64::INFINITY })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, max_global_rejects: 10_000, failure_persistence: None, ..ProptestConfig::default() })]

    /// Accelerations come back from the forces that inverse dynamics finds for them, whichever are prescribed.
    #[test]
    fn hybrid_dynamics_is_inverse_dynamics_turned_around(seed in any::<u64>(), links in 1_usize..16) {
        let mut random = Random::new(seed);
        let figure = tree_of(Joints::Every, &mut random, links, 1.0);
        let mut kernel = Kernel::<f64>::new(&figure, random.vector(9.81));
        let n = kernel.tree.nv();
        let q = random_configuration(&mut random, &figure);
        let (v, a) = (random.slice(n, 3.0), random.slice(n, 5.0));
        let wrenches = [random.wrench(links), random.wrench(links)];
        let tau = kernel.inverse(&q, &v, &a, &wrenches).expect("valid");
        let matrix = kernel.mass_matrix(&q).expect("valid");
        let (least, condition) = spectrum(&matrix);
        prop_assume!(condition < 1e10);
        // An error of ε in the forces is one of ε/λ in the accelerations.
        let scale = largest(&tau) / least;
        for mode in 0..4 {
            let prescribed: Vec<bool> = (0..n).map(|_| match mode {
                0 => false,
                1 => true,
                _ => random.below(2) == 0,
            }).collect();
            let found = kernel.hybrid([&q, &v], &prescribed, [&a, &tau], &wrenches).expect("valid");
            let error = largest(&found[0].iter().zip(&a).map(|(x, y)| x - y).collect::<Vec<_>>());
            prop_assert!(error <= 20.0 * f64::EPSILON * scale.max(largest(&a)), "a: {error:e} of {scale:e}, mode {mode}");
            let error = largest(&found[1].iter().zip(&tau).map(|(x, y)| x - y).collect::<Vec<_>>());
            let allowed = 1e-14 * largest(&tau) * condition.max(100.0);
            prop_assert!(error <= allowed, "tau: {error:e}, mode {mode}");
        }
        let forward = kernel.forward(&q, &v, &tau, &wrenches).expect("valid");
        let none = kernel.hybrid([&q, &v], &vec![false; n], [&a, &tau], &wrenches).expect("valid");
        prop_assert_eq!(forward, none[0].clone());
    }

    /// `M_DD·q̈_D = τ_D − C_D` and `τ_P = C_P + M_PD·q̈_D`, with `C` the forces of the prescribed accelerations alone.
    #[test]
    fn hybrid_dynamics_is_the_dense_partition(seed in any::<u64>(), links in 2_usize..10) {
        let mut random = Random::new(seed);
        let figure = tree_of(Joints::Every, &mut random, links, 0.5);
        let mut kernel = Kernel::<f64>::new(&figure, random.vector(9.81));
        let n = kernel.tree.nv();
        let q = random_configuration(&mut random, &figure);
        let (v, a, tau) = (random.slice(n, 3.0), random.slice(n, 5.0), random.slice(n, 20.0));
        let prescribed: Vec<bool> = (0..n).map(|_| random.below(2) == 0).collect();
        let free: Vec<usize> = (0..n).filter(|k| !prescribed[*k]).collect();
        let held: Vec<f64> = (0..n).map(|k| if prescribed[k] { a[k] } else { 0.0 }).collect();
        let bias = kernel.inverse(&q, &v, &held, &[]).expect("valid");
        let matrix = kernel.mass_matrix(&q).expect("valid");
        let inner = matrix.select_rows(&free).select_columns(&free);
        let (_, condition) = spectrum(&inner);
        prop_assume!(condition < 1e7);
        let right = DVector::from_iterator(free.len(), free.iter().map(|&k| tau[k] - bias[k]));
        let solved = inner.cholesky().map_or_else(|| right.clone(), |factor| factor.solve(&right));
        let mut expected = held.clone();
        free.iter().zip(solved.iter()).for_each(|(&k, x)| expected[k] = *x);
        let forces = kernel.inverse(&q, &v, &expected, &[]).expect("valid");
        let [found_a, found_tau] = kernel.hybrid([&q, &v], &prescribed, [&a, &tau], &[]).expect("valid");
        let tolerance = 10.0 * f64::EPSILON * condition.max(100.0);
        prop_assert!(relative_error(&found_a, &expected) <= tolerance);
        prop_assert!(relative_error(&found_tau, &forces) <= tolerance);
    }

    #[test]
    fn the_inverse_mass_matrix_is_one(seed in any::<u64>(), links in 1_usize..12) {
        let mut random = Random::new(seed);
        let figure = tree_of(Joints::Every, &mut random, links, 0.5);
        let mut kernel = Kernel::<f64>::new(&figure, random.vector(9.81));
        let n = kernel.tree.nv();
        let q = random_configuration(&mut random, &figure);
        let matrix = kernel.mass_matrix(&q).expect("valid");
        let (_, condition) = spectrum(&matrix);
        prop_assume!(condition < 1e9);
        let inverse = kernel.inverse_mass_matrix(&q).expect("valid");
        let error = (&matrix * &inverse - DMatrix::identity(n, n)).norm();
        prop_assert!(error <= 1e-14 * condition.max(100.0), "{error:e} at condition {condition:e}");
        prop_assert!((&inverse - inverse.transpose()).norm() <= 1e-14 * condition.max(100.0) * inverse.norm());
    }
}

/// With masses between 1e-6 and 1e6, lost pivots and all, no column of the inverse is much worse than forward dynamics finds it by itself.
#[test]
fn masses_far_apart_do_not_spoil_the_inverse() {
    let mut random = Random::new(23);
    let (mut columns, mut worst) = (0, 0.0_f64);
    for links in (1..13).cycle().take(48) {
        let figure = tree_of(Joints::EveryArmed, &mut random, links, 6.0);
        let q = random_configuration(&mut random, &figure);
        let mut kernel = Kernel::<f64>::new(&figure, Vector3::zeros());
        let mut exact_kernel = Kernel::<DoubleDouble>::new(&figure, Vector3::zeros());
        let n = kernel.tree.nv();
        let wide =
            |values: &[f64]| values.iter().map(|x| Scalar::from_f64(*x)).collect::<Vec<DoubleDouble>>();
        let inverse = kernel.inverse_mass_matrix(&q).expect("valid");
        for j in 0..n {
            let (mut force, rest) = (vec![0.0; n], vec![0.0; n]);
            force[j] = 1.0;
            let exact = exact_kernel.forward(&wide(&q), &wide(&rest), &wide(&force), &[]).expect("valid");
            let exact: Vec<f64> = exact.iter().map(|x| x.to_f64()).collect();
            let alone = relative_error(&kernel.forward(&q, &rest, &force, &[]).expect("valid"), &exact);
            let found = relative_error(inverse.column(j).as_slice(), &exact);
            worst = worst.max(found / (100.0 * alone + 1e-13));
            columns += 1;
        }
    }
    assert!(columns > 500 && worst < 1.0, "{worst} in {columns} columns");
}

/// `q̈ = τ/(m·l² + J)`: the armature takes its part of the force.
#[test]
fn armature_takes_its_part_of_the_force() {
    let bob = LinkSpec::root("bob", Joint::new("pivot").rz().armature(0.3))
        .mass(2.0)
        .com(Vector3::new(0.5, 0.0, 0.0));
    let figure = FigureBuilder::new("pendulum").link(bob).build().expect("valid");
    let mut kernel = Kernel::<f64>::new(&figure, Vector3::zeros());
    let a = kernel.forward(&[0.4], &[3.0], &[1.6], &[]).expect("valid");
    assert!((a[0] - 1.6 / (2.0 * 0.25 + 0.3)).abs() < 1e-15, "{a:?}");
    assert!((kernel.inverse(&[0.4], &[3.0], &a, &[]).expect("valid")[0] - 1.6).abs() < 1e-15);
    assert!((kernel.kinetic(&[0.4], &[3.0]) - 0.5 * 0.8 * 9.0).abs() < 1e-14);
    let [a, tau] = kernel.hybrid([&[0.4], &[3.0]], &[true], [&[2.0], &[0.0]], &[]).expect("valid");
    assert!((tau[0] - a[0] * 0.8).abs() < 1e-15);
}

#[test]
fn a_degree_of_freedom_without_inertia_is_named() {
    // A point mass on the axis that it turns about.
    let bob = LinkSpec::root("bob", Joint::new("pivot").rz()).mass(2.0).com(Vector3::new(0.0, 0.0, 0.5));
    let figure = FigureBuilder::new("needle").link(bob).build().expect("valid");
    let mut kernel = Kernel::<f64>::new(&figure, Vector3::zeros());
    let error = kernel.forward(&[0.0], &[0.0], &[1.0], &[]).expect_err("no inertia");
    assert_eq!(error, DynamicsError::NoInertia { dof: "pivot.rz".into(), inertia: 0.0 });
    // Prescribed, it needs no force.
    let [_, tau] = kernel.hybrid([&[0.0], &[0.0]], &[true], [&[5.0], &[0.0]], &[]).expect("prescribed");
    assert_eq!(tau[0].to_bits(), 0.0_f64.to_bits());
}

/// Accelerations, and what hybrid dynamics finds where every third acceleration is prescribed, over the scalar `T`.
fn both<T: Scalar>(figure: &Figure, [q, v, a, tau]: [&[f64]; 4]) -> Vec<T> {
    let cast = |values: &[f64]| values.iter().map(|x| T::from_f64(*x)).collect::<Vec<T>>();
    let mut kernel = Kernel::<T>::new(figure, Vector3::new(0.0, -9.81, 0.0));
    let (q, v, a, tau) = (cast(q), cast(v), cast(a), cast(tau));
    let wrench = Wrench { force: Vector3::new(3.0, 4.0, 5.0), moment: Vector3::x() };
    let wrench = Wrench { force: wrench.force.map(T::from_f64), moment: wrench.moment.map(T::from_f64) };
    let external = [(figure.links().len() - 1, wrench)];
    let prescribed: Vec<bool> = (0..v.len()).map(|k| k % 3 == 0).collect();
    let mut all = kernel.forward(&q, &v, &tau, &external).expect("valid");
    let found = kernel.hybrid([&q, &v], &prescribed, [&a, &tau], &external).expect("valid");
    all.extend(found.into_iter().flatten());
    all.extend(kernel.inverse_mass_matrix(&q).expect("valid").iter());
    all
}

#[test]
fn every_scalar_gives_the_same_answers() {
    let mut random = Random::new(5);
    let figure = tree_of(Joints::EveryArmed, &mut random, 9, 0.5);
    let (q, n) = (random_configuration(&mut random, &figure), figure.layout().nv());
    let (v, a, tau) = (random.slice(n, 2.0), random.slice(n, 5.0), random.slice(n, 20.0));
    let state: [&[f64]; 4] = [&q, &v, &a, &tau];
    let bits = |values: &mut dyn Iterator<Item = f64>| values.map(f64::to_bits).collect::<Vec<_>>();
    let plain = both::<f64>(&figure, state);
    let expected = bits(&mut plain.iter().copied());
    assert_eq!(bits(&mut both::<Dual<2>>(&figure, state).iter().map(|x| x.value())), expected);
    assert_eq!(bits(&mut both::<Counted>(&figure, state).iter().map(|x| x.value())), expected);
    assert_eq!(bits(&mut both::<Lanes<4>>(&figure, state).iter().map(|x| x.lane(3))), expected);
    let exact: Vec<f64> = both::<DoubleDouble>(&figure, state).iter().map(|x| x.to_f64()).collect();
    assert!(relative_error(&plain, &exact) < 1e-12);
    let single: Vec<f64> = both::<f32>(&figure, state).into_iter().map(f64::from).collect();
    assert!(relative_error(&single, &exact) < 1e-4);
}

#[test]
fn what_is_read_must_be_finite_and_of_the_right_length() {
    let bob = LinkSpec::root("bob", Joint::new("pivot").rx().ry()).mass(2.0).com(Vector3::new(0.5, 0.1, 0.2));
    let bob = bob.inertia(Inertia::diagonal(0.1, 0.1, 0.1));
    let figure = FigureBuilder::new("pendulum").link(bob).build().expect("valid");
    let mut kernel = Kernel::<f64>::new(&figure, Vector3::zeros());
    let (state, nan) = ([0.1, 0.2], f64::NAN);
    let not_finite = |error: DynamicsError, wanted: &str| {
        assert!(
            matches!(&error, DynamicsError::NotFinite { what, dof, .. } if *what == wanted && dof == "pivot.ry")
        );
    };
    not_finite(kernel.forward(&state, &state, &[0.0, nan], &[]).expect_err("NaN"), "tau");
    not_finite(kernel.forward(&state, &[0.0, nan], &state, &[]).expect_err("NaN"), "v");
    not_finite(kernel.forward(&[0.0, f64::INFINITY], &state, &state, &[]).expect_err("infinite"), "q");
    let held =
        kernel.hybrid([&state; 2], &[true, true], [&[0.0, nan], &state], &[]).expect_err("NaN is read");
    not_finite(held, "a");
    // What is not read may be anything.
    assert!(kernel.hybrid([&state; 2], &[true, false], [&[0.0, nan], &[nan, 0.0]], &[]).is_ok());
    let error = kernel.forward(&state, &state, &[0.0], &[]).expect_err("one force is missing");
    assert_eq!(error, DynamicsError::Length { what: "tau", expected: 2, found: 1 });
}

/// Nothing but rounding is left of the inertia of a point mass about a line through it, whatever the joint's axes.
#[test]
fn a_point_mass_on_a_skew_axis_has_no_inertia_about_it() {
    let place = Vector3::new(0.1, 0.2, -0.5);
    let joints = [
        Joint::new("hinge").axis(Axis::rotation(place)),
        Joint::new("turns").rz().ry().rx(),
        Joint::ball("ball"),
        Joint::free("free"),
    ];
    for joint in joints {
        let name = joint.name().to_owned();
        let bob = LinkSpec::root("bob", joint).mass(1.0).com(place);
        let figure = FigureBuilder::new("needle").link(bob).build().expect("valid");
        let mut kernel = Kernel::<f64>::new(&figure, Vector3::zeros());
        let (mut q, n) = (vec![0.0; figure.layout().nq()], figure.layout().nv());
        figure.neutral(&mut q).expect("the right length");
        let state = vec![0.0; n];
        let error = kernel.forward(&q, &state, &vec![1.0; n], &[]).expect_err("no inertia");
        assert!(matches!(error, DynamicsError::NoInertia { .. }), "{name}: {error}");
        let error = kernel.inverse_mass_matrix(&q).expect_err("singular");
        assert!(matches!(error, DynamicsError::NoInertia { .. }), "{name}: {error}");
    }
}

/// What is left where all that hangs from a degree of freedom has given way.
fn left_of(error: DynamicsError) -> (String, f64) {
    match error {
        DynamicsError::NoInertia { dof, inertia } => (dof, inertia),
        other => panic!("{other}"),
    }
}

/// An inertia that no matter has is taken as it is where only forces are asked for, and refused where the mass matrix is
/// not positive, by the degree of freedom and what is left of its inertia; every way to solve refuses.
#[test]
fn a_mass_matrix_that_is_not_positive_is_refused_by_name() {
    let turns = |name: &str| match name {
        "hinge" => Joint::new("j").rz(),
        "skew" => Joint::new("j").axis(Axis::rotation(Vector3::new(0.0, 1e-9, 1.0))),
        "turns" => Joint::new("j").rx().ry().rz(),
        "ball" => Joint::ball("j"),
        _ => Joint::free("j"),
    };
    for (name, dof) in
        [("hinge", "j.rz"), ("skew", "j.ru"), ("turns", "j.rz"), ("ball", "j.wz"), ("free", "j.wz")]
    {
        let link = LinkSpec::root("link", turns(name)).mass(1.0).inertia(Inertia::diagonal(2.0, 2.0, -0.25));
        let figure = FigureBuilder::new("impossible").link(link).build().expect("a figure");
        let mut kernel = Kernel::<f64>::new(&figure, Vector3::zeros());
        let (mut q, n) = (vec![0.0; figure.layout().nq()], figure.layout().nv());
        figure.neutral(&mut q).expect("the right length");
        let (zero, one) = (vec![0.0; n], vec![1.0; n]);
        let tau = kernel.inverse(&q, &zero, &one, &[]).expect("as it is");
        assert!((tau[n - 1] + 0.25).abs() < 1e-12 && kernel.mass_matrix(&q).is_ok(), "{name}: {tau:?}");
        let forward = kernel.forward(&q, &zero, &one, &[]).expect_err("not positive");
        let inverse = kernel.inverse_mass_matrix(&q).expect_err("not positive");
        let hybrid =
            kernel.hybrid([&q, &zero], &vec![false; n], [&zero, &one], &[]).expect_err("not positive");
        for error in [forward, inverse, hybrid] {
            let (found, left) = left_of(error);
            assert!((left + 0.25).abs() < 1e-6, "{name}: {left}");
            assert!(found == dof || name == "skew", "{name}: {found}");
        }
        // Prescribed, it is inverse dynamics.
        assert!(kernel.hybrid([&q, &zero], &vec![true; n], [&one, &zero], &[]).is_ok(), "{name}");
    }
}

/// Not the link itself but what its parent feels of it is below zero: a rotor of negative inertia on an arm.
#[test]
fn the_joint_that_lacks_inertia_is_named_and_not_its_child() {
    let arm = LinkSpec::root("arm", Joint::new("shoulder").rz()).mass(1.0).com(Vector3::new(0.5, 0.0, 0.0));
    let rotor =
        LinkSpec::child("rotor", "arm", Joint::new("wrist").rx()).inertia(Inertia::diagonal(1.0, -2.0, -2.0));
    let figure = FigureBuilder::new("impossible").link(arm).link(rotor).build().expect("a figure");
    let mut kernel = Kernel::<f64>::new(&figure, Vector3::zeros());
    let (dof, left) =
        left_of(kernel.forward(&[0.0; 2], &[0.0; 2], &[1.0; 2], &[]).expect_err("not positive"));
    assert_eq!(dof, "shoulder.rz");
    assert!((left - (0.25 - 2.0)).abs() < 1e-14, "{left}");
}

/// Moments without mass count: `τ = I·q̈`.
#[test]
fn a_rotor_without_mass_has_its_inertia() {
    let rotor = LinkSpec::root("rotor", Joint::new("axle").rz()).inertia(Inertia::diagonal(0.1, 0.1, 0.2));
    let figure = FigureBuilder::new("rotor").link(rotor).build().expect("a figure");
    let mut kernel = Kernel::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    let a = kernel.forward(&[0.3], &[2.0], &[1.0], &[]).expect("inertia");
    assert!((a[0] - 5.0).abs() < 1e-14, "{a:?}");
}
