//! The figures that are timed, with their states.

use crate::peers::states::States;
use solaris_model::{
    Axis, AxisKind, Base, Figure, FigureBuilder, Inertia, Joint, LinkSpec, Matrix3, Vector3, human,
};

/// World axes (m/s²); one of the peers knows no other.
pub(super) const GRAVITY: Vector3<f64> = Vector3::new(0.0, 0.0, -9.806_65);

/// A figure with states of it.
pub(super) struct Subject {
    pub(super) name: String,
    pub(super) what: String,
    pub(super) figure: Figure,
    pub(super) states: States,
}

/// Those that need nothing but the library.
pub(super) fn own() -> Result<Vec<Subject>, String> {
    let person = turns_zyx(&human(1.75, 73.0).map_err(|error| error.to_string())?)?;
    let mut subjects =
        vec![subject("human66", "the ready person of 66 dofs, its joints spelled z-y-x", person, 10_000)];
    for (count, states) in [(10, 1024), (100, 1024), (300, 128), (1000, 64)] {
        let what = format!("{count} hinges in a row, about z, y, x by turns");
        subjects.push(subject(&format!("chain{count}"), &what, chain(count)?, states));
    }
    Ok(subjects)
}

/// The robots of the package example-robot-data in a folder of Python packages.
pub(super) fn robots(packages: &str) -> Result<Vec<Subject>, String> {
    let robot = |name: &str, what: &str, path: &str, base: Base, locked: &[&str]| {
        let path = format!("{packages}/cmeel.prefix/share/example-robot-data/robots/{path}");
        let text = std::fs::read_to_string(&path).map_err(|error| format!("{path}: {error}"))?;
        let figure = solaris_io::urdf::read(&text).map_err(|error| format!("{path}: {error}"))?.figure;
        let dofs: Vec<_> = locked.iter().map(|dof| (*dof, 0.0)).collect();
        let fused = figure.fuse_named(&dofs).map_err(|error| format!("{path}: {error}"))?;
        let figure = fused.figure().on_base(base).map_err(|error| format!("{path}: {error}"))?;
        Ok::<_, String>(subject(name, what, figure, 1024))
    };
    let fingers = ["panda_finger_joint1", "panda_finger_joint2"];
    Ok(vec![
        robot(
            "panda7",
            "an arm, its fingers fixed",
            "panda_description/urdf/panda.urdf",
            Base::Fixed,
            &fingers,
        )?,
        robot("talos", "a humanoid, free in space", "talos_data/robots/talos_reduced.urdf", Base::Free, &[])?,
        robot(
            "g1",
            "a humanoid, free in space",
            "g1_description/urdf/g1_29dof_rev_1_0.urdf",
            Base::Free,
            &[],
        )?,
    ])
}

fn subject(name: &str, what: &str, figure: Figure, count: usize) -> Subject {
    let states = States::random(&figure, count);
    Subject { name: name.to_owned(), what: what.to_owned(), figure, states }
}

/// The figure with all its triples of turns about z, y, x: what Pinocchio has a joint for.
fn turns_zyx(figure: &Figure) -> Result<Figure, String> {
    let mut builder = FigureBuilder::new("human66");
    for link in figure.links() {
        let kind = link.joint().kind();
        let slides = kind.axes().iter().any(|dof| dof.axis.kind == AxisKind::Translation);
        let joint = Joint::new(link.joint().name()).placed(*link.joint().placement());
        let joint = if slides { joint.tx().ty().tz() } else { joint };
        let joint = joint.rz().ry().rx();
        let spec = match link.parent() {
            None => LinkSpec::root(link.name(), joint),
            Some(parent) => LinkSpec::child(link.name(), figure.links()[parent].name(), joint),
        };
        let spec = spec.mass(link.mass()).com(*link.com());
        builder = builder.link(spec.inertia(Inertia::Tensor(*link.inertia())));
    }
    builder.build().map_err(|error| error.to_string())
}

/// Hinges in a row, each link lighter than the one before.
fn chain(count: usize) -> Result<Figure, String> {
    let axes = [Axis::rotation(Vector3::z()), Axis::rotation(Vector3::y()), Axis::rotation(Vector3::x())];
    let name = |i: usize| format!("link{i}");
    let mut builder = FigureBuilder::new(format!("chain{count}"));
    for i in 0..count {
        let joint = Joint::new(format!("joint{i}")).axis(axes[i % 3]);
        let spec = match i {
            0 => LinkSpec::root(name(0), joint),
            _ => LinkSpec::child(name(i), name(i - 1), joint.at(Vector3::new(0.01, 0.02, 0.1))),
        };
        let spec = spec.mass(1.0 / (1.0 + 0.01 * i as f64)).com(Vector3::new(0.01, -0.005, 0.05));
        let inertia = Matrix3::new(2e-3, 1e-4, 5e-5, 1e-4, 2.2e-3, -8e-5, 5e-5, -8e-5, 6e-4);
        builder = builder.link(spec.inertia(Inertia::Tensor(inertia)));
    }
    builder.build().map_err(|error| error.to_string())
}
