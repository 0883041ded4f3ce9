//! The bodies of a model with their factors, and what is fixed to which.

use super::Rescaling;
use crate::opensim::FIRST_WITH_JOINTS;
use crate::opensim::component::path_of;
use crate::opensim::element::{child_words, members, objects};
use crate::opensim::frames::{Anchor, Frames, OFFSET, THROUGH_POINTS};
use crate::opensim::layout;
use crate::xml::{Node, Reader, tag};
use roxmltree::NodeId;
use solaris_model::{Placement, Vector3};
use std::collections::HashMap;

/// What ground is called.
const GROUND: &str = "ground";

/// The bodies of a model.
pub(super) struct Bodies<'a> {
    pub(super) model: Node<'a>,
    /// Names and elements; ground is none of them.
    pub(super) list: Vec<(&'a str, Node<'a>)>,
    numbers: HashMap<&'a str, usize>,
    nodes: HashMap<NodeId, usize>,
    /// In the layout of versions that have them.
    frames: Option<Frames<'a>>,
    factors: Vec<Vector3<f64>>,
    ground: Vector3<f64>,
}

impl<'a> Bodies<'a> {
    /// The bodies of a model; none of them is scaled.
    pub(super) fn of(reader: &mut Reader, model: Node<'a>, version: u32) -> Self {
        let has_frames = version >= FIRST_WITH_JOINTS;
        let nodes = if has_frames {
            members(model, "BodySet", |tag| tag == "Body")
        } else {
            objects(model, "BodySet")
        };
        let mut list = layout::bodies(reader, nodes);
        list.retain(|(name, _)| has_frames || *name != GROUND);
        let elements: Vec<Node> = list.iter().map(|(_, node)| *node).collect();
        Self {
            model,
            numbers: list.iter().enumerate().map(|(i, (name, _))| (*name, i)).collect(),
            nodes: elements.iter().enumerate().map(|(i, node)| (node.id(), i)).collect(),
            frames: has_frames.then(|| Frames::of(model, &elements)),
            factors: vec![Vector3::repeat(1.0); list.len()],
            ground: Vector3::repeat(1.0),
            list,
        }
    }

    /// Gives the bodies their factors; names that are none and factors that are none are faults.
    pub(super) fn scale(&mut self, reader: &mut Reader, rescaling: &Rescaling) {
        for (name, s) in &rescaling.factors {
            if let Some((i, bad)) = s.iter().enumerate().find(|(_, s)| !(1e-6..=1e6).contains(*s)) {
                let axis = ["x", "y", "z"][i];
                let message = format!(
                    "body '{name}': its factor along {axis} is {bad}; it must lie between 1e-6 and 1e6"
                );
                reader.fault(tag(self.model), message);
            } else if let Some(&body) = self.numbers.get(name.as_str()) {
                self.factors[body] = *s;
            } else if name == GROUND {
                self.ground = *s;
            } else if *s != Vector3::repeat(1.0) {
                let hint = reader.hint(name, self.numbers.keys().copied());
                reader.fault(
                    tag(self.model),
                    format!("there are factors for '{name}', which is no body of the model{hint}"),
                );
            }
        }
    }

    /// Whether joints and points hang on frames; they name bodies in older versions.
    pub(super) fn has_frames(&self) -> bool {
        self.frames.is_some()
    }

    /// The number of the body called so.
    pub(super) fn number(&self, name: &str) -> Option<usize> {
        self.numbers.get(name).copied()
    }

    /// The name of a body.
    pub(super) fn name(&self, body: Option<usize>) -> &'a str {
        body.map_or(GROUND, |body| self.list[body].0)
    }

    /// The factors of a body.
    pub(super) fn factors(&self, body: Option<usize>) -> Vector3<f64> {
        body.map_or(self.ground, |body| self.factors[body])
    }

    /// Where the frame stands that an element is connected to by one of these sockets, or by an element of an older version
    /// that names a body; nothing where it does not say or where that cannot be found, which is a fault.
    pub(super) fn holder(&mut self, reader: &mut Reader, node: Node, sockets: &[&str]) -> Option<Anchor> {
        let named = |name: &&&str| Frames::is_connected(node, name);
        if let Some(frames) = &mut self.frames
            && let Some(socket) = sockets.iter().find(named)
        {
            let owner =
                format!("<{}> '{}'", node.tag_name().name(), node.attribute("name").unwrap_or_default());
            return frames.socket(reader, node, &path_of(node, self.model), socket, &owner);
        }
        let name = sockets.iter().find_map(|socket| child_words(node, socket))?;
        let name = name.rsplit('/').next().unwrap_or(name);
        let within = Placement::identity();
        if name == GROUND {
            return Some(Anchor { body: None, within });
        }
        let Some(&body) = self.numbers.get(name) else {
            let hint = reader.hint(name, self.numbers.keys().copied());
            let what = node.tag_name().name();
            reader.fault(tag(node), format!("<{what}> names '{name}', which is no body{hint}"));
            return None;
        };
        Some(Anchor { body: Some(body), within })
    }

    /// Where the frame stands that an element belongs to; nothing where it belongs to none.
    pub(super) fn around(&mut self, reader: &mut Reader, node: Node) -> Option<Anchor> {
        for above in node.ancestors() {
            let body = match above.tag_name().name() {
                "Body" => self.nodes.get(&above.id()).copied(),
                "Ground" => None,
                OFFSET | THROUGH_POINTS => return self.frames.as_mut()?.at(reader, above),
                _ => continue,
            };
            return Some(Anchor { body, within: Placement::identity() });
        }
        None
    }
}
