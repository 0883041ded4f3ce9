//! The pictures of the documentation are those that the code draws.
//!
//! `UPDATE_PICTURES=1 cargo test -p solaris-dynamics --test dynamics pictures` draws them anew.

use crate::denavit_hartenberg::figures::branching_arm;
use solaris_dynamics::denavit_hartenberg::{View, picture};
use solaris_model::{Vector3, human};
use std::path::PathBuf;

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
    let view = View { azimuth: 0.35, width: 540.0, ..View::isometric(Vector3::y()) };
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
    use solaris_model::{FigureBuilder, Joint, LinkSpec};
    let joint = Joint::new("<b>&").rx();
    let figure =
        FigureBuilder::new("</title>").link(LinkSpec::root("a", joint).mass(1.0)).build().expect("valid");
    let svg = picture(&figure, &[0.0], &View::isometric(Vector3::z())).expect("a valid state");
    assert!(svg.contains("&lt;b&gt;&amp;.rx") && svg.contains("&lt;/title&gt;"));
}
