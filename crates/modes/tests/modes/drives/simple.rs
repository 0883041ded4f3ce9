//! Simple mode and free-style: what was wrong with them in the thesis, and what they do here.

use super::{only, pendulum, run, settings, slider};
use approx::assert_abs_diff_eq;
use solaris_modes::{
    Course, Drive, Guard, LimitLaw, Method, OutcomeKind, Rule, Settings, Simulation, Target,
};
use solaris_profiles::Profile;
use std::f64::consts::{FRAC_PI_4, PI};

fn simple(position: f64, acceleration: f64, course: Course) -> Drive {
    Drive::Simple { target: Target { position, velocity: 0.0, acceleration }, course }
}

#[test]
fn the_force_that_holds_a_target_swings_a_pendulum_past_it_for_ever() {
    // m·g·l·sin 45° does m·g·l·(sin 45°·θ − (1 − cos θ)) of work: rest again where that is zero, at 114°, not at 45°.
    let drive = Drive::FreeStyle { target: Some(Target::at(FRAC_PI_4)), duration: 20.0 };
    let found = run(pendulum(9.81), (0.0, 0.0), only(drive), 20.0);
    let work = |angle: f64| angle * FRAC_PI_4.sin() - (1.0 - angle.cos());
    let (mut low, mut high) = (1.0, 3.0);
    while high - low > 1e-12 {
        let middle = 0.5 * (low + high);
        if work(middle) > 0.0 { low = middle } else { high = middle }
    }
    assert_abs_diff_eq!(low.to_degrees(), 114.0, epsilon = 0.5);
    let angles = (0..found.motion.len()).map(|frame| found.motion.q(frame)[0]);
    let greatest = angles.clone().fold(f64::MIN, f64::max);
    // Between two frames it may be higher: by α·(Δt/2)²/2.
    assert!(greatest <= low + 1e-8 && greatest > low - 4e-4, "{greatest} {low}");
    assert!(angles.fold(f64::MAX, f64::min) >= -1e-8);
    assert_eq!(found.report.outcomes[0].result, OutcomeKind::Ended);
    assert!(found.report.energy.imbalance < 1e-7, "{:?}", found.report.energy);
}

#[test]
fn each_course_arrives_when_it_should() {
    // δ = 1 m, A = 2 m/s².
    let table = [
        (Course::TargetAngle, 1.0, 2.0, OutcomeKind::ReachedWithVelocity),
        (Course::TimeOriented { duration: 0.8 }, 0.8, 2.5, OutcomeKind::ReachedWithVelocity),
        (Course::BangBang, 2.0_f64.sqrt(), 0.0, OutcomeKind::Reached),
        (Course::HalfCosine, PI / 2.0, 0.0, OutcomeKind::Reached),
        (Course::FullSine, PI.sqrt(), 0.0, OutcomeKind::Reached),
    ];
    for (course, time, velocity, result) in table {
        let found = run(slider(), (0.5, 0.0), only(simple(1.5, 2.0, course)), 2.0);
        let outcome = &found.report.outcomes[0];
        assert_eq!(outcome.result, result, "{course:?}");
        assert_abs_diff_eq!(outcome.end, time, epsilon = 1e-12);
        assert_abs_diff_eq!(outcome.position, 1.5, epsilon = 1e-12);
        assert_abs_diff_eq!(outcome.velocity, velocity, epsilon = 1e-12);
        assert_abs_diff_eq!(outcome.acceleration.expect("was analysed"), 2.0, epsilon = 1e-12);
        // Then it stands there.
        let last = found.motion.len() - 1;
        assert_abs_diff_eq!(found.motion.q(last)[0], 1.5, epsilon = 1e-12);
        assert_abs_diff_eq!(found.motion.v(last)[0], 0.0, epsilon = 0.0);
        assert_eq!(found.report.impacts.len(), usize::from(velocity > 0.0), "{course:?}");
    }
}

#[test]
fn what_stops_a_degree_of_freedom_is_an_impulse_of_its_momentum() {
    let found = run(slider(), (0.0, 0.0), only(simple(1.0, 2.0, Course::TargetAngle)), 2.0);
    let stop = &found.report.impacts[0];
    assert_eq!((stop.what, stop.dof), ("stop", 0));
    assert_abs_diff_eq!(stop.time, 1.0, epsilon = 1e-12);
    assert_abs_diff_eq!(stop.velocity_before, 2.0, epsilon = 1e-12);
    assert_abs_diff_eq!(stop.impulse, -4.0, epsilon = 1e-11);
    assert_abs_diff_eq!(stop.loss, 4.0, epsilon = 1e-11);
}

#[test]
fn the_force_of_a_course_is_what_its_motion_needs() {
    // The half cosine: 2 kg times 2·cos(2t).
    let found = run(slider(), (0.0, 0.0), only(simple(1.0, 2.0, Course::HalfCosine)), 1.5);
    for (frame, time) in found.motion.time().iter().enumerate() {
        let force = found.motion.tau(frame).expect("was asked for")[0];
        assert_abs_diff_eq!(force, 4.0 * (2.0 * time).cos(), epsilon = 1e-11);
    }
}

#[test]
fn what_is_not_reached_is_told_and_nothing_moves() {
    let hanging = |target| Drive::Simple { target, course: Course::TargetAngle };
    let bang = |target| Drive::Simple { target, course: Course::BangBang };
    let table = [
        // Upside down, the force that holds 45° drives the pendulum away from it.
        (-9.81, (0.0, 0.0), hanging(Target::at(FRAC_PI_4)), OutcomeKind::WrongSign, Some(-13.873_4)),
        // About a vertical axis no force is needed to hold a target.
        (0.0, (0.0, 0.0), hanging(Target::at(FRAC_PI_4)), OutcomeKind::NoMotion, Some(0.0)),
        (0.0, (0.0, 0.0), bang(Target::at(FRAC_PI_4)), OutcomeKind::NoMotion, Some(0.0)),
        // It turns round on its way.
        (
            0.0,
            (0.0, 0.5),
            hanging(Target { position: 1.0, velocity: 0.0, acceleration: -1.0 }),
            OutcomeKind::Unreachable,
            Some(-1.0),
        ),
        (9.81, (0.0, 0.5), bang(Target::at(1.0)), OutcomeKind::NeedsRest, None),
        (9.81, (0.3, 0.0), hanging(Target::at(0.3)), OutcomeKind::Reached, None),
    ];
    for (gravity, state, drive, result, acceleration) in table {
        let found = run(pendulum(gravity), state, only(drive), 0.5);
        let outcome = &found.report.outcomes[0];
        assert_eq!(outcome.result, result);
        assert_abs_diff_eq!(outcome.end, 0.0, epsilon = 0.0);
        if let Some(expected) = acceleration {
            assert_abs_diff_eq!(outcome.acceleration.expect("was analysed"), expected, epsilon = 1e-4);
        }
        let last = found.motion.len() - 1;
        assert_abs_diff_eq!(found.motion.q(last)[0], state.0, epsilon = 1e-15);
    }
}

#[test]
fn eulers_rules_miss_by_half_a_step_of_the_velocity_and_the_exact_one_does_not() {
    // α = 2 over 1 s at 25 frames/s: the printed rules are off by ±α·T·Δt/2 = ±0.040.
    let position = |rule| {
        let mut simulation: Simulation = slider();
        let force = Profile::Line { from: 4.0, to: 4.0, duration: 1.0 };
        simulation.drive("slide", [Drive::Torque(force)]).expect("valid");
        simulation.set_limits(LimitLaw::Ignore).expect("valid");
        let method = Method::Fixed { rule, step: 0.04 };
        // What Euler's rules do to the energy is what the guard is for.
        let guard = Guard { energy: f64::INFINITY, ..Guard::default() };
        let settings = Settings { method, guard, ..settings(1.0, 25.0, 0.04) };
        let run = simulation.run(&settings).expect("runs");
        run.motion.q(25)[0]
    };
    assert_abs_diff_eq!(position(Rule::SemiImplicitEuler), 1.04, epsilon = 1e-12);
    assert_abs_diff_eq!(position(Rule::ExplicitEuler), 0.96, epsilon = 1e-12);
    assert_abs_diff_eq!(position(Rule::ConstantAcceleration), 1.0, epsilon = 1e-12);
    assert_abs_diff_eq!(position(Rule::RungeKutta4), 1.0, epsilon = 1e-12);
}
