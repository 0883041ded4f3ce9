//! Shapes of links.

use super::pose;
use crate::tree::Lump;
use crate::xml::{Node, Reader, element, elements, elements_called, tag};
use solaris_model::{Matrix3, Placement, Shape, ShapeKind, UnitQuaternion, Vector3};

/// A simple shape of a link, in the link's frame.
pub(super) struct Solid {
    shape: Shape,
    /// Whether it is one of its collisions, and not only seen.
    pub(super) collides: bool,
    /// Its own density (kg/m³), where one is said.
    density: Option<f64>,
}

impl Solid {
    /// Its mass, by its own density or else by this one.
    pub(super) fn lump(&self, density: f64) -> Lump {
        let Shape { kind, placement } = self.shape;
        let mass = kind.volume() * self.density.unwrap_or(density);
        let turn = *placement.rotation.to_rotation_matrix().matrix();
        let principal = Matrix3::from_diagonal(&(kind.gyration_squared() * mass));
        Lump { mass, com: placement.translation.vector, inertia: turn * principal * turn.transpose() }
    }
}

/// The simple shapes of a link.
pub(super) fn solids(reader: &mut Reader, link: Node, version: u32) -> Vec<Solid> {
    let mut solids = Vec::new();
    for (kind, collides) in [("visual", false), ("collision", true)] {
        for node in elements_called(link, kind) {
            let density = element(node, "density").and_then(|density| reader.text_number(density));
            if let Some(shape) = read(reader, node, version) {
                solids.push(Solid { shape, collides, density });
            }
        }
    }
    solids
}

/// What a link looks like: its only visual, or else its only collision, where that is simple. What is not shown is listed.
pub(super) fn shape(reader: &mut Reader, link: Node, solids: &[Solid], _version: u32) -> Option<Shape> {
    for (kind, collides) in [("visual", false), ("collision", true)] {
        let nodes: Vec<Node> = elements_called(link, kind).collect();
        let own: Vec<&Solid> = solids.iter().filter(|solid| solid.collides == collides).collect();
        if let ([_], [only]) = (&nodes[..], &own[..]) {
            return Some(only.shape);
        }
        for node in nodes {
            reader.aside(format!("<{kind}>"), tag(node));
        }
    }
    None
}

/// The element of a visual's or collision's shape.
pub(super) fn form(node: Node<'_>) -> Option<Node<'_>> {
    elements(element(node, "geometry")?).next()
}

/// Whether its mass can be found.
pub(super) fn is_simple(form: Node) -> bool {
    ["box", "sphere", "cylinder", "capsule", "ellipsoid"].contains(&form.tag_name().name())
}

/// The shape of a visual or collision, where it is simple and has a size.
fn read(reader: &mut Reader, node: Node, version: u32) -> Option<Shape> {
    let form = form(node).filter(|form| is_simple(*form))?;
    let mut number = |name: &str| element(form, name).and_then(|node| reader.text_number(node));
    let (radius, length) = (number("radius").unwrap_or(1.0), number("length").unwrap_or(1.0));
    let mut lengths = |name: &str| {
        let numbers = element(form, name).and_then(|node| reader.text_numbers(node, 3..=3));
        numbers.map_or_else(|| Vector3::repeat(1.0), |numbers| Vector3::from_row_slice(&numbers))
    };
    let kind = match form.tag_name().name() {
        "box" => ShapeKind::Box { size: lengths("size") },
        "ellipsoid" => ShapeKind::Ellipsoid { radii: lengths("radii") },
        "sphere" => ShapeKind::Sphere { radius },
        "cylinder" => ShapeKind::Cylinder { radius, length },
        _ => ShapeKind::Capsule { radius, length },
    };
    let extent = match kind {
        ShapeKind::Box { size: lengths } | ShapeKind::Ellipsoid { radii: lengths } => lengths.min(),
        ShapeKind::Sphere { radius } => radius,
        ShapeKind::Cylinder { radius, length } | ShapeKind::Capsule { radius, length } => radius.min(length),
    };
    if extent <= 0.0 {
        reader.suspect(
            tag(form),
            format!("<{}>", form.tag_name().name()),
            "a length is not above zero; the shape is left out",
        );
        return None;
    }
    // Along z there, along y here.
    let upright = match kind {
        ShapeKind::Cylinder { .. } | ShapeKind::Capsule { .. } => {
            UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::FRAC_PI_2)
        }
        _ => UnitQuaternion::identity(),
    };
    let at = pose::of(reader, node, version);
    // The frame of another link says nothing of the shape here.
    let place = at.relative_to.is_none().then_some(at.place)?;
    Some(Shape { kind, placement: place * Placement::from_parts(Vector3::zeros().into(), upright) })
}
