//! `<joint>`.

use super::origin;
use crate::xml::{Node, Reader, element, shown, tag, value_span};
use solaris_model::{Axis, Joint as FigureJoint, Limits, Passive, Placement, Vector3};
use std::ops::Range;

/// What an element `<joint>` says.
pub(super) struct Joint {
    pub(super) name: String,
    pub(super) span: Range<usize>,
    pub(super) kind: Kind,
    pub(super) placement: Placement,
    pub(super) axis: Vector3<f64>,
    pub(super) axis_span: Range<usize>,
    pub(super) limits: Option<Limits>,
    pub(super) limits_span: Range<usize>,
    pub(super) passive: Passive,
    pub(super) dynamics_span: Range<usize>,
    /// The links' names and where these stand.
    pub(super) parent: Option<(String, Range<usize>)>,
    pub(super) child: Option<(String, Range<usize>)>,
    pub(super) mimic: Option<Mimic>,
}

/// The kinds of joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Revolute,
    Continuous,
    Prismatic,
    Fixed,
    Floating,
    Planar,
}

/// What an element `<mimic>` says.
pub(super) struct Mimic {
    pub(super) joint: String,
    pub(super) multiplier: f64,
    pub(super) offset: f64,
    pub(super) span: Range<usize>,
}

pub(super) fn read(reader: &mut Reader, node: Node) -> Joint {
    reader.check_attributes(node, &["name", "type"]);
    let known = ["origin", "parent", "child", "axis", "limit", "dynamics", "mimic"];
    reader.check_elements(node, &known, &["calibration"]);
    let name = reader.need(node, "name").unwrap_or_default().to_owned();
    let kinds = [
        ("revolute", Kind::Revolute),
        ("continuous", Kind::Continuous),
        ("prismatic", Kind::Prismatic),
        ("fixed", Kind::Fixed),
        ("floating", Kind::Floating),
        ("planar", Kind::Planar),
    ];
    reader.need(node, "type");
    let kind = reader.choice(node, "type", &kinds).unwrap_or(Kind::Fixed);
    let axis_span = element(node, "axis").map_or_else(|| tag(node), |axis| value_span(axis, "xyz"));
    let (limits, limits_span) = limits(reader, node, &name, kind);
    let (passive, dynamics_span) = passive(reader, node);
    Joint {
        span: value_span(node, "name"),
        kind,
        placement: origin(reader, node),
        axis: axis(reader, node),
        axis_span,
        limits,
        limits_span,
        passive,
        dynamics_span,
        parent: end(reader, node, "parent"),
        child: end(reader, node, "child"),
        mimic: element(node, "mimic").and_then(|mimic| read_mimic(reader, mimic)),
        name,
    }
}

fn end(reader: &mut Reader, node: Node, which: &str) -> Option<(String, Range<usize>)> {
    let Some(end) = element(node, which) else {
        reader.fault(tag(node), format!("<joint> has no <{which}>"));
        return None;
    };
    reader.check_attributes(end, &["link"]);
    reader.need(end, "link").map(|name| (name.to_owned(), value_span(end, "link")))
}

fn axis(reader: &mut Reader, node: Node) -> Vector3<f64> {
    let Some(axis) = element(node, "axis") else { return Vector3::x() };
    reader.check_attributes(axis, &["xyz"]);
    reader.numbers(axis, "xyz").map_or_else(Vector3::x, Vector3::from)
}

fn limits(reader: &mut Reader, node: Node, name: &str, kind: Kind) -> (Option<Limits>, Range<usize>) {
    let limited = matches!(kind, Kind::Revolute | Kind::Prismatic);
    let Some(limit) = element(node, "limit") else {
        if limited {
            reader.suspect(tag(node), name, "it has no <limit>, which URDF wants; it is taken as unlimited");
        }
        return (None, tag(node));
    };
    let span = limit.range();
    if !limited {
        reader.check_attributes(limit, &[]);
        return (None, span);
    }
    // A motor's: `actuators` reads what it can give.
    reader.check_attributes_but(limit, &["lower", "upper"], &["effort", "velocity"]);
    let (lower, upper) = (reader.number(limit, "lower"), reader.number(limit, "upper"));
    if limit.attribute("lower").is_none() && limit.attribute("upper").is_none() {
        let message =
            "its <limit> has no 'lower' and 'upper', which URDF reads as 0 to 0; it is taken as unlimited";
        reader.suspect(span.clone(), name, message);
        return (None, span);
    }
    let (lower, upper) = (lower.unwrap_or(0.0), upper.unwrap_or(0.0));
    if lower > upper {
        let message = format!(
            "its limits {lower} to {upper} are no range, the lower is above the upper; it is taken as unlimited"
        );
        reader.suspect(span.clone(), name, message);
        return (None, span);
    }
    (Some(Limits { lower, upper }), span)
}

fn passive(reader: &mut Reader, node: Node) -> (Passive, Range<usize>) {
    let Some(dynamics) = element(node, "dynamics") else { return (Passive::default(), tag(node)) };
    reader.check_attributes(dynamics, &["damping", "friction"]);
    let damping = reader.number(dynamics, "damping").unwrap_or(0.0);
    let friction = reader.number(dynamics, "friction").unwrap_or(0.0);
    (Passive { damping, friction, ..Passive::default() }, dynamics.range())
}

fn read_mimic(reader: &mut Reader, node: Node) -> Option<Mimic> {
    reader.check_attributes(node, &["joint", "multiplier", "offset"]);
    let multiplier = reader.number(node, "multiplier").unwrap_or(1.0);
    let offset = reader.number(node, "offset").unwrap_or(0.0);
    let joint = reader.need(node, "joint")?.to_owned();
    Some(Mimic { joint, multiplier, offset, span: value_span(node, "joint") })
}

impl Joint {
    /// The figure's joint.
    pub(super) fn build(&self) -> FigureJoint {
        let joint = match self.kind {
            Kind::Fixed => FigureJoint::new(&self.name),
            Kind::Floating => FigureJoint::free(&self.name).passive(self.passive),
            Kind::Revolute | Kind::Continuous => self.one(Axis::rotation(self.axis)),
            Kind::Prismatic => self.one(Axis::translation(self.axis)),
            Kind::Planar => {
                let [first, second] = in_plane(&self.axis);
                FigureJoint::new(&self.name)
                    .axis(Axis::translation(first))
                    .passive(self.passive)
                    .axis(Axis::translation(second))
                    .passive(self.passive)
                    .axis(Axis::rotation(self.axis))
                    .passive(self.passive)
            }
        };
        joint.placed(self.placement)
    }

    fn one(&self, axis: Axis) -> FigureJoint {
        let joint = FigureJoint::new(&self.name).axis(axis).named(&self.name).passive(self.passive);
        match self.limits {
            Some(Limits { lower, upper }) => joint.limited(lower, upper),
            None => joint,
        }
    }

    /// What a note says about the joint that it mimics.
    pub(super) fn mimicry(mimic: &Mimic) -> String {
        let Mimic { joint, multiplier, offset, .. } = mimic;
        let joint = shown(joint);
        format!(
            "it mimics '{joint}' (q = {multiplier}·{joint} + {offset}); here it is a degree of freedom of its own, and \
             its motion must say so"
        )
    }
}

/// Two unit vectors that make a right-handed frame with `normal`: x and y for z.
fn in_plane(normal: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let Some(normal) = normal.try_normalize(1e-12) else { return [Vector3::x(), Vector3::y()] };
    // The coordinate axis after the one that is nearest to the normal.
    let first = match normal.iamax() {
        0 => Vector3::y(),
        1 => Vector3::z(),
        _ => Vector3::x(),
    };
    let first = (first - normal * normal.dot(&first)).normalize();
    [first, normal.cross(&first)]
}
