//! The Lagrangian formulations against the numbers of another engine, against each other and against the fast one.

use crate::support::random::Random;
use crate::support::reference::{external, figure, models};
use crate::support::{Kernel, relative_error};
use nalgebra::Vector3;
use solaris_dynamics::{DynamicsError, Formulation, InverseDynamics, Scalar, Wrench};
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, human};

const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);

/// The forces in every formulation.
fn solve<T: Scalar>(
    figure: &Figure,
    gravity: Vector3<f64>,
    [q, v, a]: [&[T]; 3],
    external: &[(usize, Wrench<T>)],
) -> [Vec<T>; 3] {
    Formulation::ALL.map(|formulation| {
        let mut dynamics = InverseDynamics::new(figure, gravity, formulation).expect("finite constants");
        let mut tau = vec![T::one(); v.len()];
        dynamics.solve(q, v, a, external, &mut tau).expect("a valid state");
        tau
    })
}

/// The worst differences from the reference and between formulations.
fn worst<T: Scalar + Into<f64>>() -> (f64, f64) {
    let (mut apart, mut off) = (0.0_f64, 0.0_f64);
    let mut cases = 0;
    for model in models() {
        let figure = figure(&model);
        let gravity = Vector3::from(model.gravity);
        let mut kernel = Kernel::<T>::new(&figure, gravity);
        for state in &model.states {
            let narrow =
                |values: &[f64]| -> Vec<T> { values.iter().map(|&value| T::from_f64(value)).collect() };
            let (q, v, a) = (narrow(&state.q), narrow(&state.qd), narrow(&state.qdd));
            let wrenches = state.fext.as_ref().map(|fext| external(&mut kernel, &q, fext));
            let mut compare = |wrenches: &[_], expected: &[f64]| {
                let tau = solve(&figure, gravity, [&q, &v, &a], wrenches)
                    .map(|tau| tau.into_iter().map(Into::into).collect::<Vec<f64>>());
                for i in 0..3 {
                    off = off.max(relative_error(&tau[i], expected));
                    apart = apart.max(relative_error(&tau[i], &tau[(i + 1) % 3]));
                }
                cases += 1;
            };
            compare(&[], &state.tau_id);
            if let (Some(wrenches), Some(expected)) = (&wrenches, &state.tau_id_ext) {
                compare(wrenches, expected);
            }
        }
    }
    assert_eq!(cases, 48 * 4, "three states each, one of them with wrenches too");
    (off, apart)
}

#[test]
fn three_formulations_agree_on_every_model_of_the_reference() {
    let (off, apart) = worst::<f64>();
    assert!(off < 5e-13 && apart < 5e-13, "off by {off:e}, apart by {apart:e}");
}

#[test]
fn three_formulations_agree_in_single_precision() {
    let (off, apart) = worst::<f32>();
    assert!(off < 1e-5 && apart < 1e-5, "off by {off:e}, apart by {apart:e}");
}

/// `q`, `v`, `a`, wrenches and the length of `tau`.
type Call<'a> = (&'a [f64], &'a [f64], &'a [f64], &'a [(usize, Wrench<f64>)], usize);

#[test]
fn the_same_faults_get_the_same_answer() {
    let figure = human(1.75, 73.0).expect("within range");
    let (good, mut bad) = (vec![0.1; 66], vec![0.1; 66]);
    bad[7] = f64::NAN;
    let force = |x: f64| Wrench { force: Vector3::new(x, 0.0, 0.0), moment: Vector3::zeros() };
    let far = [(21, force(1.0))];
    let wild = [(3, force(1.0)), (20, force(f64::INFINITY))];
    let huge = vec![1e200; 66];
    let calls: [Call; 8] = [
        (&good[1..], &good, &good, &[], 66),
        (&bad, &good, &good, &[], 66),
        (&good, &bad, &good, &[], 66),
        (&good, &good, &bad, &[], 66),
        (&good, &good, &good, &far, 66),
        (&good, &good, &good, &wild, 66),
        (&good, &good, &good, &[], 65),
        (&good, &huge, &good, &[], 66),
    ];
    for (number, (q, v, a, external, n)) in calls.into_iter().enumerate() {
        let errors = Formulation::ALL.map(|formulation| {
            let mut dynamics = InverseDynamics::new(&figure, GRAVITY, formulation).expect("finite constants");
            dynamics.solve(q, v, a, external, &mut vec![0.0; n]).expect_err("a fault")
        });
        let overflow = errors.iter().all(|error| matches!(error, DynamicsError::Overflow { .. }));
        assert!(overflow == (number == 7), "{errors:?}");
        // Which number gave out first is a matter of the formulation.
        assert!(overflow || errors.iter().all(|error| *error == errors[2]), "{errors:?}");
    }
    let infinite = Vector3::new(0.0, f64::NEG_INFINITY, 0.0);
    let errors = Formulation::ALL.map(|formulation| {
        InverseDynamics::<f64>::new(&figure, infinite, formulation).expect_err("no such gravity")
    });
    assert!(errors.iter().all(|error| *error == errors[2]), "{errors:?}");
}

/// The root's position is not in the forces of the joints: ∂W/∂q never holds it.
#[test]
fn the_torques_do_not_depend_on_the_place() {
    let figure = human(1.75, 73.0).expect("within range");
    let mut random = Random::new(5);
    let (mut q, v, a) = (random.slice(66, 1.0), random.slice(66, 2.0), random.slice(66, 5.0));
    q[..3].fill(0.0);
    let near = solve(&figure, GRAVITY, [&q, &v, &a], &[]);
    q[..3].copy_from_slice(&[1e5, -2e5, 3e5]);
    assert_eq!(solve(&figure, GRAVITY, [&q, &v, &a], &[]), near);
}

/// A link that nothing moves, with a mass and a wrench on it, takes no force.
#[test]
fn what_stands_on_the_world_moves_nothing() {
    let arm = |world: LinkSpec| {
        FigureBuilder::new("crane")
            .link(world)
            .link(
                LinkSpec::child("jib", "mast", Joint::new("slew").at(Vector3::y()).ry().rx())
                    .mass(2.0)
                    .com(Vector3::x()),
            )
            .link(
                LinkSpec::child("hook", "jib", Joint::new("weld").at(Vector3::x() * 2.0))
                    .mass(1.0)
                    .inertia(Inertia::diagonal(0.1, 0.2, 0.3)),
            )
            .build()
            .expect("a valid figure")
    };
    let mast = LinkSpec::root("mast", Joint::new("foundation"));
    let push = Wrench { force: Vector3::new(3.0, 4.0, 5.0), moment: Vector3::new(1.0, 2.0, 3.0) };
    let state: [&[f64]; 3] = [&[0.3, 0.4], &[1.0, 2.0], &[3.0, 4.0]];
    let light = solve(&arm(mast.clone()), GRAVITY, state, &[]);
    let heavy = solve(&arm(mast.mass(1e3)), GRAVITY, state, &[(0, push)]);
    for i in 0..3 {
        assert_eq!(light[i], heavy[i]);
        assert!(relative_error(&light[i], &light[2]) < 1e-14);
    }
}

#[test]
fn a_statue_has_no_state() {
    let statue = LinkSpec::root("statue", Joint::new("plinth")).mass(3.0);
    let figure = FigureBuilder::new("statue").link(statue).build().expect("a valid figure");
    assert_eq!(solve::<f64>(&figure, GRAVITY, [&[], &[], &[]], &[]), [const { Vec::<f64>::new() }; 3]);
}
