//! The pictures of the documentation are those that the code draws.
//!
//! `UPDATE_PICTURES=1 cargo test -p solaris-view --test view denavit_hartenberg` draws them anew.

use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, Vector3, human};
use solaris_view::ViewError;
use solaris_view::denavit_hartenberg::{View, picture};
use std::path::PathBuf;

/// Four joints, of which one slides and one has two degrees of freedom, with a branch.
fn branching_arm() -> Figure {
    let link =
        |name: &str, parent: &str, joint: Joint, mass: f64| LinkSpec::child(name, parent, joint).mass(mass);
    let shoulder = Joint::new("shoulder").at(Vector3::new(0.15, 0.4, 0.0)).rx();
    let elbow = Joint::new("elbow").at(Vector3::new(0.0, 0.0, 0.6)).rx();
    let rail = Joint::new("rail").at(Vector3::new(0.0, 0.12, 0.3)).tz().ry();
    FigureBuilder::new("arm")
        .link(LinkSpec::root("turret", Joint::new("base").ry()).mass(4.0))
        .link(link("upper_arm", "turret", shoulder, 2.0).com(Vector3::new(0.0, 0.0, 0.3)))
        .link(
            link("forearm", "upper_arm", elbow, 1.0)
                .com(Vector3::new(0.0, 0.0, 0.25))
                .tip(Vector3::new(0.0, 0.0, 0.5)),
        )
        .link(
            link("lamp", "upper_arm", rail, 0.5)
                .com(Vector3::new(0.0, 0.05, 0.0))
                .tip(Vector3::new(0.0, 0.1, 0.15)),
        )
        .build()
        .expect("valid")
}

fn compare(name: &str, drawn: &str) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../docs").join(name);
    if std::env::var_os("UPDATE_PICTURES").is_some() {
        std::fs::write(&path, drawn).expect("docs can be written");
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default();
    let is_same = words(&kept).len() == words(drawn).len()
        && words(&kept).iter().zip(words(drawn)).all(|(kept, drawn)| {
            match (kept.parse::<f64>(), drawn.parse::<f64>()) {
                // A last digit may be rounded otherwise elsewhere.
                (Ok(kept), Ok(drawn)) => (kept - drawn).abs() < 0.15,
                _ => *kept == drawn,
            }
        });
    assert!(is_same, "docs/{name} is not what the code draws: draw it anew with UPDATE_PICTURES=1");
}

/// The numbers of a drawing and what stands between them.
fn words(svg: &str) -> Vec<&str> {
    svg.split(['"', ' ', 'M', 'L', 'Z', '\n']).collect()
}

#[test]
fn an_arm_with_a_branch() {
    let view = View { azimuth: 0.35, ..View::isometric(Vector3::y()) };
    let q = [0.0, -0.5, 0.8, 0.1, 0.3];
    compare("dh-arm.svg", &picture(&branching_arm(), &q, &view).expect("a valid state"));
}

#[test]
fn a_leg() {
    let figure = human(1.75, 73.0).expect("within range");
    let links = ["left_thigh", "left_shank", "left_foot", "left_toes"];
    let links = links.map(|name| figure.link_index(name).expect("a link of the human")).to_vec();
    let mut q = vec![0.0; figure.layout().nq()];
    for (dof, angle) in [("left_hip.rx", -0.6), ("left_knee.rx", 0.7), ("left_ankle.rx", -0.1)] {
        q[figure.layout().dof_index(dof).expect("a dof of the human")] = angle;
    }
    let view = View { azimuth: -0.55, links, ..View::isometric(Vector3::y()) };
    compare("dh-leg.svg", &picture(&figure, &q, &view).expect("a valid state"));
}

#[test]
fn names_cannot_break_the_document() {
    let joint = Joint::new("<b>&").rx();
    let figure =
        FigureBuilder::new("</title>").link(LinkSpec::root("a", joint).mass(1.0)).build().expect("valid");
    let svg = picture(&figure, &[0.0], &View::isometric(Vector3::z())).expect("a valid state");
    assert!(svg.contains("&lt;b&gt;&amp;.rx") && svg.contains("&lt;/title&gt;"));
}

/// A pendulum of half a metre that hangs along −y, seen with y up: the drawing hangs too, and the table has its constant.
#[test]
fn what_is_below_is_drawn_below() {
    let bob = Vector3::new(0.0, -0.5, 0.0);
    let second = LinkSpec::child("second", "first", Joint::new("knee").at(bob).rx()).mass(1.0).tip(bob);
    let figure = FigureBuilder::new("pendulum")
        .link(LinkSpec::root("first", Joint::new("hip").rx()).mass(1.0).tip(bob))
        .link(second)
        .build()
        .expect("valid");
    let svg = picture(&figure, &[0.0, 0.0], &View::isometric(Vector3::y())).expect("a valid state");
    let place = |name: &str| -> f64 {
        let text = svg.lines().find(|line| line.contains(&format!(">{name}<"))).expect(name);
        text.split("y=\"").nth(1).and_then(|y| y.split('"').next()).and_then(|y| y.parse().ok()).expect(name)
    };
    assert!(place("first") + 50.0 < place("second"), "{svg}");
    assert!(svg.contains(">hip.rx<") && svg.contains(">knee.rx<"), "{svg}");
    assert!(svg.contains(">0.5<") || svg.contains(">−0.5<"), "{svg}");
}

#[test]
fn a_state_of_the_wrong_length_is_refused() {
    let error =
        picture(&branching_arm(), &[0.0], &View::isometric(Vector3::y())).expect_err("five are needed");
    assert!(matches!(error, ViewError::Dynamics(_)), "{error}");
}
