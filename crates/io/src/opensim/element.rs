//! Readers of an element's text.

use crate::xml::{Node, Reader, element, shown, tag};
use solaris_model::{Placement, UnitQuaternion, Vector3};
use std::collections::HashMap;
use std::ops::Range;

/// The text of an element, trimmed.
pub(super) fn words(node: Node<'_>) -> &str {
    let texts = node.children().filter(Node::is_text).filter_map(|child| child.text());
    texts.map(str::trim).find(|text| !text.is_empty()).unwrap_or_default()
}

/// Where the text of an element stands; its tag where it has none.
pub(super) fn words_at(node: Node) -> Range<usize> {
    let text = |child: &Node| child.is_text() && child.text().is_some_and(|text| !text.trim().is_empty());
    let Some(text) = node.children().find(text) else { return tag(node) };
    let range = text.range();
    let raw = &node.document().input_text()[range.clone()];
    let start = range.start + raw.len() - raw.trim_start().len();
    start..start + raw.trim().len()
}

/// The text of the child element `name`; nothing where it is absent or empty.
pub(super) fn child_words<'a>(node: Node<'a>, name: &str) -> Option<&'a str> {
    element(node, name).map(words).filter(|text| !text.is_empty())
}

/// The number in the child element `name`; nothing where it is absent or no number, which is a fault.
pub(super) fn child_number(reader: &mut Reader, node: Node, name: &str) -> Option<f64> {
    element(node, name).and_then(|child| reader.text_number(child))
}

/// The three numbers in the child element `name`, zero where it is absent.
pub(super) fn child_vector(reader: &mut Reader, node: Node, name: &str) -> Vector3<f64> {
    let numbers = element(node, name).and_then(|child| reader.text_numbers(child, 3..=3));
    numbers.map_or_else(Vector3::zeros, |numbers| Vector3::new(numbers[0], numbers[1], numbers[2]))
}

/// Whether the child element `name` says `true`; anything but true and false is a fault.
pub(super) fn child_flag(reader: &mut Reader, node: Node, name: &str, absent: bool) -> bool {
    let Some(child) = element(node, name) else { return absent };
    match words(child).to_ascii_lowercase().as_str() {
        "" => absent,
        "true" | "1" => true,
        "false" | "0" => false,
        other => {
            let message = format!("<{name}> is '{}'; it must be true or false", shown(other));
            reader.fault(words_at(child), message);
            absent
        }
    }
}

/// The name of an element, whose absence is a fault.
pub(super) fn name_of<'a>(reader: &mut Reader, node: Node<'a>) -> Option<&'a str> {
    let name = reader.need(node, "name")?.trim();
    if name.is_empty() {
        reader.fault(tag(node), format!("<{}> has an empty name; give it one", node.tag_name().name()));
        return None;
    }
    Some(name)
}

/// Names for what the file gives none, as OpenSim makes them up: the class in small letters, then `_0`, `_1` …
#[derive(Default)]
pub(super) struct MadeUp {
    /// Of each class, how many.
    counts: HashMap<String, usize>,
}

impl MadeUp {
    /// The name of a joint or a coordinate.
    pub(super) fn name(&mut self, reader: &mut Reader, node: Node) -> String {
        if let Some(name) = node.attribute("name").map(str::trim).filter(|name| !name.is_empty()) {
            return name.to_owned();
        }
        let class = node.tag_name().name();
        let count = self.counts.entry(class.to_owned()).or_default();
        let stem = class.to_lowercase();
        let name = if *count == 0 { stem } else { format!("{stem}_{}", *count - 1) };
        *count += 1;
        let message = format!("it has no name, and is called '{name}' here, as in OpenSim 4");
        reader.note(tag(node), format!("<{class}>"), message);
        name
    }
}

/// The elements of the set `name` of a model: what stands in its `objects`.
pub(super) fn objects<'a>(model: Node<'a>, name: &str) -> Vec<Node<'a>> {
    let sets = crate::xml::elements_called(model, name);
    let objects = sets.flat_map(|set| crate::xml::elements_called(set, "objects"));
    objects.flat_map(|objects| crate::xml::elements(objects)).collect()
}

/// The elements of the set `name` of a model, and those of the lists `components` at any depth that `belongs` knows by their
/// tags: programs may put any part of a model there.
pub(super) fn members<'a>(model: Node<'a>, name: &str, belongs: fn(&str) -> bool) -> Vec<Node<'a>> {
    let listed = |node: &Node| node.parent().is_some_and(|list| list.tag_name().name() == "components");
    let mut members = objects(model, name);
    let others = model.descendants().filter(|node| node.is_element() && belongs(node.tag_name().name()));
    members.extend(others.filter(listed));
    members
}

/// Whether an element of this name is a joint.
pub(super) fn is_joint(tag: &str) -> bool {
    tag.ends_with("Joint")
}

/// The placement that two children of an element say.
pub(super) fn offset(reader: &mut Reader, node: Node, location: &str, orientation: &str) -> Placement {
    placement(child_vector(reader, node, location), child_vector(reader, node, orientation))
}

/// The placement of a translation and an orientation.
///
/// ```text
/// R = Rx(o₁)·Ry(o₂)·Rz(o₃)
/// ```
///
/// The orientation is three body-fixed angles (rad), as everywhere in OpenSim.
pub(super) fn placement(translation: Vector3<f64>, orientation: Vector3<f64>) -> Placement {
    let axes = [Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()];
    let turn = axes
        .iter()
        .zip(orientation.iter())
        .filter(|(_, angle)| **angle != 0.0)
        .fold(UnitQuaternion::identity(), |turn, (axis, angle)| {
            turn * UnitQuaternion::from_axis_angle(axis, *angle)
        });
    Placement::from_parts(translation.into(), turn)
}
