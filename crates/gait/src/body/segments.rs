//! The human body as the planner sees it: segments by role, their masses, the momentum of a posture.

use super::foot::{mirror, mirror_rotation};
use super::leg::LegGeometry;
#[cfg(feature = "cane")]
use super::roles::CANE;
use super::roles::{ARM, LEG, MIDDLE, SIDES};
use crate::error::BodyError;
use nalgebra::{Matrix3, Vector3};
use solaris_model::{AxisKind, Figure, RootOrder, Vector3 as V3};

/// Height of the person that the recipe's lengths were measured on (m).
pub(crate) const REFERENCE_HEIGHT: f64 = 1.741;
/// Length of that person's leg over the height, for figures that do not say their own.
const LEG_OVER_HEIGHT: f64 = 0.934 / REFERENCE_HEIGHT;

/// One segment's constants.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Segment {
    /// First entry of the joint's three rotations in `q`.
    pub(crate) q: usize,
    /// Joint centre in the parent's frame.
    pub(crate) offset: Vector3<f64>,
    pub(crate) mass: f64,
    pub(crate) com: Vector3<f64>,
    pub(crate) inertia: Matrix3<f64>,
}

impl Segment {
    /// The mirror image in the body's middle plane.
    pub(crate) fn mirrored(self) -> Self {
        Self {
            offset: mirror(&self.offset),
            com: mirror(&self.com),
            inertia: mirror_rotation(&self.inertia),
            ..self
        }
    }
}

/// A cane: a rod that hangs from a fist and turns in it to the side, then forward.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cane {
    /// The side of the hand that holds it.
    pub(crate) side: usize,
    /// Its first angle in `q`, the fist in the hand's frame, mass.
    pub(crate) segment: Segment,
    /// From the fist to its tip (m).
    pub(crate) length: f64,
    /// Without the feature there is none, and the compiler leaves out whatever is done with one.
    #[cfg(not(feature = "cane"))]
    _never: std::convert::Infallible,
}

impl Cane {
    /// That of a figure, if it has one; none without the feature.
    #[cfg(not(feature = "cane"))]
    #[allow(clippy::unnecessary_wraps, reason = "as with it")]
    pub(crate) fn of(_: &Figure) -> Result<Option<Self>, BodyError> {
        Ok(None)
    }

    /// That of a figure, if it has one.
    #[cfg(feature = "cane")]
    pub(crate) fn of(figure: &Figure) -> Result<Option<Self>, BodyError> {
        let Some(index) = figure.link_index(CANE) else { return Ok(None) };
        let link = &figure.links()[index];
        let parent = link.parent().map(|parent| figure.links()[parent].name());
        let side = match parent {
            Some("left_hand") => 0,
            Some("right_hand") => 1,
            other => {
                let parent = other.unwrap_or("the world").to_owned();
                return Err(BodyError::OtherParent { link: CANE.into(), parent, wanted: "a hand".into() });
            }
        };
        let (joint, wanted) = (link.joint(), [Vector3::z(), Vector3::x()]);
        let axes = joint.kind().axes();
        let turns = axes
            .iter()
            .map(|dof| (dof.axis.kind, dof.axis.direction))
            .eq(wanted.map(|axis| (AxisKind::Rotation, axis)));
        let tip = link.tip().filter(|tip| tip.y < 0.0 && tip.x.abs().max(tip.z.abs()) < 1e-9);
        let (Some(tip), true) = (tip, turns && joint.placement().rotation.angle() <= 0.0) else {
            return Err(BodyError::OtherCane { joint: joint.name().into() });
        };
        let segment = Segment {
            q: figure.layout().joints()[index].q,
            offset: joint.placement().translation.vector,
            mass: link.mass(),
            com: *link.com(),
            inertia: *link.inertia(),
        };
        Ok(Some(Self { side, segment, length: -tip.y }))
    }

    /// The mirror image, in the other hand.
    pub(crate) fn mirrored(self) -> Self {
        Self { side: 1 - self.side, segment: self.segment.mirrored(), ..self }
    }
}

/// The figure's segments by role.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    /// Of the figure, see [`Figure::fingerprint`].
    pub(crate) fingerprint: u64,
    pub(crate) mass: f64,
    pub(crate) height: f64,
    /// Number of the figure's coordinates.
    pub(crate) nq: usize,
    /// Of both legs the left one, or what is between two of unequal length.
    pub(crate) leg: LegGeometry,
    /// Each of them, the right one as its mirror image.
    pub(crate) sides: [LegGeometry; 2],
    /// First entry of the root's translations in `q`.
    pub(crate) root: usize,
    /// The order in which the root turns.
    pub(crate) root_order: RootOrder,
    pub(crate) middle: [Segment; 5],
    pub(crate) arms: [[Segment; 4]; 2],
    pub(crate) legs: [[Segment; 4]; 2],
    /// What a hand holds.
    pub(crate) cane: Option<Cane>,
}

impl Body {
    /// Of a figure that misses nothing ([`super::missing::check`]).
    pub(crate) fn of(figure: &Figure) -> Result<Self, BodyError> {
        let sides = LegGeometry::of_sides(figure)?;
        let leg = LegGeometry::between(&sides);
        let segment = |name: &str, parent: Option<&str>| segment(figure, name, parent);
        let middle_of = |i: usize| segment(MIDDLE[i], i.checked_sub(1).map(|p| MIDDLE[p]));
        let middle = [middle_of(0)?, middle_of(1)?, middle_of(2)?, middle_of(3)?, middle_of(4)?];
        let limb = |side: &str, names: [&str; 4], from: &str| -> Result<[Segment; 4], BodyError> {
            let sided = names.map(|name| format!("{side}{name}"));
            let of = |i: usize| segment(&sided[i], Some(if i == 0 { from } else { &sided[i - 1] }));
            Ok([of(0)?, of(1)?, of(2)?, of(3)?])
        };
        let root = middle[0].q - 3;
        Ok(Self {
            fingerprint: figure.fingerprint(),
            mass: figure.mass(),
            nq: figure.layout().nq(),
            height: figure.stature().unwrap_or(leg.length() / LEG_OVER_HEIGHT),
            leg,
            sides,
            root,
            root_order: root_order(figure),
            middle,
            arms: [limb(SIDES[0], ARM, "thorax")?, limb(SIDES[1], ARM, "thorax")?],
            legs: [limb(SIDES[0], LEG, "pelvis")?, limb(SIDES[1], LEG, "pelvis")?],
            cane: Cane::of(figure)?,
        })
    }

    /// Its mirror image: each limb has the masses of the other one, and moves the coordinates that it did.
    pub(crate) fn mirrored(&self) -> Self {
        let swapped = |[left, right]: &[[Segment; 4]; 2]| {
            let of = |own: &[Segment; 4], other: &[Segment; 4]| {
                std::array::from_fn(|i| Segment { q: own[i].q, ..other[i].mirrored() })
            };
            [of(left, right), of(right, left)]
        };
        let (arms, legs) = (swapped(&self.arms), swapped(&self.legs));
        let ([left, right], cane) = (self.sides, self.cane.map(Cane::mirrored));
        let middle = self.middle.map(Segment::mirrored);
        Self { middle, arms, legs, cane, sides: [right, left], ..self.clone() }
    }

    /// Refuses a body whose legs are not mirror images, for what plans one leg and mirrors it.
    pub(crate) fn with_legs_alike(self) -> Result<Self, BodyError> {
        LegGeometry::check_alike(&self.sides)?;
        Ok(self)
    }

    /// Factor of the recipe's lengths.
    pub(crate) fn scale(&self) -> f64 {
        self.height / REFERENCE_HEIGHT
    }
}

/// The order in which the root turns: by its heading first where its joint has those very axes.
pub(crate) fn root_order(figure: &Figure) -> RootOrder {
    let axes = figure.links()[0].joint().kind().axes();
    let wanted = root_axes(RootOrder::Yzx);
    let same = axes.iter().map(|dof| (dof.axis.kind, dof.axis.direction)).eq(wanted);
    if same { RootOrder::Yzx } else { RootOrder::Zyx }
}

fn root_axes(order: RootOrder) -> [(AxisKind, V3<f64>); 6] {
    let turns = match order {
        RootOrder::Yzx => [V3::y(), V3::z(), V3::x()],
        RootOrder::Zyx => [V3::z(), V3::y(), V3::x()],
    };
    let slides = [V3::x(), V3::y(), V3::z()];
    std::array::from_fn(|k| {
        if k < 3 { (AxisKind::Translation, slides[k]) } else { (AxisKind::Rotation, turns[k - 3]) }
    })
}

pub(crate) fn segment(figure: &Figure, name: &str, parent: Option<&str>) -> Result<Segment, BodyError> {
    let missing = || BodyError::MissingLinks { figure: figure.name().into(), links: vec![name.into()] };
    let index = figure.link_index(name).ok_or_else(missing)?;
    let link = &figure.links()[index];
    let found = link.parent().map(|parent| figure.links()[parent].name());
    if found != parent {
        let show = |parent: Option<&str>| parent.unwrap_or("the world").to_owned();
        return Err(BodyError::OtherParent { link: name.into(), parent: show(found), wanted: show(parent) });
    }
    let order = if parent.is_none() { root_order(figure) } else { RootOrder::Zyx };
    let wanted = &root_axes(order)[..];
    let wanted = if parent.is_none() { wanted } else { &wanted[3..] };
    let axes = link.joint().kind().axes();
    let same = axes.len() == wanted.len()
        && axes
            .iter()
            .zip(wanted)
            .all(|(dof, (kind, axis))| dof.axis.kind == *kind && dof.axis.direction == *axis);
    if !same || link.joint().placement().rotation.angle() > 0.0 {
        return Err(BodyError::OtherJoint { joint: link.joint().name().into() });
    }
    let layout = figure.layout().joints()[index];
    Ok(Segment {
        q: layout.q + layout.nq - 3,
        offset: link.joint().placement().translation.vector,
        mass: link.mass(),
        com: *link.com(),
        inertia: *link.inertia(),
    })
}
