//! What is wrong with a scene: every class of faults, with its place.

use solaris_model::{Figure, human};
use solaris_scene::{Loader, NoFiles, read};
use std::fmt::Write;

/// The faults of a text.
pub(crate) fn faults(text: &str) -> String {
    match read(text, &mut NoFiles) {
        Ok(_) => "no fault".to_owned(),
        Err(error) => error.to_string(),
    }
}

/// A scene of an arm, with more fields.
fn arm(fields: &str) -> String {
    format!(
        r#"Scene(version: 1, duration: 1, figures: {{"arm": Figure(name: "arm", links: [
    Link(name: "base", joint: Joint(name: "slide", axes: [tx]), mass: 1),
    Link(name: "upper", parent: "base", joint: Ball(name: "shoulder"), mass: 1, com: (0, -1, 0)),
    Link(name: "lower", parent: "upper", joint: Joint(name: "elbow", axes: [rx, ry]), mass: 1, com: (0, -1, 0)),
    Link(name: "tip", parent: "lower", joint: Joint(name: "forearm",
         axes: [rx(follows: Follow(dof: "elbow.rx", along: Line(slope: 1, offset: 0)))]), mass: 1),
])}},
{fields})"#
    )
}

/// A scene of a person, with more fields.
pub(crate) fn person(fields: &str) -> String {
    format!("Scene(version: 1, figures: {{\"ann\": Human(height: 1.75, mass: 73)}},\n{fields})")
}

/// Each of these fields, and its faults.
pub(crate) fn listed(cases: &[&str]) -> String {
    let mut text = String::new();
    for case in cases {
        let _ = write!(text, "{case}\n{}\n\n", faults(&arm(case)));
    }
    text
}

#[test]
fn of_the_whole() {
    let mut text = String::new();
    for case in [
        "",
        "Scene(",
        "Scene(version: 1)) ",
        "Scen(version: 1)",
        "Figure(version: 1)",
        "Scene(version: 2, anything: 1)",
        "Scene(version: 0.5, duration: 1)",
        "Scene(figures: {}, duration: 1)",
        "Scene(version: 1, figures: [], duration: -1, rat: 3)",
        r#"Scene(version: 1, figures: {"a": Human(height: 1.75, mass: 73), "b": Human(height: 1.6, mass: 60)}, duration: 1)"#,
        r#"Scene(version: 1, figures: {"a": Humn(height: 1.75, mass: 73)}, duration: 1)"#,
        r#"Scene(version: 1, figures: {"a": Human(height: 17.5, mass: 73)}, duration: 1)"#,
        r#"Scene(version: 1, figures: {"a": File("robot.urdf")}, duration: 1)"#,
        r#"Scene(version: 1, figures: {"a": File(robot)}, duration: 1)"#,
        r#"Scene(version: 1, figures: {"a": Figure(links: [Link(name: "a", joint: Joint(name: "j", axes: [rw]), mas: 1)])}, duration: 1)"#,
    ] {
        let _ = write!(text, "{case}\n{}\n\n", faults(case));
    }
    insta::assert_snapshot!(text);
}

#[test]
fn of_settings() {
    let text = listed(&[
        "rate: 0",
        "gravity: 9.81",
        "gravity: (0, -inf, 0)",
        "tolerance: 0",
        "tolerance: 1e-6, method: RungeKutta4(step: 1e-3)",
        "method: RungeKuta4(step: 1e-3)",
        "method: RungeKutta4",
        "method: ExplicitEuler(step: -1)",
        "method: Stiff(step: 1)",
        "guard: Guard(gimbal: deg(1), energi: 1)",
        "duration: 2",
    ]);
    insta::assert_snapshot!(text);
}

#[test]
fn of_the_start() {
    let text = listed(&[
        "start: [1]",
        "start: {\"elbow.rz\": 1}",
        "start: {\"elbo.*\": 1}",
        "start: {\"slide.tx\": deg(1)}",
        "start: {\"elbow.rx\": \"1\"}",
        "start: {\"elbow.rx\": 1, \"elbow.rx\": 2}",
        "start: {\"shoulder\": 1}",
        "start: {\"shoulder\": About(axis: (0, 0, 0), angle: 1)}",
        "start: {\"shoulder.wx\": 1}",
        "start: {\"shoulder.qx\": 0.5, \"shoulder.qw\": 0.5}",
        "velocities: {\"shoulder\": (1, 2)}",
        "velocities: {\"shoulder\": 1}",
        "velocities: {\"elbw\": 1}",
    ]);
    insta::assert_snapshot!(text);
}

#[test]
fn of_drives() {
    let text = listed(&[
        "drives: {\"elbow.rx\": Fre}",
        "drives: {\"elbow.rx\": Reach(tip: \"hand\", to: (0, 1, 0), over: 1)}",
        "drives: {\"elbow.rx\": [Wait(1), Walk(steps: 3)]}",
        "drives: {\"forearm.rx\": Free}",
        "drives: {\"elbow.rx\": []}",
        "drives: {\"elbow.rx\": 3}",
        "drives: {\"elbow.rx\": Wait}",
        "drives: {\"elbow.rx\": Move(over: 1)}",
        "drives: {\"elbow.rx\": Move(to: 1, over: 0)}",
        "drives: {\"elbow.rx\": Move(to: 1, over: 1, by: Cubc)}",
        "drives: {\"elbow.rx\": [Move(to: 1, over: 1), Move(to: 2, over: -1)]}",
        "drives: {\"slide.tx\": Move(to: deg(3), over: 1)}",
        "drives: {\"shoulder\": Move(to: 1, over: 1)}",
        "drives: {\"*\": Kinematic(Line(from: 0, to: 1, duration: 1))}",
        "drives: {\"wrist.*\": Free}",
        "drives: {\"elbow.rx\": Free, \"elbow.rx\": Frozen}",
        "drives: {\"elbow.rx\": TargetAngle(to: 1, velocty: 1)}",
        "drives: {\"elbow.rx\": FreeStyle(to: 1)}",
        "drives: {\"elbow.rx\": Intensive(to: 1, over: 1, law: Cubic, limit: -1)}",
        "drives: {\"elbow.rx\": Free(until: 2)}",
        "drives: {\"elbow.rx\": Free(until: At(-1))}",
        "drives: {\"elbow.rx\": Free(until: Passes(\"elbow\", 1))}",
        "drives: {\"elbow.rx\": Free(until: Passes(\"shoulder.wx\", 1))}",
        "drives: {\"elbow.rx\": Free(until: PassesSpeed(\"elbow.rz\", 1))}",
    ]);
    insta::assert_snapshot!(text);
}

#[test]
fn of_curves() {
    let text = listed(&[
        "drives: {\"elbow.rx\": Kinematic(3)}",
        "drives: {\"elbow.rx\": Kinematic(MinimumJrek(from: 0, to: 1, duration: 2))}",
        "drives: {\"elbow.rx\": Kinematic(Wobbly(from: 0, to: 1, duration: 2))}",
        "drives: {\"elbow.rx\": Kinematic(MinimumJerk(from: 0, duration: 2, too: 1))}",
        "drives: {\"elbow.rx\": Kinematic(MinimumJerk(from: 0, to: deg(90), duration: 0))}",
        "drives: {\"elbow.rx\": Kinematic(Tension(from: 0, to: 1, duration: 1, stiffness: -3))}",
        "drives: {\"elbow.rx\": Kinematic(CatmullRom(keys: [(0, 0), (0, 1)]))}",
        "drives: {\"elbow.rx\": Kinematic(CatmullRom(keys: [0, 1]))}",
        "drives: {\"elbow.rx\": Torque(Line(from: deg(1), to: 1, duration: 1))}",
        "drives: {\"elbow.rx\": Kinematic(Blend(first: Line(from: 0, to: 1, duration: 1), fade: Fade(kind: Smoth, start: 0, end: 1)))}",
        "drives: {\"elbow.rx\": Kinematic(Weighted(layers: [(start: 1)]))}",
    ]);
    insta::assert_snapshot!(text);
}

#[test]
fn of_springs_and_limits() {
    let text = listed(&[
        "springs: Spring(stiffness: 1)",
        "springs: [Spring(stiffness: 1)]",
        "springs: [Spring(between: ((\"world\", (0, 0, 0)), (\"lowr\", (0, 0, 0))), stiffness: 1)]",
        "springs: [Spring(between: (\"world\", \"lower\"), stiffness: 1)]",
        "springs: [Spring(between: ((\"world\", (0, 0)), (\"lower\", (0, 0, 0))), stiffness: -1)]",
        "springs: [Spring(between: ((\"world\", (0, 0, 0)), (\"lower\", (0, 0, 0))), stiffness: -1)]",
        "limits: Hrd",
        "limits: Hard(restitution: 2)",
        "limits: Ignore(restitution: 2)",
        "limits: {\"elbow\": Spring(damping: 1), \"knee\": Ignore}",
    ]);
    insta::assert_snapshot!(text);
}

#[test]
fn of_the_ground() {
    let mut text = listed(&[
        "ground: Flat",
        "ground: Flta(friction: 1)",
        "ground: Flat(friction: -1)",
        "ground: Flat(friction: 1, hight: 2)",
        "ground: Flat(friction: 1, up: (0, 0, 0))",
        "ground: Flat(friction: 1, contact: Sprung(stiffness: 1))",
        "ground: Flat(friction: 1, contact: Spring(stiffness: 0, damping: 1))",
        "ground: Flat(friction: 1, contact: Spring(stifness: 1e4))",
        "ground: Flat(friction: 1, contact: Spring(slip: deg(1)))",
        "ground: Flat(friction: 1), gravity: (0, 0, 0)",
        "ground: Flat(friction: 1, contact: Planted(stiffness: 1e4))",
        "ground: Flat(friction: 1, stand: maybe)",
        "ground: Flat(friction: 1, touches: [], stand: true)",
        "ground: Flat(friction: 1, touches: 3)",
        "ground: Flat(friction: 1, touches: [(\"lowr\", (0, 0, 0), 0.1), (\"tip\", 3), (\"tip\")])",
        "ground: Flat(friction: 1, touches: [(\"lower\", (0, 0, 0), -0.1)])",
    ]);
    let scene = "Scene(version: 1, figures: {\"ann\": Human(height: 1.75, mass: 73)},\n\
                 walk: Walk(steps: 3), ground: Flat(friction: 0.8))";
    let _ = write!(text, "{scene}\n{}\n", faults(scene));
    insta::assert_snapshot!(text);
}

#[test]
fn of_walks() {
    let mut text = listed(&["walk: Walk(steps: 3)"]);
    for case in [
        "walk: Walk(steps: 3.5)",
        "walk: Walk(steps: 3, distance: 3)",
        "walk: Walk(step_frequency: 300)",
        "walk: Walk(arm_swng: deg(5))",
        "walk: Walk(arm_swing: deg(500))",
        "walk: Walk(steps: 3), gravity: (0, 0, -9.81)",
        "walk: Walk(step_frequency: 110, step_length: 0.7, speed: 1.3)",
        "walk: Walk(steps: 4, turn: deg(31))",
        "walk: Walk(steps: 4, then: Part(steps: 2))",
        "walk: Walk(steps: 4, then: [Part(turn: deg(5)), Part(steps: 2.5), Prt(steps: 2), Part(steps: 2, distance: 3)])",
        "walk: Walk(steps: 4, then: [Part(steps: 2), Part(steps: 2, turn: deg(31))])",
        "walk: Walk(steps: 4, then: [Part(steps: 4, step_frequency: 60, turn: deg(-28))])",
        "walk: Walk(distance: 3, then: [Part(steps: 2)])",
        "walk: Stand(time: 2)",
        "walk: []",
        "walk: [Stand(time: 2), Stand()]",
        "walk: [Walk(steps: 2), Stand(time: -1)]",
        "walk: [Walk(steps: 2), Stand(time: 1), Walk(steps: 2, speed: 2.5)]",
        "walk: [Walk(steps: 9, turn: deg(6)), Walk(steps: 9, turn: deg(6))]",
    ] {
        let scene =
            format!("Scene(version: 1, figures: {{\"ann\": Human(height: 1.75, mass: 73)}},\n{case})");
        let _ = write!(text, "{case}\n{}\n\n", faults(&scene));
    }
    insta::assert_snapshot!(text);
}

#[test]
fn all_at_once() {
    let text = arm("rate: -1,\nstart: {\"elbow.rz\": 1},\nvelocities: {\"shoulder\": 1, \"slid.tx\": 2},\n\
         drives: {\n    \"elbow.rx\": [Move(to: 1, over: 1), Mve(to: 1)],\n    \"nek.*\": Frozen,\n},\nlimts: Ignore,");
    insta::assert_snapshot!(faults(&text));
}

#[test]
fn what_needs_no_figure_is_found_without_one() {
    let text = "Scene(version: 1, figures: {\"x\": Person(height: 1)}, rate: 0,\n\
                drives: {\"elbow\": Mve(to: 1)}, springs: [Spring(stiffness: deg(1))], walk: Walk(step: 3))";
    insta::assert_snapshot!(faults(text));
}

/// Has one file.
struct OneFile;

impl Loader for OneFile {
    fn figure(&mut self, path: &str) -> Result<Figure, String> {
        if path == "ann.ron" {
            human(1.7, 60.0).map_err(|error| error.to_string())
        } else {
            Err("no such file".to_owned())
        }
    }
}

#[test]
fn files_come_from_the_loader() {
    let text = "Scene(version: 1, duration: 1, figures: {\"x\": File(\"ann.ron\")})";
    assert!((read(text, &mut OneFile).expect("a scene").figure().mass() - 60.0).abs() < 1e-9);
    let error = read(&text.replace("ann", "bob"), &mut OneFile).expect_err("no such file");
    assert_eq!(error.to_string(), "line 1, column 52: 'bob.ron': no such file");
    // A person floats already; on a free joint it cannot be put.
    let based = |base: &str| text.replace("\"ann.ron\"", &format!("path: \"ann.ron\", base: {base}"));
    assert_eq!(
        read(&based("Floating"), &mut OneFile).expect("a scene").figure().layout().v_names()[0],
        "root.tx"
    );
    for (base, said) in [
        (
            "Free",
            "line 1, column 58: 'ann.ron': joint 'root' moves the root 'pelvis' already, by root.tx, root.ty, root.tz, root.rz, \
             root.ry, root.rx; leave the base as the figure has it (fixed), or weld that joint first",
        ),
        ("Fre", "line 1, column 75: 'Fre' is not known here; did you mean 'Free'?"),
    ] {
        assert_eq!(read(&based(base), &mut OneFile).expect_err("refused").to_string(), said);
    }
}
