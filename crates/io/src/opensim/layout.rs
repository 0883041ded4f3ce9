//! The bodies and joints of a model of version 4, and what becomes of those of any version.

use super::component::path_of;
use super::coordinate::{self, Coordinate};
use super::couplers;
use super::element::{child_vector, name_of, objects};
use super::frames::Frames;
use super::joint::{self, JointAt};
use crate::tree::Body;
use crate::xml::{Node, Reader, element, tag};
use solaris_model::{Joint, Matrix3, Part, SourceMap};
use std::collections::{HashMap, HashSet};

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
    let bodies = bodies(reader, objects(model, "BodySet"));
    let nodes: Vec<Node> = bodies.iter().map(|(_, node)| *node).collect();
    let mut frames = Frames::of(model, &nodes);
    let (mut joints, mut lost) = (Vec::new(), false);
    for node in objects(model, "JointSet") {
        let before = lost;
        lost = true;
        let Some(name) = name_of(reader, node) else { continue };
        let (path, owner) = (path_of(node, model), format!("joint '{name}'"));
        let mut end = |socket| frames.socket(reader, node, &path, socket, &owner);
        let (parent, child) = (end("socket_parent_frame"), end("socket_child_frame"));
        if let (Some(parent), Some(child)) = (parent, child) {
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
        if self.bodies.is_empty() {
            reader.fault(tag(model), "the model has no bodies");
        }
        let coordinates: Vec<Vec<Coordinate>> =
            self.joints.iter().map(|joint| coordinate::of_joint(reader, joint.node, &mut places)).collect();
        let names: HashSet<&str> = coordinates.iter().flatten().map(|c| c.name.as_str()).collect();
        let couplers = couplers::read(reader, model, &names);
        let mut moved: HashMap<usize, usize> = HashMap::new();
        let mut built = Vec::new();
        for (i, (at, coordinates)) in self.joints.iter().zip(coordinates).enumerate() {
            places.put(Part::Joint, at.name, tag(at.node));
            built.push(joint::build(reader, at, coordinates, &couplers));
            self.claim(reader, at, i, &mut moved);
        }
        let hangs = self.check_tree(reader, &moved);
        let whole = hangs && built.iter().all(Option::is_some) && !self.bodies.is_empty();
        let bodies = (0..self.bodies.len())
            .map(|i| {
                let joint = moved.get(&i).map(|&j| (&self.joints[j], built[j].take()));
                self.body(reader, i, joint, &mut places)
            })
            .collect();
        Tree { bodies, places, whole }
    }

    /// Lets a joint move its child body, which no other may do.
    fn claim(&self, reader: &mut Reader, at: &JointAt, index: usize, moved: &mut HashMap<usize, usize>) {
        let name = at.name;
        let Some(child) = at.child.body else {
            let message = format!("the child of joint '{name}' is ground; swap its parent and its child");
            reader.fault(tag(at.node), message);
            return;
        };
        if let Some(other) = moved.insert(child, index) {
            let (body, other) = (self.bodies[child].0, self.joints[other].name);
            let message = format!(
                "joint '{name}' moves body '{body}', which joint '{other}' moves already; a loop is not read: remove one of them"
            );
            reader.fault(tag(at.node), message);
        }
    }

    /// Whether every body hangs on ground in the end; where one does not, that is a fault.
    fn check_tree(&self, reader: &mut Reader, moved: &HashMap<usize, usize>) -> bool {
        let mut hangs = true;
        let above = |i: usize| moved.get(&i).map(|&joint| self.joints[joint].parent.body);
        // The walk in which a body was met first.
        let mut met = vec![usize::MAX; self.bodies.len()];
        for start in 0..self.bodies.len() {
            let mut at = start;
            while met[at] == usize::MAX {
                met[at] = start;
                match above(at) {
                    Some(Some(parent)) => at = parent,
                    Some(None) => break,
                    None => {
                        hangs = false;
                        let (name, node) = self.bodies[at];
                        if !self.lost {
                            let message = format!(
                                "no joint moves body '{name}'; give it one, to ground or to another body"
                            );
                            reader.fault(tag(node), message);
                        }
                        break;
                    }
                }
            }
            let closed = met[at] == start && above(at).is_some_and(|parent| parent.is_some());
            if closed && self.is_above_itself(at, &above) {
                self.name_cycle(reader, at, &above);
                hangs = false;
            }
        }
        hangs
    }

    fn is_above_itself(&self, start: usize, above: &impl Fn(usize) -> Option<Option<usize>>) -> bool {
        let mut at = start;
        for _ in 0..self.bodies.len() {
            match above(at) {
                Some(Some(parent)) if parent == start => return true,
                Some(Some(parent)) => at = parent,
                _ => return false,
            }
        }
        false
    }

    fn name_cycle(&self, reader: &mut Reader, start: usize, above: &impl Fn(usize) -> Option<Option<usize>>) {
        let mut names = vec![format!("'{}'", self.bodies[start].0)];
        let mut at = start;
        while let Some(Some(parent)) = above(at)
            && parent != start
            && names.len() < 5
        {
            names.push(format!("'{}'", self.bodies[parent].0));
            at = parent;
        }
        let message = format!(
            "bodies {} are each other's ancestors (a cycle); one of them needs a joint to ground",
            names.join(", ")
        );
        reader.fault(tag(self.bodies[start].1), message);
    }

    fn body(
        &self,
        reader: &mut Reader,
        index: usize,
        joint: Option<(&JointAt, Option<joint::Built>)>,
        places: &mut SourceMap,
    ) -> Body {
        let (name, node) = self.bodies[index];
        let parent = joint.as_ref().and_then(|(at, _)| at.parent.body);
        let (moving, beyond) = joint
            .and_then(|(_, built)| built)
            .unwrap_or_else(|| (Joint::new(name), solaris_model::Placement::identity()));
        let mut body = Body::new(name, parent, moving, tag(node));
        body.beyond = beyond;
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
fn inertia(reader: &mut Reader, body: Node) -> Option<Matrix3<f64>> {
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
