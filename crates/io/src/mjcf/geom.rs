//! `<geom>`: simple solids.

use super::compiler::Compiler;
use super::defaults::Resolved;
use super::mesh::{Meshes, Solid};
use super::model::Model;
use super::orientation::{placement, to_direction};
use super::shell::surface;
use crate::tree::Lump;
use crate::xml::{Node, Reader, tag, value_span};
use solaris_model::{ImmersedShape, Matrix3, Placement, Shape, ShapeKind, UnitQuaternion, Vector3};

/// A solid with its mass, in the body's frame.
pub(super) struct Geom {
    pub(super) lump: Lump,
    pub(super) shape: Shape,
    /// The group that it belongs to.
    pub(super) group: f64,
    /// The axes of its inertia.
    pub(super) axes: UnitQuaternion<f64>,
    /// What a fluid meets of it, where it meets the geom rather than the body.
    pub(super) fluid: Option<(Placement, ImmersedShape)>,
}

impl Geom {
    /// What stands for a geom that cannot be read.
    pub(super) fn unknown() -> Self {
        let lump = Lump { mass: 1.0, com: Vector3::zeros(), inertia: Matrix3::zeros() };
        let shape = Shape { kind: ShapeKind::Sphere { radius: 1.0 }, placement: Placement::identity() };
        Self { lump, shape, group: 0.0, axes: UnitQuaternion::identity(), fluid: None }
    }

    /// A solid that stands `at` a place with its axis along z, as MuJoCo's do.
    fn of_solid(kind: ShapeKind, at: Placement, mass: f64, group: f64) -> Self {
        let upright = match kind {
            ShapeKind::Cylinder { .. } | ShapeKind::Capsule { .. } => {
                UnitQuaternion::from_scaled_axis(Vector3::x() * std::f64::consts::FRAC_PI_2)
            }
            _ => UnitQuaternion::identity(),
        };
        let turn = *at.rotation.to_rotation_matrix().matrix();
        let mut moments = kind.gyration_squared() * mass;
        if upright != UnitQuaternion::identity() {
            // Along z there, along y here.
            moments = Vector3::new(moments.x, moments.z, moments.y);
        }
        let inertia = turn * Matrix3::from_diagonal(&moments) * turn.transpose();
        let lump = Lump { mass, com: at.translation.vector, inertia: (inertia + inertia.transpose()) / 2.0 };
        Self { lump, shape: Shape { kind, placement: at * upright }, group, axes: at.rotation, fluid: None }
    }

    /// The solid of a mesh, drawn as the box of its inertia; a fluid meets that round its corners.
    fn of_mesh(solid: &Solid, at: Placement, mass: f64, group: f64, in_fluid: bool) -> Self {
        let turn = *at.rotation.to_rotation_matrix().matrix();
        let inertia = turn * solid.gyration * turn.transpose() * mass;
        let com = at.rotation * solid.com + at.translation.vector;
        let lump = Lump { mass, com, inertia: (inertia + inertia.transpose()) / 2.0 };
        let (kind, within) = solid.fitted("box", in_fluid, 1.0);
        let placement = at * within;
        Self { lump, shape: Shape { kind, placement }, group, axes: placement.rotation, fluid: None }
    }
}

/// What a geom turned out to be.
pub(super) enum Read {
    Solid(Box<Geom>),
    /// Of a kind that is not read, whose mass is missing: why.
    Unread(String),
    /// Reported.
    Faulty,
    /// Of a kind without mass.
    Nothing,
}

const READ: [&str; 19] = [
    "name",
    "class",
    "type",
    "pos",
    "quat",
    "axisangle",
    "euler",
    "xyaxes",
    "zaxis",
    "fromto",
    "size",
    "mass",
    "density",
    "group",
    "shellinertia",
    "mesh",
    "fluidshape",
    "fluidcoef",
    "fitscale",
];
const ASIDES: [&str; 18] = [
    "adhesion",
    "castshadow",
    "conaffinity",
    "condim",
    "contype",
    "friction",
    "gap",
    "margin",
    "material",
    "priority",
    "rgba",
    "solimp",
    "solmix",
    "solref",
    "surfacevel",
    "user",
    "hfield",
    "solid",
];

/// Lists the attributes that are not read.
pub(super) fn check_attributes(reader: &mut Reader, node: Node) {
    reader.check_attributes_but(node, &READ, &ASIDES);
}

/// Where a geom stands.
pub(super) struct At<'m, 'a> {
    /// The frame around it, in that of its body.
    pub(super) frame: Placement,
    pub(super) models: &'m [Model<'a>],
    /// The model that it is of.
    pub(super) model: usize,
    /// Whether the body's mass is that of its geoms.
    pub(super) counts: bool,
    /// Whether there is a fluid.
    pub(super) in_fluid: bool,
}

/// Reads a geom; meshes are read where their mass counts, or a fluid meets them.
pub(super) fn read(reader: &mut Reader, element: &Resolved, at: &At, meshes: &mut Meshes) -> Read {
    let in_fluid = at.in_fluid && element.text("fluidshape") == Some("ellipsoid");
    let mut read = read_solid(reader, element, at, meshes, in_fluid);
    if let (Read::Solid(geom), true) = (&mut read, in_fluid) {
        let mut coefficients = [0.5, 0.25, 1.5, 1.0, 1.0];
        let given = element.list(reader, "fluidcoef", 1..=5).unwrap_or_default();
        coefficients.iter_mut().zip(given).for_each(|(coefficient, given)| *coefficient = given);
        let radii = match geom.shape.kind {
            ShapeKind::Sphere { radius } => Vector3::repeat(radius),
            ShapeKind::Capsule { radius, length } => Vector3::new(radius, radius, length / 2.0 + radius),
            ShapeKind::Cylinder { radius, length } => Vector3::new(radius, radius, length / 2.0),
            ShapeKind::Ellipsoid { radii } => radii,
            ShapeKind::Box { size } => size / 2.0,
        };
        let at = Placement::from_parts(geom.lump.com.into(), geom.axes);
        geom.fluid = Some((at, ImmersedShape::Ellipsoid { radii, coefficients }));
    }
    read
}

fn read_solid(reader: &mut Reader, element: &Resolved, at: &At, meshes: &mut Meshes, in_fluid: bool) -> Read {
    let compiler = &at.models[at.model].compiler;
    let kind = element.text("type").unwrap_or("sphere");
    match kind {
        "plane" => return Read::Nothing,
        "mesh" | "sdf" | "hfield" => {}
        "sphere" | "capsule" | "ellipsoid" | "cylinder" | "box" => {
            if element.said("mesh").is_none() {
                return solid(reader, element, kind, &at.frame, compiler)
                    .map_or(Read::Faulty, |geom| Read::Solid(Box::new(geom)));
            }
        }
        _ => {
            let message = format!(
                "'type' is '{kind}'; it must be one of sphere, capsule, ellipsoid, cylinder, box, plane, mesh, hfield, sdf"
            );
            reader.fault(element.span("type"), message);
            return Read::Faulty;
        }
    }
    let group = element.number(reader, "group").unwrap_or(0.0);
    let (mass, density) = (element.number(reader, "mass"), element.number(reader, "density"));
    let weightless = mass == Some(0.0) || (mass.is_none() && density == Some(0.0));
    let silent = !at.counts || weightless || !(compiler.groups.0..=compiler.groups.1).contains(&group);
    if silent && !in_fluid {
        reader.aside(format!("<geom type=\"{kind}\">"), tag(element.node));
        return Read::Nothing;
    }
    let Some(mesh) = element.text("mesh") else {
        return Read::Unread(match kind {
            "sdf" => "its shape is a plugin's".to_owned(),
            "hfield" => "the solid under a height field is not read".to_owned(),
            _ => "it names no mesh".to_owned(),
        });
    };
    let solid = match meshes.solid(reader, at.models, at.model, mesh) {
        Ok(solid) => solid,
        Err(_) if silent => {
            let message = "their meshes were not read, and no forces of the fluid on them are found";
            reader.lacks("meshes in the fluid", message, tag(element.node), mesh);
            return Read::Nothing;
        }
        Err(why) => return Read::Unread(format!("mesh '{mesh}': {why}")),
    };
    let frame = at.frame * placement(reader, element, compiler);
    let weight = |reader: &mut Reader, volume: f64| weight(reader, element, volume);
    let geom = if matches!(kind, "mesh" | "sdf") {
        weight(reader, solid.volume).map(|mass| Geom::of_mesh(&solid, frame, mass, group, in_fluid))
    } else {
        let scale = element.number(reader, "fitscale").unwrap_or(1.0);
        let (kind, within) = solid.fitted(kind, compiler.meshes.fit_box, scale);
        weight(reader, kind.volume()).map(|mass| Geom::of_solid(kind, frame * within, mass, group))
    };
    geom.map_or(Read::Faulty, |geom| Read::Solid(Box::new(geom)))
}

fn solid(
    reader: &mut Reader,
    element: &Resolved,
    kind: &str,
    frame: &Placement,
    compiler: &Compiler,
) -> Option<Geom> {
    let size = element.list(reader, "size", 1..=3).unwrap_or_default();
    let mut size = [0, 1, 2].map(|i| size.get(i).copied().unwrap_or(0.0));
    // From the second point to the first: which way MuJoCo turns z, with which x and y turn, too.
    let mut back = None;
    let at = match element.said("fromto") {
        None => placement(reader, element, compiler),
        Some(said) => {
            let [x, y, z, u, v, w] = reader.numbers(said, "fromto")?;
            let (from, to) = (Vector3::new(x, y, z), Vector3::new(u, v, w));
            let span = value_span(said, "fromto");
            if kind == "sphere" {
                reader.fault(span, "a sphere has no 'fromto'");
                return None;
            }
            let Some(along) = super::orientation::direction(&(to - from)) else {
                reader.fault(span, "the two points of 'fromto' are the same");
                return None;
            };
            if element.said("pos").is_some() {
                reader.suspect(
                    span,
                    "<geom>",
                    "it has both 'pos' and 'fromto'; 'fromto' is used, MuJoCo 4 refuses it",
                );
            }
            back = Some(-along);
            let half = (to - from).norm() / 2.0;
            if matches!(kind, "box" | "ellipsoid") {
                (size[1], size[2]) = (size[0], half);
            } else {
                size[1] = half;
            }
            Placement::from_parts(((from + to) / 2.0).into(), to_direction(&along))
        }
    };
    let (kind, used) = shape_kind(kind, size);
    if let Some(bad) = size[..used].iter().find(|length| **length <= 0.0) {
        let message = format!("'size' needs {used} positive numbers for this type of geom; there is {bad}");
        reader.fault(element.span("size"), message);
        return None;
    }
    let shell = (element.text("shellinertia") == Some("true")).then(|| surface(&kind));
    if let Some(None) = shell {
        let message = "their mass is that of a surface in MuJoCo, and that of a solid here";
        let name = element.text("name").unwrap_or("ellipsoid");
        reader.lacks("ellipsoids with 'shellinertia'", message, element.span("shellinertia"), name);
    }
    let shell = shell.flatten();
    let mass = weight(reader, element, shell.map_or_else(|| kind.volume(), |(area, _)| area))?;
    let group = element.number(reader, "group").unwrap_or(0.0);
    let mut geom = Geom::of_solid(kind, frame * at, mass, group);
    if let Some((_, squares)) = shell {
        let turn = *(frame * at).rotation.to_rotation_matrix().matrix();
        let inertia = turn * Matrix3::from_diagonal(&(squares * mass)) * turn.transpose();
        geom.lump.inertia = (inertia + inertia.transpose()) / 2.0;
    }
    if let Some(back) = back {
        geom.axes = frame.rotation * to_direction(&back);
    }
    Some(geom)
}

/// The solid of MuJoCo's half sizes, and how many of these it uses.
fn shape_kind(kind: &str, [a, b, c]: [f64; 3]) -> (ShapeKind, usize) {
    match kind {
        "capsule" => (ShapeKind::Capsule { radius: a, length: 2.0 * b }, 2),
        "cylinder" => (ShapeKind::Cylinder { radius: a, length: 2.0 * b }, 2),
        "ellipsoid" => (ShapeKind::Ellipsoid { radii: Vector3::new(a, b, c) }, 3),
        "box" => (ShapeKind::Box { size: Vector3::new(a, b, c) * 2.0 }, 3),
        _ => (ShapeKind::Sphere { radius: a }, 1),
    }
}

/// Its mass (kg): as it is said, or of its volume at its density.
fn weight(reader: &mut Reader, element: &Resolved, volume: f64) -> Option<f64> {
    let (mass, density) = (element.number(reader, "mass"), element.number(reader, "density"));
    for (name, value) in [("mass", mass), ("density", density)] {
        if let Some(value) = value.filter(|value| *value < 0.0) {
            reader.fault(element.span(name), format!("'{name}' is {value}; it must be zero or more"));
            return None;
        }
    }
    Some(mass.unwrap_or_else(|| density.unwrap_or(1000.0) * volume))
}
