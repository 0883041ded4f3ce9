//! Texts with faults, and what is said about each.

use crate::text::render::render;
use solaris_model::MassDoubt;
use solaris_model::text::read;
use std::fmt::Write as _;

/// A good figure, to be spoilt.
const CRANE: &str = r#"Figure(
    version: 1,
    name: "crane",
    links: [
        Link(
            name: "tower",
            joint: Joint(name: "root", axes: [ry]),
            mass: 12.0,
            solid: Box(size: (0.4, 3.0, 0.4)),
        ),
        Link(
            name: "jib",
            parent: "tower",
            joint: Joint(name: "luff", at: (0.0, 3.0, 0.0), axes: [rz(limits: (deg(-10), deg(80)), damping: 4.0)]),
            mass: 3.0,
            com: (1.0, 0.0, 0.0),
            inertia: (0.01, 1.0, 1.0),
        ),
        Link(
            name: "hook",
            parent: "jib",
            joint: Ball(name: "rope", at: (2.0, 0.0, 0.0)),
            mass: 0.5,
        ),
    ],
    angles: { "jib.lift": "luff.rz" },
)
"#;

/// The crane with one piece of its text replaced by another.
fn spoilt(pairs: &[(&str, &str)]) -> String {
    pairs.iter().fold(CRANE.to_owned(), |text, (old, new)| {
        assert_eq!(text.matches(old).count(), 1, "{old}");
        text.replacen(old, new, 1)
    })
}

fn cases() -> Vec<(&'static str, String)> {
    let one = |old, new| spoilt(&[(old, new)]);
    vec![
        ("empty", String::new()),
        ("only a comment", "// nothing\n".to_owned()),
        ("truncated", CRANE[..420].to_owned()),
        ("truncated in a text", CRANE[..CRANE.find("jib\"").map_or(0, |at| at + 2)].to_owned()),
        ("binary", "\u{1}\u{0}PNG\u{fffd}\u{0}".to_owned()),
        ("binary without zeros", "\u{fffd}\u{2}PNG".to_owned()),
        ("byte order mark", format!("\u{feff}{}", one("mass: 3.0", "mass: -3.0"))),
        ("lines of Windows", one("mass: 3.0", "mass: -3.0").replace('\n', "\r\n")),
        ("XML", "<robot name=\"crane\"/>".to_owned()),
        ("another kind of text", "Scene(version: 1)".to_owned()),
        ("a list", "[1, 2]".to_owned()),
        ("no version", one("    version: 1,\n", "")),
        ("a later version", spoilt(&[("version: 1", "version: 2"), ("mass: 3.0", "wait: 3.0")])),
        ("version 0", one("version: 1", "version: 0")),
        ("version in quotes", one("version: 1", "version: \"1\"")),
        ("version twice", one("version: 1", "version: 1, version: 1")),
        ("no links", "Figure(version: 1)".to_owned()),
        ("empty links", "Figure(version: 1, links: [])".to_owned()),
        ("links that are no list", "Figure(version: 1, links: {\"a\": 1})".to_owned()),
        ("unknown field", one("mass: 3.0", "mas: 3.0")),
        ("unknown field, nothing near", one("mass: 3.0", "colour: 3.0")),
        ("unknown field of an axis", one("damping: 4.0", "dampin: 4.0")),
        ("field twice", one("mass: 3.0", "mass: 3.0, mass: 4.0")),
        ("missing joint", one("            joint: Ball(name: \"rope\", at: (2.0, 0.0, 0.0)),\n", "")),
        ("parent with a typo", one("parent: \"tower\"", "parent: \"towr\"")),
        ("two roots", one("            parent: \"jib\",\n", "")),
        ("cycle", one("parent: \"tower\"", "parent: \"hook\"")),
        ("no root", one("name: \"tower\",", "name: \"tower\", parent: \"hook\",")),
        ("duplicate link", one("name: \"hook\"", "name: \"jib\"")),
        ("duplicate joint", one("name: \"rope\"", "name: \"luff\"")),
        ("empty name", spoilt(&[("name: \"hook\"", "name: \"  \""), ("mass: 0.5", "mass: -0.5")])),
        ("names with spaces, quotes, UTF-8", spoilt(&[
            ("\"hook\"", "\"le \\\"petit\\\" crochet é e\u{301} 膝\""),
            ("mass: 0.5", "mass: -0.5"),
        ])),
        ("a fault behind combining characters", one("name: \"hook\"", "/* e\u{301} 膝 */ nam: \"hook\"")),
        ("single quotes", one("\"hook\"", "'hook'")),
        ("curly quotes", one("\"hook\"", "“hook”")),
        ("no quotes", one("\"hook\"", "hook")),
        ("a quote forgotten", one("name: \"hook\"", "name: \"hook")),
        ("a bad escape", one("\"hook\"", "\"ho\\ok\"")),
        ("1e999", one("mass: 3.0", "mass: 1e999")),
        ("NaN", one("com: (1.0, 0.0, 0.0)", "com: (1.0, NaN, -inf)")),
        ("a number with a unit", one("mass: 3.0", "mass: 3.0kg")),
        ("a number with two points", one("mass: 3.0", "mass: 3.0.1")),
        ("a comma in a number", one("mass: 3.0", "mass: 3,5")),
        ("degrees with a sign", one("deg(80)", "80°")),
        ("degrees with a unit", one("deg(80)", "80deg")),
        ("degrees in quotes", one("deg(80)", "deg(\"80\")")),
        ("degrees by another name", one("deg(80)", "degrees(80)")),
        ("two degrees", one("deg(80)", "deg(80, 90)")),
        ("degrees of a mass", one("mass: 3.0", "mass: deg(3)")),
        ("degrees of a slide", one("axes: [ry]", "axes: [ty(limits: (deg(0), deg(3)))]")),
        ("too few components", one("at: (2.0, 0.0, 0.0)", "at: (2.0, 0.0)")),
        ("a number for a vector", one("at: (2.0, 0.0, 0.0)", "at: 2.0")),
        ("five numbers of inertia", one("(0.01, 1.0, 1.0)", "(0.01, 1.0, 1.0, 0.0, 0.0)")),
        ("a size for a sphere", one("Box(size: (0.4, 3.0, 0.4))", "Sphere(size: 0.4)")),
        ("an unknown shape", one("Box(size: (0.4, 3.0, 0.4))", "Boxx(size: (0.4, 3.0, 0.4))")),
        ("a shape without thickness", one("(0.4, 3.0, 0.4)", "(0.4, 0.0, 0.4)")),
        ("bare values", one("Box(size: (0.4, 3.0, 0.4))", "Box(0.4, 3.0, 0.4)")),
        ("solid and numbers", one("mass: 12.0,", "mass: 12.0, com: (0, 0, 0), inertia: (1, 1, 1),")),
        ("an unknown axis", one("axes: [ry]", "axes: [rw]")),
        ("an axis in quotes", one("axes: [ry]", "axes: [\"ry\"]")),
        ("seven axes", one("axes: [ry]", "axes: [tx, ty, tz, rz, ry, rx, rx]")),
        ("an axis that is none", one("axes: [ry]", "axes: [Turn(axis: (0, 0, 0))]")),
        ("an axis without direction", one("axes: [ry]", "axes: [Turn]")),
        ("axes of a ball", one("Ball(name: \"rope\",", "Ball(name: \"rope\", axes: [rx],")),
        ("a ball that damps backwards", one("Ball(name: \"rope\",", "Ball(name: \"rope\", damping: -1, armature: -2,")),
        ("an unknown joint", one("Ball(name: \"rope\"", "Hinge(name: \"rope\"")),
        ("a quaternion that is none", one("at: (2.0,", "turned: Quaternion(0, 0, 0, 0), at: (2.0,")),
        ("a rotation about nothing", one("at: (2.0,", "turned: About(axis: (0, 0, 0), angle: 1), at: (2.0,")),
        ("an order that is none", one("at: (2.0,", "turned: Zxz(0, 0, 0), at: (2.0,")),
        ("reversed limits", one("(deg(-10), deg(80))", "(deg(80), deg(-10))")),
        ("one limit", one("(deg(-10), deg(80))", "(deg(80))")),
        ("a negative mass", one("mass: 3.0", "mass: -3.0")),
        ("a follower without leader", one("axes: [ry]", "axes: [ry, ty(follows: Follow(dof: \"luf.rz\", along: Line(slope: 1)))]")),
        ("a curve that goes back", one("axes: [ry]", "axes: [ry, ty(follows: Follow(dof: \"root.ry\", along: Cubics(knots: [0, 0], pieces: [(0, 0, 0, 0)])))]")),
        ("a chain in a chain", one("axes: [ry]", "axes: [ry, ty(follows: Follow(dof: \"root.ry\", along: Chain([Line(slope: 1), Chain([])])))]")),
        ("a wave without frequency", one("axes: [ry]", "axes: [ry, ty(follows: Follow(dof: \"root.ry\", along: Sine(amplitude: 1)))]")),
        ("an angle of nothing", one("\"luff.rz\"", "\"-luff.rx\"")),
        ("an angle twice", one("\"luff.rz\" }", "\"luff.rz\", \"jib.lift\": \"-luff.rz\" }")),
        ("a frame twice", one("mass: 3.0", "frames: {\"eye\": (), \"eye\": (at: (1, 0, 0))}, mass: 3.0")),
        ("a sole point that is none", one("mass: 0.5", "sole: [Heel(0, 0, 0), Toe(0, 0, 0), Ball(1, 2)], mass: 0.5")),
        ("deep brackets", format!("Figure(version: 1, links: {}", "[".repeat(100))),
        ("the wrong bracket", one("com: (1.0, 0.0, 0.0)", "com: (1.0, 0.0, 0.0]")),
        ("no comma", one("mass: 3.0,", "mass: 3.0")),
        ("no colon", one("mass: 3.0", "mass 3.0")),
        ("a comment without end", one("mass: 3.0", "/* mass: 3.0")),
        ("something behind the end", format!("{CRANE}Figure()")),
        ("a bracket too many", format!("{CRANE})")),
        ("a body and links", one("name: \"crane\",", "body: Human(height: 1.75, mass: 73),")),
        ("a body that is none", "Figure(version: 1, stature: -1, body: Human(height: 17.5, mass: 73))".to_owned()),
        ("joints that are none", "Figure(version: 1, body: Human(height: 1.75, mass: 73, joints: Limb))".to_owned()),
        ("joints that say more", "Figure(version: 1, body: Human(height: 1.75, mass: 73, joints: Limp(damping: 1)))".to_owned()),
        ("a root that is none", "Figure(version: 1, body: Human(height: 1.75, mass: 73, root: Xyz))".to_owned()),
        ("a root of a free joint", "Figure(version: 1, body: Human(height: 1.75, mass: 73, joints: Limp, root: Yzx))".to_owned()),
        ("segments that are none", "Figure(version: 1, body: Human(height: 1.75, mass: 73, segments: {\"left_thig\": 0.4, \"shank\": 4.3, \"hand\": \"big\"}))".to_owned()),
        ("loads that are none", "Figure(version: 1, body: Human(height: 1.75, mass: 73, load: {\"rigth\": 4, \"left\": 50, \"left\": 1}))".to_owned()),
        ("legs that are none", "Figure(version: 1, body: Human(height: 1.75, mass: 73, shorter_leg: {\"lefft\": 0.01, \"left\": 0.5, \"left\": 0.01}))".to_owned()),
        ("a cane in no hand", "Figure(version: 1, body: Human(height: 1.75, mass: 73, cane: \"lefft\"))".to_owned()),
        ("an age of nobody", "Figure(version: 1, body: Human(height: 1.1, mass: 20, age: 3))".to_owned()),
        ("limits that are none", "Figure(version: 1, body: Human(height: 1.75, mass: 73, limits: {\"left_elbow.xr\": (0, 1), \"left_knee.rx\": (1, 0)}))".to_owned()),
        ("a body without height", "Figure(version: 1, body: human(mass: 73))".to_owned()),
        ("several faults in several links", spoilt(&[
            ("mass: 12.0", "mas: 12.0"),
            ("parent: \"tower\"", "parent: \"towr\""),
            ("(deg(-10), deg(80))", "(deg(80), 1e999)"),
            ("mass: 3.0", "mass: -3.0"),
            ("at: (2.0, 0.0, 0.0)", "at: (2.0, 0.0)"),
            ("name: \"hook\"", "name: \"jib\""),
            ("\"luff.rz\"", "\"luff.ry\""),
        ])),
    ]
}

#[test]
fn the_crane_itself_is_good() {
    assert_eq!(read(CRANE).expect("nothing is wrong with it").layout().nv(), 5);
}

/// The inertia of the thesis's §3.7 is read, and found by whoever asks.
#[test]
fn the_box_of_the_thesis_is_a_doubt() {
    // The box of the thesis's §3.7 with M = 3 kg and edges α = 2, β = 0.2, γ = 0.3 m, as printed.
    let (m, a, b, c) = (3.0, 2.0, 0.2, 0.3);
    let printed = format!(
        "inertia: ({:.6}, {:.6}, {:.6}, {:.6}, {:.6}, {:.6})",
        m * (b * b + c * c) / 12.0,
        m * (8.0 * a * a + b * b) / 12.0,
        m * (8.0 * a * a + c * c) / 12.0,
        m * a * c / 4.0,
        m * a * b / 4.0,
        m * b * c / 16.0,
    );
    let text = spoilt(&[("inertia: (0.01, 1.0, 1.0)", &printed)]);
    let crane = read(&text).expect("a figure");
    let doubts = crane.mass_doubts();
    assert!(matches!(&doubts[..], [MassDoubt::NotPhysical { link, .. }] if link == "jib"), "{doubts:?}");
}

#[test]
fn every_fault_is_shown_where_it_is() {
    let mut shown = String::new();
    for (what, text) in cases() {
        let error = read(&text).expect_err(what);
        let _ = writeln!(shown, "[{what}]\n{}", render(&text, &error));
    }
    insta::assert_snapshot!(shown);
}
