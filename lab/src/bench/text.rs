//! A figure as the flat text of [`crate::peers::model`] and as a URDF.

use super::figures::GRAVITY;
use nalgebra::{Isometry3, Matrix3, Vector3};
use solaris_model::{Axis, AxisKind, Figure, JointKind, Link};
use std::fmt::Write;

/// A joint with at most one body.
struct Row<'a> {
    name: String,
    kind: &'static str,
    parent: Option<usize>,
    placement: Isometry3<f64>,
    axis: Vector3<f64>,
    body: Option<&'a Link>,
}

/// The flat text. Where `composite`, slides along x, y, z and turns about z, y, x that follow each other are one joint each.
pub(super) fn flat(name: &str, figure: &Figure, composite: bool) -> String {
    let rows = rows(figure, composite);
    let (layout, g) = (figure.layout(), GRAVITY);
    let mut out = format!("{name} {} {} {} {} {} {}\n", rows.len(), layout.nq(), layout.nv(), g.x, g.y, g.z);
    for row in &rows {
        let parent = row.parent.map_or("-1".to_owned(), |parent| parent.to_string());
        let (mass, com, inertia) = body(row.body);
        let i = inertia;
        let mut numbers: Vec<f64> =
            row.placement.rotation.to_rotation_matrix().matrix().transpose().iter().copied().collect();
        numbers.extend(row.placement.translation.vector.iter().chain(&row.axis));
        numbers.push(mass);
        numbers.extend(com.iter());
        numbers.extend([i[(0, 0)], i[(0, 1)], i[(0, 2)], i[(1, 1)], i[(1, 2)], i[(2, 2)]]);
        // Writing into a string does not fail.
        let _ = writeln!(out, "{} {} {parent} {}", row.name, row.kind, words(&numbers));
    }
    out
}

/// The URDF of a figure without free joints: the joint of column `k` is called `dofk`.
pub(super) fn urdf(name: &str, figure: &Figure) -> String {
    let rows = rows(figure, false);
    let mut out = format!("<robot name=\"{name}\">\n<link name=\"world\"/>\n");
    for (k, row) in rows.iter().enumerate() {
        let _ = write!(out, "<link name=\"body{k}\">");
        if row.body.is_some() {
            let (mass, com, i) = body(row.body);
            let _ = write!(
                out,
                "<inertial><origin xyz=\"{}\"/><mass value=\"{mass}\"/><inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" \
                 izz=\"{}\"/></inertial>",
                words(com.as_slice()),
                i[(0, 0)],
                i[(0, 1)],
                i[(0, 2)],
                i[(1, 1)],
                i[(1, 2)],
                i[(2, 2)]
            );
        }
        let kind = if row.kind.starts_with('R') { "continuous" } else { "prismatic" };
        let parent = row.parent.map_or("world".to_owned(), |parent| format!("body{parent}"));
        let (roll, pitch, yaw) = row.placement.rotation.euler_angles();
        let _ = writeln!(
            out,
            "</link>\n<joint name=\"dof{k}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"body{k}\"/><origin xyz=\"{}\" \
             rpy=\"{roll} {pitch} {yaw}\"/><axis xyz=\"{}\"/><limit lower=\"-1e9\" upper=\"1e9\" effort=\"1e9\" velocity=\"1e9\"/></joint>",
            words(row.placement.translation.vector.as_slice()),
            words(row.axis.as_slice()),
        );
    }
    out + "</robot>\n"
}

/// The joints, one behind the other; what is welded to the world is left out.
fn rows(figure: &Figure, composite: bool) -> Vec<Row<'_>> {
    let (mut rows, mut last) = (Vec::<Row<'_>>::new(), Vec::new());
    for link in figure.links() {
        let mut parent = link.parent().and_then(|parent: usize| last[parent]);
        let mut placement = *link.joint().placement();
        let joints = joints(link.joint().kind(), composite);
        for (index, (kind, axis)) in joints.iter().enumerate() {
            let name = format!("{}.{index}", link.name().replace(' ', "_"));
            let body = (index + 1 == joints.len()).then_some(link);
            rows.push(Row { name, kind, parent, placement, axis: *axis, body });
            (parent, placement) = (Some(rows.len() - 1), Isometry3::identity());
        }
        last.push(parent);
    }
    rows
}

fn joints(kind: &JointKind, composite: bool) -> Vec<(&'static str, Vector3<f64>)> {
    if kind.quaternion().is_some() {
        return vec![("FF", Vector3::zeros())];
    }
    let mut joints: Vec<_> = kind.axes().iter().map(|dof| single(&dof.axis)).collect();
    for (three, one) in [(["PX", "PY", "PZ"], "T3"), (["RZ", "RY", "RX"], "SZYX")] {
        let place = (0..joints.len()).find(|at| {
            joints[*at..].len() >= 3 && joints[*at..].iter().map(|(kind, _)| *kind).take(3).eq(three)
        });
        if let Some(at) = place.filter(|_| composite) {
            joints.splice(at..at + 3, [(one, Vector3::zeros())]);
        }
    }
    joints
}

fn single(axis: &Axis) -> (&'static str, Vector3<f64>) {
    let turns = axis.kind == AxisKind::Rotation;
    let direction = axis.direction.normalize();
    let along = (0..3).find(|&i| (direction[i] - 1.0).abs() < 1e-15);
    let kind = match (turns, along) {
        (true, Some(i)) => ["RX", "RY", "RZ"][i],
        (true, None) => "RU",
        (false, Some(i)) => ["PX", "PY", "PZ"][i],
        (false, None) => "PU",
    };
    (kind, direction)
}

fn body(link: Option<&Link>) -> (f64, Vector3<f64>, Matrix3<f64>) {
    link.map_or((0.0, Vector3::zeros(), Matrix3::zeros()), |link| (link.mass(), *link.com(), *link.inertia()))
}

fn words(numbers: &[f64]) -> String {
    numbers.iter().map(|x| format!("{x:e}")).collect::<Vec<_>>().join(" ")
}
