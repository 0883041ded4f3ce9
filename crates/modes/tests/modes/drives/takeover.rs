//! When one drive takes over from another, and what limits do where nothing presses: cases that went wrong once.

use solaris_model::{Curve, EventKind, FigureBuilder, Joint, LinkSpec, Vector3};
use solaris_modes::{
    Course, Drive, EndCondition, LimitLaw, Method, OutcomeKind, Rule, Run, Settings, Shape, Simulation, Step,
    Target,
};
use solaris_profiles::Profile;

/// A block of 2 kg on a slide from 0 to 5 m, without weight.
fn block() -> Simulation {
    let joint = Joint::new("slide").tx().limited(0.0, 5.0);
    let figure =
        FigureBuilder::new("block").link(LinkSpec::root("block", joint).mass(2.0)).build().expect("valid");
    Simulation::new(&figure, Vector3::zeros())
}

fn run(simulation: &Simulation, duration: f64) -> Run {
    simulation.run(&Settings::new(duration, 100.0)).expect("it comes to the end")
}

fn until(drive: Drive, until: EndCondition) -> Step {
    Step { drive, until }
}

fn line(from: f64, to: f64, duration: f64) -> Profile {
    Profile::Line { from, to, duration }
}

#[test]
fn a_limit_holds_what_starts_at_it_without_any_acceleration() {
    for sign in [-1.0, 1.0] {
        let mut simulation = block();
        let limit = if sign < 0.0 { 0.0 } else { 5.0 };
        simulation.set_start(&[limit], &[0.0]).expect("a state");
        // The force is zero at first.
        simulation.drive("slide", [Drive::Torque(line(0.0, 80.0 * sign, 1.0))]).expect("a drive");
        let run = run(&simulation, 1.0);
        for frame in 0..run.motion.len() {
            assert!((run.motion.q(frame)[0] - limit).abs() < 1e-9, "{sign}: {:?}", run.motion.q(frame));
        }
    }
}

#[test]
fn a_limit_does_not_pull_what_is_led_away_from_it() {
    let mut simulation = block();
    simulation.drive("slide", [Drive::Torque(line(0.0, 4.0, 1.0))]).expect("a drive");
    let run = run(&simulation, 1.0);
    // x = F′·t³/(6·m)
    assert!((run.motion.q(100)[0] - 4.0 / 12.0).abs() < 1e-6, "{:?}", run.motion.q(100));
}

#[test]
fn drives_that_are_over_at_once_give_way_at_once() {
    let over = |first: Step| {
        let mut simulation = block();
        simulation.set_start(&[1.0], &[0.0]).expect("a state");
        let next = Step::from(Drive::Move { to: 2.0, over: 0.5, along: solaris_modes::Shape::MinimumJerk });
        simulation.drive("slide", [first, next]).expect("drives");
        run(&simulation, 1.0).motion.q(50)[0]
    };
    for first in [
        until(Drive::Frozen, EndCondition::Lasting(0.0)),
        until(Drive::Free, EndCondition::Time(0.0)),
        until(Drive::Free, EndCondition::Lasting(0.0)),
    ] {
        assert!((over(first) - 2.0).abs() < 1e-9);
    }
    // A time that is past when the drive begins.
    let mut simulation = block();
    simulation.set_start(&[1.0], &[0.0]).expect("a state");
    let go = |to| Drive::Move { to, over: 0.4, along: solaris_modes::Shape::Cubic };
    simulation
        .drive("slide", [go(2.0).into(), until(Drive::Free, EndCondition::Time(0.2)), go(3.0).into()])
        .expect("drives");
    assert!((run(&simulation, 1.0).motion.q(90)[0] - 3.0).abs() < 1e-9);
}

#[test]
fn a_torque_goes_on_as_it_ended_until_the_next_drive() {
    let mut simulation = block();
    let torque = Drive::Torque(line(4.0, 4.0, 0.1));
    simulation
        .drive("slide", [until(torque, EndCondition::Lasting(1.0)), Drive::Free.into()])
        .expect("drives");
    let run = run(&simulation, 1.0);
    // 2 m/s² for a second.
    assert!((run.motion.q(100)[0] - 1.0).abs() < 1e-9, "{:?}", run.motion.q(100));
    assert!(run.report.impacts.is_empty(), "{:?}", run.report.impacts);
}

#[test]
fn an_impact_that_leaps_over_a_velocity_has_passed_it() {
    let mut simulation = block();
    simulation.set_limits(LimitLaw::Hard { restitution: 0.5 }).expect("a law");
    simulation.set_start(&[1.0], &[-2.0]).expect("a state");
    let turned = EndCondition::Velocity { dof: "slide".to_owned(), value: 0.0 };
    simulation.drive("slide", [until(Drive::Free, turned), Drive::Frozen.into()]).expect("drives");
    let method = Method::Fixed { rule: Rule::RungeKutta4, step: 0.01 };
    let settings = Settings { method, estimate: false, ..Settings::new(1.0, 100.0) };
    let run = simulation.run(&settings).expect("it comes to the end");
    assert_eq!(run.report.outcomes.last().map(|outcome| outcome.result), Some(OutcomeKind::Ended));
    assert!(run.motion.q(100)[0].abs() < 1e-9 && run.motion.v(100)[0].abs() < 1e-12);
    assert_eq!(run.report.cost.counts.events, 1);
}

#[test]
fn what_only_lies_at_a_limit_has_not_hit_it() {
    let mut simulation = block();
    simulation.set_start(&[5.0], &[-1.0]).expect("a state");
    let run = run(&simulation, 1.0);
    assert!(run.report.outcomes.is_empty(), "{:?}", run.report.outcomes);
    assert!((run.motion.q(100)[0] - 4.0).abs() < 1e-9);
}

#[test]
fn a_step_longer_than_a_frame_is_a_frame() {
    let mut simulation = block();
    simulation.set_start(&[1.0], &[0.1]).expect("a state");
    let anchor = |link, x| solaris_modes::Anchor { link, point: Vector3::new(x, 0.0, 0.0) };
    let between = [anchor(Some(0), 0.0), anchor(None, 3.0)];
    // 50 1/s: a tenth of a second would be unstable, a frame is not.
    let spring = solaris_modes::PointSpring { between, stiffness: 5000.0, damping: 0.0, rest: 2.0 };
    simulation.add_spring(spring).expect("a spring");
    let method = Method::Fixed { rule: Rule::RungeKutta4, step: 0.1 };
    let run = simulation.run(&Settings { method, ..Settings::new(1.0, 100.0) }).expect("stable");
    assert!(run.report.method.contains("1.000e-2"), "{}", run.report.method);
}

#[test]
fn what_follows_a_leader_is_stopped_with_it() {
    // y = 2·x carries a mass that can go on along y.
    let cart = LinkSpec::root("cart", Joint::new("x").tx()).mass(1.0);
    let rail = Joint::new("y").ty().following("x.tx", Curve::linear(2.0, 0.0));
    let lift = LinkSpec::child("lift", "cart", rail).mass(1.0);
    let bob = LinkSpec::child("bob", "lift", Joint::new("on").ty()).mass(1.0);
    let figure = FigureBuilder::new("lift").link(cart).link(lift).link(bob).build().expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    simulation.set_start(&[0.0; 3], &[1.0, 2.0, 0.0]).expect("a state");
    simulation.drive("x", [Drive::Kinematic(line(0.0, 0.5, 0.5))]).expect("a drive");
    let run = run(&simulation, 1.0);
    // The lift stops; what lies on it keeps its 2 m/s upwards.
    assert!((run.motion.v(100)[2] - 2.0).abs() < 1e-9, "{:?}", run.motion.v(100));
}

/// A cart, and a lift on it that follows: y = 2·x.
fn lift() -> Simulation {
    let cart = LinkSpec::root("cart", Joint::new("x").tx()).mass(1.0);
    let rail = Joint::new("y").ty().following("x.tx", Curve::linear(2.0, 0.0));
    let lift = LinkSpec::child("lift", "cart", rail).mass(1.0);
    let figure = FigureBuilder::new("lift").link(cart).link(lift).build().expect("valid");
    Simulation::new(&figure, Vector3::zeros())
}

#[test]
fn what_follows_has_no_drive_of_its_own() {
    let mut simulation = lift();
    let refused = simulation.drive("y", [Drive::Frozen]).expect_err("a follower");
    assert_eq!(refused.to_string(), "'y.ty' follows 'x.tx' and has no drive of its own; drive 'x.tx'");
    simulation.drive("x", [Drive::Frozen]).expect("its leader has");
}

#[test]
fn what_does_not_begin_or_end_is_said() {
    let mut simulation = block();
    let over = |drive: Drive, time| until(drive, EndCondition::Lasting(time));
    // Nothing pushes the block, so that the target gives no acceleration: the next drive comes at once.
    let target = Drive::Simple { target: Target::at(0.0), course: Course::BangBang };
    simulation.set_start(&[1.0], &[0.0]).expect("a state");
    let steps = [target.into(), over(Drive::Frozen, 0.5), over(Drive::Free, 2.0), Drive::Frozen.into()];
    simulation.drive("slide", steps).expect("drives");
    let run = run(&simulation, 1.0);
    let told: Vec<(&str, OutcomeKind, f64)> =
        run.report.outcomes.iter().map(|it| (it.drive, it.result, it.end)).collect();
    assert_eq!(
        told,
        [
            ("accelerate-decelerate (i)", OutcomeKind::NoMotion, 0.0),
            ("frozen", OutcomeKind::Ended, 0.5),
            ("free", OutcomeKind::Unfinished, 1.0),
            ("frozen", OutcomeKind::NotBegun, 1.0),
        ]
    );
    let changes: Vec<(f64, String)> = run
        .motion
        .events
        .iter()
        .filter_map(|event| match &event.kind {
            EventKind::DriveChange { what } => Some((event.time, what.clone())),
            _ => None,
        })
        .collect();
    assert_eq!(
        changes,
        [
            (0.0, "slide.tx: accelerate-decelerate (i) -> frozen".to_owned()),
            (0.5, "slide.tx: frozen -> free".to_owned())
        ]
    );
}

#[test]
fn a_check_refuses_what_a_run_refuses_at_the_beginning() {
    let settings = Settings::new(1.0, 100.0);
    let mut simulation = block();
    simulation.check(&settings).expect("it can be run");
    simulation.drive("slide", [Drive::Kinematic(line(1.0, 2.0, 1.0))]).expect("a drive");
    let refused = simulation.check(&settings).expect_err("the curve begins elsewhere");
    assert_eq!(Err(refused), simulation.run(&settings).map(|_| ()));
    let method = Method::Fixed { rule: Rule::RungeKutta4, step: 1e-9 };
    let refused = block().check(&Settings { method, ..settings.clone() }).expect_err("too much work");
    assert!(refused.to_string().contains("evaluations"), "{refused}");
    let method = Method::Stiff { tolerance: 1e-6 };
    let stiff = block().check(&Settings { method, ..settings });
    assert_eq!(stiff.is_ok(), cfg!(feature = "stiff"));
}

/// Moves of 0.3 s and 0.2 s, to and fro without end: after any number of rounds it is where one round is.
#[test]
fn what_comes_again_goes_round_and_what_takes_no_time_is_refused() {
    let to = |to: f64, over: f64| Step::from(Drive::Move { to, over, along: Shape::MinimumJerk });
    let mut simulation = super::slider();
    simulation.drive_again("slide", [to(0.5, 0.25), to(1.0, 0.3), to(0.0, 0.2)], 1).expect("valid");
    let run = simulation.run(&super::settings(5.0, 100.0, 1e-2)).expect("runs");
    for frame in 80..450 {
        assert!((run.motion.q(frame)[0] - run.motion.q(frame + 50)[0]).abs() < 1e-12, "frame {frame}");
    }
    assert!((run.motion.q(55)[0] - 1.0).abs() < 1e-12);
    assert!(run.report.outcomes.iter().all(|outcome| outcome.result != OutcomeKind::NotBegun));
    let none = Step { drive: Drive::Frozen, until: EndCondition::Lasting(0.0) };
    simulation.drive_again("slide", [to(0.5, 0.25), none], 1).expect("valid");
    let refused =
        simulation.run(&super::settings(1.0, 100.0, 1e-2)).expect_err("no time goes on").to_string();
    assert_eq!(
        refused,
        "what drives slide.tx is over and begins again, with 'frozen', without any time going on at t = 0.25 s: let one of the \
         drives that come again take time"
    );
    let beyond =
        simulation.drive_again("slide", [to(0.5, 0.25)], 1).expect_err("there is only one").to_string();
    assert_eq!(
        beyond,
        "the drive of 'slide' that comes again is 1; it must be the index of one of its drives"
    );
}
