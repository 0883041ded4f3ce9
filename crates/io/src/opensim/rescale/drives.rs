//! Joints, constraints and points that move: lengths that are functions of coordinates.

use super::bodies::Bodies;
use super::edits::{Edits, alike, same};
use super::lengths::ON;
use crate::opensim::element::{child_vector, child_words, is_joint};
use crate::opensim::frames::Anchor;
use crate::opensim::function;
use crate::xml::{Node, Reader, element, elements, elements_called, tag};
use solaris_model::Vector3;

/// What a joint hangs on.
const PARENT: [&str; 2] = ["socket_parent_frame", "parent_body"];

/// Scales what an element says of lengths that move, if anything.
pub(super) fn scale(edits: &mut Edits, reader: &mut Reader, bodies: &mut Bodies, node: Node) {
    match node.tag_name().name() {
        name if is_joint(name) => joint(edits, reader, bodies, node),
        "MovingPathPoint" | "MovingMusclePoint" => {
            let Some(at) = bodies.holder(reader, node, &ON) else { return };
            let s = bodies.factors(at.body);
            for (axis, factor) in ["x", "y", "z"].into_iter().zip(s.as_slice()) {
                if let Some(function) = location(node, axis) {
                    multiply(edits, reader, function, *factor);
                }
            }
        }
        "CoordinateCouplerConstraint" => coupler(edits, reader, bodies, node),
        "BushingForce" | "FunctionBasedBushingForce" | "ExpressionBasedBushingForce" | "WeldConstraint" => {
            // OpenSim makes frames of them, which are scaled.
            for side in ["1", "2"] {
                let Some(place) = element(node, &format!("location_body_{side}")) else { continue };
                if let Some(at) = bodies.holder(reader, node, &[format!("body_{side}").as_str()]) {
                    edits.scale(reader, place, bodies.factors(at.body).as_slice());
                }
            }
        }
        _ => {}
    }
}

/// The function of a moving point's place along an axis.
pub(super) fn location<'a>(point: Node<'a>, axis: &str) -> Option<Node<'a>> {
    let name = format!("{axis}_location");
    // The second name is that of versions before 2.
    let older = format!("{}Attachment", axis.to_uppercase());
    let holder = element(point, &name).or_else(|| element(point, &older));
    let within = holder.and_then(|holder| elements(holder).next());
    within.or_else(|| elements(point).find(|child| child.attribute("name") == Some(&name)))
}

/// The body that carries a joint.
fn parent(reader: &mut Reader, bodies: &mut Bodies, joint: Node) -> Option<Anchor> {
    bodies.holder(reader, joint, &PARENT)
}

fn joint(edits: &mut Edits, reader: &mut Reader, bodies: &mut Bodies, node: Node) {
    let Some(on) = parent(reader, bodies, node) else { return };
    let own = if bodies.has_frames() {
        bodies.holder(reader, node, &["socket_child_frame"])
    } else {
        bodies.around(reader, node)
    };
    let (on, own) =
        (bodies.factors(on.body), own.map_or_else(|| Vector3::repeat(1.0), |at| bodies.factors(at.body)));
    let winged = Vector3::new(own.x, own.y, 1.0);
    for (name, s) in [
        // Before 4.0.
        ("location_in_parent", on),
        ("location_in_child", own),
        ("location", own),
        ("radii_x_y_z", on),
        ("thoracic_ellipsoid_radii_x_y_z", on),
        ("scapula_winging_axis_origin", winged),
        ("length", Vector3::repeat(own.y)),
    ] {
        if let Some(child) = element(node, name).filter(|_| child_words(node, name).is_some()) {
            let count = match name {
                "scapula_winging_axis_origin" => 2,
                "length" => 1,
                _ => 3,
            };
            edits.scale(reader, child, &s.as_slice()[..count]);
        }
    }
    let transforms = elements_called(node, "SpatialTransform");
    for axis in transforms.flat_map(|transform| elements_called(transform, "TransformAxis")) {
        if axis.attribute("name").is_some_and(|name| name.starts_with("translation")) {
            slide(edits, reader, node, axis, &on);
        }
    }
}

/// Scales the function of a slide, unless the slide is its coordinate itself.
///
/// ```text
/// f′ = f·Σ|u_i|·s_i
/// ```
///
/// with `u` the axis and `s` the factors of the body that carries the joint, as OpenSim takes them: where the axis is oblique
/// or the joint's frame is turned, that is more or less than the slide is stretched.
fn slide(edits: &mut Edits, reader: &mut Reader, joint: Node, axis: Node, s: &Vector3<f64>) {
    let Some(function) = function::held(axis, &["coordinates", "axis"]) else { return };
    if *s == Vector3::repeat(1.0) || is_coordinate(reader, function) {
        return;
    }
    let factor = direction(reader, axis).abs().dot(s);
    let as_constant = function.tag_name().name() == "Constant";
    if as_constant && child_words(function, "value").is_none_or(|value| value.parse() == Ok(0.0)) {
        return;
    }
    if direction(reader, axis).iter().filter(|x| **x != 0.0).count() > 1 {
        let name = joint.attribute("name").unwrap_or_default();
        let message = format!(
            "its slide along an oblique axis is scaled by {factor}, the sum of its parts, as OpenSim does; look at it"
        );
        reader.suspect(tag(axis), format!("joint '{name}'"), message);
    }
    multiply(edits, reader, function, factor);
}

/// The direction of an axis, as the file has it.
fn direction(reader: &mut Reader, axis: Node) -> Vector3<f64> {
    if child_words(axis, "axis").is_some() { child_vector(reader, axis, "axis") } else { Vector3::x() }
}

/// Whether a function has the value of its coordinate.
fn is_coordinate(reader: &mut Reader, function: Node) -> bool {
    let coefficients =
        element(function, "coefficients").filter(|_| child_words(function, "coefficients").is_some());
    function.tag_name().name() == "LinearFunction"
        && coefficients
            .is_none_or(|node| reader.text_numbers(node, 2..=2).is_some_and(|line| line == [1.0, 0.0]))
}

/// Multiplies a function by a factor, as OpenSim does it.
fn multiply(edits: &mut Edits, reader: &mut Reader, function: Node, factor: f64) {
    if same(factor, 1.0) {
        return;
    }
    match function.tag_name().name() {
        "MultiplierFunction" => edits.scale_child(reader, function, "scale", 1.0, &[factor]),
        "Constant" => edits.scale_child(reader, function, "value", 0.0, &[factor]),
        _ => {
            let name =
                function.attribute("name").map_or_else(String::new, |name| format!(" name=\"{name}\""));
            let before = format!("<MultiplierFunction{name}><function>");
            edits.wrap(function, before, format!("</function><scale>{factor}</scale></MultiplierFunction>"));
        }
    }
}

/// Scales what a coordinate that slides is made to be.
fn coupler(edits: &mut Edits, reader: &mut Reader, bodies: &mut Bodies, node: Node) {
    let Some(dependent) = child_words(node, "dependent_coordinate_name") else { return };
    let Some((joint, along)) = sliding(reader, bodies.model, dependent) else { return };
    let Some(on) = parent(reader, bodies, joint) else { return };
    let s = bodies.factors(on.body);
    edits.scale_child(reader, node, "scale_factor", 1.0, &[along.abs().dot(&s)]);
    if alike(&s).is_none() {
        let name = node.attribute("name").unwrap_or_default();
        let message = "its slide is scaled as the parent is along it; OpenSim refuses several factors here";
        reader.note(tag(node), format!("constraint '{name}'"), message);
    }
}

/// The joint of a coordinate that is a slide by itself, and the slide's axis.
fn sliding<'a>(reader: &mut Reader, model: Node<'a>, coordinate: &str) -> Option<(Node<'a>, Vector3<f64>)> {
    let named = |node: &Node| node.has_tag_name("Coordinate") && node.attribute("name") == Some(coordinate);
    let found = model.descendants().find(named)?;
    let joint = found.ancestors().find(|node| is_joint(node.tag_name().name()))?;
    let index = found.prev_siblings().skip(1).filter(Node::is_element).count();
    match joint.tag_name().name() {
        "SliderJoint" => Some((joint, Vector3::x())),
        "PlanarJoint" if index > 0 => Some((joint, Vector3::ith(index.min(2) - 1, 1.0))),
        "FreeJoint" if index > 2 => Some((joint, Vector3::ith(index.min(5) - 3, 1.0))),
        "CustomJoint" => {
            let axes = elements_called(joint, "SpatialTransform")
                .flat_map(|transform| elements_called(transform, "TransformAxis"))
                .filter(|axis| axis.attribute("name").is_some_and(|name| name.starts_with("translation")))
                .filter(|axis| child_words(*axis, "coordinates") == Some(coordinate));
            for axis in axes {
                let function = function::held(axis, &["coordinates", "axis"]);
                if function.is_none_or(|function| is_coordinate(reader, function)) {
                    return Some((joint, direction(reader, axis)));
                }
            }
            None
        }
        _ => None,
    }
}
