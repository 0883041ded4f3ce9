//! Recorded motions as drives.

use super::{double_pendulum, settings};
use approx::assert_abs_diff_eq;
use solaris_model::Vector3;
use solaris_modes::{Drive, LimitLaw, OutcomeKind, RecordedMotion, Simulation};
use std::sync::Arc;

#[test]
fn what_swings_freely_swings_the_same_with_its_carrier_on_record() {
    let mut simulation = Simulation::new(&double_pendulum(), Vector3::new(0.0, -9.81, 0.0));
    simulation.set_limits(LimitLaw::Ignore).expect("valid");
    simulation.set_start(&[0.9, -0.4], &[0.0, 0.5]).expect("valid");
    let free = simulation.run(&settings(1.0, 500.0, 1e-3)).expect("runs");
    let recorded = Arc::new(RecordedMotion::new(free.motion.clone()).expect("has samples"));
    assert_eq!(recorded.span(), (0.0, 1.0));
    simulation.drive("upper_hinge", [Drive::Recorded(recorded)]).expect("valid");
    let again = simulation.run(&settings(1.0, 500.0, 1e-3)).expect("runs");
    assert_eq!(again.report.outcomes[0].result, OutcomeKind::Reached);
    // The last frame has the upper stopped, after its record.
    for frame in 0..500 {
        for dof in 0..2 {
            assert_abs_diff_eq!(again.motion.q(frame)[dof], free.motion.q(frame)[dof], epsilon = 1e-9);
            assert_abs_diff_eq!(again.motion.v(frame)[dof], free.motion.v(frame)[dof], epsilon = 1e-8);
        }
        // Its drive has nothing to do.
        assert_abs_diff_eq!(again.motion.tau(frame).expect("was asked for")[0], 0.0, epsilon = 1e-6);
    }
}
