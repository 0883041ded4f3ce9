//! `<model>`, `<world>`, `<frame>`.

use super::frames::{Anchor, Entity, Frames, Kind, Scope};
use super::include::{self, Files, is_true};
use super::joint::{self, Joint};
use super::link::{self, Link};
use super::pose::{self, Pose};
use crate::xml::{Node, Reader, element, elements, tag, text_of, value_span};
use std::ops::Range;

/// The most models that may be in each other.
const DEEPEST: usize = 50;
/// What does not matter to the motion.
const ASIDES: [&str; 21] = [
    "plugin",
    "light",
    "gui",
    "scene",
    "physics",
    "state",
    "road",
    "audio",
    "atmosphere",
    "magnetic_field",
    "actor",
    "spherical_coordinates",
    "self_collide",
    "allow_auto_disable",
    "enable_wind",
    "gripper",
    "population",
    "sensor",
    "wind",
    "model_state",
    "projector",
];

/// All that was read.
pub(super) struct Contents<'l> {
    pub(super) frames: Frames,
    /// Of each entity, where it stands in the main text.
    pub(super) spans: Vec<Range<usize>>,
    pub(super) links: Vec<Link>,
    pub(super) joints: Vec<Joint>,
    pub(super) files: Files<'l>,
    /// Models of the world that could not be included, and why.
    pub(super) left_out: Vec<(Range<usize>, String)>,
    /// Whether there are more links than are read.
    pub(super) is_full: bool,
}

/// Where something is read.
#[derive(Clone)]
pub(super) struct Context {
    /// The second number of the file's version.
    pub(super) version: u32,
    pub(super) scope: usize,
    /// What places are relative to that say nothing.
    pub(super) own: Anchor,
    /// Where the main text includes the file that is read; none in the main text.
    pub(super) span: Option<Range<usize>>,
    pub(super) depth: usize,
}

/// What an `<include>` says about its model.
pub(super) struct Given {
    pub(super) name: Option<String>,
    pub(super) pose: Option<Pose>,
    pub(super) placed: Option<(String, Range<usize>)>,
    pub(super) is_static: Option<bool>,
    pub(super) merge: bool,
}

impl<'l> Contents<'l> {
    pub(super) fn new(files: Files<'l>) -> Self {
        Self {
            frames: Frames::new(),
            spans: Vec::new(),
            links: Vec::new(),
            joints: Vec::new(),
            files,
            left_out: Vec::new(),
            is_full: false,
        }
    }

    /// Adds an entity that stands at `span` of the file that is read.
    pub(super) fn add(
        &mut self,
        reader: &mut Reader,
        context: &Context,
        span: Range<usize>,
        entity: Entity,
    ) -> usize {
        self.spans.push(context.at(span.clone()));
        self.frames.add(reader, &span, entity)
    }
}

impl Context {
    /// That of the main file.
    pub(super) fn outer(version: u32) -> Self {
        Self { version, scope: 0, own: Anchor::Scope, span: None, depth: 0 }
    }

    /// A place of the file that is read, in the main text.
    pub(super) fn at(&self, span: Range<usize>) -> Range<usize> {
        self.span.clone().unwrap_or(span)
    }

    /// A frame that is named at `span` of the file that is read.
    pub(super) fn named(&self, name: &str, span: Range<usize>) -> Anchor {
        if name == "__model__" { self.own.clone() } else { Anchor::Named(name.to_owned(), self.at(span)) }
    }

    /// What a pose is relative to, or else `otherwise`.
    pub(super) fn base(&self, pose: &Pose, otherwise: &Anchor) -> Anchor {
        match &pose.relative_to {
            Some((name, span)) => self.named(name, span.clone()),
            None => otherwise.clone(),
        }
    }
}

/// The models of a world.
pub(super) fn of_world(reader: &mut Reader, world: Node, contents: &mut Contents, context: &Context) {
    reader.check_attributes(world, &["name"]);
    content(reader, world, contents, context);
}

/// The one model of a file, or the one that it includes.
pub(super) fn of_root(reader: &mut Reader, root: Node, contents: &mut Contents, context: &Context) {
    for node in elements(root) {
        match node.tag_name().name() {
            "model" => read(reader, node, contents, context, None),
            "include" => include::read(reader, node, contents, context),
            _ => {}
        }
    }
}

/// A model in the scope of `context`.
pub(super) fn read(
    reader: &mut Reader,
    node: Node,
    contents: &mut Contents,
    context: &Context,
    given: Option<Given>,
) {
    reader.check_attributes(node, &["name", "canonical_link", "placement_frame", "namespace"]);
    if context.depth >= DEEPEST {
        reader.fault(tag(node), format!("more than {DEEPEST} models are nested in each other"));
        return;
    }
    let given =
        given.unwrap_or(Given { name: None, pose: None, placed: None, is_static: None, merge: false });
    let name = given.name.unwrap_or_else(|| reader.need(node, "name").unwrap_or_default().trim().to_owned());
    let pose = given.pose.unwrap_or_else(|| pose::of(reader, node, context.version));
    let own_placed = node.attribute("placement_frame").map(str::trim).filter(|frame| !frame.is_empty());
    let own_placed =
        own_placed.map(|frame| (frame.to_owned(), context.at(value_span(node, "placement_frame"))));
    let placed = given.placed.or(own_placed);
    let own_static = element(node, "static").is_some_and(|it| is_true(text_of(it).0));
    let is_static = given.is_static.unwrap_or(own_static);
    let base = context.base(&pose, &context.own);
    if given.merge {
        if placed.is_some() {
            reader.fault(
                tag(node),
                "placement_frame of a model that is merged is not read; give its pose without",
            );
        }
        merge(
            reader,
            node,
            contents,
            context,
            &name,
            Entity {
                name: format!("_merged__{name}__model__"),
                scope: context.scope,
                place: pose.place,
                relative_to: base,
                kind: Kind::Frame { attached_to: context.own.clone() },
            },
        );
        return;
    }
    let canonical = node.attribute("canonical_link").map(str::trim).filter(|link| !link.is_empty());
    let scope = contents.frames.open(Scope {
        is_static,
        canonical: canonical.map(|link| context.named(link, value_span(node, "canonical_link"))),
        ..Scope::default()
    });
    let model = contents.add(
        reader,
        context,
        value_span(node, "name"),
        Entity {
            name,
            scope: context.scope,
            place: pose.place,
            relative_to: base,
            kind: Kind::Model { scope, placed: placed.map(|(frame, span)| Anchor::Named(frame, span)) },
        },
    );
    contents.frames.scopes[scope].model = Some(model);
    let inner = Context { scope, own: Anchor::Scope, depth: context.depth + 1, ..context.clone() };
    content(reader, node, contents, &inner);
}

/// What is in a model becomes the scope's own; the model's frame stays.
fn merge(
    reader: &mut Reader,
    node: Node,
    contents: &mut Contents,
    context: &Context,
    name: &str,
    frame: Entity,
) {
    if name.is_empty() {
        return;
    }
    let frame = contents.add(reader, context, tag(node), frame);
    let inner = Context { own: Anchor::Entity(frame), depth: context.depth + 1, ..context.clone() };
    content(reader, node, contents, &inner);
}

fn content(reader: &mut Reader, node: Node, contents: &mut Contents, context: &Context) {
    let known = ["link", "joint", "frame", "model", "include", "pose", "static", "gravity"];
    reader.check_elements(node, &known, &ASIDES);
    for child in elements(node) {
        match child.tag_name().name() {
            "link" if context.scope > 0 => link::read(reader, child, contents, context),
            "joint" => joint::read(reader, child, contents, context),
            "frame" => frame(reader, child, contents, context),
            "model" => read(reader, child, contents, context, None),
            "include" => include::read(reader, child, contents, context),
            _ => {}
        }
    }
}

fn frame(reader: &mut Reader, node: Node, contents: &mut Contents, context: &Context) {
    reader.check_attributes(node, &["name", "attached_to"]);
    reader.check_elements(node, &["pose"], &[]);
    let name = reader.need(node, "name").unwrap_or_default().trim().to_owned();
    let attached = node.attribute("attached_to").map(str::trim).filter(|frame| !frame.is_empty());
    let attached_to = attached
        .map_or_else(|| context.own.clone(), |frame| context.named(frame, value_span(node, "attached_to")));
    let pose = pose::of(reader, node, context.version);
    let relative_to = context.base(&pose, &attached_to);
    let kind = Kind::Frame { attached_to };
    let entity = Entity { name, scope: context.scope, place: pose.place, relative_to, kind };
    contents.add(reader, context, value_span(node, "name"), entity);
}
