//! Drawn shapes of links.

use crate::LinkLine;
use crate::camera::Bounds;
use crate::error::ViewError;
use glam::{DMat3, DQuat, DVec3};
use nalgebra::Vector3;
use serde::Serialize;
use solaris_model::{Figure, Link, Shape, ShapeKind};

/// The side of the body that something belongs to, told from its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Side {
    /// `left_…`, `…_left`, `l_…`, `…_l`, `left.…`.
    Left,
    /// `right_…`, `…_right`, `r_…`, `…_r`, `right.…`.
    Right,
    /// Anything else.
    Middle,
}

impl Side {
    /// The side, and the name without it: `left_knee.flexion` → left, `knee.flexion`.
    pub(crate) fn split(name: &str) -> (Self, String) {
        let (head, tail) = name.split_once('.').map_or((name, None), |(head, tail)| (head, Some(tail)));
        for (side, words) in [(Self::Left, ["left", "l"]), (Self::Right, ["right", "r"])] {
            // A part of something that is called by its side alone: `left.fx`.
            if let Some(tail) = tail.filter(|_| head == words[0]) {
                return (side, tail.to_owned());
            }
            for word in words {
                let before = head.strip_prefix(word).and_then(|rest| rest.strip_prefix('_'));
                let rest = before.or_else(|| head.strip_suffix(word).and_then(|rest| rest.strip_suffix('_')));
                if let Some(rest) = rest.filter(|rest| !rest.is_empty()) {
                    return (side, tail.map_or(rest.to_owned(), |tail| format!("{rest}.{tail}")));
                }
            }
        }
        // Of one figure among several: `ann.left_knee.rx`.
        match tail.map(Self::split) {
            Some((side, rest)) if side != Self::Middle => (side, format!("{head}.{rest}")),
            _ => (Self::Middle, name.to_owned()),
        }
    }
}

/// A solid in its link's frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Part {
    pub(crate) kind: &'static str,
    /// Box: edges; cylinder: radius, length; ellipsoid: semi-axes; capsule: radius at −y, radius at +y, distance of the
    /// centres; sphere: radius (m).
    pub(crate) size: Vec<f64>,
    pub(crate) at: [f64; 3],
    pub(crate) turn: [f64; 4],
}

impl Part {
    /// The smallest box around it (m) when its link stands at `place`, turned by `turn`.
    pub(crate) fn bounds(&self, place: DVec3, turn: DQuat) -> Bounds {
        let centre = place + turn * DVec3::from_array(self.at);
        let axes = DMat3::from_quat(turn * DQuat::from_array(self.turn));
        // How far each of the shape's own axes reaches along the world's.
        let [x, y, z] = [axes.x_axis, axes.y_axis, axes.z_axis].map(DVec3::abs);
        match (self.kind, self.size.as_slice()) {
            ("box", &[a, b, c]) => Bounds::around(centre, (x * a + y * b + z * c) / 2.0),
            ("ellipsoid", &[a, b, c]) => {
                let (x, y, z) = (x * a, y * b, z * c);
                Bounds::around(centre, (x * x + y * y + z * z).map(f64::sqrt))
            }
            ("cylinder", &[radius, length]) => {
                let rim = (DVec3::ONE - y * y).max(DVec3::ZERO).map(f64::sqrt) * radius;
                Bounds::around(centre, y * (length / 2.0) + rim)
            }
            ("capsule", &[near, far, length]) => {
                let end = axes.y_axis * (length / 2.0);
                let ball = |at, radius| Bounds::around(at, DVec3::splat(radius));
                ball(centre - end, near).union(ball(centre + end, far))
            }
            (_, size) => Bounds::around(centre, DVec3::splat(size.iter().copied().fold(0.0, f64::max))),
        }
    }
}

/// A link as it is drawn.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Drawn {
    name: String,
    pub(crate) side: Side,
    pub(crate) parts: Vec<Part>,
}

impl Drawn {
    /// The smallest box around its parts (m) when it stands at `place`, turned by `turn`; none without parts.
    pub(crate) fn bounds(&self, place: DVec3, turn: DQuat) -> Option<Bounds> {
        self.parts.iter().map(|part| part.bounds(place, turn)).reduce(Bounds::union)
    }

    /// Whether it belongs to the left or the right.
    pub(crate) fn is_sided(&self) -> bool {
        self.side != Side::Middle
    }
}

/// Radius of a stick, as a share of its length.
const STICK: f64 = 0.04;
/// Bounds of the radius of a stick, as shares of the figure's reach.
const STICK_BOUNDS: (f64, f64) = (0.004, 0.03);
/// Radius of a link that is but a point, as a share of the figure's reach.
const POINT: f64 = 0.03;

/// All links, in order.
pub(crate) fn links(figure: &Figure) -> Vec<Drawn> {
    let reach = reach(figure);
    let draw = |link: usize| {
        let name = figure.links()[link].name().to_owned();
        let (side, _) = Side::split(&name);
        let parts = parts(figure, link, reach);
        Drawn { name, side, parts }
    };
    (0..figure.links().len()).map(draw).collect()
}

/// Adds lines to the links that they go with, but for links with a shape of their own, which would hide them.
pub(crate) fn add_lines(links: &mut [Drawn], figure: &Figure, lines: &[LinkLine]) -> Result<(), ViewError> {
    let reach = reach(figure);
    let is_end = |link: usize| {
        let mut children = figure.links().iter().filter(|child| child.parent() == Some(link));
        figure.links()[link].tip().is_none() && children.next().is_none()
    };
    // Better than a ball where its mass is.
    for line in lines.iter().filter(|line| line.link < figure.links().len()) {
        if figure.links()[line.link].shape().is_none() && is_end(line.link) {
            links[line.link].parts.clear();
        }
    }
    for line in lines {
        let Some(link) = figure.links().get(line.link) else {
            let (link, links) = (line.link, links.len());
            return Err(ViewError::LineLink { link, figure: figure.name().to_owned(), links });
        };
        if link.shape().is_some() {
            continue;
        }
        let [from, to] = line.ends;
        if let Some(mut part) = stick(&(to - from), reach) {
            part.at = (DVec3::from_array(part.at) + DVec3::new(from.x, from.y, from.z)).into();
            links[line.link].parts.push(part);
        }
    }
    Ok(())
}

/// Whether a link among others is nothing but the place that they are fixed at, such as `world` of many robots, or a place in that.
fn is_place(figure: &Figure, link: &Link) -> bool {
    let still = link.joint().kind().nv() == 0;
    let fixed = link.parent().is_none_or(|parent| is_place(figure, &figure.links()[parent]));
    figure.links().len() > 1 && still && link.mass() == 0.0 && fixed
}

/// How far the figure can reach from its root (m), all joints stretched; 1 where it is but a point.
fn reach(figure: &Figure) -> f64 {
    let links = figure.links();
    let mut starts: Vec<f64> = Vec::with_capacity(links.len());
    let mut farthest = 0.0_f64;
    for link in links {
        let offset = link.parent().map_or(0.0, |_| link.joint().placement().translation.vector.norm());
        let start = link.parent().map_or(0.0, |parent| starts[parent]) + offset;
        let ends = [
            Some(*link.com()),
            link.tip().copied(),
            link.shape().map(|shape| shape.placement.translation.vector),
        ];
        farthest =
            ends.into_iter().flatten().map(|end| start + end.norm()).fold(farthest.max(start), f64::max);
        starts.push(start);
    }
    if farthest > 0.0 { farthest } else { 1.0 }
}

/// The link's own shape, or sticks from its joint to those of its children and to its tip, or to where its mass is.
fn parts(figure: &Figure, link: usize, reach: f64) -> Vec<Part> {
    if let Some(shape) = figure.links()[link].shape() {
        return vec![shaped(shape, next_radius(figure, link))];
    }
    let children = figure.links().iter().filter(|child| child.parent() == Some(link));
    let ends: Vec<_> = children
        .map(|child| child.joint().placement().translation.vector)
        .chain(figure.links()[link].tip().copied())
        .collect();
    let is_place = is_place(figure, &figure.links()[link]);
    if is_place && ends.len() > 1 {
        // What stands at different places of the world is several figures.
        return Vec::new();
    }
    let sticks: Vec<Part> = ends.iter().filter_map(|end| stick(end, reach)).collect();
    if sticks.is_empty() && !is_place {
        let com = figure.links()[link].com();
        let ball = Part {
            kind: "sphere",
            size: vec![POINT * reach],
            at: (*com).into(),
            turn: DQuat::IDENTITY.to_array(),
        };
        return [ball].into_iter().chain(stick(com, reach)).collect();
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

/// A thin capsule from the origin to `end`; `None` where they coincide.
fn stick(end: &Vector3<f64>, reach: f64) -> Option<Part> {
    let end = DVec3::new(end.x, end.y, end.z);
    let length = end.length();
    let direction = end.try_normalize()?;
    let radius = (STICK * length).clamp(STICK_BOUNDS.0 * reach, STICK_BOUNDS.1 * reach);
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
        assert_eq!(split("left.fx"), (Side::Left, "fx".into()));
        assert_eq!(split("ann.left_knee.rx"), (Side::Left, "ann.knee.rx".into()));
        assert_eq!(split("left.right_knee"), (Side::Left, "right_knee".into()));
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
        assert_eq!(format!("{:?}", drawn[0].parts[0].size), "[0.06, 0.06, 2.0]");
        assert_eq!(format!("{:?}", drawn[0].parts[0].at), "[0.0, -1.0, 0.0]");
        let end = DQuat::from_array(drawn[0].parts[0].turn) * DVec3::Y;
        assert!(end.distance(-DVec3::Y) < 1e-12, "{end}");
    }

    #[test]
    fn a_mass_on_a_hinge_hangs_on_a_stick_and_a_place_is_not_drawn() {
        let bob = Vector3::new(0.0, -0.02, 0.0);
        let figure = FigureBuilder::new("f")
            .link(LinkSpec::root("world", Joint::new("place")))
            .link(LinkSpec::child("bob", "world", Joint::new("pivot").rx()).mass(1.0).com(bob))
            .build()
            .expect("valid");
        let drawn = links(&figure);
        let kinds: Vec<&str> = drawn[1].parts.iter().map(|part| part.kind).collect();
        assert!(drawn[0].parts.is_empty(), "{:?}", drawn[0]);
        assert_eq!(kinds, ["sphere", "capsule"]);
        assert_eq!(format!("{:?}", drawn[1].parts[0].size), "[0.0006]", "as thick as suits 2 cm");
    }

    #[test]
    fn boxes_are_those_of_the_shapes_surfaces() {
        let part = |kind, size: &[f64]| Part {
            kind,
            size: size.to_vec(),
            at: [0.0; 3],
            turn: DQuat::IDENTITY.to_array(),
        };
        let tilted = DQuat::from_rotation_z(std::f64::consts::FRAC_PI_6);
        let (sin, cos) = std::f64::consts::FRAC_PI_6.sin_cos();
        let near = |kind, size: &[f64], edges: DVec3| {
            let bounds = part(kind, size).bounds(DVec3::ONE, tilted);
            assert!(bounds.edges().distance(edges) < 1e-12, "{kind}: {:?}", bounds.edges());
            assert!(bounds.low.midpoint(bounds.high).distance(DVec3::ONE) < 1e-12, "{kind}");
        };
        near("sphere", &[0.5], DVec3::ONE);
        near("box", &[2.0, 1.0, 3.0], DVec3::new(2.0 * cos + sin, 2.0 * sin + cos, 3.0));
        near("capsule", &[0.5, 0.5, 2.0], DVec3::new(2.0 * sin + 1.0, 2.0 * cos + 1.0, 1.0));
        near("cylinder", &[0.5, 2.0], DVec3::new(2.0 * sin + cos, 2.0 * cos + sin, 1.0));
        let reach = |a: f64, b: f64| 2.0 * (a * cos).hypot(b * sin);
        near("ellipsoid", &[2.0, 1.0, 3.0], DVec3::new(reach(2.0, 1.0), reach(1.0, 2.0), 6.0));
    }

    #[test]
    fn limbs_taper_towards_thinner_ones() {
        let figure = human(1.741, 73.0).expect("a person");
        let thigh = links(&figure).into_iter().find(|link| link.name == "left_thigh").expect("a thigh");
        assert_eq!(thigh.side, Side::Left);
        let radius = |name: &str| match figure.links()[figure.link_index(name).expect("a link")].shape() {
            Some(Shape { kind: ShapeKind::Capsule { radius, .. }, .. }) => *radius,
            other => panic!("{name} is {other:?}"),
        };
        let (own, next) = (radius("left_thigh"), radius("left_shank"));
        let [from, to] = [0, 1].map(|end| thigh.parts[0].size[end]);
        // Half way to the shank's, to the millimetre that is written.
        assert!(own > next && (from - own).abs() < 1e-3 && (to - 0.5 * (own + next)).abs() < 1e-3);
    }
}
