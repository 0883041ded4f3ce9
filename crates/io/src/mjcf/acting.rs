//! What acts on the bodies of MuJoCo's model and has no place in a figure: each kind is said once, by name.

use super::defaults::{Defaults, Resolved};
use crate::xml::{Node, Reader, elements, tag};

/// Attributes by which a tendon acts of itself.
const OF_TENDONS: [&str; 4] = ["stiffness", "damping", "armature", "frictionloss"];
/// Attributes by which an actuator acts on its joint without any command.
const OF_ACTUATORS: [&str; 2] = ["armature", "damping"];

/// Goes through `<tendon>`, `<actuator>`, `<equality>` and `<deformable>`.
pub(super) fn read(reader: &mut Reader, section: Node, defaults: &Defaults) {
    let kind = section.tag_name().name();
    for node in elements(section) {
        let element = node.tag_name().name();
        let name = node.attribute("name").unwrap_or(element);
        match kind {
            "tendon" if acts(&resolved(reader, defaults, node, &["tendon"]), &OF_TENDONS) => reader.lacks(
                "tendons",
                "their springs, dampers, friction and armature are not in the figure",
                tag(node),
                name,
            ),
            "actuator" if acts(&resolved(reader, defaults, node, &[element, "general"]), &OF_ACTUATORS) => reader
                .lacks(
                    "actuators",
                    "their armature and damping are not in the figure: give them to the joints, times the gear squared",
                    tag(node),
                    name,
                ),
            "equality" if node.attribute("active") != Some("false") => reader.lacks(
                "equalities",
                "what they tie together is free in a figure, and the forces that hold it are not found",
                tag(node),
                name,
            ),
            "deformable" if element == "flex" => {
                reader.lacks("soft bodies", "their elastic forces are not in the figure", tag(node), name);
            }
            _ => reader.unread(format!("<{element}> of <{kind}>"), tag(node)),
        }
    }
}

/// An element with what its class says of the first of `kinds` that it has defaults of.
fn resolved<'a>(
    reader: &mut Reader,
    defaults: &'a Defaults<'a>,
    node: Node<'a>,
    kinds: &[&str],
) -> Vec<Resolved<'a>> {
    kinds.iter().map(|kind| defaults.resolve_as(reader, node, 0, kind)).collect()
}

/// Whether one of these attributes says another number than zero.
fn acts(elements: &[Resolved], attributes: &[&str]) -> bool {
    let zero = |text: &str| {
        text.split_whitespace().all(|word| word.parse::<f64>().is_ok_and(|number| number == 0.0))
    };
    attributes.iter().any(|attribute| {
        elements.iter().filter_map(|element| element.text(attribute)).any(|text| !zero(text))
    })
}
