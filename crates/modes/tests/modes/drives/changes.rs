//! One drive after the other: at an instant, after a time, at an event.

use super::{double_pendulum, pendulum, run, settings, slider};
use approx::assert_abs_diff_eq;
use solaris_model::{EventKind, Vector3};
use solaris_modes::{Drive, EndCondition, LimitLaw, OutcomeKind, Run, Shape, Simulation, Step};
use solaris_profiles::Profile;

fn until(drive: Drive, until: EndCondition) -> Step {
    Step { drive, until }
}

fn force(force: f64, duration: f64) -> Drive {
    Drive::Torque(Profile::Line { from: force, to: force, duration })
}

/// The times of the changes of drives.
fn changes(run: &Run) -> Vec<f64> {
    let changes =
        run.motion.events.iter().filter(|event| matches!(event.kind, EventKind::DriveChange { .. }));
    changes.map(|event| event.time).collect()
}

#[test]
fn forces_follow_one_another_without_a_jump() {
    // 2 kg: 1 m/s² for 0.5 s, then −3 m/s² for 0.25 s, then nothing.
    let steps = vec![force(2.0, 0.5).into(), force(-6.0, 0.25).into(), Drive::Free.into()];
    let found = run(slider(), (0.0, 0.0), steps, 1.0);
    assert_abs_diff_eq!(changes(&found)[..], [0.5, 0.75][..], epsilon = 1e-12);
    for (frame, t) in found.motion.time().iter().enumerate() {
        let (x, v) = match t {
            t if *t <= 0.5 => (0.5 * t * t, *t),
            t if *t <= 0.75 => {
                let s = t - 0.5;
                (0.125 + 0.5 * s - 1.5 * s * s, 0.5 - 3.0 * s)
            }
            t => (0.156_25 - 0.25 * (t - 0.75), -0.25),
        };
        assert_abs_diff_eq!(found.motion.q(frame)[0], x, epsilon = 1e-12);
        assert_abs_diff_eq!(found.motion.v(frame)[0], v, epsilon = 1e-12);
    }
}

#[test]
fn a_drive_gives_way_at_a_time_after_a_time_and_where_something_passes() {
    let slide = "slide".to_owned();
    let table = [
        // v = t, x = t²/2.
        (EndCondition::Time(0.3), 0.3),
        (EndCondition::Lasting(0.45), 0.45),
        (EndCondition::Position { dof: slide.clone(), value: 0.08 }, 0.4),
        (EndCondition::Velocity { dof: slide, value: 0.65 }, 0.65),
    ];
    for (condition, time) in table {
        let steps = vec![until(force(2.0, 5.0), condition.clone()), Drive::Free.into()];
        let found = run(slider(), (0.0, 0.0), steps, 1.0);
        assert_abs_diff_eq!(changes(&found)[..], [time][..], epsilon = 1e-12);
        assert_eq!(found.report.outcomes[0].result, OutcomeKind::Interrupted, "{condition:?}");
        assert_abs_diff_eq!(found.report.outcomes[0].velocity, time, epsilon = 1e-12);
        // It keeps its velocity.
        assert_abs_diff_eq!(found.motion.v(100)[0], time, epsilon = 1e-12);
        assert_abs_diff_eq!(found.motion.q(100)[0], time * (1.0 - 0.5 * time), epsilon = 1e-12);
    }
}

#[test]
fn an_event_of_one_joint_hands_over_another() {
    // The lower hinge is free until the upper passes 30°, and is then brought to rest at 0.
    let mut simulation = Simulation::new(&double_pendulum(), Vector3::new(0.0, -9.81, 0.0));
    simulation.set_limits(LimitLaw::Ignore).expect("valid");
    simulation.set_start(&[1.0, 0.4], &[0.0, 0.0]).expect("valid");
    let passes = EndCondition::Position { dof: "upper_hinge".to_owned(), value: 30_f64.to_radians() };
    let calm = Drive::Move { to: 0.0, over: 0.4, along: Shape::MinimumJerk };
    simulation.drive("lower_hinge", [until(Drive::Free, passes), calm.into()]).expect("valid");
    let found = simulation.run(&settings(1.0, 1000.0, 1e-3)).expect("runs");
    let change = changes(&found)[0];
    let at = |time: f64| (time * 1000.0).floor() as usize;
    let (before, after) = (at(change), at(change) + 1);
    let limit = 30_f64.to_radians();
    assert!(found.motion.q(before)[0] >= limit && found.motion.q(after)[0] <= limit);
    // Positions and velocities go on; between two frames they change by what 1 ms allows.
    for dof in 0..2 {
        let (q0, q1) = (found.motion.q(before)[dof], found.motion.q(after)[dof]);
        let (v0, v1) = (found.motion.v(before)[dof], found.motion.v(after)[dof]);
        assert_abs_diff_eq!(q1 - q0, 0.5e-3 * (v0 + v1), epsilon = 1e-4);
        assert_abs_diff_eq!(v1, v0, epsilon = 0.2);
    }
    let outcome = found.report.outcomes.iter().find(|outcome| outcome.drive == "move").expect("ended");
    assert_eq!(outcome.result, OutcomeKind::Reached);
    assert_abs_diff_eq!(outcome.end, change + 0.4, epsilon = 1e-12);
    assert_abs_diff_eq!(outcome.position, 0.0, epsilon = 1e-12);
    assert_abs_diff_eq!(outcome.velocity, 0.0, epsilon = 1e-12);
    assert!(found.report.energy.imbalance < 1e-6, "{:?}", found.report.energy);
}

#[test]
fn a_curve_that_is_let_go_falls_on_with_its_velocity() {
    let raise = Drive::Move { to: 1.0, over: 0.6, along: Shape::Cubic };
    let steps = vec![until(raise, EndCondition::Time(0.3)), Drive::Free.into()];
    let found = run(pendulum(9.81), (0.0, 0.0), steps, 0.6);
    let energy = |frame: usize| {
        let (q, v) = (found.motion.q(frame)[0], found.motion.v(frame)[0]);
        0.5 * 2.0 * 0.25 * v * v - 2.0 * 9.81 * 0.5 * q.cos()
    };
    // Half of the cubic: 0.5 rad with 1.5/0.6 rad/s, and from there on the energy stays.
    assert_abs_diff_eq!(found.motion.q(30)[0], 0.5, epsilon = 1e-12);
    assert_abs_diff_eq!(found.motion.v(30)[0], 2.5, epsilon = 1e-12);
    for frame in 31..=60 {
        assert_abs_diff_eq!(energy(frame), energy(30), epsilon = 1e-9);
    }
}
