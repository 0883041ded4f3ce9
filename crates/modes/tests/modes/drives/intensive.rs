//! Intensive mode: targets that are tracked, through whatever else the figure does.

use super::{double_pendulum, only, pendulum, run, settings};
use approx::assert_abs_diff_eq;
use solaris_model::{Vector3, human};
use solaris_modes::{Drive, Law, LimitLaw, OutcomeKind, Simulation, Target};

fn intensive(target: Target, duration: f64, law: Law) -> Drive {
    Drive::Intensive { target, duration, law, limit: None }
}

/// A human whose pelvis nothing holds, and whose left leg goes for a posture in a second; the greatest error of the positions
/// and of the velocities.
fn leg(law: Law, rate: f64, gravity: f64) -> (f64, f64) {
    let figure = human(1.75, 73.0).expect("in range");
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, -gravity, 0.0));
    simulation.set_limits(LimitLaw::Ignore).expect("valid");
    let mut targets = Vec::new();
    for link in figure.links() {
        match link.joint().name() {
            "root" => simulation.drive("root", [Drive::Free]).expect("valid"),
            "left_hip" | "left_knee" => {}
            joint => simulation.drive(joint, [Drive::Frozen]).expect("valid"),
        }
    }
    let postures = [("left_hip", [0.2, -0.3, -1.0]), ("left_knee", [0.05, 0.1, 1.0])];
    for (joint, posture) in postures {
        for (axis, position) in ["rz", "ry", "rx"].iter().zip(posture) {
            let name = format!("{joint}.{axis}");
            simulation.drive(&name, [intensive(Target::at(position), 1.0, law)]).expect("valid");
            targets.push((figure.layout().dof_index(&name).expect("has it"), position));
        }
    }
    let run = simulation.run(&settings(1.0, rate, 1.0)).expect("runs");
    assert_eq!(run.report.outcomes.len(), 6);
    let mut worst = (0.0_f64, 0.0_f64);
    for outcome in &run.report.outcomes {
        let (_, position) = targets.iter().find(|(dof, _)| *dof == outcome.dof).expect("is driven");
        assert_eq!(outcome.result, OutcomeKind::Reached);
        worst = (worst.0.max((outcome.position - position).abs()), worst.1.max(outcome.velocity.abs()));
    }
    worst
}

#[test]
fn a_leg_on_a_floating_pelvis_arrives_by_the_cubic_law() {
    for gravity in [0.0, 9.81] {
        let (position, velocity) = leg(Law::Cubic, 240.0, gravity);
        assert!(position <= 1e-4, "{position:e}");
        assert!(velocity <= 1e-3, "{velocity:e}");
    }
}

#[test]
fn the_quintic_law_misses_by_no_more_than_the_square_of_the_frame() {
    let [slow, middle, fast] = [120.0, 240.0, 480.0].map(|rate| leg(Law::Quintic, rate, 9.81));
    assert!(middle.0 <= 1e-6, "{middle:?}");
    assert!(middle.1 <= 1e-4, "{middle:?}");
    for (coarse, fine) in [(slow, middle), (middle, fast)] {
        assert!(coarse.0 >= 3.5 * fine.0 && coarse.1 >= 3.5 * fine.1, "{slow:?} {middle:?} {fast:?}");
    }
}

#[test]
fn a_target_with_a_velocity_is_met_with_it() {
    let target = Target { position: 1.0, velocity: 0.7, acceleration: -0.4 };
    for law in [Law::Cubic, Law::Quintic] {
        let found = run(pendulum(9.81), (0.2, -0.3), only(intensive(target, 0.75, law)), 0.75);
        let outcome = &found.report.outcomes[0];
        assert_eq!(outcome.result, OutcomeKind::Reached);
        // At 100 frames a second.
        assert_abs_diff_eq!(outcome.position, 1.0, epsilon = 2e-5);
        assert_abs_diff_eq!(outcome.velocity, 0.7, epsilon = 1e-4);
    }
}

#[test]
fn a_force_of_the_next_joint_and_a_free_one_are_reckoned_with() {
    // The upper hinge tracks while the lower swings freely.
    let mut simulation = Simulation::new(&double_pendulum(), Vector3::new(0.0, -9.81, 0.0));
    simulation.set_start(&[0.0, 1.2], &[0.0, 0.0]).expect("valid");
    simulation.drive("upper_hinge", [intensive(Target::at(0.8), 1.0, Law::Quintic)]).expect("valid");
    let found = simulation.run(&settings(1.0, 240.0, 1.0 / 480.0)).expect("runs");
    assert_abs_diff_eq!(found.report.outcomes[0].position, 0.8, epsilon = 2e-6);
    assert_abs_diff_eq!(found.report.outcomes[0].velocity, 0.0, epsilon = 1e-4);
}

#[test]
fn a_weak_drive_says_that_its_force_was_not_enough() {
    // m·g·l·sin 1 is 8.3 N m.
    let drive =
        Drive::Intensive { target: Target::at(1.0), duration: 1.0, law: Law::Quintic, limit: Some(4.0) };
    let found = run(pendulum(9.81), (0.0, 0.0), only(drive), 1.5);
    assert_eq!(found.report.outcomes[0].result, OutcomeKind::LimitedByTorque);
    assert!(found.report.outcomes[0].position < 0.9);
    let forces = (0..100).map(|frame| found.motion.tau(frame).expect("was asked for")[0].abs());
    let greatest = forces.fold(0.0, f64::max);
    assert_abs_diff_eq!(greatest, 4.0, epsilon = 1e-9);
}

#[test]
fn the_literal_law_does_not_lead_to_its_target() {
    let found = run(pendulum(9.81), (0.0, 0.0), only(intensive(Target::at(0.785), 1.0, Law::Literal)), 1.0);
    let outcome = &found.report.outcomes[0];
    assert_eq!(outcome.result, OutcomeKind::Missed);
    assert!(outcome.missed_by.is_some_and(|by| by > 0.1), "{outcome:?}");
}
