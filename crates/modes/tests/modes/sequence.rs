//! Parts of a sequence over several degrees of freedom: when each begins and ends.

use approx::assert_abs_diff_eq;
use solaris_model::{EventKind, FigureBuilder, Joint, LinkSpec, Vector3};
use solaris_modes::{
    Aim, Course, Drive, EndCondition, Method, OutcomeKind, Part, Rule, Run, Servo, Settings, Shape,
    Simulation, Step, Target,
};

/// Blocks of 1 kg on a rail, without weight.
fn blocks() -> Simulation {
    let block =
        |name: &str| LinkSpec::child(name, "rail", Joint::new(format!("{name}_slide")).tx()).mass(1.0);
    let figure = FigureBuilder::new("blocks")
        .link(LinkSpec::root("rail", Joint::new("bed")))
        .link(block("a"))
        .link(block("b"))
        .link(block("c"))
        .build()
        .expect("valid");
    Simulation::new(&figure, Vector3::zeros())
}

fn run(simulation: &Simulation, duration: f64) -> Run {
    let method = Method::Fixed { rule: Rule::RungeKutta4, step: 1e-2 };
    simulation.run(&Settings { method, estimate: false, ..Settings::new(duration, 100.0) }).expect("runs")
}

fn to(to: f64, over: f64) -> Step {
    Drive::Move { to, over, along: Shape::MinimumJerk }.into()
}

fn of(name: &str, steps: Vec<Step>) -> (String, Vec<Step>) {
    (format!("{name}_slide"), steps)
}

/// When each drive began, by name of the degree of freedom.
fn starts(run: &Run, name: &str) -> Vec<f64> {
    let own = run.report.outcomes.iter().filter(|outcome| outcome.name == format!("{name}_slide.tx"));
    own.map(|outcome| outcome.start).collect()
}

#[test]
fn a_part_begins_when_all_of_the_one_before_is_done() {
    let mut simulation = blocks();
    simulation
        .sequence(vec![
            Part::Together(vec![of("a", vec![to(1.0, 0.3), to(0.5, 0.2)]), of("b", vec![to(1.0, 0.8)])]),
            Part::Until(EndCondition::Lasting(0.25)),
            Part::Together(vec![of("a", vec![to(0.0, 0.4)]), of("c", vec![to(1.0, 0.1)])]),
            Part::Together(vec![of("b", vec![to(0.0, 0.5)])]),
        ])
        .expect("valid");
    let run = run(&simulation, 3.0);
    let near = |found: Vec<f64>, expected: &[f64]| {
        assert_eq!(found.len(), expected.len(), "{found:?}");
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?}");
    };
    near(starts(&run, "a"), &[0.0, 0.3, 1.05]);
    near(starts(&run, "b"), &[0.0, 1.45]);
    // It stands until its part comes.
    near(starts(&run, "c"), &[0.0, 1.05]);
    assert!(
        run.report.outcomes.iter().all(|x| [OutcomeKind::Reached, OutcomeKind::Ended].contains(&x.result))
    );
    assert_abs_diff_eq!(run.motion.q(300)[1], 0.0, epsilon = 1e-12);
}

/// A target-angle drive of 1 m at 2 m/s² takes 1 s, which is known only in the run; a block that is thrown passes 0.6 m at 0.3 s.
#[test]
fn what_only_the_run_knows_is_waited_for() {
    let mut simulation = blocks();
    simulation.set_start(&[0.0; 3], &[0.0, 0.0, 2.0]).expect("valid");
    simulation.drive("c_slide", [Drive::Free]).expect("valid");
    let target = Target { position: 1.0, velocity: 0.0, acceleration: 2.0 };
    let passes = EndCondition::Position { dof: "c_slide".to_owned(), value: 2.6 };
    simulation
        .sequence(vec![
            Part::Together(vec![of("a", vec![Drive::Simple { target, course: Course::TargetAngle }.into()])]),
            Part::Until(passes),
            Part::Together(vec![of("b", vec![to(1.0, 0.5)])]),
        ])
        .expect("valid");
    let run = run(&simulation, 2.0);
    assert_abs_diff_eq!(starts(&run, "b")[1], 1.3, epsilon = 1e-9);
    let changes =
        run.motion.events.iter().filter(|event| matches!(event.kind, EventKind::DriveChange { .. }));
    assert!(changes.count() >= 2);
}

/// A servo without an end goes on through the parts that do not name it, until one does.
#[test]
fn what_has_no_end_goes_on_until_it_is_named() {
    let servo = |at| Drive::Servo(Servo { aim: Aim::At(at), stiffness: 400.0, damping: 40.0, limit: None });
    let mut simulation = blocks();
    simulation
        .sequence(vec![
            Part::Together(vec![of("a", vec![servo(1.0).into()]), of("b", vec![to(1.0, 0.5)])]),
            Part::Together(vec![of("b", vec![to(0.0, 0.5)])]),
            Part::Together(vec![of("a", vec![servo(0.0).into()])]),
        ])
        .expect("valid");
    let run = run(&simulation, 3.0);
    // Critically damped at 20 1/s: x = 1 − (1 + 20·t)·e^(−20·t).
    for frame in [10, 50, 60, 99] {
        let t = 20.0 * frame as f64 / 100.0;
        assert_abs_diff_eq!(run.motion.q(frame)[0], 1.0 - (1.0 + t) * (-t).exp(), epsilon = 1e-5);
    }
    assert_abs_diff_eq!(run.motion.q(300)[0], 0.0, epsilon = 1e-6);
    let refused = blocks().sequence(vec![
        Part::Together(vec![of("a", vec![servo(1.0).into()])]),
        Part::Together(vec![of("b", vec![to(1.0, 0.5)])]),
    ]);
    assert_eq!(
        refused.expect_err("nothing ends").to_string(),
        "part 1 of the sequence never is over, so that nothing comes after it: let something in it come to an end, or wait for a \
         time or an event"
    );
}

/// Step by step, as whoever calls asks, it is the run with frames at these times, to the bit: servos, loads, pushes and parts.
#[test]
fn step_by_step_it_is_the_same_run() {
    use solaris_model::Load;
    use solaris_modes::time::Stepping;
    use solaris_modes::{Carry, Push, PushLaw};

    let mut simulation = blocks();
    let servo = Drive::Servo(Servo { aim: Aim::At(1.0), stiffness: 40.0, damping: 4.0, limit: Some(15.0) });
    simulation
        .sequence(vec![
            Part::Together(vec![of("a", vec![servo.into()]), of("b", vec![to(1.0, 0.33)])]),
            Part::Together(vec![of("b", vec![to(0.0, 0.4)]), of("c", vec![Drive::Free.into()])]),
        ])
        .expect("valid");
    let at = |law| Push { link: 1, point: Vector3::zeros(), from: 0.21, law };
    simulation.add_push(at(PushLaw::Force { force: Vector3::x() * 7.0, over: 0.1 })).expect("valid");
    simulation.add_push(at(PushLaw::Impulse { impulse: Vector3::x(), over: 0.0 })).expect("valid");
    let load = Load { link: 1, at: Vector3::zeros(), mass: 2.0, inertia: nalgebra::Matrix3::zeros() };
    simulation.add_carry(Carry { load, from: 0.57, until: 0.83 }).expect("valid");
    let whole = run(&simulation, 1.5);
    let mut running =
        simulation.start(Stepping::Fixed { rule: Rule::RungeKutta4, step: 1e-2 }).expect("begins");
    for frame in 1..=150 {
        running.advance_to(whole.motion.time()[frame]).expect("goes on");
        for dof in 0..3 {
            assert_eq!(running.q()[dof].to_bits(), whole.motion.q(frame)[dof].to_bits(), "frame {frame}");
        }
    }
    // Other drives take one out of the sequence, and what is left of it goes on.
    let mut other =
        simulation.start(Stepping::Fixed { rule: Rule::RungeKutta4, step: 1e-2 }).expect("begins");
    other.step(0.1).expect("goes on");
    other.drive("b_slide", [Drive::Frozen]).expect("valid");
    other.step(1.0).expect("goes on");
    assert!((other.q()[1] - other.simulation().state().0[1]).abs() < 0.3);
}
