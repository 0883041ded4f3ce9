//! Every question over every scalar: the same code, the same answers.

use crate::questions::case::Case;
use crate::support::random::Joints;
use nalgebra::{DMatrix, Matrix3, Vector3};
use solaris_dynamics as dynamics;
use solaris_dynamics::scalar::{Counted, DoubleDouble, Dual, Lanes};
use solaris_dynamics::{Frame, JacobianAxes, Pose, Scalar, Tree, Workspace, Wrench};

/// All answers about one state, one after the other.
fn answers<T: Scalar>(case: &Case) -> Vec<T> {
    let tree = Tree::<T>::new(&case.figure, case.gravity).expect("finite constants");
    let mut workspace = Workspace::new(&tree);
    let ws = &mut workspace;
    let cast = |values: &[f64]| -> Vec<T> { values.iter().map(|x| T::from_f64(*x)).collect() };
    let (q, v, a) = (cast(&case.q), cast(&case.v), cast(&case.a));
    let vector = |v: &Vector3<f64>| v.map(T::from_f64);
    let external: Vec<(usize, Wrench<T>)> = case
        .external
        .iter()
        .map(|(link, w)| (*link, Wrench { force: vector(&w.force), moment: vector(&w.moment) }))
        .collect();
    let (n, links) = (tree.nv(), tree.link_count());
    let placement = Pose { rotation: Matrix3::identity(), translation: vector(&Vector3::new(0.1, 0.2, 0.3)) };
    let frame = Frame { link: links - 1, placement };
    let mut out: Vec<T> = Vec::new();
    let mut keep = |values: &[T]| out.extend_from_slice(values);
    let mut all = || {
        let matrix = |rows: usize, columns: usize| DMatrix::<T>::zeros(rows, columns);
        let mut six = matrix(6, n);
        for axes in [JacobianAxes::World, JacobianAxes::Frame] {
            dynamics::jacobian(&tree, ws, &q, &frame, axes, &mut six)?;
            keep(six.as_slice());
            dynamics::jacobian_rate(&tree, ws, &q, &v, &frame, axes, &mut six)?;
            keep(six.as_slice());
        }
        dynamics::accelerations(&tree, ws, &q, &v, &a)?;
        keep(frame.acceleration(ws).linear.as_slice());
        dynamics::bias_accelerations(&tree, ws, &q, &v)?;
        keep(frame.acceleration(ws).linear.as_slice());
        dynamics::centroidal_momentum_matrix(&tree, ws, &q, &mut six)?;
        keep(six.as_slice());
        let mut three = matrix(3, n);
        dynamics::center_of_mass_jacobian(&tree, ws, &q, &mut three)?;
        keep(three.as_slice());
        keep(dynamics::composite_body(&tree, ws, &q)?.inertia.as_slice());
        keep(dynamics::centroidal_momentum(&tree, ws, &q, &v)?.angular.as_slice());
        keep(dynamics::centroidal_momentum_rate(&tree, ws, &q, &v, &a)?.moment.as_slice());
        let mut square = matrix(n, n);
        dynamics::coriolis_matrix(&tree, ws, &q, &v, &mut square)?;
        keep(square.as_slice());
        let mut tau = vec![T::zero(); n];
        dynamics::gravity_torques(&tree, ws, &q, &mut tau)?;
        keep(&tau);
        dynamics::joint_reactions(&tree, ws, &q, &v, &a, &external, &mut tau)?;
        keep(ws.reaction(links - 1).moment.as_slice());
        let mut regressor = matrix(n, 10 * links);
        dynamics::torque_regressor(&tree, ws, &q, &v, &a, &mut regressor)?;
        keep(regressor.as_slice());
        let (mut a, force) = (a.clone(), vector(&Vector3::new(1.0, 2.0, 3.0)));
        match dynamics::ground_acceleration(&tree, ws, &q, &v, &mut a, &external, &force, &mut tau) {
            Ok(()) => keep(&a),
            Err(error) => assert!(matches!(error, dynamics::DynamicsError::Root { .. }), "{error}"),
        }
        Ok::<(), dynamics::DynamicsError>(())
    };
    all().expect("a valid state");
    out
}

fn compare<T: Scalar>(tolerance: f64, value: impl Fn(T) -> f64) {
    for seed in 0..20 {
        let case = Case::with(Joints::Every, seed);
        let expected = answers::<f64>(&case);
        let found = answers::<T>(&case);
        assert_eq!(found.len(), expected.len());
        let scale = expected.iter().fold(1.0_f64, |scale, x| scale.max(x.abs()));
        for (found, expected) in found.into_iter().zip(expected) {
            let found = value(found);
            assert!((found - expected).abs() <= tolerance * scale, "seed {seed}: {found} {expected}");
        }
    }
}

#[test]
fn single_precision_agrees_to_five_digits() {
    compare::<f32>(1e-5, f64::from);
}

#[test]
fn dual_numbers_have_the_same_values() {
    compare::<Dual<2>>(0.0, Dual::value);
}

#[test]
fn every_lane_agrees() {
    compare::<Lanes<4>>(1e-13, |x| x.lane(3));
}

#[test]
fn counting_changes_nothing() {
    compare::<Counted>(0.0, Counted::value);
}

#[test]
fn more_digits_agree_with_those_that_there_are() {
    compare::<DoubleDouble>(1e-13, DoubleDouble::to_f64);
}
