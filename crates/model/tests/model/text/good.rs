//! What a text may say, and what it means.

use solaris_model::text::read;
use solaris_model::{
    Axis, Curve, Figure, FigureBuilder, Inertia, Joint, LinkSpec, Placement, Shape, ShapeKind, Vector3,
};

fn figure(text: &str) -> Figure {
    read(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn joint(text: &str) -> Joint {
    let text = format!("Figure(version: 1, links: [Link(name: \"a\", joint: {text}, mass: 1)])");
    figure(&text).links()[0].joint().clone()
}

fn turned(rotation: &str) -> [f64; 4] {
    joint(&format!("Joint(name: \"j\", turned: {rotation})")).placement().rotation.coords.into()
}

fn assert_close(found: [f64; 4], wanted: [f64; 4]) {
    for (a, b) in found.iter().zip(wanted) {
        assert!((a - b).abs() < 1e-15, "{found:?} {wanted:?}");
    }
}

#[test]
fn the_three_ways_to_turn_agree() {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let wanted = [half, 0.0, 0.0, half];
    assert_close(turned("About(axis: (2, 0, 0), angle: deg(90))"), wanted);
    assert_close(turned("Xyz(deg(90), 0, 0)"), wanted);
    assert_close(turned("Zyx(0, 0, 1.5707963267948966)"), wanted);
    assert_close(turned("Quaternion(0.70710678, 0, 0, 0.70710678)"), wanted);
}

#[test]
fn degrees_and_radians_are_told_apart() {
    let joint = joint(
        "Joint(name: \"j\", axes: [rx(limits: (deg(-90), 1.5)), tz(limits: (-inf, 0.2)), Slide(axis: (0, 3, 4))])",
    );
    let dofs = joint.kind().axes();
    let limits = |i: usize| dofs[i].limits.map(|limits| (limits.lower, limits.upper));
    assert_eq!(limits(0), Some((-std::f64::consts::FRAC_PI_2, 1.5)));
    assert_eq!(limits(1), Some((f64::NEG_INFINITY, 0.2)));
    assert_eq!(dofs[2].axis, Axis::translation(Vector3::new(0.0, 0.6, 0.8)));
}

#[test]
fn a_solid_is_the_uniform_solid_of_the_links_mass() {
    let text = "Figure(version: 1, links: [Link(name: \"a\", joint: Joint(name: \"j\"), mass: 3,
        solid: Cylinder(radius: 0.1, length: 0.5, at: (0, -0.25, 0), turned: Zyx(deg(30), 0, 0)))])";
    let placement =
        joint("Joint(name: \"j\", at: (0, -0.25, 0), turned: Zyx(deg(30), 0, 0))").placement().to_owned();
    let shape = Shape { kind: ShapeKind::Cylinder { radius: 0.1, length: 0.5 }, placement };
    let wanted = FigureBuilder::new("figure")
        .link(LinkSpec::root("a", Joint::new("j")).mass(3.0).inertia(Inertia::Uniform(shape)))
        .build()
        .expect("a figure");
    let found = figure(text);
    assert!((found.links()[0].inertia() - wanted.links()[0].inertia()).amax() < 1e-17);
    assert_eq!(found.links()[0].com(), wanted.links()[0].com());
    assert_eq!(found.links()[0].shape().map(|shape| shape.kind), Some(shape.kind));
    assert_ne!(found.links()[0].joint().placement(), &Placement::translation(1.0, 0.0, 0.0));
}

#[test]
fn a_body_may_have_an_age_and_limits() {
    let text = "Figure(version: 1, body: Human(height: 1.3, mass: 27, age: 8.5, limits: {\"left_elbow.rx\": (deg(-90), 0)}))";
    let limit = -std::f64::consts::FRAC_PI_2;
    let wanted = solaris_model::Human::new(1.3, 27.0).age(8.5).limits("left_elbow.rx", limit, 0.0);
    assert_eq!(figure(text), wanted.build().expect("a child"));
}

#[test]
fn a_body_carries_a_load_in_each_hand() {
    let text = "Figure(version: 1, body: Human(height: 1.75, mass: 73, load: {\"right\": 8, \"left\": 2.5}))";
    let wanted = solaris_model::Human::new(1.75, 73.0).load("right", 8.0).load("left", 2.5);
    assert_eq!(figure(text), wanted.build().expect("a porter"));
}

#[test]
fn a_body_stands_on_legs_of_unequal_length() {
    let text = "Figure(version: 1, body: Human(height: 1.75, mass: 73, shorter_leg: {\"left\": 0.02}))";
    let wanted = solaris_model::Human::new(1.75, 73.0).shorter_leg("left", 0.02);
    assert_eq!(figure(text), wanted.build().expect("a person"));
}

#[test]
fn a_body_holds_a_cane() {
    let text = "Figure(version: 1, body: Human(height: 1.75, mass: 73, cane: \"left\"))";
    let wanted = solaris_model::Human::new(1.75, 73.0).cane("left").build().expect("a person");
    assert_eq!(figure(text), wanted);
    assert_eq!(figure(&solaris_model::text::write(&wanted)), wanted);
}

#[test]
fn a_body_is_one_word() {
    let found = figure(
        "Figure(version: 1, name: \"ann\", body: Human(height: 1.65, mass: 58, segments: {\"left_thigh\": 0.45}))",
    );
    let wanted =
        solaris_model::Human::new(1.65, 58.0).segment_length("left_thigh", 0.45).build().expect("a human");
    assert_eq!((found.name(), found.stature()), ("ann", Some(1.65)));
    assert_eq!(found.links(), wanted.links());
    assert_eq!(
        figure("(version: 1, stature: 1.7, body: Human(height: 1.65, mass: 58))").stature(),
        Some(1.7)
    );
    let limp = |joints: &str| {
        figure(&format!("(version: 1, body: Human(height: 1.65, mass: 58, joints: {joints}))"))
    };
    let wanted = solaris_model::Human::new(1.65, 58.0).limp().build().expect("a human");
    assert_eq!(limp("Limp").links(), wanted.links());
    assert_eq!(limp("Angles").layout().nq(), 66);
    let root =
        |order: &str| figure(&format!("(version: 1, body: Human(height: 1.65, mass: 58, root: {order}))"));
    let names = |order: &str| root(order).layout().q_names()[..6].join(" ");
    assert_eq!(names("Yzx"), "root.tx root.ty root.tz root.ry root.rz root.rx");
    assert_eq!(names("Zyx"), "root.tx root.ty root.tz root.rz root.ry root.rx");
}

#[test]
fn a_follower_has_a_curve_and_an_angle_a_sign() {
    let text = "Figure(version: 1, links: [Link(name: \"a\", mass: 1, joint: Joint(name: \"knee\", axes: [
        rx, tx(follows: Follow(dof: \"knee.rx\", along: Line(slope: 2))),
        ty(follows: Follow(dof: \"knee.rx\", along: Cubics(knots: [0, 1, 2], pieces: [(0, 1, 2, 3), (6, 0, 0, 0)]))),
        tz(follows: Follow(dof: \"knee.rx\", along: Chain([Sine(amplitude: 2, frequency: 3),
            Quintics(knots: [0, 1], pieces: [(0, 0, 0, 0, 0, 1)])])))]))],
        angles: {\"flexion\": \"-knee.rx\"})";
    let knee = figure(text);
    assert_eq!(knee.followers()[0].curve, Curve::linear(2.0, 0.0));
    assert_eq!(knee.followers()[1].curve.at(1.5)[0].to_bits(), 6.0_f64.to_bits());
    let fifth = (2.0 * 0.3_f64.sin()).powi(5);
    assert!((knee.followers()[2].curve.at(0.1)[0] - fifth).abs() < 1e-15);
    assert!(knee.anatomical_angles()[0].sign < 0.0);
}

/// Comments, marks at the beginning, line ends of other systems, `Some` and `None`, raw texts, names left out.
#[test]
fn what_else_ron_has_is_read() {
    let text = "\u{feff}#![enable(implicit_some)]\r\n// one\r\n/* two /* three */ */ (version: 0x1, name: Some(r#\"a \"b\" c\"#), stature: None,\r\n\
        links: [(name: \"膝 e\\u{301}\\x41\", joint: Joint(name: \"j\", axes: [rx()]), mass: 1_000.5e-1, tip: [0, 0, +1.,],),],)// end";
    let read = figure(text);
    assert_eq!((read.name(), read.stature()), ("a \"b\" c", None));
    assert_eq!((read.links()[0].name(), read.mass().to_bits()), ("膝 e\u{301}A", 100.05_f64.to_bits()));
}
