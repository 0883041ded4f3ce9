//! Shapes of links.

use super::origin;
use crate::xml::{Node, Reader, element, elements, elements_called, tag};
use solaris_model::{Placement, Shape, ShapeKind, UnitQuaternion, Vector3};

/// The simple shape of a link, as it is seen or else as it collides; of several none is the link's. What is not read is
/// listed.
pub(super) fn shape(reader: &mut Reader, link: Node) -> Option<Shape> {
    let mut shape = None;
    for kind in ["visual", "collision"] {
        let nodes: Vec<Node> = elements_called(link, kind).collect();
        let only = nodes.len() == 1 && shape.is_none();
        for node in nodes {
            let read = read(reader, node).filter(|_| only);
            if read.is_none() {
                reader.aside(format!("<{kind}>"), tag(node));
            }
            shape = shape.or(read);
        }
    }
    shape
}

fn read(reader: &mut Reader, node: Node) -> Option<Shape> {
    let geometry = element(node, "geometry")?;
    let form = elements(geometry).next()?;
    let name = form.tag_name().name();
    let kind = match name {
        "box" => reader.numbers(form, "size").map(|size| ShapeKind::Box { size: Vector3::from(size) }),
        "sphere" => reader.number(form, "radius").map(|radius| ShapeKind::Sphere { radius }),
        "cylinder" | "capsule" => {
            let (radius, length) = (reader.number(form, "radius"), reader.number(form, "length"));
            let whole = radius.zip(length);
            whole.map(|(radius, length)| match name {
                "cylinder" => ShapeKind::Cylinder { radius, length },
                _ => ShapeKind::Capsule { radius, length },
            })
        }
        _ => None,
    }?;
    if !is_solid(&kind) {
        reader.suspect(tag(form), format!("<{name}>"), "a length is not above zero; the shape is left out");
        return None;
    }
    // Along z there, along y here.
    let upright = match kind {
        ShapeKind::Cylinder { .. } | ShapeKind::Capsule { .. } => {
            UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::FRAC_PI_2)
        }
        _ => UnitQuaternion::identity(),
    };
    let placement = origin(reader, node) * Placement::from_parts(Vector3::zeros().into(), upright);
    Some(Shape { kind, placement })
}

fn is_solid(kind: &ShapeKind) -> bool {
    match *kind {
        ShapeKind::Box { size } | ShapeKind::Ellipsoid { radii: size } => {
            size.iter().all(|length| *length > 0.0)
        }
        ShapeKind::Cylinder { radius, length } | ShapeKind::Capsule { radius, length } => {
            radius > 0.0 && length > 0.0
        }
        ShapeKind::Sphere { radius } => radius > 0.0,
    }
}
