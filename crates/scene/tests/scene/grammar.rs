//! What the words of a scene come to.

use solaris_model::Vector3;
use solaris_modes::{
    Anchor, ContactLaw, ContactPoint, Course, Drive, EndCondition, Law, LimitLaw, Method, Rule, Shape, Step,
    Target, contact_points,
};
use solaris_profiles::Profile;
use solaris_scene::{NoFiles, Scene, read};

fn scene(fields: &str) -> Scene {
    let text = format!(
        r#"Scene(version: 1, duration: 1, figures: {{"arm": Figure(name: "arm", gravity: (0, 0, -1.62), links: [
            Link(name: "base", joint: Free(name: "root"), mass: 1, solid: Sphere(radius: 0.1)),
            Link(name: "upper", parent: "base", joint: Ball(name: "shoulder"), mass: 1, com: (0, -1, 0)),
            Link(name: "lower", parent: "upper", joint: Joint(name: "elbow", axes: [rx, ry(limits: (0, 1))]), mass: 1, com: (0, -1, 0)),
            Link(name: "hand", parent: "lower", joint: Joint(name: "reach", axes: [ty]), mass: 1),
        ])}},
        {fields})"#
    );
    read(&text, &mut NoFiles).unwrap_or_else(|error| panic!("{error}"))
}

fn steps(scene: &Scene, dof: &str) -> Vec<Step> {
    scene.simulation().driven_by(scene.figure().layout().dof_index(dof).expect("a dof")).to_vec()
}

fn one(drive: &str) -> Step {
    let scene = scene(&format!("drives: {{\"elbow.rx\": {drive}}}"));
    let [step] = &steps(&scene, "elbow.rx")[..] else { panic!("one step") };
    step.clone()
}

#[test]
fn every_drive_can_be_said() {
    let half = std::f64::consts::PI / 6.0;
    let jerk = Profile::MinimumJerk { from: 0.0, to: half, duration: 2.0 };
    let target = Target { position: half, velocity: half, acceleration: half };
    let all = "to: deg(30), velocity: deg(30), acceleration: deg(30)";
    let simple = |course| Drive::Simple { target, course };
    let cases = [
        ("Free".to_owned(), Drive::Free),
        ("[Frozen()]".to_owned(), Drive::Frozen),
        (
            "Kinematic(MinimumJerk(from: 0, to: deg(30), duration: 2))".to_owned(),
            Drive::Kinematic(jerk.clone()),
        ),
        (
            "Kinematic(along: MinimumJerk(from: 0, to: deg(30), duration: 2))".to_owned(),
            Drive::Kinematic(jerk),
        ),
        (
            "Torque(Line(from: 1, to: 2, duration: 3))".to_owned(),
            Drive::Torque(Profile::Line { from: 1.0, to: 2.0, duration: 3.0 }),
        ),
        (
            "Move(to: deg(30), over: 2)".to_owned(),
            Drive::Move { to: half, over: 2.0, along: Shape::MinimumJerk },
        ),
        (
            "Move(to: deg(30), over: 2, by: Cubic)".to_owned(),
            Drive::Move { to: half, over: 2.0, along: Shape::Cubic },
        ),
        (format!("TargetAngle({all})"), simple(Course::TargetAngle)),
        (format!("TimeOriented({all}, over: 2)"), simple(Course::TimeOriented { duration: 2.0 })),
        (format!("AccelerateDecelerate({all})"), simple(Course::BangBang)),
        (format!("AccelerateDecelerate({all}, by: HalfCosine)"), simple(Course::HalfCosine)),
        (format!("AccelerateDecelerate({all}, by: FullSine)"), simple(Course::FullSine)),
        ("FreeStyle(for: 2)".to_owned(), Drive::FreeStyle { target: None, duration: 2.0 }),
        (format!("FreeStyle({all}, for: 2)"), Drive::FreeStyle { target: Some(target), duration: 2.0 }),
        (
            format!("Intensive({all}, over: 2)"),
            Drive::Intensive { target, duration: 2.0, law: Law::Quintic, limit: None },
        ),
        (
            format!("Intensive({all}, over: 2, law: Literal, limit: 5)"),
            Drive::Intensive { target, duration: 2.0, law: Law::Literal, limit: Some(5.0) },
        ),
    ];
    for (text, drive) in cases {
        assert_eq!(one(&text), drive.into(), "{text}");
    }
}

#[test]
fn every_end_of_a_drive_can_be_said() {
    let named = "elbow.ry".to_owned();
    for (text, until) in [
        ("Done", EndCondition::Done),
        ("At(2)", EndCondition::Time(2.0)),
        ("Lasting(0.5)", EndCondition::Lasting(0.5)),
        (
            "Passes(\"elbow.ry\", deg(180))",
            EndCondition::Position { dof: named.clone(), value: std::f64::consts::PI },
        ),
        ("PassesSpeed(\"elbow.ry\", -1)", EndCondition::Velocity { dof: named, value: -1.0 }),
    ] {
        assert_eq!(one(&format!("Free(until: {text})")), Step { drive: Drive::Free, until }, "{text}");
    }
    assert_eq!(one("Wait(0.5)"), Step { drive: Drive::Frozen, until: EndCondition::Lasting(0.5) });
}

#[test]
fn what_names_a_dof_more_closely_wins() {
    let scene = scene(
        "drives: {\"elbow.rx\": Frozen, \"elbow\": Wait(1), \"*\": Free, \"shoulder.*\": Frozen, \"reach.*\": Wait(2), \"r*.t*\": Wait(3)}",
    );
    assert_eq!(steps(&scene, "elbow.rx"), [Drive::Frozen.into()]);
    assert_eq!(steps(&scene, "elbow.ry")[0].until, EndCondition::Lasting(1.0));
    assert_eq!(steps(&scene, "shoulder.wy"), [Drive::Frozen.into()]);
    assert_eq!(steps(&scene, "reach.ty")[0].until, EndCondition::Lasting(3.0));
    assert_eq!(steps(&scene, "root.vx"), [Drive::Free.into()]);
}

#[test]
fn what_follows_is_not_meant_by_patterns() {
    let text = r#"Scene(version: 1, duration: 1, figures: {"arm": Figure(name: "arm", links: [
        Link(name: "upper", joint: Joint(name: "elbow", axes: [rx]), mass: 1, com: (0, -1, 0)),
        Link(name: "lower", parent: "upper", joint: Joint(name: "wrist",
             axes: [rx(follows: Follow(dof: "elbow.rx", along: Line(slope: 1, offset: 0)))]), mass: 1, com: (0, -1, 0)),
    ])}, drives: {"*": Frozen})"#;
    let scene = read(text, &mut NoFiles).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(steps(&scene, "elbow.rx"), [Drive::Frozen.into()]);
    assert_eq!(steps(&scene, "wrist.rx"), [Drive::Free.into()]);
}

#[test]
fn states_springs_and_limits_are_those_said() {
    let scene = scene(
        "start: {\"root\": (at: (1, 2, 3)), \"shoulder.qx\": 0.6, \"shoulder.qw\": 0.8, \"elbow.*\": deg(90), \"elbow.ry\": 0.5},
         velocities: {\"root\": (moving: (1, 2, 3), turning: (4, 5, 6)), \"shoulder\": (7, 8, 9), \"reach\": 10},
         springs: [Spring(between: ((\"world\", (0, 1, 0)), (\"lower\", (0, 0, 1))), stiffness: 5, rest: 1)],
         limits: {\"*\": Ignore, \"elbow\": Hard(restitution: 0.5)},
         method: SemiImplicitEuler(step: 1e-3), rate: 50",
    );
    let simulation = scene.simulation();
    let (q, v) = simulation.state();
    let right_angle = std::f64::consts::FRAC_PI_2;
    let expected = [1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0, 0.6, 0.0, 0.0, 0.8, right_angle, 0.5, 0.0];
    assert!(q.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-15), "{q:?}");
    assert!(
        v.iter().zip([1., 2., 3., 4., 5., 6., 7., 8., 9., 0., 0., 10.]).all(|(a, b)| (a - b).abs() < 1e-15)
    );
    assert_eq!(*simulation.gravity(), Vector3::new(0.0, 0.0, -1.62));
    let world = Anchor { link: None, point: Vector3::y() };
    assert_eq!(simulation.springs()[0].between, [world, Anchor { link: Some(2), point: Vector3::z() }]);
    assert_eq!(simulation.limit_of(10), LimitLaw::Hard { restitution: 0.5 });
    assert_eq!(simulation.limit_of(11), LimitLaw::Ignore);
    assert_eq!(scene.settings().method, Method::Fixed { rule: Rule::SemiImplicitEuler, step: 1e-3 });
}

#[test]
fn a_ground_is_the_one_said_or_fits_the_figure() {
    let plain = scene("ground: Flat(friction: 0.5)");
    let (plane, found) = plain.simulation().grounded().expect("a ground");
    let figure = plain.figure();
    // The scene's gravity is (0, 0, −1.62): up is against it, and the weight on one point sinks in by 2 mm.
    assert!((plane.up.into_inner() - Vector3::z()).norm() < 1e-15 && plane.height == 0.0);
    let ContactLaw::Compliant { stiffness, damping, slip } = plane.law else { panic!("a spring") };
    assert!((stiffness * 2e-3 / (figure.mass() * 1.62) - 1.0).abs() < 1e-12);
    assert_eq!((plane.friction, damping, slip), (0.5, 1.0, 0.01));
    assert_eq!(found, contact_points(figure));

    let told = scene(
        "ground: Flat(friction: 0, height: -2, up: (0, 3, 4), contact: Spring(stiffness: 5e3, damping: 0, slip: 0.1),
                      touches: [(\"lower\", (0, 0, 1), 0.1), (\"lower\", (0, 1, 0))])",
    );
    let (plane, found) = told.simulation().grounded().expect("a ground");
    assert!((plane.up.into_inner() - Vector3::new(0.0, 0.6, 0.8)).norm() < 1e-15);
    assert_eq!((plane.height, plane.friction), (-2.0, 0.0));
    assert_eq!(plane.law, ContactLaw::Compliant { stiffness: 5e3, damping: 0.0, slip: 0.1 });
    let touch = |center, radius| ContactPoint { link: 2, center, radius };
    assert_eq!(found, [touch(Vector3::z(), 0.1), touch(Vector3::y(), 0.0)]);
}

/// Scenes that were written before the laws had these names go on.
#[test]
fn the_older_words_for_laws_of_contact_mean_the_same() {
    let law = |contact: &str| {
        let scene = scene(&format!("ground: Flat(friction: 0.5, contact: {contact})"));
        scene.simulation().grounded().expect("a ground").0.law
    };
    assert_eq!(law("Rigid"), ContactLaw::Rigid);
    assert_eq!(law("Planted"), ContactLaw::Rigid);
    let compliant = ContactLaw::Compliant { stiffness: 5e3, damping: 2.0, slip: 0.1 };
    for word in ["Compliant", "Spring"] {
        assert_eq!(law(&format!("{word}(stiffness: 5e3, damping: 2, slip: 0.1)")), compliant, "{word}");
    }
}

#[test]
fn a_curve_begins_where_it_begins_unless_told_otherwise() {
    let curve = "drives: {\"elbow.rx\": Kinematic(Line(from: 1, to: 3, duration: 4))}";
    let scene = scene(curve);
    let (q, v) = scene.simulation().state();
    assert!((q[11] - 1.0).abs() < 1e-15 && (v[9] - 0.5).abs() < 1e-15);
    let told = self::scene(&format!("{curve}, start: {{\"elbow.rx\": 0.25}}"));
    assert!((told.simulation().state().0[11] - 0.25).abs() < 1e-15);
}

#[test]
fn blends_are_those_of_the_profiles() {
    let layers = one(
        "Kinematic(Blend(first: Line(from: 0, to: 1, duration: 1), second: (profile: Line(from: 1, to: 0, duration: 1), start: 0.5, outside: Extrapolate), fade: Fade(kind: Sinh(stiffness: 1), start: 0.5, end: 1)))",
    );
    let Drive::Kinematic(Profile::Blend { second, fade, .. }) = layers.drive else { panic!("a blend") };
    assert!((second.start - 0.5).abs() < 1e-15 && (fade.end() - 1.0).abs() < 1e-15);
    assert_eq!(second.outside, solaris_profiles::Outside::Extrapolate);
}
