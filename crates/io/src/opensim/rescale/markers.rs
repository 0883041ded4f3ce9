//! Markers that get other places, are new, or go.

use super::Rescaling;
use super::bodies::Bodies;
use super::edits::Edits;
use super::lengths::ON;
use crate::opensim::element::{child_words, words, words_at};
use crate::xml::{Node, Reader, element, elements_called, tag};
use solaris_model::{Placement, Vector3};
use std::collections::HashMap;

/// A marker's place on a body.
#[derive(Clone, Debug, PartialEq)]
pub struct MarkerPlace {
    /// The marker's name.
    pub name: String,
    /// The name of the body that it sits on.
    pub body: String,
    /// Where, in the body's own frame after scaling (m).
    pub position: Vector3<f64>,
    /// Whether a static trial leaves it where it is.
    pub is_fixed: bool,
}

/// Where a marker is in the scaled model: on which body, and where its frame stands in that body's.
pub(super) type Frame = (Option<usize>, Placement);

/// The frames of all markers of a model, by the markers' names.
pub(super) fn frames(reader: &mut Reader, bodies: &mut Bodies) -> HashMap<String, Frame> {
    let mut found = HashMap::new();
    for node in markers(bodies.model) {
        if let (Some(name), Some(at)) = (node.attribute("name"), bodies.holder(reader, node, &ON)) {
            found.insert(name.trim().to_owned(), (at.body, at.within));
        }
    }
    found
}

fn markers(model: Node<'_>) -> impl Iterator<Item = Node<'_>> {
    model.descendants().filter(|node| node.has_tag_name("Marker"))
}

/// Writes the places that markers are given, and takes out those that go; `frames` are those after scaling.
pub(super) fn place(
    edits: &mut Edits,
    reader: &mut Reader,
    bodies: &Bodies,
    rescaling: &Rescaling,
    frames: &HashMap<String, Frame>,
) {
    let model = bodies.model;
    let known: HashMap<&str, Node> =
        markers(model).filter_map(|node| Some((node.attribute("name")?.trim(), node))).collect();
    for name in &rescaling.removed {
        if let Some(node) = known.get(name.as_str()) {
            edits.remove(*node);
        } else {
            let hint = reader.hint(name, known.keys().copied());
            let message =
                format!("marker '{name}' is to be removed, and the model has none of the name{hint}");
            reader.fault(tag(model), message);
        }
    }
    let mut new = Vec::new();
    for marker in &rescaling.markers {
        if !marker.position.iter().all(|x| x.is_finite()) {
            let [x, y, z] = marker.position.into();
            let message = format!("marker '{}' is to be at ({x}, {y}, {z}), which is no place", marker.name);
            reader.fault(tag(model), message);
            continue;
        }
        let body = bodies.number(&marker.body);
        if body.is_none() && marker.body != bodies.name(None) {
            let hint = reader.hint(&marker.body, bodies.list.iter().map(|(name, _)| *name));
            let message =
                format!("marker '{}' is to be on '{}', which is no body{hint}", marker.name, marker.body);
            reader.fault(tag(model), message);
            continue;
        }
        match known.get(marker.name.as_str()) {
            Some(node) => change(
                edits,
                reader,
                bodies,
                *node,
                marker,
                frames.get(&marker.name).filter(|at| at.0 == body),
            ),
            None => new.push(element_of(marker, bodies.has_frames())),
        }
    }
    if !new.is_empty() {
        add(edits, model, &new);
    }
}

/// Gives a marker of the model another place; `frame` is the one that it is in, unless it goes to another body.
fn change(
    edits: &mut Edits,
    reader: &mut Reader,
    bodies: &Bodies,
    node: Node,
    marker: &MarkerPlace,
    frame: Option<&Frame>,
) {
    let mut place = marker.position;
    if let Some((_, within)) = frame {
        if *within != Placement::identity() {
            place = within.inverse_transform_point(&place.into()).coords;
        }
    } else {
        let socket =
            ON.into_iter().find_map(|name| element(node, name)).filter(|node| !words(*node).is_empty());
        let Some(socket) = socket else {
            let message =
                format!("marker '{}' cannot be put on another body: it has no <{}>", marker.name, ON[0]);
            reader.fault(tag(node), message);
            return;
        };
        edits.replace(words_at(socket), path(&marker.body, bodies.has_frames()));
    }
    let [x, y, z] = place.into();
    match element(node, "location").filter(|_| child_words(node, "location").is_some()) {
        Some(location) => edits.set(reader, location, &[x, y, z]),
        None => edits.insert(node, &format!("<location>{x} {y} {z}</location>")),
    }
    match element(node, "fixed").filter(|_| child_words(node, "fixed").is_some()) {
        Some(fixed) if child_words(node, "fixed") != Some(&marker.is_fixed.to_string()) => {
            edits.replace(words_at(fixed), marker.is_fixed.to_string());
        }
        None if marker.is_fixed => edits.insert(node, "<fixed>true</fixed>"),
        Some(_) | None => {}
    }
}

/// What a point names its body by.
fn path(body: &str, has_frames: bool) -> String {
    match (has_frames, body) {
        (true, "ground") => "/ground".to_owned(),
        (true, body) => format!("/bodyset/{body}"),
        (false, body) => body.to_owned(),
    }
}

fn element_of(marker: &MarkerPlace, has_frames: bool) -> String {
    let [x, y, z] = marker.position.into();
    let socket = ON[usize::from(!has_frames)];
    let (name, body) = (escaped(&marker.name), escaped(&path(&marker.body, has_frames)));
    format!(
        "<Marker name=\"{name}\"><{socket}>{body}</{socket}><location>{x} {y} {z}</location><fixed>{}</fixed></Marker>",
        marker.is_fixed
    )
}

fn escaped(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

/// Adds markers to the model's set, which it need not have.
fn add(edits: &mut Edits, model: Node, new: &[String]) {
    let lines = new.join("\n\t\t\t\t");
    let Some(set) = elements_called(model, "MarkerSet").next() else {
        let set = format!(
            "<MarkerSet name=\"markerset\">\n\t\t\t<objects>\n\t\t\t\t{lines}\n\t\t\t</objects>\n\t\t</MarkerSet>"
        );
        edits.insert(model, &set);
        return;
    };
    match element(set, "objects") {
        Some(objects) => edits.insert(objects, &lines),
        None => edits.insert(set, &format!("<objects>\n\t\t\t\t{lines}\n\t\t\t</objects>")),
    }
}
