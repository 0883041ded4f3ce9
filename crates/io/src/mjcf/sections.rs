//! The sections of a file besides its bodies.

use crate::xml::{Node, Reader, elements, elements_called, tag, value_span};
use solaris_model::{Place, Vector3};
use std::collections::HashMap;

/// Sections whose elements act on the bodies.
const ACTING: [&str; 6] = ["actuator", "contact", "tendon", "equality", "deformable", "keyframe"];
/// Sections without any use for a motion.
const ASIDES: [&str; 7] = ["visual", "asset", "statistic", "size", "custom", "extension", "sensor"];
/// Attributes of `<option>` for the simulation's own steps.
const STEPS: [&str; 23] = [
    "timestep",
    "apirate",
    "impratio",
    "tolerance",
    "ls_tolerance",
    "noslip_tolerance",
    "ccd_tolerance",
    "sleep_tolerance",
    "mpr_tolerance",
    "o_margin",
    "o_solref",
    "o_solimp",
    "o_friction",
    "integrator",
    "cone",
    "jacobian",
    "solver",
    "iterations",
    "ls_iterations",
    "noslip_iterations",
    "ccd_iterations",
    "collision",
    "sdf_iterations",
];

/// Elements that stand for others: without them bodies would be missing.
pub(super) fn refuse_makers(reader: &mut Reader, root: Node) {
    for node in root.descendants().filter(Node::is_element) {
        let advice = match node.tag_name().name() {
            "include" => "other files are not followed: put their elements here",
            "attach" | "replicate" | "composite" | "flexcomp" => {
                "the bodies that it makes are not made here: write them out"
            }
            _ => continue,
        };
        let advice = format!(
            "<{}>: {advice} (MuJoCo saves a compiled model as one file by mj_saveLastXML)",
            node.tag_name().name()
        );
        reader.fault(tag(node), advice);
    }
}

/// Lists what is not read, and returns gravity.
pub(super) fn read(reader: &mut Reader, root: Node) -> Vector3<f64> {
    let mut gravity = Vector3::new(0.0, 0.0, -9.81);
    let mut weightless = false;
    for section in elements(root) {
        let name = section.tag_name().name();
        match name {
            "compiler" | "default" | "worldbody" => {}
            "option" => {
                reader.check_attributes_but(section, &["gravity"], &STEPS);
                gravity = reader.numbers(section, "gravity").map_or(gravity, Vector3::from);
                for flag in elements_called(section, "flag") {
                    weightless |= flag.attribute("gravity") == Some("disable");
                    flags(reader, flag);
                }
            }
            _ if ACTING.contains(&name) => {
                for child in elements(section) {
                    reader.unread(format!("<{}> of <{name}>", child.tag_name().name()), tag(child));
                }
            }
            _ if ASIDES.contains(&name) => reader.aside(format!("<{name}>"), tag(section)),
            _ => reader.unread_element(section),
        }
    }
    if weightless { Vector3::zeros() } else { gravity }
}

fn flags(reader: &mut Reader, flag: Node) {
    for attribute in flag.attributes() {
        let listed = format!("attribute '{}' of <flag>", attribute.name());
        match attribute.name() {
            "gravity" => {}
            "passive" | "spring" | "damper" | "frictionloss" | "equality" | "actuation" => {
                reader.unread(listed, attribute.range());
            }
            _ => reader.aside(listed, attribute.range()),
        }
    }
}

/// Names of one kind that are used twice are faults.
pub(super) fn unique<'a>(reader: &mut Reader, kind: &str, names: impl Iterator<Item = (Node<'a>, &'a str)>) {
    let mut places = HashMap::new();
    let mut repeated = 0;
    for (node, name) in names {
        let span = value_span(node, "name");
        let Some(first) = places.get(name) else {
            places.insert(name, span);
            continue;
        };
        repeated += 1;
        // Lines are counted for the few that will be read.
        let before = if repeated <= 100 {
            format!(" (on line {})", Place::of(reader.text(), std::ops::Range::clone(first)).line)
        } else {
            String::new()
        };
        reader.fault(span, format!("{kind} '{name}' is there already{before}; names must be unique"));
    }
}
