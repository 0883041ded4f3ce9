//! From the table of segments to a figure.

use super::Joints;
use super::segments::{
    ANGLES, BALL_HEIGHT, DAMPING, Drawn, HEEL_BEHIND, LIMITS, REFERENCE_HEIGHT, REFERENCE_MASS, SEGMENTS,
    Segment,
};
use crate::builder::{FigureBuilder, LinkSpec};
use crate::fault::FigureError;
use crate::figure::Figure;
use crate::inertia::{Inertia, Shape, ShapeKind};
use crate::joint::{Joint, Passive};
use crate::link::SolePart;
use crate::scale::exact_total;
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};

/// Factor of the lengths of the table at this height.
pub(super) fn scale(height: f64) -> f64 {
    height / REFERENCE_HEIGHT
}

/// The figure; `factor` gives a segment's own length factor by its sided name.
pub(super) fn figure(
    height: f64,
    mass: f64,
    joints: Joints,
    factor: impl Fn(&str) -> f64,
) -> Result<Figure, FigureError> {
    let scale = scale(height);
    let sides = ["", "left_", "right_"];
    let of = |prefix| Side { prefix, joints, damping: mass / REFERENCE_MASS * scale.powf(1.5) };
    let total: f64 = SEGMENTS.iter().map(|s| if s.paired { 2.0 * s.mass } else { s.mass }).sum();
    let segments = || {
        let of_side = |prefix: &'static str| {
            SEGMENTS.iter().filter(move |s| s.paired != prefix.is_empty()).map(move |s| (of(prefix), s))
        };
        sides.into_iter().flat_map(of_side)
    };
    let mut masses: Vec<f64> = segments().map(|(_, segment)| mass * segment.mass / total).collect();
    // The heaviest segment, the abdomen, takes what rounding leaves.
    let is_exact = exact_total(&mut masses, mass);
    debug_assert!(is_exact, "{mass} kg over {} segments", masses.len());
    let mut builder = FigureBuilder::new("human").stature(height);
    for ((side, segment), mass) in segments().zip(masses) {
        builder = builder.link(side.link(segment, scale, mass, &factor));
    }
    let is_coordinate = |joint: &str| joints == Joints::Angles || !is_quaternion(joint);
    for &(name, joint, axis, left, right) in ANGLES.iter().filter(|(_, joint, ..)| is_coordinate(joint)) {
        let paired = SEGMENTS.iter().any(|s| s.joint == joint && s.paired);
        let sides: &[(&str, f64)] =
            if paired { &[("left_", left), ("right_", right)] } else { &[("", left)] };
        for (side, sign) in sides {
            builder = builder.angle(format!("{side}{name}"), format!("{side}{joint}.{axis}"), *sign < 0.0);
        }
    }
    builder.build()
}

/// Whether a limp body has it turn by a quaternion.
fn is_quaternion(joint: &str) -> bool {
    matches!(joint, "root" | "shoulder")
}

/// One side of the body; the middle has no prefix.
struct Side {
    prefix: &'static str,
    joints: Joints,
    /// Of a limp body's joints, relative to the table.
    damping: f64,
}

impl Side {
    fn name(&self, segment: &Segment) -> String {
        if segment.paired { format!("{}{}", self.prefix, segment.name) } else { segment.name.to_owned() }
    }

    fn is_right(&self) -> bool {
        self.prefix == "right_"
    }

    /// A vector of the table, mirrored on the right.
    fn vector(&self, v: [f64; 3]) -> Vector3<f64> {
        Vector3::new(if self.is_right() { -v[0] } else { v[0] }, v[1], v[2])
    }

    fn link(&self, segment: &Segment, scale: f64, mass: f64, factor: &impl Fn(&str) -> f64) -> LinkSpec {
        let parent = SEGMENTS.iter().find(|s| s.name == segment.parent);
        let name = self.name(segment);
        let own = scale * factor(&name);
        let joint = self.joint(segment, parent.map_or(scale, |parent| scale * factor(&self.name(parent))));
        let moments = segment.gyration.map(|k| mass * (k * segment.length * own).powi(2));
        let mut link = match parent {
            Some(parent) => LinkSpec::child(name, self.name(parent), joint),
            None => LinkSpec::root(name, joint),
        };
        link = link
            .mass(mass)
            .com(self.vector(segment.com) * own)
            .inertia(Inertia::diagonal(moments[0], moments[1], moments[2]))
            .shape(self.shape(&segment.drawn, own));
        let toes_at = SEGMENTS[SEGMENTS.len() - 1].offset;
        match segment.name {
            "foot" => {
                let ankle = -(BALL_HEIGHT - toes_at[1]) * own;
                link.sole(SolePart::Heel, Vector3::new(0.0, ankle, -HEEL_BEHIND * own))
                    .sole(SolePart::Ball, Vector3::new(0.0, ankle, toes_at[2] * own))
            }
            "toes" => {
                // The toes stand on the foot's sole: their joint's height is the foot's.
                let down = -BALL_HEIGHT * scale * factor(&self.name(&SEGMENTS[SEGMENTS.len() - 2]));
                let tip = Vector3::new(0.0, down, segment.length * own);
                link.sole(SolePart::Ball, Vector3::new(0.0, down, 0.0)).sole(SolePart::ToeTip, tip).tip(tip)
            }
            "hand" => link.tip(Vector3::new(0.0, -0.180 * own, 0.0)),
            "head" => link.tip(Vector3::new(0.0, segment.length * own, 0.0)),
            _ => link,
        }
    }

    /// The joint, at the table's offset times the parent's scale; limits mirrored on the right.
    fn joint(&self, segment: &Segment, parent_scale: f64) -> Joint {
        let name = if segment.paired {
            format!("{}{}", self.prefix, segment.joint)
        } else {
            segment.joint.to_owned()
        };
        let at = self.vector(segment.offset) * parent_scale;
        let is_limp = self.joints == Joints::Limp;
        let damper = DAMPING.iter().find(|(joint, _)| is_limp && *joint == segment.joint);
        let damping = damper.map_or(0.0, |(_, damping)| damping * self.damping);
        let acts = Passive { damping, ..Passive::default() };
        if is_limp && is_quaternion(segment.joint) {
            let is_root = segment.parent.is_empty();
            return if is_root { Joint::free(name) } else { Joint::ball(name) }.at(at).passive(acts);
        }
        let mut joint = Joint::new(name).at(at);
        if segment.parent.is_empty() {
            joint = joint.tx().ty().tz();
        }
        let order = if is_limp && segment.joint == "elbow" { ["rx", "rz", "ry"] } else { ["rz", "ry", "rx"] };
        for axis in order {
            joint = match axis {
                "rz" => joint.rz(),
                "ry" => joint.ry(),
                _ => joint.rx(),
            }
            .passive(acts);
            if let Some(&(.., lower, upper)) =
                LIMITS.iter().find(|(j, a, ..)| *j == segment.joint && *a == axis)
            {
                let mirrored = self.is_right() && axis != "rx";
                let (lower, upper) = if mirrored { (-upper, -lower) } else { (lower, upper) };
                joint = joint.limited(lower.to_radians(), upper.to_radians());
            }
        }
        joint
    }

    fn shape(&self, drawn: &Drawn, scale: f64) -> Shape {
        match *drawn {
            Drawn::Body { centre, radii } => Shape {
                kind: ShapeKind::Ellipsoid { radii: Vector3::from(radii) * scale },
                placement: Isometry3::from_parts(
                    Translation3::from(self.vector(centre) * scale),
                    UnitQuaternion::identity(),
                ),
            },
            Drawn::Limb { to, radius } => {
                let to = self.vector(to) * scale;
                let turn = UnitQuaternion::rotation_between(&Vector3::y(), &to);
                // Straight down is the only direction without a unique turn from "up".
                let turn = turn.unwrap_or_else(|| {
                    UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI)
                });
                Shape {
                    kind: ShapeKind::Capsule { radius: radius * scale, length: to.norm() },
                    placement: Isometry3::from_parts(Translation3::from(to / 2.0), turn),
                }
            }
        }
    }
}
