//! What the links look like.

use glam::{DQuat, DVec3};
use nalgebra::UnitQuaternion;
use serde::Serialize;
use solaris_model::{Figure, Link, Shape, ShapeKind};

/// The side of the body that something belongs to, told from its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Side {
    /// `left_…`, `…_left`, `l_…`, `…_l`.
    Left,
    /// `right_…`, `…_right`, `r_…`, `…_r`.
    Right,
    /// Anything else.
    Middle,
}

impl Side {
    /// The side, and the name without it: `left_knee.flexion` → left, `knee.flexion`.
    pub(crate) fn split(name: &str) -> (Self, String) {
        let (head, tail) = name.split_once('.').map_or((name, None), |(head, tail)| (head, Some(tail)));
        for (side, words) in [(Self::Left, ["left", "l"]), (Self::Right, ["right", "r"])] {
            for word in words {
                let before = head.strip_prefix(word).and_then(|rest| rest.strip_prefix('_'));
                let rest = before.or_else(|| head.strip_suffix(word).and_then(|rest| rest.strip_suffix('_')));
                if let Some(rest) = rest.filter(|rest| !rest.is_empty()) {
                    return (side, tail.map_or(rest.to_owned(), |tail| format!("{rest}.{tail}")));
                }
            }
        }
        (Self::Middle, name.to_owned())
    }
}

/// A solid in its link's frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Part {
    kind: &'static str,
    /// Box: edges; cylinder: radius, length; ellipsoid: semi-axes; capsule: radius at −y, radius at +y, distance of the
    /// centres; sphere: radius (m).
    size: Vec<f64>,
    at: [f64; 3],
    turn: [f64; 4],
}

/// A link as it is drawn.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Drawn {
    name: String,
    side: Side,
    parts: Vec<Part>,
}

impl Drawn {
    /// Whether it belongs to the left or the right.
    pub(crate) fn is_sided(&self) -> bool {
        self.side != Side::Middle
    }
}

/// Radius of a stick, as a share of its length, and its bounds (m).
const STICK: (f64, f64, f64) = (0.04, 0.004, 0.03);
/// Radius of a link that is but a point (m).
const POINT: f64 = 0.03;

/// All links, in order.
pub(crate) fn links(figure: &Figure) -> Vec<Drawn> {
    let draw = |link: usize| {
        let name = figure.links()[link].name().to_owned();
        let (side, _) = Side::split(&name);
        Drawn { side, parts: parts(figure, link), name }
    };
    (0..figure.links().len()).map(draw).collect()
}

/// The link's own shape, or sticks from its joint to those of its children and to its tip.
fn parts(figure: &Figure, link: usize) -> Vec<Part> {
    if let Some(shape) = figure.links()[link].shape() {
        return vec![shaped(shape, next_radius(figure, link))];
    }
    let children = figure.links().iter().filter(|child| child.parent() == Some(link));
    let ends = children
        .map(|child| child.joint().placement().translation.vector)
        .chain(figure.links()[link].tip().copied());
    let sticks: Vec<Part> = ends.map(|end| DVec3::new(end.x, end.y, end.z)).filter_map(stick).collect();
    if sticks.is_empty() {
        let com = figure.links()[link].com();
        return vec![Part {
            kind: "sphere",
            size: vec![POINT],
            at: [com.x, com.y, com.z],
            turn: [0.0, 0.0, 0.0, 1.0],
        }];
    }
    sticks
}

/// Radius of the one capsule that continues this one, if there is one.
fn next_radius(figure: &Figure, link: usize) -> Option<f64> {
    let mut children = figure.links().iter().filter(|child| child.parent() == Some(link));
    match (children.next()?.shape()?.kind, children.next()) {
        (ShapeKind::Capsule { radius, .. }, None) => Some(radius),
        _ => None,
    }
}

/// Limbs taper: where a capsule continues a thicker one, they meet half way between their radii.
fn shaped(shape: &Shape, next: Option<f64>) -> Part {
    let (kind, size) = match shape.kind {
        ShapeKind::Box { size } => ("box", vec![size.x, size.y, size.z]),
        ShapeKind::Cylinder { radius, length } => ("cylinder", vec![radius, length]),
        ShapeKind::Ellipsoid { radii } => ("ellipsoid", vec![radii.x, radii.y, radii.z]),
        ShapeKind::Capsule { radius, length } => {
            let far = next.filter(|next| *next < radius).map_or(radius, |next| f64::midpoint(radius, next));
            ("capsule", vec![radius, far, length])
        }
        ShapeKind::Sphere { radius } => ("sphere", vec![radius]),
    };
    let (at, turn) = (shape.placement.translation.vector, shape.placement.rotation.coords);
    Part { kind, size, at: at.into(), turn: turn.into() }
}

/// A skin between two ellipsoids that follow each other, such as those of the trunk.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Skin {
    parent: usize,
    child: usize,
    /// The child's joint in the parent's frame (m).
    offset: [f64; 3],
}

/// The skins: wherever an ellipsoid's joint hangs, unturned, on another ellipsoid.
pub(crate) fn skins(figure: &Figure) -> Vec<Skin> {
    let links = figure.links();
    let unturned = |rotation: &UnitQuaternion<f64>| rotation.angle() < 1e-9;
    let smooth = |link: &Link| {
        let shape = link.shape().filter(|shape| matches!(shape.kind, ShapeKind::Ellipsoid { .. }));
        shape.is_some_and(|shape| unturned(&shape.placement.rotation))
    };
    let skin = |(child, link): (usize, &Link)| {
        let parent = link.parent()?;
        let placement = link.joint().placement();
        let joined = smooth(link) && smooth(&links[parent]) && unturned(&placement.rotation);
        joined.then(|| Skin { parent, child, offset: placement.translation.vector.into() })
    };
    links.iter().enumerate().filter_map(skin).collect()
}

/// A thin capsule from the origin to `end`; `None` where they coincide.
fn stick(end: DVec3) -> Option<Part> {
    let length = end.length();
    let direction = end.try_normalize()?;
    let radius = (STICK.0 * length).clamp(STICK.1, STICK.2);
    let turn = DQuat::from_rotation_arc(DVec3::Y, direction);
    Some(Part {
        kind: "capsule",
        size: vec![radius, radius, length],
        at: (end / 2.0).into(),
        turn: turn.into(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3, human};

    #[test]
    fn sides_are_told_from_names() {
        let split = |name| Side::split(name);
        assert_eq!(split("left_knee.flexion"), (Side::Left, "knee.flexion".into()));
        assert_eq!(split("hip_r"), (Side::Right, "hip".into()));
        assert_eq!(split("lumbar.bend"), (Side::Middle, "lumbar.bend".into()));
        assert_eq!(split("lever"), (Side::Middle, "lever".into()));
        assert_eq!(split("left"), (Side::Middle, "left".into()));
    }

    #[test]
    fn a_link_without_a_shape_becomes_sticks() {
        let figure = FigureBuilder::new("f")
            .link(LinkSpec::root("a", Joint::new("j").rx()).mass(1.0))
            .link(LinkSpec::child("b", "a", Joint::new("k").at(Vector3::new(0.0, -2.0, 0.0)).rx()).mass(1.0))
            .build()
            .expect("valid");
        let drawn = links(&figure);
        assert_eq!((drawn[0].parts[0].kind, drawn[1].parts[0].kind), ("capsule", "sphere"));
        assert_eq!(format!("{:?}", drawn[0].parts[0].size), "[0.03, 0.03, 2.0]");
        assert_eq!(format!("{:?}", drawn[0].parts[0].at), "[0.0, -1.0, 0.0]");
        let end = DQuat::from_array(drawn[0].parts[0].turn) * DVec3::Y;
        assert!(end.distance(-DVec3::Y) < 1e-12, "{end}");
    }

    #[test]
    fn the_trunk_and_the_feet_have_skins() {
        let figure = human(1.75, 73.0).expect("a person");
        let names: Vec<&str> = skins(&figure).iter().map(|skin| figure.links()[skin.child].name()).collect();
        assert_eq!(names, ["abdomen", "thorax", "left_toes", "right_toes"]);
    }

    #[test]
    fn limbs_taper_towards_thinner_ones() {
        let figure = human(1.741, 73.0).expect("a person");
        let thigh = links(&figure).into_iter().find(|link| link.name == "left_thigh").expect("a thigh");
        assert_eq!(thigh.side, Side::Left);
        assert!(
            (thigh.parts[0].size[0] - 0.071).abs() < 1e-12 && (thigh.parts[0].size[1] - 0.059).abs() < 1e-12
        );
    }
}
