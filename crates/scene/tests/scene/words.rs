//! The words of a scene that lead, repeat, push and carry, against closed forms.

use crate::fixtures::fixture;
use approx::assert_abs_diff_eq;
use solaris_model::{Figure, Known, Motion, MotionInfo, Vector3};
use solaris_modes::OutcomeKind;
use solaris_scene::{Loader, Simulated, read};
use std::f64::consts::{FRAC_PI_2, TAU};

fn simulated(name: &str) -> Simulated {
    fixture(name).simulate(&mut ()).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Index in `v`, and in `q` where no joint is a ball, of a name of a fixture.
fn dof(name: &str, of: &str) -> usize {
    fixture(of).figure().layout().dof_index(name).expect("a dof")
}

/// `τ = m·g·l·sin q`, 2 kg at 0.25 m.
fn load(angle: f64) -> f64 {
    2.0 * 9.806_65 * 0.25 * angle.sin()
}

#[test]
fn servos_come_to_rest_where_their_springs_carry_the_load() {
    let run = simulated("servos.ron");
    let last = run.motion.len() - 1;
    let at = |name: &str| run.motion.q(last)[dof(name, "servos.ron")];
    let aim = 60_f64.to_radians();
    // What is left of the swing after 3 s is some tenths of a degree.
    assert_abs_diff_eq!(60.0 * (aim - at("placed")), load(at("placed")), epsilon = 0.35);
    // Half of 2·2/(m·g·l) of an undamped weak motor's swing; its force is at its limit all the time.
    let outcome = |name: &str| {
        let found = run.report.outcomes.iter().find(|outcome| outcome.name == name);
        found.expect("an outcome").result
    };
    assert_eq!(outcome("weak"), OutcomeKind::LimitedByTorque);
    assert_eq!(outcome("placed"), OutcomeKind::Missed);
    for frame in [0, 150, 300] {
        let carried = dof("carried", "servos.ron");
        assert_abs_diff_eq!(run.motion.q(frame)[carried], 40_f64.to_radians(), epsilon = 1e-7);
        assert_abs_diff_eq!(
            run.motion.tau(frame).expect("forces")[carried],
            load(40_f64.to_radians()),
            epsilon = 1e-5
        );
    }
    // The weak one moves by 2 N m alone: ½·I·q̇² = 2·q − m·g·l·(1 − cos q), I = that of its capsule about the pivot.
    let weak = dof("weak", "servos.ron");
    let inertia = {
        let simulation = fixture("servos.ron");
        let link = &simulation.figure().links()[simulation.figure().link_index("weak").expect("a link")];
        link.inertia()[(0, 0)] + 2.0 * 0.25 * 0.25
    };
    for frame in [40, 90, 200, 300] {
        let (q, v) = (run.motion.q(frame)[weak], run.motion.v(frame)[weak]);
        let work = 2.0 * q - 2.0 * 9.806_65 * 0.25 * (1.0 - q.cos());
        assert_abs_diff_eq!(0.5 * inertia * v * v, work, epsilon = 1e-5);
    }
    assert!(run.report.energy.imbalance < 1e-4 * run.report.energy.scale);
}

#[test]
fn what_comes_again_is_where_closed_forms_say() {
    let run = simulated("again.ron");
    let at = |frame: usize, name: &str| run.motion.q(frame)[dof(name, "again.ron")];
    for frame in 0..run.motion.len() {
        let t = frame as f64 / 100.0;
        assert_abs_diff_eq!(at(frame, "swings"), 0.2 * (TAU * t / 1.6 + FRAC_PI_2).sin(), epsilon = 1e-12);
        let omega = TAU / 0.8;
        let drift = 3.0 / (2.0 * omega) * t - 3.0 / (2.0 * omega * omega) * (omega * t).sin();
        assert_abs_diff_eq!(at(frame, "pushed"), drift, epsilon = 1e-6);
    }
    // A round of the shuttle takes 1.3 s: it is as it was a round ago, and stands at its ends in time.
    for frame in 131..run.motion.len() {
        assert_abs_diff_eq!(at(frame, "shuttles"), at(frame - 130, "shuttles"), epsilon = 1e-10);
    }
    assert_abs_diff_eq!(at(180, "shuttles"), 0.4, epsilon = 1e-12);
    // One blow is 8·0.25/2 N s on 2 kg in its quarter of a second: its way is ∫∫ of a quintic from 8 to 0 N, 8/2·T²·(1/2 − 1/7).
    let way = 4.0 * 0.25_f64.powi(2) * (0.5 - 1.0 / 7.0);
    for blow in 1..=3 {
        let frame = 75 * (blow - 1) + 25;
        assert_abs_diff_eq!(at(frame, "knocks"), blow as f64 * way, epsilon = 1e-6);
    }
    assert!(
        run.report
            .outcomes
            .iter()
            .all(|outcome| outcome.name != "swings" || outcome.result == OutcomeKind::Reached)
    );
}

#[test]
fn pushes_give_their_impulse_and_its_moment() {
    let run = simulated("pushed.ron");
    // Of 4 kg: 10 N for 0.1 s along z, 0.6 N s along y, ∫ 2·sin over half of 1 s along x; the last is on the slab's origin.
    let last = run.motion.len() - 1;
    let q = run.motion.q(last);
    let v = &run.motion.v(last)[..3];
    let turned = nalgebra::UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(q[6], q[3], q[4], q[5]));
    let world = turned * nalgebra::Vector3::new(v[0], v[1], v[2]);
    // Of a slab with a block at its centre all forces but the first go through the centre.
    for (found, impulse) in world.iter().zip([2.0 / std::f64::consts::PI, 0.6, 1.0]) {
        assert_abs_diff_eq!(*found, impulse / 4.0, epsilon = 1e-6);
    }
    let energy = &run.report.energy;
    assert_abs_diff_eq!(energy.end.total(), energy.start.total() + energy.pushes, epsilon = 1e-7);
    assert!(energy.pushes > 0.1 && energy.work.abs() < 1e-9);
}

#[test]
fn a_load_that_is_taken_up_shares_the_angular_momentum() {
    let run = simulated("carried.ron");
    let figure = fixture("carried.ron").figure().clone();
    // About its pivot: I + m·l² of the arm, and of 0.5 kg at 0.5 m.
    let arm = &figure.links()[figure.link_index("taker").expect("a link")];
    let alone = arm.inertia()[(0, 0)] + 2.0 * 0.25 * 0.25;
    let load = 0.001 + 0.5 * 0.25;
    let speed = |frame: usize, name: &str| run.motion.v(frame)[dof(name, "carried.ron")];
    let both = 2.0 * alone / (alone + load);
    for (frame, expected) in [(49, 2.0), (50, both), (149, both), (151, both), (200, both)] {
        assert_abs_diff_eq!(speed(frame, "taker"), expected, epsilon = 1e-9);
    }
    assert_abs_diff_eq!(run.report.energy.impacts, 0.5 * alone * 2.0 * (2.0 - both), epsilon = 1e-9);
    // The other one has its load as its own.
    let keeper = &figure.links()[figure.link_index("keeper").expect("a link")];
    assert_abs_diff_eq!(keeper.mass(), 2.5, epsilon = 1e-15);
    let keeper_dof = dof("keeper", "carried.ron");
    for frame in [110, 150, 190] {
        let force = (alone + load) * run.motion.a(frame)[keeper_dof];
        assert_abs_diff_eq!(run.motion.tau(frame).expect("forces")[keeper_dof], force, epsilon = 1e-9);
    }
}

#[test]
fn parts_begin_when_those_before_are_over() {
    let run = simulated("sequence.ron");
    let started = |name: &str, drive: &str| -> Vec<f64> {
        let own = run.report.outcomes.iter().filter(|outcome| outcome.name == name && outcome.drive == drive);
        own.map(|outcome| outcome.start).collect()
    };
    let ended = |name: &str| {
        run.report.outcomes.iter().filter(|x| x.name == name).map(|x| x.end).next().expect("one")
    };
    // The first part lasts as long as the longer of the two: the arm of simple mode takes what one analysis says.
    let first = ended("left").max(ended("right"));
    let left = started("left", "move");
    for (found, expected) in left.iter().zip([0.0, first + 0.3, first + 0.7, 2.5]) {
        assert_abs_diff_eq!(*found, expected, epsilon = 1e-9);
    }
    assert_eq!(left.len(), 4);
    assert_abs_diff_eq!(started("right", "move")[0], 2.5, epsilon = 1e-9);
    let last = run.motion.len() - 1;
    for name in ["left", "right"] {
        assert_abs_diff_eq!(run.motion.q(last)[dof(name, "sequence.ron")], 0.0, epsilon = 1e-12);
    }
}

#[test]
fn two_figures_on_a_spring_swing_about_their_centre_of_mass() {
    let mut scene = fixture("two.ron");
    // A tolerance is one of positions: energy is asked for to 1e-6 of itself below.
    scene.settings_mut().method = solaris_modes::Method::Automatic { tolerance: 1e-8 };
    let run = scene.simulate(&mut ()).expect("runs");
    let layout = fixture("two.ron").figure().layout().clone();
    let x = |frame: usize, name: &str| {
        let q = layout.q_names().iter().position(|known| known == name).expect("a coordinate");
        run.motion.q(frame)[q]
    };
    // r = l₀ + (r₀ − l₀)·cos ωt with ω² = k/μ, μ = 3·1.5/4.5 kg; the one that has turned round counts its way the other way.
    let omega = f64::sqrt(60.0 / 1.0);
    for frame in 0..run.motion.len() {
        let apart = 1.5 - x(frame, "right.root.px") - x(frame, "left.root.px");
        let expected = 1.2 + 0.3 * (omega * frame as f64 / 100.0).cos();
        assert_abs_diff_eq!(apart, expected, epsilon = 1e-5);
        assert_abs_diff_eq!(3.0 * x(frame, "left.root.px"), 1.5 * x(frame, "right.root.px"), epsilon = 1e-6);
    }
    assert!(run.report.energy.imbalance < 1e-6 * run.report.energy.scale);
}

#[test]
fn a_hand_is_where_it_is_to_be_and_what_is_too_far_is_said() {
    let scene = fixture("reach.ron");
    let run = simulated("reach.ron");
    let figure = scene.figure();
    let hand = |side: &str, frame: usize| {
        let tree = solaris_dynamics::Tree::<f64>::new(figure, nalgebra::Vector3::zeros()).expect("a tree");
        let mut workspace = solaris_dynamics::Workspace::new(&tree);
        solaris_dynamics::forward_kinematics(&tree, &mut workspace, run.motion.q(frame)).expect("finite");
        let link = figure.link_index(&format!("{side}_hand")).expect("a hand");
        workspace.pose(link).transform(&nalgebra::Vector3::new(0.0, -0.1, 0.0))
    };
    // Along a straight line with the least jerk, s = 10u³ − 15u⁴ + 6u⁵, and there to the last digits.
    let (begin, end) = (hand("right", 0), nalgebra::Vector3::new(-0.25, 1.35, 0.4));
    for frame in 0..=100 {
        let u = (frame as f64 / 80.0).min(1.0);
        let s = u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
        assert_abs_diff_eq!(hand("right", frame), begin + (end - begin) * s, epsilon = 1e-6);
    }
    assert_abs_diff_eq!(hand("right", 80), end, epsilon = 1e-9);
    for (frame, place) in [(150, (-0.05, 1.35, 0.4)), (200, (-0.05, 1.15, 0.4)), (300, (-0.25, 1.15, 0.4))] {
        let place = nalgebra::Vector3::new(place.0, place.1, place.2);
        assert_abs_diff_eq!(hand("right", frame), place, epsilon = 1e-9);
    }
    // The left arm is stretched towards what is too far away.
    let aim = nalgebra::Vector3::new(0.3, 1.3, 1.2);
    let shoulder = figure.link_index("left_upper_arm").expect("an arm");
    let elbow = figure.links()[figure.link_index("left_forearm").expect("an arm")].joint().placement();
    let wrist = figure.links()[figure.link_index("left_hand").expect("an arm")].joint().placement();
    let length = elbow.translation.vector.norm() + wrist.translation.vector.norm() + 0.1;
    let tree = solaris_dynamics::Tree::<f64>::new(figure, nalgebra::Vector3::zeros()).expect("a tree");
    let mut workspace = solaris_dynamics::Workspace::new(&tree);
    solaris_dynamics::forward_kinematics(&tree, &mut workspace, run.motion.q(300)).expect("finite");
    let from = workspace.pose(shoulder).translation;
    assert_abs_diff_eq!((hand("left", 300) - from).norm(), length, epsilon = 1e-3);
    assert_abs_diff_eq!((hand("left", 300) - aim).norm(), (aim - from).norm() - length, epsilon = 1e-3);
    let said = run.report.remarks.iter().map(ToString::to_string).collect::<Vec<_>>();
    assert!(
        said.iter().any(|said| said.starts_with("'left_hand' cannot reach all of its way: at ")),
        "{said:?}"
    );
    assert_eq!(scene.notes().len(), 1);
}

/// A slide that moves as `x = t² + 0.5·t` for 2 s, in a file that knows positions alone.
struct OneClip;

impl Loader for OneClip {
    fn figure(&mut self, _path: &str) -> Result<Figure, String> {
        Err("no figures".to_owned())
    }

    fn motion(
        &mut self,
        path: &str,
        figure: &Figure,
        gravity: &Vector3<f64>,
        _: &[usize],
    ) -> Result<Motion, String> {
        if path != "slide.csv" {
            return Err("there is no such file".to_owned());
        }
        let times: Vec<f64> = (0..=200).map(|k| f64::from(k) / 100.0).collect();
        let q = times.iter().flat_map(|t| [t * t + 0.5 * t, 0.1]).collect();
        let info = MotionInfo { gravity: *gravity, ..MotionInfo::on_earth(figure, 100.0) };
        let zeros = vec![0.0; 2 * times.len()];
        let known = Known { v: vec![false; 2], a: vec![false; 2] };
        Motion::recorded(figure, info, times, [q, zeros.clone(), zeros], known)
            .map_err(|error| error.to_string())
    }
}

fn clipped(fields: &str) -> Result<solaris_scene::Scene, String> {
    let text = format!(
        r#"Scene(version: 1, duration: 3, rate: 100, gravity: (0, 0, 0), figures: {{"b": Figure(name: "b", links: [
    Link(name: "rail", joint: Joint(name: "bed")),
    Link(name: "one", parent: "rail", joint: Joint(name: "one_slide", axes: [tx(name: "one")]), mass: 2),
    Link(name: "two", parent: "rail", joint: Joint(name: "two_slide", axes: [tx(name: "two")]), mass: 2),
])}}, {fields})"#
    );
    read(&text, &mut OneClip).map_err(|error| error.to_string())
}

#[test]
fn a_clip_is_followed_in_part_and_blended_in() {
    // From 0.5 to 1.5 s of its own time, from the beginning: it begins as it is there, and stands where it ends.
    let scene = clipped("clip: Clip(file: \"slide.csv\", from: 0.5, to: 1.5), drives: {\"two\": Free}")
        .expect("a scene");
    let run = scene.simulate(&mut ()).expect("runs");
    for frame in 0..=100 {
        let t = 0.5 + frame as f64 / 100.0;
        assert_abs_diff_eq!(run.motion.q(frame)[0], t * t + 0.5 * t, epsilon = 1e-6);
        assert_abs_diff_eq!(run.motion.q(frame)[1], 0.0, epsilon = 1e-12);
    }
    assert_abs_diff_eq!(run.motion.q(200)[0], 3.0, epsilon = 1e-6);
    // From 1 s on, from where it stands, in half a second.
    let scene = clipped(
        "start: {\"one\": 0.3}, clip: Clip(file: \"slide.csv\", at: 1.0, blend: 0.5, dofs: [\"one\"])",
    )
    .expect("a scene");
    let run = scene.simulate(&mut ()).expect("runs");
    for frame in 0..=300 {
        let t = frame as f64 / 100.0 - 1.0;
        let u = (t / 0.5).clamp(0.0, 1.0);
        let w = u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
        let expected = 0.3 + w * (t * t + 0.5 * t - 0.3);
        assert_abs_diff_eq!(run.motion.q(frame)[0], expected, epsilon = 1e-5);
    }
    for (fields, said) in [
        ("clip: Clip(file: \"slid.csv\")", "'slid.csv': there is no such file"),
        (
            "clip: Clip(file: \"slide.csv\", from: 5)",
            "'slide.csv': there is nothing of it from 5 to inf s; it goes from 0 to 2 s",
        ),
        ("clip: Clip(fil: \"slide.csv\")", "Clip has no field 'fil'; did you mean 'file'?"),
        (
            "clip: Clip(file: \"slide.csv\", blend: -1)",
            "blend is -1; it must be a finite time, zero or more (s)",
        ),
        (
            "clip: Clip(file: \"slide.csv\", dofs: [\"on\"])",
            "no degree of freedom or joint 'on'; did you mean 'one'?",
        ),
    ] {
        let error = clipped(fields).expect_err("refused");
        assert!(error.contains(said), "{error}");
    }
}
