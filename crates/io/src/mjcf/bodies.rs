//! `<worldbody>`: the tree of bodies.

mod contents;

use super::assembly::Assembly;
use super::chain::{Segment, segments};
use super::compiler::{Compiler, FromGeoms};
use super::defaults::{Resolved, SPECIFIERS};
use super::geom::{self, At, Geom};
use super::inertia::{self, Weight};
use super::joint::{self, Joint, Kind};
use super::medium::{Acting, Surroundings};
use super::mesh::Meshes;
use super::model::Model;
use super::orientation::placement;
use super::sections::World;
use super::springs::Sprung;
use crate::loader::Loader;
use crate::tree::{Body, Names};
use crate::xml::{Node, Reader, elements_called, tag, value_span};
use contents::{Around, Contents, Walk};
use solaris_model::{Joint as FigureJoint, Limits, NamedFrame, Part, Placement, Shape, SourceMap};
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::ops::Range;

/// The most bodies of a model.
const MOST_BODIES: usize = 100_000;

/// A body that is still to be read.
struct Open<'a> {
    node: Node<'a>,
    /// Its parent's place in the list.
    parent: Option<usize>,
    /// What stands around it in the parent.
    around: Around,
}

/// What is needed while bodies are read.
struct Reading<'r, 'a, 't> {
    reader: &'r mut Reader<'t>,
    models: &'a [Model<'a>],
    assembly: &'r Assembly<'r>,
    world: &'r World,
    places: &'r mut SourceMap,
    bodies: Vec<Body>,
    /// Of each body the model that it is of; none for links between joints, which are not the file's.
    model_of: Vec<Option<usize>>,
    /// Of each body whether anything moves it.
    moving: Vec<bool>,
    meshes: Meshes<'r>,
    surroundings: Surroundings,
    sprung: Sprung,
    /// Bodies of whose mass something is missing, and whether they have any.
    missing: Vec<(Range<usize>, String, bool)>,
    body_names: Names,
    joint_names: Names,
    /// Joints of figures that are called like bodies.
    group_names: Names,
    /// Kinds and names of what has been read, with its place.
    seen: HashMap<(&'static str, String), Range<usize>>,
    /// Names that were met again.
    repeated: usize,
    count: usize,
}

/// All bodies, parents first, and what acts on them.
pub(super) fn read<'a>(
    reader: &mut Reader,
    models: &'a [Model<'a>],
    assembly: &Assembly,
    world: &World,
    places: &mut SourceMap,
    loader: &mut dyn Loader,
) -> (Vec<Body>, Acting, Sprung) {
    let [bodies, joints] = names(reader, models);
    let names = |of: &[String]| Names::of(of.iter().map(String::as_str));
    let mut reading = Reading {
        body_names: names(&bodies),
        joint_names: names(&joints),
        group_names: names(&joints),
        reader,
        models,
        assembly,
        world,
        places,
        bodies: Vec::new(),
        model_of: Vec::new(),
        moving: Vec::new(),
        meshes: Meshes::new(loader),
        surroundings: Surroundings::default(),
        sprung: Sprung::default(),
        missing: Vec::new(),
        seen: HashMap::new(),
        repeated: 0,
        count: 0,
    };
    let (mut walk, mut open) = (Walk::new(models), Vec::new());
    for world in elements_called(models[0].root, "worldbody") {
        let contents = walk.contents(reading.reader, world, Around::world());
        for (node, _) in &contents.geoms {
            reading.reader.aside("<geom> of <worldbody>", tag(*node));
        }
        for (node, _) in contents.joints.iter().chain(&contents.inertials) {
            reading.reader.fault(tag(*node), format!("the world cannot have a <{}>", node.tag_name().name()));
        }
        for (node, _) in &contents.sites {
            reading.reader.unread("<site> of <worldbody>", tag(*node));
        }
        let children = contents.bodies.into_iter().map(|(node, around)| Open { node, parent: None, around });
        open.extend(children.rev());
        while let Some(next) = open.pop() {
            if reading.count == MOST_BODIES {
                let message = format!("the model has more than {MOST_BODIES} bodies");
                reading.reader.fault(tag(next.node), message);
                break;
            }
            reading.body(&mut walk, next, &mut open);
        }
    }
    reading.sum_up();
    let Reading { reader, mut bodies, model_of, surroundings, sprung, .. } = reading;
    let changed = bodies.iter_mut().zip(model_of);
    let mut changed: Vec<(&mut Body, &Compiler)> =
        changed.filter_map(|(body, model)| Some((body, &models[model?].compiler))).collect();
    inertia::adjust(reader, &mut changed, models);
    let acting = if world.springs || world.dampers { surroundings } else { Surroundings::default() };
    let acting = acting.acting(&bodies);
    (bodies, acting, sprung)
}

/// The names of all bodies and joints, which others must not get.
fn names(reader: &Reader, models: &[Model]) -> [Vec<String>; 2] {
    // What there is to say will be said when they are read.
    let (mut silent, mut walk) = (Reader::new(reader.text()), Walk::new(models));
    let (mut bodies, mut joints) = (Vec::new(), Vec::new());
    for world in elements_called(models[0].root, "worldbody") {
        let mut open = vec![(world, Around::world())];
        while let Some((node, around)) = open.pop() {
            let contents = walk.contents(&mut silent, node, around);
            joints.extend(contents.joints.iter().filter_map(|(node, around)| around.name(*node)));
            bodies.extend(contents.bodies.iter().filter_map(|(node, around)| around.name(*node)));
            open.extend(contents.bodies.into_iter().map(|(node, around)| (node, Around::body(&around))));
        }
    }
    [bodies, joints]
}

impl<'a> Reading<'_, 'a, '_> {
    fn body(&mut self, walk: &mut Walk<'_, 'a>, this: Open<'a>, open: &mut Vec<Open<'a>>) {
        let Open { node, parent, around } = this;
        self.count += 1;
        let mut known = vec!["name", "pos", "childclass", "user", "gravcomp"];
        known.extend(SPECIFIERS);
        self.reader.check_attributes_but(node, &known, &["sleep", "simple", "fuse"]);
        let name = match around.name(node) {
            // A name that is there already is reported.
            Some(name) if self.is_new("body", &name, node) => name,
            Some(name) => self.body_names.take(&name),
            None => self.body_names.take(&format!("body{}", self.count)),
        };
        let Model { compiler, defaults, .. } = &self.models[around.model];
        let class = defaults.class(self.reader, node, "childclass").unwrap_or(around.class);
        let at = around.frame * placement(self.reader, &Resolved::plain(node), compiler);
        let inside = Around::body(&around).of_class(class);
        let contents = walk.contents(self.reader, node, inside);
        let joints = self.joints(&name, &contents, parent);
        let free = joints.iter().filter(|joint| joint.kind == Kind::Free);
        self.sprung.places.extend(free.map(|joint| (joint.name.clone(), at)));
        let counts = match compiler.from_geoms {
            FromGeoms::Never => false,
            FromGeoms::Auto => contents.inertials.is_empty(),
            FromGeoms::Always => true,
        };
        let (geoms, missing) = self.geoms(&contents, counts);
        if let Some((second, _)) = contents.inertials.get(1) {
            self.reader.fault(tag(*second), format!("body '{name}' has a second <inertial>"));
        }
        let inertial = contents.inertials.first().map(|(node, around)| (*node, around.frame));
        let lump = inertia::of_body(self.reader, inertial, &geoms, compiler);
        let gravcomp = self.reader.number(node, "gravcomp").unwrap_or(0.0);
        let moves = !joints.is_empty() || parent.is_some_and(|parent| self.moving[parent]);
        self.say_about_mass(node, &name, moves, &missing, lump.is_some());

        let span = if node.has_attribute("name") { value_span(node, "name") } else { tag(node) };
        let (parent, mut body) = self.chain(&name, node, parent, at, &joints);
        body.parent = parent;
        body.span = span;
        let index = self.bodies.len();
        if moves && self.world.is_fluid() {
            let ellipsoids = geoms.iter().filter_map(|geom| geom.fluid);
            let before = self.surroundings.ellipsoids.len();
            self.surroundings.ellipsoids.extend(ellipsoids.map(|(at, shape)| (index, at, shape)));
            if self.surroundings.ellipsoids.len() == before {
                let axes = lump.as_ref().and_then(|weight| weight.axes);
                self.surroundings.boxes.push((index, axes));
            }
        }
        if moves && gravcomp != 0.0 {
            self.surroundings.carried.push((index, gravcomp));
        }
        if let Some(Weight { lump, .. }) = lump {
            (body.mass, body.com, body.inertia) = (lump.mass, lump.com, lump.inertia);
        }
        body.shape = heaviest(&geoms);
        body.frames = self.sites(&contents);
        let mass_span = inertial.map_or_else(|| tag(node), |(inertial, _)| tag(inertial));
        for field in ["mass", "inertia", "com"] {
            self.places.put_field(Part::Link, &name, field, mass_span.clone());
        }
        self.bodies.push(body);
        self.model_of.push(Some(around.model));
        self.moving.push(moves);
        let parent = Some(self.bodies.len() - 1);
        let children = contents.bodies.into_iter().map(|(node, around)| Open { node, parent, around });
        open.extend(children.rev());
    }

    /// Whether a name of its kind is the first; another is a fault.
    fn is_new(&mut self, kind: &'static str, name: &str, node: Node) -> bool {
        let span = value_span(node, "name");
        let first = match self.seen.entry((kind, name.to_owned())) {
            Entry::Vacant(entry) => {
                entry.insert(span);
                return true;
            }
            Entry::Occupied(entry) => entry.get().clone(),
        };
        self.repeated += 1;
        // Lines are counted for the few that will be read.
        let before = if self.repeated <= 100 {
            format!(" (on {})", self.assembly.line(&first))
        } else {
            String::new()
        };
        let message = format!("{kind} '{name}' is there already{before}; names must be unique");
        self.reader.fault(span, message);
        false
    }

    fn joints(&mut self, body: &str, contents: &Contents<'a>, parent: Option<usize>) -> Vec<Joint<'a>> {
        let mut joints: Vec<Joint> = Vec::new();
        for (node, around) in &contents.joints {
            joint::check_attributes(self.reader, *node);
            let Model { compiler, defaults, .. } = &self.models[around.model];
            let element = if node.tag_name().name() == "freejoint" {
                Resolved::plain(*node)
            } else {
                defaults.resolve(self.reader, *node, around.class)
            };
            let is_free = node.tag_name().name() == "freejoint" || element.text("type") == Some("free");
            let name = match around.name(*node) {
                Some(name) if self.is_new("joint", &name, *node) => name,
                Some(name) => self.joint_names.take(&name),
                None => {
                    let name = if is_free { "root".to_owned() } else { format!("{body}_joint") };
                    let name = self.joint_names.take(&name);
                    self.group_names.take(&name)
                }
            };
            let joint = joint::read(self.reader, &element, name, &around.frame, compiler, self.world);
            if joint.reference != 0.0 {
                self.sprung.references.insert(joint.name.clone(), joint.reference);
            }
            self.sprung.joints.extend(joint.sprung.map(|set| (joint.name.clone(), set)));
            joints.push(joint);
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

    /// The solids of a body, and why the mass of others is missing.
    fn geoms(&mut self, contents: &Contents<'a>, counts: bool) -> (Vec<Geom>, Vec<String>) {
        let (mut geoms, mut missing) = (Vec::new(), Vec::new());
        for (node, around) in &contents.geoms {
            geom::check_attributes(self.reader, *node);
            let (models, model) = (self.models, around.model);
            let element = models[model].defaults.resolve(self.reader, *node, around.class);
            let in_fluid = self.world.is_fluid();
            let at = At { frame: around.frame, models, model, counts, in_fluid };
            match geom::read(self.reader, &element, &at, &mut self.meshes) {
                geom::Read::Solid(geom) => geoms.push(*geom),
                geom::Read::Unread(why) => missing.push(why),
                // What it weighs is not known; that it would weigh nothing is no further fault.
                geom::Read::Faulty => geoms.push(Geom::unknown()),
                geom::Read::Nothing => {}
            }
        }
        (geoms, missing)
    }

    fn sites(&mut self, contents: &Contents<'a>) -> Vec<NamedFrame> {
        let mut frames = Vec::new();
        for (node, around) in &contents.sites {
            let Model { compiler, defaults, .. } = &self.models[around.model];
            let element = defaults.resolve(self.reader, *node, around.class);
            let Some(name) = around.name(*node) else {
                self.reader.aside("<site> without a name", tag(*node));
                continue;
            };
            if element.said("fromto").is_some() {
                self.reader.unread("<site fromto>", tag(*node));
                continue;
            }
            let placement = around.frame * placement(self.reader, &element, compiler);
            frames.push(NamedFrame { name, placement });
        }
        frames
    }

    /// Says what is missing from a body's mass.
    fn say_about_mass(&mut self, node: Node, name: &str, moves: bool, missing: &[String], found: bool) {
        if let Some(first) = missing.first() {
            let others = match missing.len() - 1 {
                0 => String::new(),
                1 => " (and of one more)".to_owned(),
                more => format!(" (and of {more} more)"),
            };
            let message = format!(
                "the mass of a geom{others} is missing: {first}; what is known without it counts. Give it an <inertial>, or put the file there"
            );
            self.reader.suspect(tag(node), name, message);
            if moves {
                self.missing.push((tag(node), name.to_owned(), found));
            }
        } else if moves && !found {
            let message = "it moves and has neither <inertial> nor geoms with mass: it counts as massless";
            self.reader.suspect(tag(node), name, message);
        }
    }

    /// Sums up the mass that is missing.
    fn sum_up(&mut self) {
        let Some((span, ..)) = self.missing.first() else { return };
        let span = span.clone();
        let (count, all) = (self.missing.len(), self.moving.iter().filter(|moves| **moves).count());
        let empty = self.missing.iter().filter(|(.., found)| !found).count();
        let mut names: Vec<&str> = self.missing.iter().take(5).map(|(_, name, _)| name.as_str()).collect();
        if count > names.len() {
            names.push("…");
        }
        let alone = match empty {
            0 => String::new(),
            _ => format!("; {empty} of them have no other mass"),
        };
        let message = format!(
            "of {count} of {all} bodies that move, some is not known, as meshes were not read ({}){alone}",
            names.join(", ")
        );
        self.reader.missing(span, "mass", message);
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
            self.model_of.push(None);
            self.moving.push(true);
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
