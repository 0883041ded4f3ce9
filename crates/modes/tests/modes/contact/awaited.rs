//! What waits for a link to come to the ground or to leave it.

use crate::contact::planted::ground;
use crate::contact::{G, at, floor};
use approx::assert_abs_diff_eq;
use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, Vector3};
use solaris_modes::{
    ContactLaw, Drive, EndCondition, GroundPlane, Method, Part, Rule, Run, Settings, SetupError, Shape,
    Simulation, Step,
};
use solaris_profiles::Profile;

/// A ball of 2 kg that moves up and down, and a flag on a rail beside it.
fn ball_and_flag() -> Figure {
    FigureBuilder::new("scene")
        .link(LinkSpec::root("place", Joint::new("bed")))
        .link(LinkSpec::child("ball", "place", Joint::new("flight").ty()).mass(2.0))
        .link(LinkSpec::child("flag", "place", Joint::new("rail").tx()).mass(1.0))
        .build()
        .expect("valid")
}

const RADIUS: f64 = 0.1;

fn simulation(plane: GroundPlane, height: f64) -> Simulation {
    let figure = ball_and_flag();
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, -G, 0.0));
    let touch = solaris_modes::ContactPoint { link: 1, ..at(Vector3::zeros(), RADIUS) };
    simulation.set_ground(plane, vec![touch]).expect("valid");
    simulation.set_start(&[height, 0.0], &[0.0, 0.0]).expect("valid");
    simulation
}

const METHODS: [Method; 4] = [
    Method::Fixed { rule: Rule::RungeKutta4, step: 1e-3 },
    Method::Adaptive { tolerance: 1e-9 },
    Method::Impulses { step: 1e-3 },
    Method::Usual,
];

fn run(simulation: &Simulation, method: Method, duration: f64) -> Run {
    let settings = Settings { method, estimate: false, ..Settings::new(duration, 100.0) };
    simulation.run(&settings).unwrap_or_else(|error| panic!("{method:?}: {error}"))
}

fn wave() -> Step {
    Drive::Move { to: 1.0, over: 0.1, along: Shape::MinimumJerk }.into()
}

fn until(drive: Drive, link: &str, comes_down: bool) -> Step {
    let link = link.to_owned();
    let until = if comes_down { EndCondition::TouchDown { link } } else { EndCondition::LiftOff { link } };
    Step { drive, until }
}

/// When the move of the flag began (s).
fn waved(run: &Run) -> f64 {
    let moved = run.report.outcomes.iter().filter(|outcome| outcome.name == "rail.tx");
    moved.map(|outcome| outcome.start).next_back().expect("it has moved")
}

/// `t = √(2(h − r)/g)`, whatever the ground is made of.
#[test]
fn a_drive_begins_as_a_ball_comes_down() {
    let height = 1.0;
    let expected = (2.0 * (height - RADIUS) / G).sqrt();
    for law in [ContactLaw::Rigid, ContactLaw::Compliant { stiffness: 1e5, damping: 1.0, slip: 0.01 }] {
        for method in METHODS {
            let mut simulation = simulation(GroundPlane { law, ..floor(0.5, 1e4, 1.0, 0.01) }, height);
            simulation.drive("rail", [until(Drive::Frozen, "ball", true), wave()]).expect("valid");
            let found = waved(&run(&simulation, method, 1.0));
            // Impulses are of order one.
            let off = if matches!(method, Method::Impulses { .. }) { 1e-3 } else { 1e-6 };
            assert_abs_diff_eq!(found, expected, epsilon = off);
        }
    }
}

/// A force that grows lifts it when it is the weight: `F = 4·m·g·t`, and what is waited for is a micrometre above the ground. That it left is no
/// coming down, which is waited for next.
#[test]
fn a_part_begins_as_a_ball_leaves_and_the_next_as_it_comes_back() {
    let weight = 2.0 * G;
    let leaves = 0.25;
    let late = (6e-6 / (4.0 * G)).cbrt();
    for method in METHODS {
        let mut simulation = simulation(ground(0.5), RADIUS);
        let lift = Profile::Line { from: 0.0, to: 4.0 * weight, duration: 1.0 };
        let pull = Step { drive: Drive::Torque(lift), until: EndCondition::Time(0.5) };
        simulation.drive("flight", [pull, Drive::Free.into()]).expect("valid");
        let part = |to| {
            let step = Drive::Move { to, over: 0.02, along: Shape::MinimumJerk }.into();
            Part::Together(vec![("rail".to_owned(), vec![step])])
        };
        let waits = |comes_down| Part::Until(until(Drive::Frozen, "ball", comes_down).until);
        simulation.sequence(vec![waits(false), part(1.0), waits(true), part(0.0)]).expect("valid");
        let found = run(&simulation, method, 1.5);
        let starts: Vec<f64> = found
            .report
            .outcomes
            .iter()
            .filter(|outcome| outcome.name == "rail.tx" && outcome.drive == "move")
            .map(|outcome| outcome.start)
            .collect();
        let [first, second] = starts[..] else { panic!("{method:?}: {:?}", found.report.outcomes) };
        let step = if matches!(method, Method::Impulses { .. }) { 2e-3 } else { 2e-4 };
        assert_abs_diff_eq!(first, leaves + late, epsilon = step);
        // At half a second, with a = 4g·(t − ¼): v = ⅛g and y = g/96; then it falls.
        let (v, y) = (G / 8.0, G / 96.0);
        let back = 0.5 + (v + (v * v + 2.0 * G * y).sqrt()) / G;
        assert_abs_diff_eq!(second, back, epsilon = step);
    }
}

#[test]
fn what_never_touches_is_not_waited_for() {
    let figure = ball_and_flag();
    let mut bare = Simulation::new(&figure, Vector3::new(0.0, -G, 0.0));
    let nobody = bare.drive("rail", [until(Drive::Frozen, "bell", true)]).expect_err("no such link");
    assert_eq!(nobody.to_string(), "figure 'scene' has no link 'bell'; did you mean 'ball'?");
    bare.drive("rail", [until(Drive::Frozen, "ball", true)]).expect("a link");
    let error = bare.run(&Settings::new(0.1, 10.0)).expect_err("there is no ground").to_string();
    assert!(error.contains("waits for 'ball'") && error.contains("lay a ground"), "{error}");
    let mut flag = simulation(ground(0.5), 1.0);
    flag.sequence(vec![Part::Until(EndCondition::LiftOff { link: "flag".to_owned() })]).expect("a link");
    let error = flag.run(&Settings::new(0.1, 10.0)).expect_err("the flag touches nothing");
    assert!(error.to_string().contains("'flag'"), "{error}");
    let part = Part::Until(EndCondition::TouchDown { link: "bell".to_owned() });
    assert!(matches!(flag.sequence(vec![part]), Err(SetupError::UnknownLink { .. })));
    let part = Part::Until(EndCondition::Position { dof: "bell".to_owned(), value: 0.0 });
    assert!(matches!(flag.sequence(vec![part]), Err(SetupError::UnknownDof { .. })));
}

/// What nothing but a curve moves comes down on nothing: it goes through the ground, and nobody is told.
#[test]
fn what_follows_a_curve_is_not_seen() {
    let mut simulation = simulation(ground(0.5), 1.0);
    let down = Drive::Move { to: -0.5, over: 0.5, along: Shape::MinimumJerk };
    simulation.drive("flight", [down]).expect("valid");
    simulation.drive("rail", [until(Drive::Frozen, "ball", true), wave()]).expect("valid");
    let run = run(&simulation, Method::Usual, 1.0);
    assert!(run.motion.q(100)[1].abs() < 1e-12);
}
