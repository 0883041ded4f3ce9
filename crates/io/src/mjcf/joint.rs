//! `<joint>` and `<freejoint>`.

use super::compiler::Compiler;
use super::defaults::Resolved;
use super::sections::World;
use crate::xml::{Node, Reader, tag};
use solaris_model::{Limits, Passive, Placement, Vector3};

/// What a joint lets its body do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Hinge,
    Slide,
    Ball,
    Free,
}

/// What an element says, in its body's frame.
#[derive(Clone)]
pub(super) struct Joint<'a> {
    pub(super) node: Node<'a>,
    pub(super) name: String,
    pub(super) kind: Kind,
    pub(super) anchor: Vector3<f64>,
    pub(super) axis: Vector3<f64>,
    /// MuJoCo's coordinate in the pose of the file (rad, m).
    pub(super) reference: f64,
    pub(super) limits: Option<Limits>,
    pub(super) armature: f64,
    pub(super) passive: Passive,
    /// Time constant (s) and damping ratio of a spring and damper that the inertia of the whole model sets.
    pub(super) sprung: Option<[f64; 2]>,
}

/// Attributes that are read.
const READ: [&str; 19] = [
    "name",
    "class",
    "type",
    "pos",
    "axis",
    "ref",
    "range",
    "limited",
    "armature",
    "damping",
    "stiffness",
    "springref",
    "frictionloss",
    "group",
    "user",
    "springdamper",
    "align",
    "actuatorfrcrange",
    "actuatorgravcomp",
];
/// Attributes of the solver.
const SOLVER: [&str; 6] =
    ["solreflimit", "solimplimit", "solreffriction", "solimpfriction", "margin", "actuatorfrclimited"];

/// Lists the attributes that are not read.
pub(super) fn check_attributes(reader: &mut Reader, node: Node) {
    reader.check_attributes_but(node, &READ, &SOLVER);
}

/// Reads a joint that stands in `frame`, a frame of its body; `name` is what it is called.
pub(super) fn read<'a>(
    reader: &mut Reader,
    element: &Resolved<'a>,
    name: String,
    frame: &Placement,
    compiler: &Compiler,
    world: &World,
) -> Joint<'a> {
    let node = element.node;
    let kinds = [("hinge", Kind::Hinge), ("slide", Kind::Slide), ("ball", Kind::Ball), ("free", Kind::Free)];
    let kind = match element.said("type") {
        _ if node.tag_name().name() == "freejoint" => Kind::Free,
        Some(said) => reader.choice(said, "type", &kinds).unwrap_or(Kind::Hinge),
        None => Kind::Hinge,
    };
    let unit = if kind == Kind::Hinge { compiler.angle } else { 1.0 };
    let anchor = Vector3::from(element.numbers(reader, "pos").unwrap_or_default());
    let axis = element.numbers(reader, "axis").map_or_else(Vector3::z, Vector3::from);
    let reference = element.number(reader, "ref").unwrap_or(0.0) * unit;
    let limits = limits(reader, element, kind, &name, unit, compiler);
    let stiffness = linear(reader, element, "stiffness", &name);
    let set: Option<[f64; 2]> = element.numbers(reader, "springdamper");
    let sprung = set.filter(|set| set.iter().all(|number| *number > 0.0));
    let found = sprung.and_then(|_| world.sprung(&name));
    let mut passive = Passive {
        stiffness,
        rest: element.number(reader, "springref").unwrap_or(0.0) * unit,
        damping: linear(reader, element, "damping", &name),
        friction: element.number(reader, "frictionloss").unwrap_or(0.0),
    };
    if let Some([stiffness, damping]) = found {
        (passive.stiffness, passive.damping) = (stiffness, damping);
    } else if sprung.is_some() {
        let message = "they set spring and damper by the inertia of the whole model; write 'stiffness' and 'damping' (MuJoCo saves them)";
        reader.lacks("springdampers of joints", message, element.span("springdamper"), &name);
    }
    if kind == Kind::Free && stiffness != 0.0 {
        let message = "they have no place in a figure";
        reader.lacks("springs of free joints", message, element.span("stiffness"), &name);
        passive.stiffness = 0.0;
    }
    passive.stiffness *= f64::from(u8::from(world.springs));
    passive.damping *= f64::from(u8::from(world.dampers));
    passive.friction *= f64::from(u8::from(world.friction));
    if passive.stiffness == 0.0 || matches!(kind, Kind::Ball | Kind::Free) {
        passive.rest = 0.0;
    }
    let armature = element.number(reader, "armature").unwrap_or(0.0);
    if element.text("actuatorgravcomp") == Some("true") {
        let message = "in MuJoCo, 'gravcomp' is borne by their actuators, and so part of their forces; here it is taken off";
        reader.lacks("'actuatorgravcomp' of joints", message, element.span("actuatorgravcomp"), &name);
    }
    if kind == Kind::Free && armature != 0.0 {
        let message = "it acts on the velocity along the body's axes here, along the world's in MuJoCo: forces differ by \
                       armature·(ω × v)";
        reader.lacks("armature of free joints", message, element.span("armature"), &name);
    }
    if kind == Kind::Free && node.attribute("align").is_some_and(|align| align == "true") {
        let message = "it is not applied: the joint moves the body's own frame here, that of its inertia in MuJoCo, so that the \
                       same numbers are other places";
        reader.lacks("'align' of free joints", message, element.span("align"), &name);
    }
    Joint {
        node,
        name,
        kind,
        anchor: frame.rotation * anchor + frame.translation.vector,
        axis: frame.rotation * axis,
        reference: if matches!(kind, Kind::Hinge | Kind::Slide) { reference } else { 0.0 },
        limits,
        armature,
        passive,
        sprung,
    }
}

/// A coefficient that may be followed by those of higher powers.
fn linear(reader: &mut Reader, element: &Resolved, attribute: &'static str, name: &str) -> f64 {
    let numbers = element.list(reader, attribute, 1..=3).unwrap_or_default();
    if numbers.iter().skip(1).any(|number| *number != 0.0) {
        let (subject, message) = if attribute == "stiffness" {
            ("springs that are not linear", "of their 'stiffness' the first number alone is in the figure")
        } else {
            ("dampers that are not linear", "of their 'damping' the first number alone is in the figure")
        };
        reader.lacks(subject, message, element.span(attribute), name);
    }
    numbers.first().copied().unwrap_or(0.0)
}

fn limits(
    reader: &mut Reader,
    element: &Resolved,
    kind: Kind,
    name: &str,
    unit: f64,
    compiler: &Compiler,
) -> Option<Limits> {
    let range: Option<[f64; 2]> = element.numbers(reader, "range");
    let choices = [("true", Some(true)), ("false", Some(false)), ("auto", None)];
    let said = element.said("limited").and_then(|said| reader.choice(said, "limited", &choices)).flatten();
    // MuJoCo's `auto`: limited where there is a range.
    let auto = compiler.autolimits && range.is_some_and(|[lower, upper]| lower < upper);
    if !said.unwrap_or(auto) || kind == Kind::Free {
        return None;
    }
    let Some([lower, upper]) = range else {
        if kind == Kind::Ball {
            return None;
        }
        reader.fault(tag(element.node), format!("joint '{name}' is limited and has no 'range'"));
        return None;
    };
    match kind {
        Kind::Hinge | Kind::Slide => Some(Limits { lower: lower * unit, upper: upper * unit }),
        Kind::Ball => {
            reader.unsupported(element.span("range"), name, "the range of a ball joint is not read");
            None
        }
        Kind::Free => None,
    }
}
