//! `<worldbody>`: the tree of bodies.

mod contents;

use super::chain::{Segment, segments};
use super::compiler::{Compiler, FromGeoms};
use super::defaults::{Defaults, Resolved, SPECIFIERS};
use super::geom::{self, Geom};
use super::joint::{self, Joint, Kind};
use super::orientation::placement;
use super::{inertia, sections};
use crate::tree::{Body, Names};
use crate::xml::{Node, Reader, elements_called, tag, value_span};
use contents::Contents;
use solaris_model::{Joint as FigureJoint, Limits, NamedFrame, Part, Placement, Shape, SourceMap};
use std::collections::HashSet;

/// A body that is still to be read.
struct Open<'a> {
    node: Node<'a>,
    /// Its parent's place in the list, and the frame around it in the parent.
    parent: Option<usize>,
    frame: Placement,
    class: usize,
}

/// What is needed while bodies are read.
struct Reading<'r, 'a, 't> {
    reader: &'r mut Reader<'t>,
    compiler: &'r Compiler,
    defaults: &'a Defaults<'a>,
    places: &'r mut SourceMap,
    bodies: Vec<Body>,
    /// Which of the bodies are the file's, not links between joints.
    of_file: Vec<bool>,
    body_names: Names,
    joint_names: Names,
    /// Joints of figures that are called like bodies.
    group_names: Names,
    /// Kinds and names of what has been read.
    seen: HashSet<(&'static str, &'a str)>,
    count: usize,
}

/// All bodies, parents first.
pub(super) fn read<'a>(
    reader: &mut Reader,
    root: Node<'a>,
    compiler: &Compiler,
    defaults: &'a Defaults<'a>,
    places: &mut SourceMap,
) -> Vec<Body> {
    let names = |kinds: &'static [&'static str]| {
        let worlds = elements_called(root, "worldbody").flat_map(|world| world.descendants());
        worlds
            .filter(move |node| kinds.contains(&node.tag_name().name()))
            .filter_map(|node| Some((node, node.attribute("name")?)))
    };
    sections::unique(reader, "body", names(&["body"]));
    sections::unique(reader, "joint", names(&["joint", "freejoint"]));
    let mut reading = Reading {
        reader,
        compiler,
        defaults,
        places,
        bodies: Vec::new(),
        of_file: Vec::new(),
        body_names: Names::of(names(&["body"]).map(|(_, name)| name)),
        joint_names: Names::of(names(&["joint", "freejoint"]).map(|(_, name)| name)),
        group_names: Names::of(names(&["joint", "freejoint"]).map(|(_, name)| name)),
        seen: HashSet::new(),
        count: 0,
    };
    let mut open = Vec::new();
    for world in elements_called(root, "worldbody") {
        let contents = Contents::of(reading.reader, world, 0, defaults, compiler);
        for (node, ..) in &contents.geoms {
            reading.reader.aside("<geom> of <worldbody>", tag(*node));
        }
        for (node, ..) in contents.joints.iter().chain(&contents.inertials) {
            reading.reader.fault(tag(*node), format!("the world cannot have a <{}>", node.tag_name().name()));
        }
        for (node, ..) in &contents.sites {
            reading.reader.unread("<site> of <worldbody>", tag(*node));
        }
        let children =
            contents.bodies.into_iter().map(|(node, frame, class)| Open { node, parent: None, frame, class });
        open.extend(children.collect::<Vec<_>>().into_iter().rev());
        while let Some(next) = open.pop() {
            reading.body(&next, &mut open);
        }
    }
    let Reading { reader, mut bodies, of_file, .. } = reading;
    let mut changed: Vec<&mut Body> =
        bodies.iter_mut().zip(of_file).filter(|(_, of_file)| *of_file).map(|(body, _)| body).collect();
    inertia::adjust(reader, &mut changed, compiler, root);
    bodies
}

impl<'a> Reading<'_, 'a, '_> {
    fn body(&mut self, this: &Open<'a>, open: &mut Vec<Open<'a>>) {
        let node = this.node;
        self.count += 1;
        let mut known = vec!["name", "pos", "childclass", "user"];
        known.extend(SPECIFIERS);
        self.reader.check_attributes_but(node, &known, &["sleep", "simple", "fuse"]);
        let name = match node.attribute("name").filter(|name| !name.trim().is_empty()) {
            // A name that is there already has been reported.
            Some(name) if self.seen.insert(("body", name)) => name.to_owned(),
            Some(name) => self.body_names.take(name),
            None => self.body_names.take(&format!("body{}", self.count)),
        };
        let class = self.defaults.class(self.reader, node, "childclass").unwrap_or(this.class);
        let at = this.frame * placement(self.reader, &Resolved::plain(node), self.compiler);
        let contents = Contents::of(self.reader, node, class, self.defaults, self.compiler);
        let joints = self.joints(&name, &contents, this.parent);
        let (geoms, unread) = self.geoms(&contents);
        if let Some((second, _)) = contents.inertials.get(1).map(|(node, frame, _)| (*node, frame)) {
            self.reader.fault(tag(second), format!("body '{name}' has a second <inertial>"));
        }
        let inertial = contents.inertials.first().map(|(node, frame, _)| (*node, *frame));
        let lump = inertia::of_body(self.reader, inertial, &geoms, self.compiler);
        self.say_about_mass(node, &name, &contents, unread, lump.is_some());

        let span = if node.has_attribute("name") { value_span(node, "name") } else { tag(node) };
        let (parent, mut body) = self.chain(&name, node, this.parent, at, &joints);
        body.parent = parent;
        body.span = span;
        if let Some(lump) = lump {
            (body.mass, body.com, body.inertia) = (lump.mass, lump.com, lump.inertia);
        }
        body.shape = heaviest(&geoms);
        body.frames = self.sites(&contents);
        let mass_span = inertial.map_or_else(|| tag(node), |(inertial, _)| tag(inertial));
        for field in ["mass", "inertia", "com"] {
            self.places.put_field(Part::Link, &name, field, mass_span.clone());
        }
        self.bodies.push(body);
        self.of_file.push(true);
        let parent = Some(self.bodies.len() - 1);
        let children =
            contents.bodies.into_iter().map(|(node, frame, class)| Open { node, parent, frame, class });
        open.extend(children.collect::<Vec<_>>().into_iter().rev());
    }

    fn joints(&mut self, body: &str, contents: &Contents<'a>, parent: Option<usize>) -> Vec<Joint<'a>> {
        let mut joints: Vec<Joint> = Vec::new();
        for (node, frame, class) in &contents.joints {
            joint::check_attributes(self.reader, *node);
            let element = if node.tag_name().name() == "freejoint" {
                Resolved::plain(*node)
            } else {
                self.defaults.resolve(self.reader, *node, *class)
            };
            let is_free = node.tag_name().name() == "freejoint" || element.text("type") == Some("free");
            let name = match node.attribute("name").filter(|name| !name.trim().is_empty()) {
                Some(name) if self.seen.insert(("joint", name)) => name.to_owned(),
                Some(name) => self.joint_names.take(name),
                None => {
                    let name = if is_free { "root".to_owned() } else { format!("{body}_joint") };
                    let name = self.joint_names.take(&name);
                    self.group_names.take(&name)
                }
            };
            joints.push(joint::read(self.reader, &element, name, frame, self.compiler));
        }
        let free = joints.iter().find(|joint| joint.kind == Kind::Free);
        if let Some(free) = free.filter(|_| joints.len() > 1) {
            let message = format!("body '{body}' has a free joint beside others; it must be its only one");
            self.reader.fault(tag(free.node), message);
        }
        if let Some(free) = free.filter(|_| parent.is_some()) {
            let message = format!(
                "body '{body}' has a free joint inside of another body; only bodies of the world can"
            );
            self.reader.fault(tag(free.node), message);
        }
        joints
    }

    fn geoms(&mut self, contents: &Contents<'a>) -> (Vec<Geom>, bool) {
        let (mut geoms, mut unread) = (Vec::new(), false);
        for (node, frame, class) in &contents.geoms {
            geom::check_attributes(self.reader, *node);
            let element = self.defaults.resolve(self.reader, *node, *class);
            match geom::read(self.reader, &element, frame, self.compiler) {
                geom::Read::Solid(geom) => geoms.push(geom),
                geom::Read::Unread => {
                    unread |= element.text("mass") != Some("0") && element.text("density") != Some("0");
                }
                // What it weighs is not known; that it would weigh nothing is no further fault.
                geom::Read::Faulty => geoms.push(Geom::unknown()),
                geom::Read::Nothing => {}
            }
        }
        (geoms, unread)
    }

    fn sites(&mut self, contents: &Contents<'a>) -> Vec<NamedFrame> {
        let mut frames = Vec::new();
        for (node, frame, class) in &contents.sites {
            let element = self.defaults.resolve(self.reader, *node, *class);
            let Some(name) = node.attribute("name") else {
                self.reader.aside("<site> without a name", tag(*node));
                continue;
            };
            if element.said("fromto").is_some() {
                self.reader.unread("<site fromto>", tag(*node));
                continue;
            }
            let placement = frame * placement(self.reader, &element, self.compiler);
            frames.push(NamedFrame { name: name.to_owned(), placement });
        }
        frames
    }

    /// Says what is missing from a body's mass.
    fn say_about_mass(&mut self, node: Node, name: &str, contents: &Contents, unread: bool, found: bool) {
        let from_geoms = match self.compiler.from_geoms {
            FromGeoms::Never => false,
            FromGeoms::Auto => contents.inertials.is_empty(),
            FromGeoms::Always => true,
        };
        if unread && from_geoms {
            let message = "it has geoms made of meshes, which are not read, and their mass is missing: give it an <inertial>";
            self.reader.suspect(tag(node), name, message);
        } else if !contents.joints.is_empty() && !found {
            let message = "it moves and has neither <inertial> nor geoms with mass: it counts as massless";
            self.reader.suspect(tag(node), name, message);
        }
    }

    /// The massless links in front of a body, which are added, and the body with the joint that moves it.
    fn chain(
        &mut self,
        name: &str,
        node: Node,
        mut parent: Option<usize>,
        at: Placement,
        joints: &[Joint<'a>],
    ) -> (Option<usize>, Body) {
        let (segments, beyond) = segments(at, joints);
        let count = segments.len();
        let mut last = None;
        for (i, segment) in segments.into_iter().enumerate() {
            let after = segment.joints.last().map_or("", |(joint, _)| joint.name.as_str()).to_owned();
            let joint = self.joint(name, &segment);
            if i + 1 == count {
                last = Some(joint);
                break;
            }
            let link = self.body_names.take(&format!("{name}_{after}"));
            self.bodies.push(Body::new(link, parent, joint, tag(node)));
            self.of_file.push(false);
            parent = Some(self.bodies.len() - 1);
        }
        let body = match last {
            Some(joint) => Body { beyond, ..Body::new(name, parent, joint, tag(node)) },
            None => Body::new(name, parent, FigureJoint::new("").placed(beyond), tag(node)),
        };
        (parent, body)
    }

    fn joint(&mut self, body: &str, segment: &Segment<'_, 'a>) -> FigureJoint {
        for (joint, _) in &segment.joints {
            let span = if joint.node.has_attribute("name") {
                value_span(joint.node, "name")
            } else {
                tag(joint.node)
            };
            self.places.put(Part::Dof, &joint.name, span.clone());
            self.places.put(Part::Joint, &joint.name, span.clone());
            for field in ["limits", "armature", "stiffness", "damping", "friction"] {
                let attribute = match field {
                    "limits" => "range",
                    "friction" => "frictionloss",
                    _ => field,
                };
                if joint.node.has_attribute(attribute) {
                    self.places.put_field(Part::Dof, &joint.name, field, value_span(joint.node, attribute));
                }
            }
        }
        let first = segment.joints[0].0;
        let built = match (first.kind, segment.joints.len()) {
            (Kind::Ball, _) => FigureJoint::ball(&first.name).armature(first.armature).passive(first.passive),
            (Kind::Free, _) => FigureJoint::free(&first.name).armature(first.armature).passive(first.passive),
            (_, 1) => FigureJoint::new(&first.name),
            _ => {
                let name = self.group_names.take(body);
                self.places.put(Part::Joint, &name, tag(first.node));
                FigureJoint::new(name)
            }
        };
        let built = segment.joints.iter().fold(built, |built, (joint, axis)| {
            let Some(axis) = axis else { return built };
            let built = built.axis(*axis).named(&joint.name).armature(joint.armature).passive(joint.passive);
            match joint.limits {
                Some(Limits { lower, upper }) => built.limited(lower, upper),
                None => built,
            }
        });
        built.placed(segment.placement)
    }
}

/// The shape of the geom with the most mass.
fn heaviest(geoms: &[Geom]) -> Option<Shape> {
    let mut geoms = geoms.iter();
    let first = geoms.next()?;
    Some(geoms.fold(first, |most, geom| if geom.lump.mass > most.lump.mass { geom } else { most }).shape)
}
