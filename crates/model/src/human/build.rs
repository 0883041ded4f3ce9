//! The human built: from the table of segments to a figure.

use super::girth;
use super::segments::{
    ANGLES, BALL_HEIGHT, DAMPING, Drawn, HEEL_BEHIND, LIMITS, REFERENCE_HEIGHT, REFERENCE_MASS, SEGMENTS,
    Segment,
};
use super::{Joints, RootOrder};
use crate::builder::{FigureBuilder, LinkSpec};
use crate::fault::FigureError;
use crate::figure::Figure;
use crate::inertia::{Inertia, Shape, ShapeKind};
use crate::joint::{Joint, Passive};
use crate::link::SolePart;
use crate::scale::exact_total;
use nalgebra::{Isometry3, Matrix3, Translation3, UnitQuaternion, Vector3};

/// Where a hand holds a load, below its wrist (m of the table).
const FIST: f64 = 0.090;

/// A cane: how far the elbow of the hand that it stands in is bent where its length is fitted, as canes are (rad), its mass for
/// each metre (kg/m), and its radius (m).
const CANE_ELBOW: f64 = 30.0 * std::f64::consts::PI / 180.0;
const CANE_MASS: f64 = 0.4;
const CANE_RADIUS: f64 = 0.009;

/// Factor of the lengths of the table at this height.
pub(super) fn scale(height: f64) -> f64 {
    height / REFERENCE_HEIGHT
}

/// How far below a leg's segment's joint the next one's is (m of the table).
pub(super) fn below(segment: &str) -> f64 {
    SEGMENTS.iter().find(|next| next.parent == segment).map_or(0.0, |next| -next.offset[1])
}

/// What a human is built from.
pub(super) struct Body<'a> {
    /// Height (m).
    pub(super) height: f64,
    /// Mass (kg).
    pub(super) mass: f64,
    pub(super) joints: Joints,
    pub(super) root: RootOrder,
    /// A segment's share of the mass relative to the table, by its name without the side.
    pub(super) share: &'a dyn Fn(&str) -> f64,
    /// A segment's length relative to the table at this height, by its names with and without the side.
    pub(super) factor: &'a dyn Fn(&str, &str) -> f64,
    /// What the hand of a side, `left_` or `right_`, carries (kg).
    pub(super) load: &'a dyn Fn(&str) -> f64,
    /// The side, `left_` or `right_`, whose hand holds a cane.
    pub(super) cane: Option<&'static str>,
    /// Limits (rad) in place of the table's, by the name of a degree of freedom.
    pub(super) limits: &'a dyn Fn(&str) -> Option<[f64; 2]>,
}

/// The figure.
pub(super) fn figure(body: &Body<'_>) -> Result<Figure, FigureError> {
    let Body { height, mass, joints, share, .. } = *body;
    let scale = scale(height);
    let sides = ["", "left_", "right_"];
    let of = |prefix| Side { prefix, scale, body, damping: mass / REFERENCE_MASS * scale.powf(1.5) };
    let share = |segment: &Segment| segment.mass * share(segment.name);
    let total: f64 = SEGMENTS.iter().map(|s| if s.paired { 2.0 * share(s) } else { share(s) }).sum();
    let segments = || {
        let of_side = |prefix: &'static str| {
            SEGMENTS.iter().filter(move |s| s.paired != prefix.is_empty()).map(move |s| (of(prefix), s))
        };
        sides.into_iter().flat_map(of_side)
    };
    let mut masses: Vec<f64> = segments().map(|(_, segment)| mass * share(segment) / total).collect();
    // The heaviest segment, the abdomen, takes what rounding leaves.
    let is_exact = exact_total(&mut masses, mass);
    debug_assert!(is_exact, "{mass} kg over {} segments", masses.len());
    let mut builder = FigureBuilder::new("human").stature(height);
    for ((side, segment), mass) in segments().zip(masses) {
        builder = builder.link(side.link(segment, mass));
    }
    if let Some(prefix) = body.cane {
        builder = builder.link(of(prefix).cane());
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

/// Whether a human's degree of freedom of this name has limits.
pub(super) fn has_limits(figure: &Figure, dof: &str) -> bool {
    figure.links().iter().zip(figure.layout().joints()).any(|(link, at)| {
        let names = &figure.layout().v_names()[at.v..at.v + at.nv];
        let mut axes = link.joint().kind().axes().iter().zip(names);
        axes.any(|(axis, name)| name == dof && axis.limits.is_some())
    })
}

/// Whether a limp body has it turn by a quaternion.
fn is_quaternion(joint: &str) -> bool {
    matches!(joint, "root" | "shoulder")
}

/// Mass, centre of mass and inertia about it of a body with a point mass: with `d` from the common centre to each,
/// `I + Σ m (d² 1 − d dᵀ)`.
fn with_point(
    (mass, com, inertia): (f64, Vector3<f64>, Matrix3<f64>),
    load: f64,
    at: Vector3<f64>,
) -> (f64, Vector3<f64>, Matrix3<f64>) {
    if load == 0.0 {
        return (mass, com, inertia);
    }
    let all = mass + load;
    let centre = (com * mass + at * load) / all;
    let about = |mass: f64, at: Vector3<f64>| {
        let d = at - centre;
        (Matrix3::identity() * d.norm_squared() - d * d.transpose()) * mass
    };
    (all, centre, inertia + about(mass, com) + about(load, at))
}

/// One side of the body; the middle has no prefix.
struct Side<'a> {
    prefix: &'static str,
    /// Of the lengths of the table.
    scale: f64,
    body: &'a Body<'a>,
    /// Of a limp body's joints, relative to the table.
    damping: f64,
}

impl Side<'_> {
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

    /// What the lengths of the table are scaled by.
    fn length(&self, segment: &Segment) -> f64 {
        self.scale * (self.body.factor)(&self.name(segment), segment.name)
    }

    fn link(&self, segment: &Segment, mass: f64) -> LinkSpec {
        let parent = SEGMENTS.iter().find(|s| s.name == segment.parent);
        let name = self.name(segment);
        let own = self.length(segment);
        let joint = self.joint(segment, parent.map_or(self.scale, |parent| self.length(parent)));
        let moments = segment.gyration.map(|k| mass * (k * segment.length * own).powi(2));
        let mut link = match parent {
            Some(parent) => LinkSpec::child(name, self.name(parent), joint),
            None => LinkSpec::root(name, joint),
        };
        let load = if segment.name == "hand" { (self.body.load)(self.prefix) } else { 0.0 };
        let (com, inertia) = (self.vector(segment.com) * own, Matrix3::from_diagonal(&moments.into()));
        let (all, com, inertia) = with_point((mass, com, inertia), load, Vector3::y() * (-FIST * own));
        link =
            link.mass(all).com(com).inertia(Inertia::Tensor(inertia)).shape(self.shape(segment, own, mass));
        let toes_at = SEGMENTS[SEGMENTS.len() - 1].offset;
        match segment.name {
            "foot" => {
                let ankle = -(BALL_HEIGHT - toes_at[1]) * own;
                link.sole(SolePart::Heel, Vector3::new(0.0, ankle, -HEEL_BEHIND * own))
                    .sole(SolePart::Ball, Vector3::new(0.0, ankle, toes_at[2] * own))
            }
            "toes" => {
                // The toes stand on the foot's sole: their joint's height is the foot's.
                let down = -BALL_HEIGHT * self.length(&SEGMENTS[SEGMENTS.len() - 2]);
                let tip = Vector3::new(0.0, down, segment.length * own);
                link.sole(SolePart::Ball, Vector3::new(0.0, down, 0.0)).sole(SolePart::ToeTip, tip).tip(tip)
            }
            "hand" => link.tip(Vector3::new(0.0, -0.180 * own, 0.0)),
            "head" => link.tip(Vector3::new(0.0, segment.length * own, 0.0)),
            _ => link,
        }
    }

    /// The cane in its hand: a thin rod that hangs from the fist and turns in it to the side and forward. It is as long as the fist is high over
    /// the ground where somebody stands straight with the elbow bent by [`CANE_ELBOW`].
    fn cane(&self) -> LinkSpec {
        let segment = |name: &str| SEGMENTS.iter().find(|segment| segment.name == name);
        let sum = |names: &[(&str, f64)]| -> f64 {
            names.iter().filter_map(|(name, y)| Some(y * self.length(segment(name)?))).sum()
        };
        let offset = |name: &str| segment(name).map_or(0.0, |segment| segment.offset[1]);
        let sole = BALL_HEIGHT - offset("toes");
        let legs = sum(&[
            ("pelvis", -offset("thigh")),
            ("thigh", -offset("shank")),
            ("shank", -offset("foot")),
            ("foot", sole),
        ]);
        let trunk = sum(&[
            ("pelvis", offset("abdomen")),
            ("abdomen", offset("thorax")),
            ("thorax", offset("clavicle")),
            ("clavicle", offset("upper_arm")),
        ]);
        let upper_arm = sum(&[("upper_arm", -offset("forearm"))]);
        let below_elbow = sum(&[("forearm", -offset("hand")), ("hand", FIST)]);
        let length = legs + trunk - upper_arm - below_elbow * CANE_ELBOW.cos();
        let fist = Vector3::new(0.0, -sum(&[("hand", FIST)]), 0.0);
        let (mass, tip) = (CANE_MASS * length, Vector3::new(0.0, -length, 0.0));
        let (along, across) = (0.5 * CANE_RADIUS.powi(2), length.powi(2) / 12.0 + 0.25 * CANE_RADIUS.powi(2));
        LinkSpec::child("cane", format!("{}hand", self.prefix), Joint::new("cane").at(fist).rz().rx())
            .mass(mass)
            .com(tip * 0.5)
            .inertia(Inertia::Tensor(Matrix3::from_diagonal(&(Vector3::new(across, along, across) * mass))))
            .shape(Shape {
                kind: ShapeKind::Capsule { radius: CANE_RADIUS, length },
                placement: Isometry3::translation(0.0, -0.5 * length, 0.0),
            })
            .tip(tip)
    }

    /// The joint, at the table's offset times the parent's scale; limits mirrored on the right.
    fn joint(&self, segment: &Segment, parent_scale: f64) -> Joint {
        let name = if segment.paired {
            format!("{}{}", self.prefix, segment.joint)
        } else {
            segment.joint.to_owned()
        };
        let at = self.vector(segment.offset) * parent_scale;
        let is_limp = self.body.joints == Joints::Limp;
        let damper = DAMPING.iter().find(|(joint, _)| is_limp && *joint == segment.joint);
        let damping = damper.map_or(0.0, |(_, damping)| damping * self.damping);
        let acts = Passive { damping, ..Passive::default() };
        if is_limp && is_quaternion(segment.joint) {
            let is_root = segment.parent.is_empty();
            return if is_root { Joint::free(name) } else { Joint::ball(name) }.at(at).passive(acts);
        }
        let mut joint = Joint::new(name).at(at);
        let is_root = segment.parent.is_empty();
        if is_root {
            joint = joint.tx().ty().tz();
        }
        let order = match segment.joint {
            "elbow" if is_limp => ["rx", "rz", "ry"],
            _ if is_root && self.body.root == RootOrder::Yzx => ["ry", "rz", "rx"],
            _ => ["rz", "ry", "rx"],
        };
        for axis in order {
            joint = match axis {
                "rz" => joint.rz(),
                "ry" => joint.ry(),
                _ => joint.rx(),
            }
            .passive(acts);
            if let Some([lower, upper]) = (self.body.limits)(&format!("{}.{axis}", joint.name())) {
                joint = joint.limited(lower, upper);
            } else if let Some(&(.., lower, upper)) =
                LIMITS.iter().find(|(j, a, ..)| *j == segment.joint && *a == axis)
            {
                let mirrored = self.is_right() && axis != "rx";
                let (lower, upper) = if mirrored { (-upper, -lower) } else { (lower, upper) };
                joint = joint.limited(lower.to_radians(), upper.to_radians());
            }
        }
        joint
    }

    /// What is drawn: `own` scales the lengths, and `mass` says how thick it is (see [`super::girth`]).
    fn shape(&self, segment: &Segment, own: f64, mass: f64) -> Shape {
        let volume = mass / segment.density;
        let ellipsoid = |centre: [f64; 3], radii: Vector3<f64>| Shape {
            kind: ShapeKind::Ellipsoid { radii },
            placement: Isometry3::from_parts(
                Translation3::from(self.vector(centre) * own),
                UnitQuaternion::identity(),
            ),
        };
        match segment.drawn {
            Drawn::Bony { centre, radii } => ellipsoid(centre, Vector3::from(radii) * own),
            Drawn::Trunk { centre, radii } => {
                ellipsoid(centre, girth::ellipsoid(Vector3::from(radii) * own, volume))
            }
            Drawn::Limb { from, to } => {
                let (from, to) = (self.vector(from) * own, self.vector(to) * own);
                let (along, middle) = (to - from, (from + to) / 2.0);
                let turn = UnitQuaternion::rotation_between(&Vector3::y(), &along);
                // Straight down is the only direction without a unique turn from "up".
                let turn = turn.unwrap_or_else(|| {
                    UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI)
                });
                let length = along.norm();
                Shape {
                    kind: ShapeKind::Capsule { radius: girth::capsule(length, volume), length },
                    placement: Isometry3::from_parts(Translation3::from(middle), turn),
                }
            }
        }
    }
}
