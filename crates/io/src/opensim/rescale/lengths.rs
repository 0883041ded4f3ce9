//! Places and sizes: frames, points, wrap objects, looks.

use super::bodies::Bodies;
use super::edits::{Edits, alike};
use crate::opensim::element::{child_vector, child_words, placement};
use crate::opensim::frames::OFFSET;
use crate::xml::{Node, Reader, element, elements, elements_called};
use solaris_model::Vector3;

/// Points that stand still in a frame.
const POINTS: [&str; 6] =
    ["Marker", "Station", "PathPoint", "ConditionalPathPoint", "MusclePoint", "MuscleViaPoint"];

/// The sockets by which points hang on frames.
pub(super) const ON: [&str; 2] = ["socket_parent_frame", "body"];

/// Scales what an element says of places and sizes, if anything; `is_moved` says which markers get other places.
pub(super) fn scale(
    edits: &mut Edits,
    reader: &mut Reader,
    bodies: &mut Bodies,
    node: Node,
    is_moved: impl Fn(&str) -> bool,
) {
    match node.tag_name().name() {
        OFFSET => {
            let Some(at) = bodies.holder(reader, node, &["socket_parent"]) else { return };
            child(edits, reader, node, "translation", &bodies.factors(at.body));
        }
        "Marker" if node.attribute("name").is_some_and(|name| is_moved(name.trim())) => {}
        name if POINTS.contains(&name) => {
            let Some(at) = bodies.holder(reader, node, &ON) else { return };
            child(edits, reader, node, "location", &bodies.factors(at.body));
        }
        "attached_geometry" => {
            let Some(at) = bodies.around(reader, node) else { return };
            for geometry in elements(node) {
                edits.scale_child(reader, geometry, "scale_factors", 1.0, bodies.factors(at.body).as_slice());
            }
        }
        "VisibleObject" if node.parent().is_some_and(|parent| parent.has_tag_name("Body")) => {
            let Some(at) = bodies.around(reader, node) else { return };
            looks(edits, reader, node, &bodies.factors(at.body));
        }
        name if name.starts_with("Wrap") && is_wrap_object(node) => {
            let Some(at) = bodies.around(reader, node) else { return };
            wrap_object(edits, reader, node, &bodies.factors(at.body));
        }
        _ => {}
    }
}

/// Scales the three numbers of the child `name`, which are zero where there is none.
fn child(edits: &mut Edits, reader: &mut Reader, node: Node, name: &str, s: &Vector3<f64>) {
    if let Some(child) = element(node, name).filter(|_| child_words(node, name).is_some()) {
        edits.scale(reader, child, s.as_slice());
    }
}

/// What a body looks like in versions before 4: OpenSim makes frames of the transforms (angles, then places).
fn looks(edits: &mut Edits, reader: &mut Reader, node: Node, s: &Vector3<f64>) {
    let sets = elements_called(node, "GeometrySet").flat_map(|set| elements_called(set, "objects"));
    let shapes: Vec<Node> = sets.flat_map(elements).collect();
    // Before 2.1 there are only names of files.
    if shapes.is_empty() && child_words(node, "geometry_files").is_some() {
        edits.scale_child(reader, node, "scale_factors", 1.0, s.as_slice());
    }
    for shape in &shapes {
        edits.scale_child(reader, *shape, "scale_factors", 1.0, s.as_slice());
    }
    for holder in shapes.into_iter().chain([node]) {
        if let Some(transform) =
            element(holder, "transform").filter(|_| child_words(holder, "transform").is_some())
        {
            edits.scale(reader, transform, &[1.0, 1.0, 1.0, s.x, s.y, s.z]);
        }
    }
}

fn is_wrap_object(node: Node) -> bool {
    let set = node.parent().filter(|list| list.has_tag_name("objects")).and_then(|list| list.parent());
    set.is_some_and(|set| set.has_tag_name("WrapObjectSet"))
}

/// Scales a wrap object, by how much longer its own axes become.
fn wrap_object(edits: &mut Edits, reader: &mut Reader, node: Node, s: &Vector3<f64>) {
    child(edits, reader, node, "translation", s);
    let turn = placement(Vector3::zeros(), child_vector(reader, node, "xyz_body_rotation")).rotation;
    // What scales alike keeps its digits.
    let alike = alike(s);
    let stretch = |axis: Vector3<f64>| alike.unwrap_or_else(|| (turn * axis).component_mul(s).norm());
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()].map(stretch);
    let round = f64::midpoint(x, y);
    let mut one = |name: &str, factor: f64| {
        if let Some(size) = element(node, name) {
            edits.scale(reader, size, &[factor]);
        }
    };
    match node.tag_name().name() {
        "WrapCylinder" => {
            one("radius", round);
            one("length", z);
        }
        "WrapSphere" => one("radius", alike.unwrap_or(s.sum() / 3.0)),
        "WrapTorus" => {
            one("inner_radius", round);
            one("outer_radius", round);
        }
        "WrapEllipsoid" => child(edits, reader, node, "dimensions", &Vector3::new(x, y, z)),
        _ => {}
    }
}
