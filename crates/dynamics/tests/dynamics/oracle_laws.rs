//! Every operation against products of 4×4 matrices and virtual work, on trees with every kind of joint.

use crate::support::oracle::Oracle;
use crate::support::random::{Sample, State};
use crate::support::{Kernel, relative_error};
use nalgebra::Vector3;
use proptest::prelude::*;

/// The worst relative difference of any operation on a random tree in a random state.
fn worst(seed: u64, decades: f64) -> (&'static str, f64) {
    let Sample { figure, gravity, state: State { q, v, a }, external } = Sample::random(seed, decades);
    let (mut kernel, oracle) =
        (Kernel::<f64>::new(&figure, gravity), Oracle::new(&figure, gravity, &q, &v, &a));
    let at_rest = Oracle::new(&figure, gravity, &q, &v, &vec![0.0; a.len()]);
    let mut errors = vec![
        ("tau", oracle.error_of(&kernel.inverse(&q, &v, &a, &[]).expect("valid"), &[])),
        (
            "tau with wrenches",
            oracle.error_of(&kernel.inverse(&q, &v, &a, &external).expect("valid"), &external),
        ),
        ("bias", at_rest.error_of(&kernel.bias_forces(&q, &v).expect("valid"), &[])),
        (
            "M",
            relative_error(
                kernel.mass_matrix(&q).expect("valid").as_slice(),
                oracle.mass_matrix().as_slice(),
            ),
        ),
        ("kinetic", relative_error(&[kernel.kinetic(&q, &v)], &[oracle.kinetic_energy()])),
        ("potential", (kernel.potential(&q) - oracle.potential_energy()).abs() / (figure.mass() * 50.0)),
    ];
    let (momentum, (linear, angular)) = (kernel.momentum(&q, &v), oracle.momentum());
    let scale = figure.mass() * 3.0;
    errors.push(("linear momentum", (momentum.linear - linear).amax() / scale));
    errors.push(("angular momentum", (momentum.angular - angular).amax() / scale));
    for (i, body) in oracle.bodies.iter().enumerate() {
        let (pose, twist) = (kernel.workspace.pose(i), kernel.workspace.velocity(i));
        let spin = body.rate.fixed_view::<3, 3>(0, 0) * body.w.fixed_view::<3, 3>(0, 0).transpose();
        let angular = Vector3::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]);
        errors.push(("rotation", (pose.rotation - body.w.fixed_view::<3, 3>(0, 0)).amax()));
        errors.push(("translation", (pose.translation - body.w.column(3).xyz()).amax()));
        errors.push(("velocity", (twist.linear - body.rate.column(3).xyz()).amax() / 10.0));
        errors.push(("angular velocity", (twist.angular - angular).amax() / 10.0));
    }
    errors.into_iter().max_by(|(_, a), (_, b)| a.total_cmp(b)).expect("several")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn every_operation_agrees_with_virtual_work(seed in any::<u64>()) {
        let (what, error) = worst(seed, 1.0);
        prop_assert!(error < 2e-13, "{what}: {error:e}");
    }

    /// Masses between a milligram and a tonne in one figure.
    #[test]
    fn mass_ratios_of_twelve_decades_do_no_harm(seed in any::<u64>()) {
        let (what, error) = worst(seed, 6.0);
        prop_assert!(error < 2e-13, "{what}: {error:e}");
    }
}
