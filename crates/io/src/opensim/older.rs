//! The layout of versions 1.9 to 3.3: bodies hold their joints.

use super::element::{MadeUp, child_flag, child_words, objects, offset, words_at};
use super::frames::Anchor;
use super::joint::JointAt;
use super::layout::{Layout, bodies};
use crate::xml::{Node, Reader, element, elements, tag};
use solaris_model::Placement;
use std::collections::HashMap;

/// What ground is called, which is a body of the set.
const GROUND: &str = "ground";

/// Reads the layout of these versions.
pub(super) fn read<'a>(reader: &mut Reader, model: Node<'a>) -> Layout<'a> {
    let mut bodies = bodies(reader, objects(model, "BodySet"));
    bodies.retain(|(name, _)| *name != GROUND);
    let numbers: HashMap<&str, usize> = bodies.iter().enumerate().map(|(i, (name, _))| (*name, i)).collect();
    let (mut joints, mut lost) = (Vec::new(), false);
    let mut names = MadeUp::default();
    for (i, (_, node)) in bodies.iter().enumerate() {
        let held = element(*node, "Joint").and_then(|joint| elements(joint).next());
        let Some(joint) = held else { continue };
        let name = names.name(reader, joint);
        let from = offset(reader, joint, "location_in_parent", "orientation_in_parent");
        let parent = parent(reader, joint, &name, &numbers, from);
        let to = offset(reader, joint, "location", "orientation");
        let Some(mut parent) = parent else {
            lost = true;
            continue;
        };
        let mut child = Anchor { body: Some(i), within: to };
        // The joint's own motion is from its body to the parent, as OpenSim 4 writes it when it saves such a model.
        if child_flag(reader, joint, "reverse", false) {
            std::mem::swap(&mut parent, &mut child);
        }
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
