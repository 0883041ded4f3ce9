//! A figure as a model of MuJoCo's: the same links, joints, masses and inertias, and what can touch the ground.

use solaris_model::{AxisKind, Figure, Vector3};
use solaris_modes::{ContactPoint, GroundPlane};
use std::fmt::Write;

/// Of the spheres that stand for points (m); MuJoCo knows none without a size.
const POINT: f64 = 1e-6;

/// What can touch the ground.
pub(crate) type Ground<'a> = Option<(&'a GroundPlane, &'a [ContactPoint])>;

/// The text of the model. All joints are slides and hinges, so that coordinates are ours, in MuJoCo's [order].
pub(crate) fn text(figure: &Figure, gravity: &Vector3<f64>, ground: Ground) -> String {
    let contact = if ground.is_some() { "enable" } else { "disable" };
    let mut out = format!(
        "<mujoco model=\"{}\">\n<compiler angle=\"radian\" autolimits=\"false\" inertiafromgeom=\"false\" boundmass=\"0\" \
         boundinertia=\"0\" balanceinertia=\"false\"/>\n<option gravity=\"{}\" cone=\"elliptic\"><flag contact=\"{contact}\" \
         constraint=\"{contact}\" limit=\"disable\" frictionloss=\"disable\"/></option>\n<worldbody>\n",
        figure.name(),
        words(gravity.as_slice()),
    );
    if let Some((plane, _)) = ground {
        let friction = plane.friction;
        let _ = writeln!(
            out,
            "<geom type=\"plane\" size=\"0 0 1\" zaxis=\"0 1 0\" contype=\"1\" conaffinity=\"0\" friction=\"{friction} 0 0\"/>"
        );
    }
    let roots = (0..figure.links().len()).filter(|link| figure.links()[*link].parent().is_none());
    roots.for_each(|root| body(&mut out, figure, ground, root));
    out + "</worldbody>\n</mujoco>\n"
}

/// For each of MuJoCo's coordinates, the index of ours: it goes into the depth of a tree first, and a figure need not.
pub(crate) fn order(figure: &Figure) -> Vec<usize> {
    let mut order = Vec::new();
    let roots = (0..figure.links().len()).filter(|link| figure.links()[*link].parent().is_none());
    roots.for_each(|root| descend(figure, root, &mut order));
    order
}

fn descend(figure: &Figure, index: usize, order: &mut Vec<usize>) {
    let at = figure.layout().joints()[index];
    order.extend(at.q..at.q + at.nq);
    children(figure, index).for_each(|child| descend(figure, child, order));
}

fn children(figure: &Figure, index: usize) -> impl Iterator<Item = usize> {
    (index + 1..figure.links().len()).filter(move |child| figure.links()[*child].parent() == Some(index))
}

/// A link and what it carries.
fn body(out: &mut String, figure: &Figure, ground: Ground, index: usize) {
    let link = &figure.links()[index];
    let placement = link.joint().placement();
    let turn = placement.rotation;
    // Writing into a string does not fail.
    let _ = writeln!(
        out,
        "<body name=\"{}\" pos=\"{}\" quat=\"{}\">",
        link.name(),
        words(placement.translation.vector.as_slice()),
        words(&[turn.w, turn.i, turn.j, turn.k]),
    );
    for dof in link.joint().kind().axes() {
        let kind = if dof.axis.kind == AxisKind::Rotation { "hinge" } else { "slide" };
        let _ = writeln!(out, "<joint type=\"{kind}\" axis=\"{}\"/>", words(dof.axis.direction.as_slice()));
    }
    let i = link.inertia();
    let tensor = [i[(0, 0)], i[(1, 1)], i[(2, 2)], i[(0, 1)], i[(0, 2)], i[(1, 2)]];
    let _ = writeln!(
        out,
        "<inertial mass=\"{}\" pos=\"{}\" fullinertia=\"{}\"/>",
        link.mass(),
        words(link.com().as_slice()),
        words(&tensor)
    );
    let touches = ground.into_iter().flat_map(|(plane, points)| points.iter().map(|at| (plane.friction, at)));
    for (friction, touch) in touches.filter(|(_, touch)| touch.link == index) {
        let centre = touch.center + POINT * Vector3::y();
        let _ = writeln!(
            out,
            "<geom type=\"sphere\" size=\"{POINT}\" pos=\"{}\" contype=\"0\" conaffinity=\"1\" friction=\"{friction} 0 0\"/>",
            words(centre.as_slice()),
        );
    }
    children(figure, index).for_each(|child| body(out, figure, ground, child));
    out.push_str("</body>\n");
}

fn words(numbers: &[f64]) -> String {
    numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(" ")
}
