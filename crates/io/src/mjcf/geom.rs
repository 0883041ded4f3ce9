//! `<geom>`: simple solids.

use super::compiler::Compiler;
use super::defaults::Resolved;
use super::orientation::{placement, to_direction};
use crate::tree::Lump;
use crate::xml::{Node, Reader, value_span};
use solaris_model::{Matrix3, Placement, Shape, ShapeKind, UnitQuaternion, Vector3};

/// A solid with its mass, in the body's frame.
pub(super) struct Geom {
    pub(super) lump: Lump,
    pub(super) shape: Shape,
    /// The group that it belongs to.
    pub(super) group: f64,
}

impl Geom {
    /// What stands for a geom that cannot be read.
    pub(super) fn unknown() -> Self {
        let lump = Lump { mass: 1.0, com: Vector3::zeros(), inertia: Matrix3::zeros() };
        let shape = Shape { kind: ShapeKind::Sphere { radius: 1.0 }, placement: Placement::identity() };
        Self { lump, shape, group: 0.0 }
    }
}

/// What a geom turned out to be.
pub(super) enum Read {
    Solid(Geom),
    /// Of a kind that is not read, which may have mass.
    Unread,
    /// Reported.
    Faulty,
    /// Of a kind without mass.
    Nothing,
}

const READ: [&str; 15] = [
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
];
const ASIDES: [&str; 22] = [
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
    "fluidcoef",
    "fluidshape",
    "fitscale",
    "hfield",
    "mesh",
    "solid",
];

/// Lists the attributes that are not read.
pub(super) fn check_attributes(reader: &mut Reader, node: Node) {
    reader.check_attributes_but(node, &READ, &ASIDES);
}

/// Reads a geom that stands in `frame`, a frame of its body.
pub(super) fn read(reader: &mut Reader, element: &Resolved, frame: &Placement, compiler: &Compiler) -> Read {
    let kind = element.text("type").unwrap_or("sphere");
    match kind {
        "plane" | "hfield" => return Read::Nothing,
        "mesh" | "sdf" => {
            reader.unread(format!("<geom type=\"{kind}\">"), element.span("type"));
            return Read::Unread;
        }
        "sphere" | "capsule" | "ellipsoid" | "cylinder" | "box" => {}
        _ => {
            let message = format!(
                "'type' is '{kind}'; it must be one of sphere, capsule, ellipsoid, cylinder, box, plane, mesh, hfield, sdf"
            );
            reader.fault(element.span("type"), message);
            return Read::Faulty;
        }
    }
    if element.said("mesh").is_some() {
        reader.unread("<geom> fitted to a mesh", element.span("mesh"));
        return Read::Unread;
    }
    solid(reader, element, kind, frame, compiler).map_or(Read::Faulty, Read::Solid)
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
    if element.text("shellinertia") == Some("true") {
        reader
            .unread("attribute 'shellinertia' of <geom> (it counts as solid)", element.span("shellinertia"));
    }
    let mass = mass(reader, element, &kind)?;
    let upright = match kind {
        ShapeKind::Cylinder { .. } | ShapeKind::Capsule { .. } => {
            UnitQuaternion::from_scaled_axis(Vector3::x() * std::f64::consts::FRAC_PI_2)
        }
        _ => UnitQuaternion::identity(),
    };
    let at = frame * at;
    let turn = *at.rotation.to_rotation_matrix().matrix();
    let mut moments = kind.gyration_squared() * mass;
    if upright != UnitQuaternion::identity() {
        // Along z there, along y here.
        moments = Vector3::new(moments.x, moments.z, moments.y);
    }
    let inertia = turn * Matrix3::from_diagonal(&moments) * turn.transpose();
    let lump = Lump { mass, com: at.translation.vector, inertia: (inertia + inertia.transpose()) / 2.0 };
    let shape = Shape { kind, placement: at * upright };
    Some(Geom { lump, shape, group: element.number(reader, "group").unwrap_or(0.0) })
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
fn mass(reader: &mut Reader, element: &Resolved, kind: &ShapeKind) -> Option<f64> {
    let (mass, density) = (element.number(reader, "mass"), element.number(reader, "density"));
    for (name, value) in [("mass", mass), ("density", density)] {
        if let Some(value) = value.filter(|value| *value < 0.0) {
            reader.fault(element.span(name), format!("'{name}' is {value}; it must be zero or more"));
            return None;
        }
    }
    Some(mass.unwrap_or_else(|| density.unwrap_or(1000.0) * kind.volume()))
}
