//! Servos against damped oscillators in closed form, alone and beside other forces.

use super::{only, pendulum, run, settings, slider};
use approx::assert_abs_diff_eq;
use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
use solaris_modes::{
    Aim, Drive, EndCondition, FailureKind, OutcomeKind, Run, RunError, Servo, Settings, SetupError,
    Simulation, Step,
};
use solaris_profiles::Profile;

fn servo(aim: Aim, stiffness: f64, damping: f64, limit: Option<f64>) -> Drive {
    Drive::Servo(Servo { aim, stiffness, damping, limit })
}

/// How much of the energy at play came from nowhere.
fn imbalance(run: &Run) -> f64 {
    run.report.energy.imbalance / run.report.energy.scale
}

/// `m·ẍ = k·(x* − x) − d·ẋ` from rest at zero: `x = x* − x*·e^(−ζωt)·(cos ω't + ζω/ω'·sin ω't)`.
#[test]
fn to_a_place_it_is_a_damped_oscillator() {
    let (mass, stiffness, damping, to) = (2.0, 50.0, 4.0, 0.3);
    let (decay, natural) = (damping / (2.0 * mass), f64::sqrt(stiffness / mass));
    let rate = (natural * natural - decay * decay).sqrt();
    let run = run(slider(), (0.0, 0.0), only(servo(Aim::At(to), stiffness, damping, None)), 2.0);
    for frame in 0..=200 {
        let t = frame as f64 / 100.0;
        let swing = (-decay * t).exp() * ((rate * t).cos() + decay / rate * (rate * t).sin());
        assert_abs_diff_eq!(run.motion.q(frame)[0], to - to * swing, epsilon = 1e-10);
        let force = stiffness * (to - run.motion.q(frame)[0]) - damping * run.motion.v(frame)[0];
        assert_abs_diff_eq!(run.motion.tau(frame).expect("forces")[0], force, epsilon = 1e-10);
    }
    // All work went into motion: ½·k·x*² in the spring, less what is left in it, less d·∫ẋ².
    let kinetic = 0.5 * mass * run.motion.v(200)[0].powi(2);
    assert_abs_diff_eq!(run.report.energy.work, kinetic, epsilon = 1e-10);
    assert!(imbalance(&run) < 1e-9, "{:e}", imbalance(&run));
}

/// At its limit the motor gives a constant force; where the demand falls below it is where `k·(x* − x) − d·ẋ = limit`.
#[test]
fn at_its_limit_it_pushes_evenly_and_the_kink_is_located() {
    // x = t²·limit/(2m) until 100·(1 − t²/2) − 20·t = 2 → t = (−20 + √(400 + 4·50·98))/100.
    let (mass, limit) = (2.0, 2.0);
    let (stiffness, damping) = (100.0, 20.0);
    let a: f64 = limit / mass;
    let off = (-damping * a + ((damping * a).powi(2) + 2.0 * stiffness * a * (stiffness - limit)).sqrt())
        / (stiffness * a);
    let run = run(slider(), (0.0, 0.0), only(servo(Aim::At(1.0), stiffness, damping, Some(limit))), 3.0);
    for frame in 0..=300 {
        let t = frame as f64 / 100.0;
        if t <= off {
            assert_abs_diff_eq!(run.motion.q(frame)[0], 0.5 * a * t * t, epsilon = 1e-12);
            assert_abs_diff_eq!(run.motion.tau(frame).expect("forces")[0], limit, epsilon = 1e-12);
        } else {
            assert!(run.motion.tau(frame).expect("forces")[0] <= limit + 1e-12);
        }
    }
    // From there on it is a damped oscillator about its aim, that begins with what it has, down to the other end of the motor.
    let (decay, natural) = (damping / (2.0 * mass), f64::sqrt(stiffness / mass));
    let rate = (natural * natural - decay * decay).sqrt();
    let (x, v) = (0.5 * a * off * off - 1.0, a * off);
    let frame = (off * 100.0).ceil() as usize + 1;
    let t = frame as f64 / 100.0 - off;
    let swing = (-decay * t).exp() * (x * (rate * t).cos() + (v + decay * x) / rate * (rate * t).sin());
    assert_abs_diff_eq!(run.motion.q(frame)[0], 1.0 + swing, epsilon = 1e-8);
    assert!(run.report.cost.counts.events >= 1);
    assert!(imbalance(&run) < 1e-9, "{:e}", imbalance(&run));
}

/// With the aim `x* = A·…` of a polynomial the deviation `e = x* − x` is the one of `m·ë + d·ė + k·e = m·ẍ*`: with a parabola it
/// settles at `m·ẍ*/k`.
#[test]
fn along_a_curve_it_lags_by_what_the_acceleration_needs() {
    let aim =
        Profile::ConstantAcceleration { from: 0.0, duration: 6.0, acceleration: 0.5, start_velocity: 0.0 };
    let run = run(slider(), (0.0, 0.0), only(servo(Aim::Along(aim), 80.0, 25.0, None)), 6.0);
    assert_abs_diff_eq!(0.25 * 36.0 - run.motion.q(600)[0], 2.0 * 0.5 / 80.0, epsilon = 1e-9);
    let [outcome] = &run.report.outcomes[..] else { panic!("{:?}", run.report.outcomes) };
    assert_eq!((outcome.drive, outcome.result), ("servo", OutcomeKind::Missed));
    assert_abs_diff_eq!(outcome.missed_by.expect("a target"), 0.0125, epsilon = 1e-9);
}

/// A servo that is the last holds where its curve ends; one that is not gives way.
#[test]
fn after_its_curve_the_last_one_holds_and_another_gives_way() {
    let aim = || Aim::Along(Profile::MinimumJerk { from: 0.0, to: 1.0, duration: 0.5 });
    let held = run(slider(), (0.0, 0.0), only(servo(aim(), 800.0, 80.0, None)), 3.0);
    assert_abs_diff_eq!(held.motion.q(300)[0], 1.0, epsilon = 1e-8);
    let steps: Vec<Step> = vec![servo(aim(), 800.0, 80.0, None).into(), Drive::Free.into()];
    let free = run(slider(), (0.0, 0.0), steps, 1.0);
    let speed = free.motion.v(51)[0];
    assert_abs_diff_eq!(free.motion.v(100)[0], speed, epsilon = 1e-12);
    assert_abs_diff_eq!(free.motion.tau(60).expect("forces")[0], 0.0, epsilon = 1e-12);
}

/// A hanging bob held off the vertical by a servo rests where `k·(θ* − θ) = m·g·l·sin θ`; with what the load needs beside it, a
/// torque, it rests at its aim.
#[test]
fn beside_a_torque_it_has_nothing_left_to_carry() {
    let (aim, stiffness) = (0.6, 40.0);
    let pd = || servo(Aim::At(aim), stiffness, 12.0, None);
    let alone = run(pendulum(9.81), (aim, 0.0), only(pd()), 8.0);
    let rest = alone.motion.q(800)[0];
    assert_abs_diff_eq!(stiffness * (aim - rest), 2.0 * 9.81 * 0.5 * rest.sin(), epsilon = 1e-6);
    let load = 2.0 * 9.81 * 0.5 * f64::sin(aim);
    let torque = Drive::Torque(Profile::Line { from: load, to: load, duration: 1.0 });
    let both = run(pendulum(9.81), (aim, 0.0), only(Drive::Sum(vec![torque, pd()])), 3.0);
    for frame in 0..=300 {
        assert_abs_diff_eq!(both.motion.q(frame)[0], aim, epsilon = 1e-12);
    }
    assert_eq!(both.report.outcomes[0].drive, "sum");
}

/// Two servos on a double pendulum, by the stiff method and by a fixed step: the same motion, its energy balanced.
#[cfg(feature = "stiff")]
#[test]
fn the_stiff_method_has_its_derivatives() {
    use solaris_modes::{Method, Rule};

    let figure = super::double_pendulum();
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    simulation.drive("upper_hinge", [servo(Aim::At(0.8), 3e4, 60.0, None)]).expect("valid");
    simulation.drive("lower_hinge", [servo(Aim::At(-0.5), 2e3, 10.0, Some(200.0))]).expect("valid");
    let by = |method| {
        let settings = Settings { method, estimate: false, ..Settings::new(0.5, 100.0) };
        simulation.run(&settings).expect("runs")
    };
    let stiff = by(Method::Stiff { tolerance: 1e-10 });
    let fixed = by(Method::Fixed { rule: Rule::RungeKutta4, step: 2e-5 });
    for frame in 0..=50 {
        for dof in 0..2 {
            assert_abs_diff_eq!(stiff.motion.q(frame)[dof], fixed.motion.q(frame)[dof], epsilon = 1e-6);
        }
    }
    assert!(imbalance(&stiff) < 1e-5 && imbalance(&fixed) < 1e-6);
}

/// `ẍ = −(k/m)·x − (d/m)·ẋ` has the eigenvalue −d/m nearly, where `d² ≫ 4·k·m`: 2.785 of it is the longest step of the rule.
#[test]
fn its_stiffness_bounds_the_step_even_where_it_begins_later() {
    let stiff = || servo(Aim::At(0.0), 10.0, 2e4, None);
    for steps in [
        vec![stiff().into()],
        vec![Step { drive: Drive::Free, until: EndCondition::Lasting(0.1) }, stiff().into()],
    ] {
        let mut simulation = slider();
        simulation.drive("slide", steps).expect("valid");
        let failed = simulation.run(&settings(1.0, 100.0, 1e-3)).expect_err("a step that is too long");
        let RunError::Failed(failure) = failed else { panic!("{failed}") };
        let FailureKind::StepTooLong { longest, eigenvalue, .. } = failure.cause else { panic!("{failure}") };
        assert_abs_diff_eq!(eigenvalue, -1e4, epsilon = 1.0);
        assert!((2.7e-4..2.9e-4).contains(&longest), "{longest}");
        // The automatic choice finds its way.
        let found = simulation.run(&Settings::new(0.2, 100.0)).expect("finds a step");
        assert!(found.report.error.expect("an estimate").position <= 1e-6);
    }
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let mut simulation = slider();
    for (drive, said) in [
        (
            servo(Aim::At(f64::NAN), 1.0, 1.0, None),
            "the aim of the servo of 'slide.tx' is NaN; it must be a finite number",
        ),
        (
            servo(Aim::At(0.0), -1.0, 1.0, None),
            "the stiffness of the servo of 'slide.tx' is -1; it must be a finite number, zero or more",
        ),
        (
            servo(Aim::At(0.0), 1.0, f64::INFINITY, None),
            "the damping of the servo of 'slide.tx' is inf; it must be a finite number, zero or more",
        ),
        (
            servo(Aim::At(0.0), 1.0, 1.0, Some(0.0)),
            "the greatest force of the servo of 'slide.tx' is 0; it must be a finite number above zero",
        ),
        (
            Drive::Sum(vec![Drive::Frozen]),
            "the sum of forces of 'slide.tx' has the drive 'frozen' in it, which is none; it can be of torques and servos",
        ),
    ] {
        assert_eq!(simulation.drive("slide", [drive]).expect_err("refused").to_string(), said);
    }
    let ball = FigureBuilder::new("b").link(LinkSpec::root("a", Joint::ball("hip")).mass(1.0));
    let mut ball = Simulation::new(&ball.build().expect("valid"), Vector3::zeros());
    let refused = ball.drive("hip", [servo(Aim::At(0.0), 1.0, 1.0, None)]).expect_err("no coordinate");
    assert!(matches!(refused, SetupError::NoSuchDrive { drive: "servo", .. }), "{refused}");
}
