//! The parts of a model that are not read, by name.

use super::couplers::COUPLER;
use super::element::{child_words, is_joint, members};
use super::frames::{OFFSET, THROUGH_POINTS};
use crate::xml::{Node, Reader, element, elements, elements_called, shown, tag};

/// Children of a model that are read, or say nothing that could be left out.
const READ: [&str; 8] =
    ["Ground", "gravity", "BodySet", "JointSet", "ConstraintSet", "MarkerSet", "length_units", "force_units"];
/// Sets whose members may matter to the motion.
const SETS: [&str; 5] = ["ForceSet", "ControllerSet", "ProbeSet", "ComponentSet", "AnalysisSet"];
/// Sets whose members do not.
const ASIDE_SETS: [&str; 2] = ["ContactGeometrySet", "FrameSet"];
/// Children that are about the file or its looks.
const ASIDES: [&str; 8] = [
    "credits",
    "publications",
    "defaults",
    "notes",
    "ModelVisualPreferences",
    "assembly_accuracy",
    "use_visualizer",
    "appliesForce",
];

/// Lists what is not read: what may matter one by one, looks and contacts in one sentence.
pub(super) fn list(reader: &mut Reader, model: Node) {
    units(reader, model);
    for child in elements(model) {
        let name = child.tag_name().name();
        if READ.contains(&name) {
            continue;
        }
        if SETS.contains(&name) || name == "components" {
            let members = if name == "components" { elements(child).collect() } else { objects_of(child) };
            for member in members.into_iter().filter(|member| !is_read(member.tag_name().name())) {
                reader.unread_element(member);
            }
        } else if ASIDE_SETS.contains(&name) {
            for member in objects_of(child) {
                aside(reader, member);
            }
        } else if ASIDES.contains(&name) {
            aside(reader, child);
        } else if elements(child).next().is_some() || !super::words(child).is_empty() {
            reader.unread_element(child);
        }
    }
    for body in members(model, "BodySet", |tag| tag == "Body").into_iter().chain(element(model, "Ground")) {
        frame(reader, body);
    }
    let joints = members(model, "JointSet", is_joint);
    for inner in joints.into_iter().flat_map(|joint| elements_called(joint, "frames")).flat_map(elements) {
        frame(reader, inner);
    }
}

/// Whether members of `components` that are called so are read.
fn is_read(tag: &str) -> bool {
    matches!(tag, "Body" | OFFSET | THROUGH_POINTS | COUPLER) || is_joint(tag)
}

/// A body, ground or another frame: everything but where it is and what it weighs.
fn frame(reader: &mut Reader, node: Node) {
    for child in elements(node) {
        match child.tag_name().name() {
            "mass" | "mass_center" | "inertia" | "Joint" | "socket_parent" | "translation"
            | "orientation" => {}
            name if name.starts_with("inertia_") => {}
            "WrapObjectSet" => objects_of(child).into_iter().for_each(|member| aside(reader, member)),
            "attached_geometry" => elements(child).for_each(|member| aside(reader, member)),
            "FrameGeometry" | "VisibleObject" | "Geometry" => aside(reader, child),
            "components" => elements(child)
                .filter(|member| !is_read(member.tag_name().name()))
                .for_each(|member| reader.unread_element(member)),
            _ => reader.unread_element(child),
        }
    }
}

fn aside(reader: &mut Reader, node: Node) {
    reader.aside(format!("<{}>", node.tag_name().name()), tag(node));
}

fn objects_of(set: Node) -> Vec<Node> {
    elements_called(set, "objects").flat_map(elements).collect()
}

/// Numbers are taken for metres and newtons.
fn units(reader: &mut Reader, model: Node) {
    for (name, known) in
        [("length_units", ["meters", "m", "meter"]), ("force_units", ["N", "newtons", "newton"])]
    {
        let told = child_words(model, name).unwrap_or(known[0]);
        if !known.iter().any(|unit| unit.eq_ignore_ascii_case(told)) {
            let span = element(model, name).map_or_else(|| tag(model), tag);
            let message =
                format!("they are '{}'; numbers are read as {} all the same", shown(told), known[0]);
            reader.suspect(span, format!("<{name}>"), message);
        }
    }
}
