//! A simulation as a model of MuJoCo's, which Drake reads too: the same links, joints, masses and inertias, and what can touch.

use solaris_model::{AxisKind, Dof, Figure, JointKind, Link, Shape, ShapeKind, Vector3};
use solaris_modes::{LimitLaw, Simulation};
use std::fmt::Write;

/// Of the spheres that stand for points (m); MuJoCo knows none without a size.
const POINT: f64 = 1e-6;

/// The text of the model. Coordinates are ours, in MuJoCo's [order]; quaternions have `w` first there.
pub(crate) fn text(simulation: &Simulation) -> String {
    let (figure, grounded) = (simulation.figure(), simulation.grounded());
    let touches = touches(simulation);
    let contact = switch(touches);
    let is_limited = (0..figure.layout().nv()).any(|dof| simulation.limit_of(dof) != LimitLaw::Ignore);
    let mut out = format!(
        "<mujoco model=\"{}\">\n<compiler angle=\"radian\" autolimits=\"false\" inertiafromgeom=\"false\" boundmass=\"0\" \
         boundinertia=\"0\" balanceinertia=\"false\"/>\n<option gravity=\"{}\" cone=\"elliptic\"><flag contact=\"{contact}\" \
         constraint=\"{contact}\" limit=\"{}\" frictionloss=\"disable\"/></option>\n<worldbody>\n",
        figure.name(),
        words(simulation.gravity().as_slice()),
        switch(is_limited && touches),
    );
    if let Some((plane, _)) = grounded {
        let friction = plane.friction;
        let _ = writeln!(
            out,
            "<geom type=\"plane\" size=\"0 0 1\" zaxis=\"0 1 0\" contype=\"1\" conaffinity=\"0\" friction=\"{friction} 0 0\"/>"
        );
    }
    let roots = (0..figure.links().len()).filter(|link| figure.links()[*link].parent().is_none());
    roots.for_each(|root| body(&mut out, simulation, root));
    (0..figure.links().len())
        .filter(|link| is_lifted(figure, *link))
        .for_each(|link| body(&mut out, simulation, link));
    out + "</worldbody>\n</mujoco>\n"
}

/// Whether anything can: limits and dampers are for such scenes, the others are about the kernel.
fn touches(simulation: &Simulation) -> bool {
    simulation.grounded().is_some() || simulation.collisions().is_some()
}

fn switch(is_on: bool) -> &'static str {
    if is_on { "enable" } else { "disable" }
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

/// Whether a link flies, and what it hangs on is fixed where the world is: free joints are the world's alone there.
fn is_lifted(figure: &Figure, index: usize) -> bool {
    let link = &figure.links()[index];
    let is_fixed = |parent: usize| {
        let parent = &figure.links()[parent];
        parent.parent().is_none() && parent.joint().kind().nv() == 0
    };
    matches!(link.joint().kind(), JointKind::Free { .. }) && link.parent().is_some_and(is_fixed)
}

/// A link and what it carries.
fn body(out: &mut String, simulation: &Simulation, index: usize) {
    let figure = simulation.figure();
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
    joints(out, simulation, index);
    if link.parent().is_some() || link.joint().kind().nv() > 0 {
        inertial(out, link);
    } else {
        // What is fixed to the world has to have one that is none of a point, whatever it is.
        out.push_str("<inertial mass=\"1\" pos=\"0 0 0\" diaginertia=\"1 1 1\"/>\n");
    }
    spheres(out, simulation, index);
    let collisions = simulation.collisions().filter(|all| all.pairs.iter().flatten().any(|i| *i == index));
    if let (Some(collisions), Some(shape)) = (collisions, link.shape()) {
        solid(out, shape, collisions.friction);
    }
    children(figure, index)
        .filter(|child| !is_lifted(figure, *child))
        .for_each(|child| body(out, simulation, child));
    out.push_str("</body>\n");
}

fn inertial(out: &mut String, link: &Link) {
    let i = link.inertia();
    let tensor = [i[(0, 0)], i[(1, 1)], i[(2, 2)], i[(0, 1)], i[(0, 2)], i[(1, 2)]];
    let _ = writeln!(
        out,
        "<inertial mass=\"{}\" pos=\"{}\" fullinertia=\"{}\"/>",
        link.mass(),
        words(link.com().as_slice()),
        words(&tensor)
    );
}

/// The joints of a link, by the names of its degrees of freedom.
fn joints(out: &mut String, simulation: &Simulation, index: usize) {
    let figure = simulation.figure();
    let joint = figure.links()[index].joint();
    let at = figure.layout().joints()[index];
    let name = |i: usize| &figure.layout().v_names()[at.v + i];
    let (kind, passive) = match joint.kind() {
        JointKind::Ball { passive, .. } => ("ball", passive),
        JointKind::Free { passive, .. } => ("free", passive),
        kind => {
            for (i, dof) in kind.axes().iter().enumerate() {
                let limited = touches(simulation) && simulation.limit_of(at.v + i) != LimitLaw::Ignore;
                axis(out, name(i), dof, (touches(simulation), limited));
            }
            return;
        }
    };
    let damps = touches(simulation) && passive.damping > 0.0;
    let damping = if damps { format!(" damping=\"{}\"", passive.damping) } else { String::new() };
    let _ = writeln!(out, "<joint name=\"{}\" type=\"{kind}\"{damping}/>", joint.name());
}

/// A slide or a hinge, with its damper and its limits where they are wanted.
fn axis(out: &mut String, name: &str, dof: &Dof, (damped, limited): (bool, bool)) {
    let kind = if dof.axis.kind == AxisKind::Rotation { "hinge" } else { "slide" };
    let _ = write!(
        out,
        "<joint name=\"{name}\" type=\"{kind}\" axis=\"{}\"",
        words(dof.axis.direction.as_slice())
    );
    if damped && dof.passive.damping > 0.0 {
        let _ = write!(out, " damping=\"{}\"", dof.passive.damping);
    }
    if let Some(limits) = dof.limits.filter(|_| limited) {
        let _ = write!(out, " limited=\"true\" range=\"{} {}\"", limits.lower, limits.upper);
    }
    out.push_str("/>\n");
}

/// What of a link can touch the ground.
fn spheres(out: &mut String, simulation: &Simulation, index: usize) {
    let Some((plane, points)) = simulation.grounded() else { return };
    for touch in points.iter().filter(|touch| touch.link == index) {
        // A point is at the lowest place of the sphere that stands for it, while the link is upright.
        let radius = touch.radius.max(POINT);
        let centre = touch.center + (radius - touch.radius) * Vector3::y();
        let _ = writeln!(
            out,
            "<geom type=\"sphere\" size=\"{radius}\" pos=\"{}\" contype=\"0\" conaffinity=\"1\" friction=\"{} 0 0\"/>",
            words(centre.as_slice()),
            plane.friction,
        );
    }
}

/// The shape of a link that touches others: a box or a sphere.
fn solid(out: &mut String, shape: &Shape, friction: f64) {
    let turn = shape.placement.rotation;
    let (kind, size) = match shape.kind {
        ShapeKind::Box { size } => ("box", words((0.5 * size).as_slice())),
        ShapeKind::Sphere { radius } => ("sphere", words(&[radius])),
        // Along z there, along y here; nothing that is measured has one.
        _ => return,
    };
    let _ = writeln!(
        out,
        "<geom type=\"{kind}\" size=\"{size}\" pos=\"{}\" quat=\"{}\" contype=\"2\" conaffinity=\"2\" friction=\"{friction} 0 0\"/>",
        words(shape.placement.translation.vector.as_slice()),
        words(&[turn.w, turn.i, turn.j, turn.k]),
    );
}

fn words(numbers: &[f64]) -> String {
    numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(" ")
}
