//! Curves that jump leave a rule its order.

use super::{double_pendulum, settings};
use solaris_model::Vector3;
use solaris_modes::{Course, Drive, LimitLaw, Simulation, Target};
use solaris_profiles::Profile;

/// The free lower hinge after a second, in which the upper is driven and something jumps at times that no step hits.
fn lower(drive: &Drive, step: f64) -> f64 {
    let mut simulation = Simulation::new(&double_pendulum(), Vector3::new(0.0, -9.81, 0.0));
    simulation.set_limits(LimitLaw::Ignore).expect("valid");
    simulation.set_start(&[0.0, 0.5], &[0.0, 0.0]).expect("valid");
    simulation.drive("upper_hinge", [drive.clone()]).expect("valid");
    let run = simulation.run(&settings(1.0, 10.0, step)).expect("runs");
    run.motion.q(10)[1]
}

/// Each halving of the step makes the error at least twelve times smaller; with a jump inside of a step it is two times, or four.
fn check(drive: &Drive) {
    let reference = lower(drive, 1.0 / 1280.0);
    let errors = [0.1, 0.05, 0.025].map(|step| (lower(drive, step) - reference).abs());
    assert!(errors[2] > 1e-9, "{errors:?} are hardly errors");
    for pair in errors.windows(2) {
        assert!(pair[0] / pair[1] > 12.0, "{errors:?}");
    }
}

#[test]
fn a_drive_that_switches_its_acceleration_keeps_the_order() {
    let target = Target { position: 0.8, velocity: 0.0, acceleration: 9.0 };
    check(&Drive::Simple { target, course: Course::BangBang });
}

#[test]
fn a_profile_of_phases_keeps_the_order() {
    check(&Drive::Kinematic(Profile::Trapezoidal {
        from: 0.0,
        to: 0.8,
        largest_velocity: 1.7,
        largest_acceleration: 7.0,
    }));
}

#[test]
fn a_curve_that_ends_in_mid_run_keeps_the_order() {
    check(&Drive::Kinematic(Profile::Trigonometric { from: 0.0, to: 0.8, duration: 0.537 }));
}
