//! The bodies and joints of a model of version 4, and what becomes of those of any version.

use super::axes::{Built, product};
use super::component::path_of;
use super::coordinate::{self, Coordinate};
use super::couplers;
use super::element::{MadeUp, child_flag, child_vector, is_joint, members, name_of, offset};
use super::frames::Frames;
use super::joint::{self, JointAt};
use super::mount::{Mount, mount};
use crate::tree::{Body, Names};
use crate::xml::{Node, Reader, element, tag};
use solaris_model::{Joint, Matrix3, Part, SourceMap};
use std::collections::HashSet;

/// What a model consists of.
pub(super) struct Layout<'a> {
    /// The bodies, with different names.
    pub(super) bodies: Vec<(&'a str, Node<'a>)>,
    pub(super) joints: Vec<JointAt<'a>>,
    /// Whether there are joints of which it is not known what they join.
    pub(super) lost: bool,
}

/// Reads the layout of version 4.
pub(super) fn read<'a>(reader: &mut Reader, model: Node<'a>) -> Layout<'a> {
    let bodies = bodies(reader, members(model, "BodySet", |tag| tag == "Body"));
    let nodes: Vec<Node> = bodies.iter().map(|(_, node)| *node).collect();
    let mut frames = Frames::of(model, &nodes);
    let (mut joints, mut lost) = (Vec::new(), false);
    let mut names = MadeUp::default();
    for node in members(model, "JointSet", is_joint) {
        let before = lost;
        lost = true;
        let name = names.name(reader, node);
        let (path, owner) = (path_of(node, model), format!("joint '{name}'"));
        let mut end = |socket| frames.socket(reader, node, &path, socket, &owner);
        let (parent, child) = (end("socket_parent_frame"), end("socket_child_frame"));
        if let (Some(mut parent), Some(mut child)) = (parent, child) {
            // Before 30505, offsets stand in the joint itself.
            parent.within =
                product(&parent.within, &offset(reader, node, "location_in_parent", "orientation_in_parent"));
            child.within =
                product(&child.within, &offset(reader, node, "location_in_child", "orientation_in_child"));
            if child_flag(reader, node, "reverse", false) {
                std::mem::swap(&mut parent, &mut child);
            }
            joints.push(JointAt { name, node, parent, child });
            lost = before;
        }
    }
    Layout { bodies, joints, lost }
}

/// The bodies among these elements, by their names.
pub(super) fn bodies<'a>(reader: &mut Reader, nodes: Vec<Node<'a>>) -> Vec<(&'a str, Node<'a>)> {
    let mut names = HashSet::new();
    let mut bodies = Vec::new();
    for node in nodes {
        if node.tag_name().name() != "Body" {
            reader.unread_element(node);
            continue;
        }
        let Some(name) = name_of(reader, node) else { continue };
        if names.insert(name) {
            bodies.push((name, node));
        } else {
            reader.fault(tag(node), format!("two bodies are called '{name}'; rename one of them"));
        }
    }
    bodies
}

/// The bodies with their joints.
pub(super) struct Tree {
    pub(super) bodies: Vec<Body>,
    /// Where they stand in the text.
    pub(super) places: SourceMap,
    /// Whether every joint could be read.
    pub(super) whole: bool,
}

impl Layout<'_> {
    /// The bodies with their joints.
    pub(super) fn tree(&self, reader: &mut Reader, model: Node) -> Tree {
        let mut places = SourceMap::default();
        places.put(Part::Figure, "", tag(model));
        let mut coordinates: Vec<Vec<Coordinate>> =
            self.joints.iter().map(|joint| coordinate::of_joint(reader, joint.node, &mut places)).collect();
        let called = self.joints.iter().map(|joint| joint.name.as_str());
        coordinate::distinguish(reader, called, &mut coordinates);
        let names: HashSet<&str> = coordinates.iter().flatten().map(|c| c.name.as_str()).collect();
        let couplers = couplers::read(reader, model, &names);
        let mounts = mount(reader, &self.bodies, &self.joints, self.lost);
        let mut turned = vec![false; self.joints.len()];
        for mount in &mounts.of {
            if let Mount::Backward(joint) = *mount {
                turned[joint] = true;
            }
        }
        let mut built = Vec::new();
        for ((at, coordinates), turned) in self.joints.iter().zip(coordinates).zip(turned) {
            places.put(Part::Joint, &at.name, tag(at.node));
            built.push(joint::build(reader, at, coordinates, &couplers, turned));
        }
        let whole = mounts.whole && built.iter().all(Option::is_some);
        let taken = self.bodies.iter().map(|(name, _)| *name);
        let mut names = Names::of(taken.chain(self.joints.iter().map(|joint| joint.name.as_str())));
        // Links between the joints of one of the file stand behind all bodies.
        let (mut bodies, mut between) = (Vec::new(), Vec::new());
        for (i, mount) in mounts.of.iter().enumerate() {
            let (mut parent, joint) = match *mount {
                Mount::Forward(j) => (self.joints[j].parent.body, built[j].take()),
                Mount::Backward(j) => (self.joints[j].child.body, built[j].take()),
                Mount::Free => (None, Some(joint::free(self.bodies[i].0))),
                Mount::None => (None, None),
            };
            let Built { mut joints, beyond } = joint.unwrap_or_default();
            let last = joints.pop().unwrap_or_else(|| Joint::new(self.bodies[i].0));
            for inner in joints {
                let name = names.take(&format!("{}_between", inner.name()));
                between.push(Body::new(name, parent, inner, tag(self.bodies[i].1)));
                parent = Some(self.bodies.len() + between.len() - 1);
            }
            let mut body = self.body(reader, i, parent, last, &mut places);
            body.beyond = beyond;
            bodies.push(body);
        }
        bodies.append(&mut between);
        if bodies.is_empty() && !self.lost {
            reader.suspect(tag(model), "model", "it has no bodies: nothing of it moves");
            bodies.push(Body::new("ground", None, Joint::new("root"), tag(model)));
        }
        Tree { bodies, places, whole: whole && !self.lost }
    }

    fn body(
        &self,
        reader: &mut Reader,
        index: usize,
        parent: Option<usize>,
        joint: Joint,
        places: &mut SourceMap,
    ) -> Body {
        let (name, node) = self.bodies[index];
        let mut body = Body::new(name, parent, joint, tag(node));
        let mass = element(node, "mass").map_or(Some(0.0), |mass| reader.text_number(mass));
        let inertia = inertia(reader, node);
        body.com = child_vector(reader, node, "mass_center");
        // Numbers that are none are at fault, not what they would make of the figure.
        (body.mass, body.inertia) = mass.zip(inertia).unwrap_or((1.0, Matrix3::zeros()));
        for (field, child) in
            [("mass", "mass"), ("com", "mass_center"), ("inertia", "inertia"), ("inertia", "inertia_xx")]
        {
            if let Some(child) = element(node, child) {
                places.put_field(Part::Link, name, field, tag(child));
            }
        }
        let subject = format!("body '{name}'");
        if body.mass == 0.0 {
            reader.suspect(tag(node), subject, "it has no mass");
        } else if inertia.is_some() && body.inertia.amax() == 0.0 {
            reader.suspect(tag(node), subject, "its inertia is zero: it is taken for a point mass");
        }
        body
    }
}

/// The inertia of a body: `xx yy zz xy xz yz`, in one element or in six; nothing where it is no six numbers, which is a
/// fault.
pub(super) fn inertia(reader: &mut Reader, body: Node) -> Option<Matrix3<f64>> {
    let numbers = match element(body, "inertia") {
        Some(node) => reader.text_numbers(node, 6..=6)?,
        None => ["xx", "yy", "zz", "xy", "xz", "yz"]
            .map(|pair| element(body, &format!("inertia_{pair}")))
            .map(|node| node.map_or(Some(0.0), |node| reader.text_number(node)))
            .into_iter()
            .collect::<Option<_>>()?,
    };
    let [xx, yy, zz, xy, xz, yz] = numbers[..] else { return None };
    #[rustfmt::skip]
    let inertia = Matrix3::new(
        xx, xy, xz,
        xy, yy, yz,
        xz, yz, zz,
    );
    Some(inertia)
}
