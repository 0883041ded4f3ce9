//! `<joint>`.

use super::frames::{Anchor, Entity, Kind as Framed};
use super::model::{Contents, Context};
use super::pose;
use crate::xml::{Node, Reader, element, shown, tag, text_of, value_span};
use solaris_model::{Limits, Passive, Vector3};
use std::ops::Range;

/// What a `<joint>` says.
pub(super) struct Joint {
    pub(super) entity: usize,
    pub(super) kind: Kind,
    pub(super) parent: Anchor,
    pub(super) child: Anchor,
    pub(super) axes: Vec<JointAxis>,
    pub(super) span: Range<usize>,
}

/// The kinds of joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Revolute,
    Continuous,
    Prismatic,
    Universal,
    Ball,
    Fixed,
    Gearbox,
    /// A turn, with a slide that follows it by this much (m/rad).
    Screw(f64),
}

/// What an `<axis>` says.
pub(super) struct JointAxis {
    pub(super) direction: Vector3<f64>,
    /// The frame that the direction is in; none for the joint's.
    pub(super) expressed_in: Option<Anchor>,
    pub(super) limits: Option<Limits>,
    pub(super) passive: Passive,
    pub(super) span: Range<usize>,
}

/// Beyond this a limit is none: what the format's older versions have in place of infinity.
const NO_LIMIT: f64 = 1e16;

pub(super) fn read(reader: &mut Reader, node: Node, contents: &mut Contents, context: &Context) {
    reader.check_attributes(node, &["name", "type"]);
    let known = ["parent", "child", "axis", "axis2", "pose", "thread_pitch", "screw_thread_pitch"];
    let asides = ["physics", "sensor", "gearbox_ratio", "gearbox_reference_body"];
    reader.check_elements(node, &known, &asides);
    let name = reader.need(node, "name").unwrap_or_default().trim().to_owned();
    reader.need(node, "type");
    let kind = kind(reader, node);
    let [parent, child] = ["parent", "child"].map(|end| self::end(reader, node, context, end));
    let axes = match kind {
        Kind::Fixed | Kind::Ball | Kind::Gearbox => &[][..],
        Kind::Universal => &["axis", "axis2"][..],
        _ => &["axis"][..],
    };
    let axes = axes.iter().filter_map(|which| axis(reader, node, context, &name, which, kind)).collect();
    let pose = pose::of(reader, node, context.version);
    let (Some(parent), Some(child)) = (parent, child) else { return };
    if let Anchor::Named(world, _) = &child
        && world == "world"
    {
        let message =
            format!("joint '{name}' has the world as its child; make it the parent, and the link the child");
        reader.fault(tag(node), message);
        return;
    }
    let span = value_span(node, "name");
    let relative_to = context.base(&pose, &child);
    let framed = Framed::Joint { child: child.clone() };
    let entity = Entity { name, scope: context.scope, place: pose.place, relative_to, kind: framed };
    let entity = contents.add(reader, context, span.clone(), entity);
    contents.joints.push(Joint { entity, kind, parent, child, axes, span: context.at(span) });
}

fn kind(reader: &mut Reader, node: Node) -> Kind {
    let kinds = [
        ("revolute", Kind::Revolute),
        ("continuous", Kind::Continuous),
        ("prismatic", Kind::Prismatic),
        ("universal", Kind::Universal),
        ("revolute2", Kind::Universal),
        ("ball", Kind::Ball),
        ("fixed", Kind::Fixed),
        ("screw", Kind::Screw(0.0)),
        ("gearbox", Kind::Gearbox),
    ];
    match reader.choice(node, "type", &kinds) {
        Some(Kind::Screw(_)) => Kind::Screw(lead(reader, node)),
        kind => kind.unwrap_or(Kind::Fixed),
    }
}

/// How far a screw slides per turn by 1 rad (m).
///
/// `<screw_thread_pitch>` is the way per revolution, right-handed; the older `<thread_pitch>` the turn per way, left-handed.
fn lead(reader: &mut Reader, node: Node) -> f64 {
    let mut number = |name: &str| element(node, name).and_then(|pitch| reader.text_number(pitch));
    match (number("screw_thread_pitch"), number("thread_pitch")) {
        (Some(way), _) => way / std::f64::consts::TAU,
        (None, Some(turn)) if turn != 0.0 => -1.0 / turn,
        _ => 1.0 / std::f64::consts::TAU,
    }
}

fn end(reader: &mut Reader, node: Node, context: &Context, which: &str) -> Option<Anchor> {
    let found = element(node, which).map(text_of).filter(|(name, _)| !name.is_empty());
    if found.is_none() {
        reader.fault(tag(node), format!("<joint> has no <{which}>"));
    }
    found.map(|(name, span)| context.named(name, span))
}

fn axis(
    reader: &mut Reader,
    joint: Node,
    context: &Context,
    name: &str,
    which: &str,
    kind: Kind,
) -> Option<JointAxis> {
    let Some(node) = element(joint, which) else {
        reader.fault(tag(joint), format!("joint '{name}' has no <{which}>"));
        return None;
    };
    reader.check_elements(
        node,
        &["xyz", "dynamics", "limit", "use_parent_model_frame", "mimic"],
        &["initial_position"],
    );
    let xyz = element(node, "xyz");
    let numbers = xyz.and_then(|xyz| reader.text_numbers(xyz, 3..=3));
    let direction = numbers.map_or_else(Vector3::z, |numbers| Vector3::from_row_slice(&numbers));
    let expressed_in = xyz.and_then(|xyz| xyz.attribute("expressed_in")).map(str::trim);
    let expressed_in = expressed_in.filter(|frame| !frame.is_empty()).zip(xyz);
    let of_model =
        element(node, "use_parent_model_frame").is_some_and(|it| super::include::is_true(text_of(it).0));
    let expressed_in = match expressed_in {
        Some((frame, xyz)) => Some(context.named(frame, value_span(xyz, "expressed_in"))),
        // Before version 1.5 all axes were along the model's.
        None if context.version == 4 || (context.version < 7 && of_model) => Some(context.own.clone()),
        None => None,
    };
    if let Some(mimic) = element(node, "mimic") {
        let leader = shown(mimic.attribute("joint").unwrap_or_default());
        let message = format!(
            "it mimics '{leader}'; here it is a degree of freedom of its own, and its motion must say so"
        );
        reader.note(tag(mimic), name, message);
    }
    Some(JointAxis {
        direction,
        expressed_in,
        limits: limits(reader, node, name, kind),
        passive: passive(reader, node),
        span: context.at(xyz.map_or_else(|| tag(node), tag)),
    })
}

fn limits(reader: &mut Reader, axis: Node, name: &str, kind: Kind) -> Option<Limits> {
    let limit = element(axis, "limit").filter(|_| kind != Kind::Continuous)?;
    let asides = ["effort", "velocity", "stiffness", "dissipation"];
    reader.check_elements(limit, &["lower", "upper"], &asides);
    let mut bound = |which: &str, none: f64| {
        let node = element(limit, which)?;
        let word = text_of(node).0.to_ascii_lowercase();
        let infinite = ["inf", "+inf", "-inf", "infinity", "-infinity", ""].contains(&word.as_str());
        let value = if infinite { none } else { reader.text_number(node)? };
        Some(if value.abs() >= NO_LIMIT { none } else { value })
    };
    let lower = bound("lower", f64::NEG_INFINITY).unwrap_or(f64::NEG_INFINITY);
    let upper = bound("upper", f64::INFINITY).unwrap_or(f64::INFINITY);
    if lower > upper {
        let message = format!(
            "its limits {lower} to {upper} are no range, the lower is above the upper; it is taken as unlimited"
        );
        reader.suspect(tag(limit), name, message);
        return None;
    }
    (lower.is_finite() || upper.is_finite()).then_some(Limits { lower, upper })
}

fn passive(reader: &mut Reader, axis: Node) -> Passive {
    let Some(dynamics) = element(axis, "dynamics") else { return Passive::default() };
    let names = ["damping", "friction", "spring_reference", "spring_stiffness"];
    reader.check_elements(dynamics, &names, &[]);
    let [damping, friction, rest, stiffness] =
        names.map(|name| element(dynamics, name).and_then(|node| reader.text_number(node)).unwrap_or(0.0));
    Passive { stiffness, rest, damping, friction }
}
