//! The bodies that links and joints make.

use super::carriers::{Carrier, Carriers};
use super::frames::Kind as Framed;
use super::joint::{Joint, JointAxis, Kind};
use super::model::Contents;
use super::solved::Solved;
use super::spanning::{self, Edge, Held};
use super::ties::Closing;
use crate::tree::{Body, Names};
use crate::xml::{Node, Reader, tag};
use solaris_model::{Axis, Curve, Joint as FigureJoint, NamedFrame, Part, SourceMap, Vector3};

/// The one model of the file that moves, where there is but one: names are those in it.
pub(super) fn top(contents: &Contents) -> Option<usize> {
    let frames = &contents.frames;
    let moving: Vec<usize> = (0..contents.links.len()).filter(|link| moves(contents, *link)).collect();
    // Where nothing moves, whatever stands there.
    let all = if moving.is_empty() { (0..contents.links.len()).collect() } else { moving };
    let mut tops = all.into_iter().map(|link| {
        let mut scope = frames.entities[contents.links[link].entity].scope;
        let mut top = None;
        while let Some(model) = frames.scopes[scope].model {
            (top, scope) = (Some(model), frames.entities[model].scope);
        }
        top
    });
    let first = tops.next()?;
    if tops.all(|top| top == first) { first } else { None }
}

fn moves(contents: &Contents, link: usize) -> bool {
    !contents.frames.is_static(contents.frames.entities[contents.links[link].entity].scope)
}

/// The bodies, with what there is to say of them, and the joints that close loops.
pub(super) fn bodies(
    reader: &mut Reader,
    root: Node,
    contents: &Contents,
    top: Option<usize>,
    places: &mut SourceMap,
) -> (Vec<Body>, Vec<Closing>) {
    if contents.is_full {
        return Default::default();
    }
    let solved = Solved::of(reader, &contents.frames, &contents.spans);
    let moving: Vec<usize> = (0..contents.links.len()).filter(|link| moves(contents, *link)).collect();
    let all_stand = moving.is_empty();
    let moving = if all_stand { (0..contents.links.len()).collect() } else { moving };
    if moving.is_empty() {
        for (span, message) in &contents.left_out {
            reader.fault(span.clone(), message.clone());
        }
        if reader.has_faults() {
            return Default::default();
        }
        let message = "it has no <link>, so that nothing can move: is it a part that another file includes?";
        reader.suspect(tag(root), "<sdf>", message);
        return (vec![Body::new("world", None, FigureJoint::new(""), tag(root))], Vec::new());
    }
    let left_out = contents.links.len() - moving.len();
    if left_out > 0 {
        let links = if left_out == 1 { "1 link".to_owned() } else { format!("{left_out} links") };
        let message = format!("{links} of static models left out: nothing moves them");
        reader.note(tag(root), "static models", message);
    }
    let carriers = Carriers::of(reader, &contents.frames, &contents.spans);
    let mut mechanism = Mechanism::of(reader, contents, &solved, &carriers, &moving, top);
    let (held, loops) = if all_stand {
        mechanism.joints.clear();
        (vec![Held::Free; moving.len()], Vec::new())
    } else {
        let edges: Vec<Edge> = mechanism.joints.iter().map(|(_, edge)| *edge).collect();
        spanning::tree(moving.len(), &edges)
    };
    mechanism.say_loops(reader, &held, &loops);
    let mut bodies = mechanism.bodies(reader, &held, all_stand, places);
    mechanism.add_frames(&mut bodies);
    let closings = loops.iter().map(|joint| mechanism.closing(reader, *joint, &bodies)).collect();
    (bodies, closings)
}

/// Links that move and the joints between them.
struct Mechanism<'c, 'l> {
    contents: &'c Contents<'l>,
    solved: &'c Solved<'c>,
    carriers: &'c Carriers,
    moving: &'c [usize],
    /// Of each link, its place in `moving`.
    nodes: Vec<Option<usize>>,
    joints: Vec<(&'c Joint, Edge)>,
    top: Option<usize>,
}

impl<'c, 'l> Mechanism<'c, 'l> {
    fn of(
        reader: &mut Reader,
        contents: &'c Contents<'l>,
        solved: &'c Solved<'c>,
        carriers: &'c Carriers,
        moving: &'c [usize],
        top: Option<usize>,
    ) -> Self {
        let mut nodes = vec![None; contents.links.len()];
        moving.iter().enumerate().for_each(|(node, link)| nodes[*link] = Some(node));
        let mut mechanism = Self { contents, solved, carriers, moving, nodes, joints: Vec::new(), top };
        for joint in &contents.joints {
            let name = mechanism.name(joint.entity);
            if joint.kind == Kind::Gearbox {
                let message =
                    "it is a gearbox, which couples two turns and is not read yet: its forces are missing";
                reader.suspect(joint.span.clone(), name, message);
                continue;
            }
            let scope = contents.frames.entities[joint.entity].scope;
            let [parent, child] = [&joint.parent, &joint.child]
                .map(|end| carriers.anchor(reader, &contents.frames, scope, end));
            let (Some(parent), Some(child)) = (parent, child) else { continue };
            let [parent, child] = [parent, child].map(|end| match end {
                Carrier::World => None,
                Carrier::Link(link) => mechanism.nodes[link],
            });
            if parent == child {
                if parent.is_some() {
                    let message = format!("joint '{name}' has the same link on both ends");
                    reader.fault(joint.span.clone(), message);
                }
                continue;
            }
            mechanism.joints.push((joint, Edge { parent, child }));
        }
        mechanism
    }

    fn name(&self, entity: usize) -> String {
        self.solved.frames().full_name(entity, self.top)
    }

    fn link_entity(&self, node: usize) -> usize {
        self.contents.links[self.moving[node]].entity
    }

    fn say_loops(&self, reader: &mut Reader, held: &[Held], loops: &[usize]) {
        for &i in loops {
            let (joint, Edge { child, .. }) = self.joints[i];
            let holder = child.and_then(|child| match held[child] {
                Held::By(other) | Held::Reversed(other) => Some(self.name(self.joints[other].0.entity)),
                Held::Free => None,
            });
            let holder =
                holder.map_or_else(String::new, |name| format!(", which joint '{name}' holds already"));
            let child = child.map_or_else(
                || "the world".to_owned(),
                |child| format!("'{}'", self.name(self.link_entity(child))),
            );
            let message = format!(
                "it closes a loop at {child}{holder}; it is left open, and its forces are missing: those of other joints differ \
                 from the closed mechanism's"
            );
            reader.missing(joint.span.clone(), self.name(joint.entity), message);
        }
    }

    fn bodies(
        &self,
        reader: &mut Reader,
        held: &[Held],
        all_stand: bool,
        places: &mut SourceMap,
    ) -> Vec<Body> {
        // A name that is there twice has been told.
        let mut joints = Names::default();
        let joints: Vec<String> =
            self.joints.iter().map(|(joint, _)| joints.take(&self.name(joint.entity))).collect();
        let mut names = Names::of(joints.iter().map(String::as_str));
        let mut links = Names::default();
        let alone = held.iter().filter(|held| **held == Held::Free).count() == 1;
        let mut bodies = Vec::with_capacity(held.len());
        for (node, held) in held.iter().enumerate() {
            let link = &self.contents.links[self.moving[node]];
            let name = links.take(&self.name(link.entity));
            let span = link.span.clone();
            self.say_of_link(reader, node, &name, *held, all_stand);
            places.put(Part::Link, &name, span.clone());
            for field in ["mass", "inertia"] {
                places.put_field(Part::Link, &name, field, link.inertial.clone());
            }
            let mut body = match *held {
                Held::Free if all_stand => {
                    let weld = FigureJoint::new("").placed(self.solved.in_world(link.entity));
                    Body::new(name, None, weld, span)
                }
                Held::Free => {
                    let root = names.take(&if alone { "root".to_owned() } else { format!("{name}_root") });
                    Body::new(name, None, FigureJoint::free(root), span)
                }
                Held::By(i) | Held::Reversed(i) => {
                    let (joint, Edge { parent, child }) = self.joints[i];
                    let reversed = matches!(held, Held::Reversed(_));
                    let carrier = if reversed { child } else { parent };
                    let at = self.solved.between(carrier.map(|node| self.link_entity(node)), joint.entity);
                    let built = self.joint(reader, joint, &joints[i], reversed, places).placed(at);
                    let beyond = self.solved.between(Some(joint.entity), link.entity);
                    Body { beyond, ..Body::new(name, carrier, built, span) }
                }
            };
            (body.mass, body.com, body.inertia) = (link.lump.mass, link.lump.com, link.lump.inertia);
            body.shape = link.shape;
            bodies.push(body);
        }
        bodies
    }

    fn say_of_link(&self, reader: &mut Reader, node: usize, name: &str, held: Held, all_stand: bool) {
        let link = &self.contents.links[self.moving[node]];
        if all_stand {
            return;
        }
        if link.by_default {
            let message = "it has no <inertial>, which the format makes 1 kg and 1 kg m² about every axis";
            reader.suspect(link.span.clone(), name, message);
        }
        if link.weightless {
            let message = "gravity passes it over (<gravity>false</gravity>); here its weight counts";
            reader.missing(link.span.clone(), name, message);
        }
        if held == Held::Free {
            let place = self.solved.in_world(link.entity);
            let [x, y, z] = place.translation.vector.into();
            let message = format!(
                "no joint holds it: it is free, and its coordinates are its place in the world, in the file ({x}, {y}, {z}) m"
            );
            reader.note(link.span.clone(), name, message);
        }
    }

    /// The figure's joint called `name`; reversed, it moves the file's parent against its child.
    fn joint(
        &self,
        reader: &mut Reader,
        joint: &Joint,
        name: &str,
        reversed: bool,
        places: &mut SourceMap,
    ) -> FigureJoint {
        places.put(Part::Joint, name, joint.axes.first().map_or(&joint.span, |axis| &axis.span).clone());
        let built = match joint.kind {
            Kind::Ball => FigureJoint::ball(name),
            _ => FigureJoint::new(name),
        };
        if reversed && joint.kind == Kind::Ball {
            let message =
                "its child holds its parent here: its rotation is that of the parent against the child";
            reader.note(joint.span.clone(), name, message);
        }
        let mut axes: Vec<(String, &JointAxis)> = match &joint.axes[..] {
            [axis] => vec![(name.to_owned(), axis)],
            axes => axes
                .iter()
                .zip(["axis", "axis2"])
                .map(|(axis, end)| (format!("{name}.{end}"), axis))
                .collect(),
        };
        if reversed {
            axes.reverse();
        }
        axes.into_iter().fold(built, |built, (dof, axis)| {
            places.put(Part::Dof, &dof, axis.span.clone());
            let direction = self.direction(reader, joint, axis) * if reversed { -1.0 } else { 1.0 };
            let moved = match joint.kind {
                Kind::Prismatic => Axis::translation(direction),
                _ => Axis::rotation(direction),
            };
            let built = built.axis(moved).named(dof).passive(axis.passive);
            let built = match axis.limits {
                Some(limits) => built.limited(limits.lower, limits.upper),
                None => built,
            };
            match joint.kind {
                Kind::Screw(lead) => built
                    .axis(Axis::translation(direction))
                    .named(format!("{name}.slide"))
                    .following(name, Curve::linear(lead, 0.0)),
                _ => built,
            }
        })
    }

    /// The direction of an axis, in the joint's frame.
    fn direction(&self, reader: &mut Reader, joint: &Joint, axis: &JointAxis) -> Vector3<f64> {
        let Some(anchor) = &axis.expressed_in else { return axis.direction };
        let scope = self.contents.frames.entities[joint.entity].scope;
        let Some(frame) = self.solved.anchor(reader, scope, anchor) else { return Vector3::z() };
        let own = self.solved.in_world(joint.entity).rotation;
        if own == frame.rotation { axis.direction } else { own.inverse() * (frame.rotation * axis.direction) }
    }

    /// A joint that closes a loop of these bodies.
    fn closing(&self, reader: &mut Reader, index: usize, bodies: &[Body]) -> Closing {
        let (joint, Edge { parent, child }) = self.joints[index];
        let ends = [parent, child].map(|node| match node {
            Some(node) => {
                let within = self.solved.between(Some(self.link_entity(node)), joint.entity);
                (Some(bodies[node].name.clone()), within)
            }
            None => (None, self.solved.in_world(joint.entity)),
        });
        let axis = joint.axes.first().map(|axis| self.direction(reader, joint, axis));
        Closing { name: self.name(joint.entity), kind: joint.kind, ends, axis }
    }

    /// Gives each body the `<frame>`s that are attached to it.
    fn add_frames(&self, bodies: &mut [Body]) {
        let frames = self.solved.frames();
        for (i, entity) in frames.entities.iter().enumerate() {
            if !matches!(entity.kind, Framed::Frame { .. }) || entity.name.starts_with("_merged__") {
                continue;
            }
            let carrier = self.carriers.entity(i);
            let Some(Carrier::Link(link)) = carrier else { continue };
            let Some(node) = self.nodes[link] else { continue };
            let placement = self.solved.between(Some(self.contents.links[link].entity), i);
            bodies[node].frames.push(NamedFrame { name: self.name(i), placement });
        }
    }
}
