//! Forces as a linear function of the masses.

use crate::questions::case::{Case, difference, matrix};
use crate::support::random::Joints;
use crate::support::reference::{figure, models};
use crate::support::{Kernel, relative_error};
use nalgebra::{DVector, Vector3};
use proptest::prelude::*;
use solaris_dynamics::{inertial_parameters, torque_regressor};
use solaris_model::{FigureBuilder, Inertia, Joint, LinkSpec};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn regressor_times_parameters_are_the_forces(seed in any::<u64>(), one_axis in any::<bool>()) {
        let mut case = Case::with(if one_axis { Joints::OneAxis } else { Joints::Every }, seed);
        let mut y = matrix(case.nv(), 10 * case.figure.links().len());
        let Kernel { tree, workspace } = &mut case.kernel;
        torque_regressor(tree, workspace, &case.q, &case.v, &case.a, &mut y).expect("valid");
        let mut found = y * DVector::from_vec(inertial_parameters(&case.figure));
        // The armature is not a parameter.
        for (link, at) in case.figure.links().iter().zip(case.figure.layout().joints()) {
            (0..at.nv).for_each(|k| found[at.v + k] += link.joint().kind().armature(k) * case.a[at.v + k]);
        }
        let tau = case.kernel.inverse(&case.q, &case.v, &case.a, &[]).expect("valid");
        let error = difference(&found, &DVector::from_vec(tau), 1.0);
        prop_assert!(error < 1e-12, "{error:e}");
    }
}

/// The order of the parameters, and that the inertia is about the link's origin.
#[test]
fn parameters_are_in_pinocchio_s_order() {
    let inertia = nalgebra::Matrix3::new(0.11, 0.01, 0.02, 0.01, 0.12, 0.03, 0.02, 0.03, 0.13);
    let link = LinkSpec::root("a", Joint::new("j").rx())
        .mass(2.0)
        .com(Vector3::new(1.0, 2.0, 3.0))
        .inertia(Inertia::Tensor(inertia));
    let massless = LinkSpec::root("w", Joint::new("weld"));
    let child = LinkSpec::child("b", "w", Joint::new("k").ry()).mass(1.0);
    let figure = FigureBuilder::new("one").link(link).build().expect("a valid figure");
    // 0.11 + 2·(4 + 9), 0.01 − 2·1·2, 0.12 + 2·(1 + 9), 0.02 − 2·1·3, 0.03 − 2·2·3, 0.13 + 2·(1 + 4)
    let expected = [2.0, 2.0, 4.0, 6.0, 26.11, -3.99, 20.12, -5.98, -11.97, 10.13];
    let found = inertial_parameters(&figure);
    assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}");
    let two = FigureBuilder::new("two").link(massless).link(child).build().expect("a valid figure");
    assert_eq!(inertial_parameters(&two)[..11], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
}

/// Every state of every figure of another engine: its torques.
#[test]
fn regressor_times_parameters_are_the_reference_s_forces() {
    for model in models() {
        let figure = figure(&model);
        let mut kernel = Kernel::<f64>::new(&figure, model.gravity.into());
        let parameters = DVector::from_vec(inertial_parameters(&figure));
        for state in &model.states {
            let mut y = matrix(state.qd.len(), parameters.len());
            let Kernel { tree, workspace } = &mut kernel;
            torque_regressor(tree, workspace, &state.q, &state.qd, &state.qdd, &mut y).expect("valid");
            let error = relative_error((y * &parameters).as_slice(), &state.tau_id);
            assert!(error < 1e-13, "{}: {error:e}", model.name);
        }
    }
}
