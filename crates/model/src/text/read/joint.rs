//! A joint: its place, its axes, what acts on them and what they follow.

use super::FigureReader;
use super::exact::Exact;
use crate::curve::Curve;
use crate::fault::Part;
use crate::joint::{Axis, AxisKind, Joint, JointKind, Passive};
use crate::layout::velocity_names;
use crate::text::spatial::ReadSpatial as _;
use nalgebra::Vector3;
use solaris_text::{Content, Fields, Node};
use std::ops::Range;

const AXES: [&str; 8] = ["rx", "ry", "rz", "tx", "ty", "tz", "Turn", "Slide"];
/// Fields of an axis; the first stands in `Turn` and `Slide` alone.
const AXIS_FIELDS: [&str; 9] =
    ["axis", "name", "limits", "armature", "stiffness", "rest", "damping", "friction", "follows"];
const JOINT_FIELDS: [&str; 4] = ["name", "at", "turned", "axes"];
const BALL_FIELDS: [&str; 8] =
    ["name", "at", "turned", "armature", "stiffness", "rest", "damping", "friction"];

/// Where the fields of a degree of freedom stand, by what faults call them.
type DofPlaces = Vec<(&'static str, Range<usize>)>;

impl FigureReader<'_> {
    /// The joint of the link called `link`.
    pub(super) fn joint(&mut self, node: &Node<'_>, link: &str) -> Option<Joint> {
        let kind = self.kind(node, &["Joint", "Ball", "Free"])?;
        let known: &[&str] = if kind == "Joint" { &JOINT_FIELDS } else { &BALL_FIELDS };
        let fields = self.fields(node, &["Joint", "Ball", "Free"], known)?;
        let name_node = self.required(&fields, "name", "\"…\"");
        let name = name_node.and_then(|node| self.name(node, "the name of a joint"));
        let placement = self.placement(&fields);
        let named = name.unwrap_or_default();
        let mut places: Vec<DofPlaces> = Vec::new();
        let mut exact = Exact::new(link, &placement);
        let mut joint = match kind {
            "Ball" | "Free" => {
                let joint = if kind == "Ball" { Joint::ball(named) } else { Joint::free(named) };
                let joint = self.acting(&fields, joint, false);
                places.resize(joint.kind().nv(), dof_places(&fields));
                joint
            }
            _ => self.axes(&fields, Joint::new(named), &mut places, &mut exact),
        };
        joint = joint.placed(placement);
        let name_node = name_node.filter(|_| name.is_some())?;
        self.places.put_name(Part::Joint, named, name_node.span.clone());
        joint.normalize_axes();
        self.exact.extend(exact.filled());
        if !self.places.are_kept() {
            return Some(joint);
        }
        let axes = matches!(joint.kind(), JointKind::Axes(_));
        for (dof, places) in velocity_names(named, joint.kind()).iter().zip(places) {
            for (field, span) in places {
                match field {
                    "" if axes => self.places.put_name(Part::Dof, dof, span),
                    _ => self.places.put_field(Part::Dof, dof, field, span),
                }
            }
        }
        Some(joint)
    }

    /// The joint with the axes of the field `axes`; without one it is a weld.
    fn axes(
        &mut self,
        fields: &Fields<'_, '_>,
        mut joint: Joint,
        places: &mut Vec<DofPlaces>,
        exact: &mut Exact,
    ) -> Joint {
        let Some(node) = fields.get("axes") else { return joint };
        self.places.put_field(Part::Joint, joint.name(), "axes", node.span.clone());
        let Some(items) = self.items(node, "axes", "[rx, …]") else {
            self.lost.dofs = true;
            return joint;
        };
        for item in items {
            let Some((axis, fields)) = self.axis(item) else {
                self.lost.dofs = true;
                continue;
            };
            exact.axis(&axis);
            let turns = axis.kind == AxisKind::Rotation;
            joint = self.acting(&fields, joint.axis(axis), turns);
            let name = fields.get("name");
            if let Some(name) = name.and_then(|node| self.name(node, "the name of a degree of freedom")) {
                joint = joint.named(name);
            }
            if let Some(limits) = fields.get("limits")
                && let Some([lower, upper]) = self.limits(limits, turns)
            {
                joint = joint.limited(lower, upper);
            }
            if let Some(follows) = fields.get("follows")
                && let Some((leader, curve)) = self.follows(follows)
            {
                joint = joint.following(leader, curve);
            }
            if !self.places.are_kept() {
                continue;
            }
            let mut here = dof_places(&fields);
            here.push(("", name.map_or_else(|| item.place(), |node| node.span.clone())));
            places.push(here);
        }
        joint
    }

    /// `rx`, `rx(limits: …)`, `Turn(axis: (x, y, z), …)`
    fn axis<'n, 'a>(&mut self, node: &'n Node<'a>) -> Option<(Axis, Fields<'n, 'a>)> {
        let kind = self.kind(node, &AXES)?;
        let own = matches!(kind, "Turn" | "Slide");
        let fields = self.fields(node, &AXES, if own { &AXIS_FIELDS } else { &AXIS_FIELDS[1..] })?;
        let direction = if own {
            let axis = self.required(&fields, "axis", "(x, y, z)")?;
            self.direction(axis)?
        } else {
            Vector3::ith(usize::from(kind.as_bytes()[1] - b'x'), 1.0)
        };
        let slides = kind == "Slide" || kind.starts_with('t');
        Some((if slides { Axis::translation(direction) } else { Axis::rotation(direction) }, fields))
    }

    /// `(lower, upper)`
    pub(super) fn limits(&mut self, node: &Node<'_>, turns: bool) -> Option<[f64; 2]> {
        let Some([lower, upper]) = node.items() else {
            let message = format!("limits must be two numbers (lower, upper), not {}", node.describe());
            self.fault(node.place(), message);
            return None;
        };
        let lower = self.bound(lower, turns, "the lower limit");
        let upper = self.bound(upper, turns, "the upper limit");
        let (lower, upper) = (lower?, upper?);
        if lower > upper {
            self.fault(node.span.clone(), "the lower limit is above the upper one; exchange them");
            return None;
        }
        Some([lower, upper])
    }

    /// The joint with armature, spring, damper and friction on the last axis, or on all of a ball or free joint.
    fn acting(&mut self, fields: &Fields<'_, '_>, mut joint: Joint, turns: bool) -> Joint {
        if let Some(armature) = fields.get("armature").and_then(|node| self.number(node, "armature")) {
            joint = joint.armature(armature);
        }
        let mut number =
            |field| fields.get(field).and_then(|node| self.number(node, field)).unwrap_or_default();
        let (stiffness, damping, friction) = (number("stiffness"), number("damping"), number("friction"));
        let rest =
            fields.get("rest").and_then(|node| self.coordinate(node, turns, "rest")).unwrap_or_default();
        joint.passive(Passive { stiffness, rest, damping, friction })
    }

    /// `Follow(dof: "knee", along: Line(slope: 1, offset: 0))`
    fn follows<'n>(&mut self, node: &'n Node<'_>) -> Option<(&'n str, Curve)> {
        let fields = self.fields(node, &["Follow"], &["dof", "along"])?;
        let leader = self.required(&fields, "dof", "\"knee.rx\"");
        let curve = self.required(&fields, "along", "Line(slope: 1, offset: 0)");
        let leader = leader.and_then(|node| self.name(node, "the degree of freedom to follow"));
        let curve = curve.and_then(|node| self.curve(node));
        Some((leader?, curve?))
    }

    fn curve(&mut self, node: &Node<'_>) -> Option<Curve> {
        match self.kind(node, &["Line", "Polynomial", "Cubics", "Quintics", "Sine", "Chain"])? {
            "Line" => {
                let fields = self.fields(node, &["Line"], &["slope", "offset"])?;
                let slope = self.required(&fields, "slope", "1");
                let slope = slope.and_then(|node| self.number(node, "slope"));
                let offset = fields.get("offset").map_or(Some(0.0), |node| self.number(node, "offset"));
                Some(Curve::linear(slope?, offset?))
            }
            "Polynomial" => match node.group().map(|group| &group.content) {
                Some(Content::Tuple(items)) if items.len() == 1 => {
                    self.list(&items[0], "the polynomial").map(Curve::Polynomial)
                }
                _ => {
                    self.fault(node.span.clone(), "Polynomial([c0, c1, …]) takes one list of numbers");
                    None
                }
            },
            "Cubics" => {
                let (knots, pieces) = self.in_pieces(node, "Cubics", ["c0", "c1", "c2", "c3"])?;
                Some(Curve::Cubics { knots, pieces })
            }
            "Quintics" => {
                let (knots, pieces) =
                    self.in_pieces(node, "Quintics", ["c0", "c1", "c2", "c3", "c4", "c5"])?;
                Some(Curve::Quintics { knots, pieces })
            }
            "Sine" => {
                let fields = self.fields(node, &["Sine"], &["amplitude", "frequency", "phase", "offset"])?;
                let amplitude = self.required(&fields, "amplitude", "1");
                let frequency = self.required(&fields, "frequency", "1");
                let amplitude = amplitude.and_then(|node| self.number(node, "amplitude"));
                let frequency = frequency.and_then(|node| self.number(node, "frequency"));
                let mut other = |name| fields.get(name).map_or(Some(0.0), |node| self.number(node, name));
                let (phase, offset) = (other("phase"), other("offset"));
                Some(Curve::Sine {
                    amplitude: amplitude?,
                    frequency: frequency?,
                    phase: phase?,
                    offset: offset?,
                })
            }
            _ => match node.group().map(|group| &group.content) {
                Some(Content::Tuple(items)) if items.len() == 1 => self.chain(&items[0]),
                _ => {
                    self.fault(node.span.clone(), "Chain([CURVE, …]) takes one list of curves");
                    None
                }
            },
        }
    }

    /// Curves one after the other, none of which is a chain.
    fn chain(&mut self, node: &Node<'_>) -> Option<Curve> {
        let items = self.items(node, "the chain", "[CURVE, …]")?;
        let mut curves = Vec::new();
        for item in items {
            if item
                .group()
                .is_some_and(|group| group.name.as_ref().is_some_and(|named| named.name == "Chain"))
            {
                self.fault(item.span.clone(), "a chain stands in a chain; write one");
                return None;
            }
            curves.push(self.curve(item));
        }
        curves.into_iter().collect::<Option<_>>().map(Curve::Chain)
    }

    fn in_pieces<const N: usize>(
        &mut self,
        node: &Node<'_>,
        kind: &'static str,
        parts: [&str; N],
    ) -> Option<(Vec<f64>, Vec<[f64; N]>)> {
        let example = format!("[({}), …]", parts.join(", "));
        let fields = self.fields(node, &[kind], &["knots", "pieces"])?;
        let knots = self.required(&fields, "knots", "[…]");
        let pieces = self.required(&fields, "pieces", &example);
        let knots = knots.and_then(|node| self.list(node, "the knots"));
        let pieces = pieces.and_then(|node| self.items(node, "pieces", &example));
        let pieces: Option<Vec<_>> =
            pieces?.iter().map(|item| self.numbers(item, "a piece", parts)).collect();
        Some((knots?, pieces?))
    }
}

/// Where the fields of a degree of freedom stand.
fn dof_places(fields: &Fields<'_, '_>) -> DofPlaces {
    let called = [
        ("limits", "limits"),
        ("armature", "armature"),
        ("stiffness", "stiffness"),
        ("rest", "the spring's rest"),
        ("damping", "damping"),
        ("friction", "friction"),
    ];
    let mut places: DofPlaces = called
        .into_iter()
        .filter_map(|(field, called)| fields.get(field).map(|node| (called, node.span.clone())))
        .collect();
    let follows = fields.get("follows").and_then(|node| match &node.group()?.content {
        Content::Fields(found) => Some(found),
        _ => None,
    });
    for (named, node) in follows.into_iter().flatten() {
        match named.name {
            "dof" => places.push(("follows", node.span.clone())),
            "along" => places.push(("along", node.span.clone())),
            _ => {}
        }
    }
    places
}
