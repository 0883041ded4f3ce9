//! Solids as an eye in parallel light has them: their outlines.

use super::Lens;
use crate::chart::{Point, path};
use crate::draw::Part;
use glam::{DMat2, DMat3, DQuat, DVec2, DVec3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// A solid at its place (m), in axes of which z is towards the eye.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Solid {
    /// Two balls and the cone that touches both: centres and radii.
    Limb([(DVec3, f64); 2]),
    /// Its middle and the vectors of its three semi-axes.
    Ellipsoid(DVec3, DMat3),
    /// The smallest convex solid around points.
    Hull(Vec<DVec3>),
}

/// Points of a cylinder's rim.
const RIM: usize = 24;

impl Solid {
    /// A part of a link that stands at `place`, turned by `turn`.
    pub(super) fn of(part: &Part, place: DVec3, turn: DQuat) -> Self {
        let centre = place + turn * DVec3::from_array(part.at);
        let axes = DMat3::from_quat(turn * DQuat::from_array(part.turn));
        match (part.kind, part.size.as_slice()) {
            ("capsule", &[near, far, length]) => {
                let end = axes.y_axis * (0.5 * length);
                Self::Limb([(centre - end, near), (centre + end, far)])
            }
            ("ellipsoid", &[a, b, c]) => {
                Self::Ellipsoid(centre, axes * DMat3::from_diagonal(DVec3::new(a, b, c)))
            }
            ("box", &[a, b, c]) => {
                let half =
                    |corner: u8, bit: u8, edge: f64| if corner & bit == 0 { -0.5 * edge } else { 0.5 * edge };
                let corner = |i: u8| centre + axes * DVec3::new(half(i, 1, a), half(i, 2, b), half(i, 4, c));
                Self::Hull((0..8).map(corner).collect())
            }
            ("cylinder", &[radius, length]) => {
                let rim = |i: usize| {
                    let (sin, cos) = (TAU * i as f64 / RIM as f64).sin_cos();
                    let end = if i < RIM { -0.5 * length } else { 0.5 * length };
                    centre + axes * DVec3::new(radius * cos, end, radius * sin)
                };
                Self::Hull((0..2 * RIM).map(rim).collect())
            }
            (_, size) => {
                let radius = size.iter().copied().fold(0.0, f64::max);
                Self::Limb([(centre, radius), (centre, radius)])
            }
        }
    }

    /// What closes the waist between two ellipsoids: a flat piece between their outlines, behind both.
    pub(super) fn between(a: &Self, b: &Self) -> Option<Self> {
        let (Self::Ellipsoid(from, first), Self::Ellipsoid(to, second)) = (a, b) else { return None };
        let across = (*to - *from).truncate().try_normalize()?.perp();
        let depth = from.z.min(to.z) - first.row(2).length().max(second.row(2).length());
        let edges = [(from, first), (to, second)].map(|(centre, axes)| {
            // The point of an ellipse C = Σ s sᵀ whose normal is n lies C n/√(nᵀ C n) from its middle.
            let reach = silhouette(axes) * across;
            let edge = reach / reach.dot(across).max(1e-18).sqrt();
            [edge, -edge].map(|edge| (centre.truncate() + edge).extend(depth))
        });
        Some(Self::Hull(edges.concat()))
    }

    /// How far its middle is towards the eye (m).
    pub(super) fn depth(&self) -> f64 {
        match self {
            Self::Limb([(a, _), (b, _)]) => 0.5 * (a.z + b.z),
            Self::Ellipsoid(centre, _) => centre.z,
            Self::Hull(points) => points.iter().map(|point| point.z).sum::<f64>() / points.len() as f64,
        }
    }

    /// Its outline as the text of a path.
    pub(super) fn outline(&self, lens: &Lens) -> String {
        match self {
            Self::Limb(ends) => limb(ends.map(|(at, radius)| (lens.point(at), radius * lens.scale))),
            Self::Ellipsoid(centre, axes) => ellipse(lens.point(*centre), silhouette(axes), lens.scale),
            Self::Hull(points) => {
                let points: Vec<Point> = points.iter().map(|point| lens.point(*point)).collect();
                path(&hull(points)) + "Z"
            }
        }
    }
}

/// The outline of an ellipsoid, as the matrix C of an ellipse xᵀ C⁻¹ x = 1: the sum of s sᵀ over its semi-axes, seen.
fn silhouette(axes: &DMat3) -> DMat2 {
    let columns = [axes.x_axis, axes.y_axis, axes.z_axis].map(DVec3::truncate);
    columns.iter().fold(DMat2::ZERO, |sum, s| sum + DMat2::from_cols(*s * s.x, *s * s.y))
}

/// To a tenth of a pixel.
fn tenth(x: f64) -> String {
    let text = format!("{x:.1}");
    let text = text.strip_suffix(".0").unwrap_or(&text);
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn joined(numbers: &[f64]) -> String {
    numbers.iter().map(|x| tenth(*x)).collect::<Vec<_>>().join(" ")
}

/// Two circles (px) and the lines that touch both on the outside.
fn limb([(a, near), (b, far)]: [(Point, f64); 2]) -> String {
    let (along, across) = (b.0 - a.0, b.1 - a.1);
    let length = along.hypot(across);
    if length <= (near - far).abs() {
        let (centre, radius) = if near > far { (a, near) } else { (b, far) };
        let (from, to) = ((centre.0 - radius, centre.1), (centre.0 + radius, centre.1));
        let half = |end: Point| format!("A{} 0 0 1 {}", joined(&[radius, radius]), joined(&[end.0, end.1]));
        return format!("M{}{}{}Z", joined(&[from.0, from.1]), half(to), half(from));
    }
    // Where they touch, from the line of centres.
    let (turn, touch) = (across.atan2(along), ((near - far) / length).acos());
    let on = |(x, y): Point, radius: f64, angle: f64| {
        joined(&[x + radius * angle.cos(), y + radius * angle.sin()])
    };
    let arc = |centre, radius: f64, angle, is_large| {
        format!("A{} 0 {} 1 {}", joined(&[radius, radius]), u8::from(is_large), on(centre, radius, angle))
    };
    format!(
        "M{}{}L{}{}Z",
        on(a, near, turn + touch),
        arc(a, near, turn - touch, touch < FRAC_PI_2),
        on(b, far, turn - touch),
        arc(b, far, turn + touch, touch > FRAC_PI_2),
    )
}

/// An ellipse about a point (px) of the matrix C (m²).
fn ellipse((x, y): Point, c: DMat2, scale: f64) -> String {
    let (mean, half, mixed) = (0.5 * (c.x_axis.x + c.y_axis.y), 0.5 * (c.x_axis.x - c.y_axis.y), c.x_axis.y);
    let apart = half.hypot(mixed);
    let [long, short] = [mean + apart, mean - apart].map(|square| scale * square.max(0.0).sqrt());
    // The sheet's y goes down.
    let turn = -0.5 * mixed.atan2(half);
    let end = DVec2::from_angle(turn) * long;
    let arc = |end: DVec2| {
        let radii = joined(&[long, short, turn.to_degrees()]);
        format!("A{radii} 1 1 {}", joined(&[x + end.x, y + end.y]))
    };
    format!("M{}{}{}Z", joined(&[x - end.x, y - end.y]), arc(end), arc(-end))
}

/// The corners of the smallest convex polygon around points. After A. M. Andrew (1979).
fn hull(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let chain = |points: &mut dyn Iterator<Item = Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..] {
                if (b.0 - a.0) * (point.1 - a.1) - (b.1 - a.1) * (point.0 - a.0) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut corners = chain(&mut points.iter().copied());
    corners.extend(chain(&mut points.iter().rev().copied()));
    corners
}

#[cfg(test)]
mod tests {
    use super::*;

    const LENS: Lens = Lens { scale: 100.0, from: (0.0, 0.0), place: (50.0, 50.0) };

    #[test]
    fn an_upright_limb_touches_its_balls_at_their_sides() {
        let limb = Solid::Limb([(DVec3::ZERO, 0.1), (DVec3::Y * 0.4, 0.1)]);
        // Up on the sheet is less y; the lines stand 10 px to the left and to the right.
        assert_eq!(limb.outline(&LENS), "M60 50A10 10 0 0 1 40 50L40 10A10 10 0 0 1 60 10Z");
        let ball = Solid::Limb([(DVec3::ZERO, 0.1), (DVec3::Z, 0.05)]);
        assert_eq!(ball.outline(&LENS), "M40 50A10 10 0 0 1 60 50A10 10 0 0 1 40 50Z");
    }

    #[test]
    fn a_turned_ellipsoid_is_a_turned_ellipse() {
        let turn = DMat3::from_rotation_z(std::f64::consts::FRAC_PI_4);
        let solid = Solid::Ellipsoid(DVec3::ZERO, turn * DMat3::from_diagonal(DVec3::new(0.4, 0.1, 0.2)));
        // Its long axis goes up to the right.
        assert_eq!(solid.outline(&LENS), "M21.7 78.3A40 10 -45 1 1 78.3 21.7A40 10 -45 1 1 21.7 78.3Z");
    }

    #[test]
    fn a_hull_leaves_out_what_lies_inside() {
        let corners = hull(vec![(0.0, 0.0), (2.0, 0.0), (1.0, 1.0), (2.0, 2.0), (0.0, 2.0), (1.0, 0.0)]);
        assert_eq!(corners, [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]);
    }

    #[test]
    fn a_waist_is_as_wide_as_both_ends() {
        let ball = |y: f64| Solid::Ellipsoid(DVec3::Y * y, DMat3::from_diagonal(DVec3::splat(0.1)));
        let Some(Solid::Hull(points)) = Solid::between(&ball(0.0), &ball(0.5)) else { panic!("a waist") };
        let mut points: Vec<String> = points.iter().map(|p| format!("{:.1} {:.1}", p.x, p.y)).collect();
        points.sort();
        assert_eq!(points, ["-0.1 0.0", "-0.1 0.5", "0.1 0.0", "0.1 0.5"]);
    }
}
