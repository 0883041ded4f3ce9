//! The layout of versions 2 and 3: bodies hold their joints.

use super::element::{child_flag, child_vector, child_words, name_of, objects, placement, words_at};
use super::frames::Anchor;
use super::joint::JointAt;
use super::layout::{Layout, bodies};
use crate::xml::{Node, Reader, element, elements, tag};
use solaris_model::Placement;
use std::collections::HashMap;

/// What ground is called, which is a body of the set.
const GROUND: &str = "ground";

/// Reads the layout of versions 2 and 3.
pub(super) fn read<'a>(reader: &mut Reader, model: Node<'a>) -> Layout<'a> {
    let mut bodies = bodies(reader, objects(model, "BodySet"));
    bodies.retain(|(name, _)| *name != GROUND);
    let numbers: HashMap<&str, usize> = bodies.iter().enumerate().map(|(i, (name, _))| (*name, i)).collect();
    let (mut joints, mut lost) = (Vec::new(), false);
    for (i, (body, node)) in bodies.iter().enumerate() {
        let held = element(*node, "Joint").and_then(|joint| elements(joint).next());
        let Some(joint) = held else { continue };
        let Some(name) = name_of(reader, joint) else {
            lost = true;
            continue;
        };
        let within = |reader: &mut Reader, location, orientation| {
            placement(child_vector(reader, joint, location), child_vector(reader, joint, orientation))
        };
        let from = within(reader, "location_in_parent", "orientation_in_parent");
        let parent = parent(reader, joint, name, &numbers, from);
        let to = within(reader, "location", "orientation");
        if child_flag(reader, joint, "reverse", false) {
            let message = format!(
                "joint '{name}' of body '{body}' is reversed, which is not read; open and save it in OpenSim 4"
            );
            reader.fault(tag(joint), message);
        }
        let Some(parent) = parent else {
            lost = true;
            continue;
        };
        let child = Anchor { body: Some(i), within: to };
        joints.push(JointAt { name, node: joint, parent, child });
    }
    Layout { bodies, joints, lost }
}

/// Where a joint stands in the body that it names as its parent.
fn parent(
    reader: &mut Reader,
    joint: Node,
    name: &str,
    numbers: &HashMap<&str, usize>,
    within: Placement,
) -> Option<Anchor> {
    let Some(told) = child_words(joint, "parent_body") else {
        reader.fault(tag(joint), format!("joint '{name}' has no <parent_body>; name a body or '{GROUND}'"));
        return None;
    };
    if told == GROUND {
        return Some(Anchor { body: None, within });
    }
    if let Some(&number) = numbers.get(told) {
        return Some(Anchor { body: Some(number), within });
    }
    let hint = reader.hint(told, numbers.keys().copied().chain([GROUND]));
    let span = element(joint, "parent_body").map_or_else(|| tag(joint), |node| words_at(node));
    reader.fault(span, format!("joint '{name}': <parent_body> names '{told}', which is no body{hint}"));
    None
}
