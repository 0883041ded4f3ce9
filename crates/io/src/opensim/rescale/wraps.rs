//! Whether a path lies on a wrap object.

use super::bodies::Bodies;
use super::paths::Pose;
use crate::opensim::element::{child_flag, child_number, child_vector, child_words, placement};
use crate::xml::{Node, Reader, element, elements, elements_called};
use solaris_model::Vector3;
use std::collections::HashMap;

/// The wrap objects of a model, by their names.
pub(super) struct Wraps<'a> {
    objects: HashMap<&'a str, Node<'a>>,
}

impl<'a> Wraps<'a> {
    /// Those of a model.
    pub(super) fn of(model: Node<'a>) -> Self {
        let sets = model.descendants().filter(|node| node.has_tag_name("WrapObjectSet"));
        let mut objects = HashMap::new();
        for object in sets.flat_map(|set| elements_called(set, "objects")).flat_map(elements) {
            if let Some(name) = object.attribute("name") {
                objects.entry(name.trim()).or_insert(object);
            }
        }
        Self { objects }
    }

    /// Whether all objects that the set `wraps` names leave a path through `points` straight. Points that are not a part of
    /// the path in the pose are nothing; `false` where it cannot be said without bending the path round them.
    pub(super) fn leave_straight(
        &self,
        reader: &mut Reader,
        bodies: &mut Bodies,
        pose: &Pose,
        wraps: Node,
        points: &[Option<Vector3<f64>>],
    ) -> bool {
        let mut members = elements_called(wraps, "objects").flat_map(elements);
        members.all(|wrap| self.leaves_straight(reader, bodies, pose, wrap, points).unwrap_or(false))
    }

    fn leaves_straight(
        &self,
        reader: &mut Reader,
        bodies: &mut Bodies,
        pose: &Pose,
        wrap: Node,
        points: &[Option<Vector3<f64>>],
    ) -> Option<bool> {
        let object = *self.objects.get(child_words(wrap, "wrap_object")?)?;
        if !child_flag(reader, object, "active", true) {
            return Some(true);
        }
        let at = bodies.around(reader, object)?;
        let place =
            [child_vector(reader, object, "translation"), child_vector(reader, object, "xyz_body_rotation")];
        let frame = pose.frame(bodies, &at)? * placement(place[0], place[1]);
        let range = match element(wrap, "range") {
            Some(range) => reader.text_numbers(range, 2..=2)?,
            None => vec![-1.0, -1.0],
        };
        // From 1; less than that is from the first or to the last point.
        let first = if range[0] < 1.0 { 0 } else { range[0] as usize - 1 };
        let last = if range[1] < 1.0 { points.len() } else { range[1] as usize };
        let seen = points.get(first..last.min(points.len()))?.iter().flatten();
        let seen: Vec<Vector3<f64>> =
            seen.map(|point| frame.inverse_transform_point(&(*point).into()).coords).collect();
        let round = Round::of(reader, object)?;
        Some(seen.array_windows().all(|[a, b]| round.misses(a, b)))
    }
}

/// A wrap object about its own origin.
enum Round {
    /// About z; with a side (axis and sign) the path is kept there.
    Cylinder { radius: f64, side: Option<(usize, f64)> },
    /// With these semi-axes; a sphere is one.
    Ellipsoid(Vector3<f64>),
}

impl Round {
    fn of(reader: &mut Reader, object: Node) -> Option<Self> {
        match object.tag_name().name() {
            "WrapCylinder" => {
                let radius = child_number(reader, object, "radius")?;
                let quadrant = child_words(object, "quadrant").unwrap_or("all").to_ascii_lowercase();
                let sign = if quadrant.starts_with('-') { -1.0 } else { 1.0 };
                let side = match quadrant.trim_start_matches(['+', '-']) {
                    "x" => Some((0, sign)),
                    "y" => Some((1, sign)),
                    "z" => Some((2, sign)),
                    _ => None,
                };
                Some(Self::Cylinder { radius, side })
            }
            "WrapSphere" => Some(Self::Ellipsoid(Vector3::repeat(child_number(reader, object, "radius")?))),
            "WrapEllipsoid" => Some(Self::Ellipsoid(child_vector(reader, object, "dimensions"))),
            _ => None,
        }
    }

    /// Whether the segment from `a` to `b` stays straight beyond doubt.
    ///
    /// # Source
    ///
    /// The conditions under which `wrapLine` of OpenSim 4.6 returns `noWrap` or `insideRadius`.
    fn misses(&self, a: &Vector3<f64>, b: &Vector3<f64>) -> bool {
        match self {
            Self::Cylinder { radius, side } => misses_cylinder(a, b, *radius, *side),
            Self::Ellipsoid(size) => {
                // On a unit sphere: |b + l·(a − b)|² = 1.
                let (from, way) = (b.component_div(size), (a - b).component_div(size));
                let (aa, bb, cc) = (way.norm_squared(), 2.0 * way.dot(&from), from.norm_squared() - 1.0);
                if cc < 0.0 || a.component_div(size).norm_squared() < 1.0 {
                    return true;
                }
                let root = (bb * bb - 4.0 * aa * cc).sqrt();
                let crossings = [(-bb + root) / (2.0 * aa), (-bb - root) / (2.0 * aa)];
                // No number where the line misses.
                !crossings.into_iter().all(|l| 0.0 < l && l < 1.0)
            }
        }
    }
}

fn misses_cylinder(a: &Vector3<f64>, b: &Vector3<f64>, radius: f64, side: Option<(usize, f64)>) -> bool {
    let is_inside = |point: &Vector3<f64>| point.xy().norm() < radius;
    if is_inside(a) || is_inside(b) {
        return true;
    }
    // The point of the line that is nearest to the axis; no number where the two are parallel.
    let way = b - a;
    let t = -a.xy().dot(&way.xy()) / way.xy().norm_squared();
    let near = a + way * t;
    let hits = is_inside(&near) && 0.0 < t && t < 1.0;
    let Some((axis, sign)) = side else { return !hits };
    let is_there = |point: &Vector3<f64>| (point[axis] >= 0.0) == (sign > 0.0);
    let at = [is_there(a), is_there(b)];
    t.is_finite() && at != [false; 2] && !hits && (at == [true; 2] || is_there(&near))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_beside_a_round_thing_stays_straight() {
        let misses = |round: &Round, a: [f64; 3], b: [f64; 3]| round.misses(&a.into(), &b.into());
        let tube = Round::Cylinder { radius: 1.0, side: None };
        assert!(misses(&tube, [-2.0, 1.1, 0.0], [2.0, 1.1, 5.0]));
        assert!(!misses(&tube, [-2.0, 0.9, 0.0], [2.0, 0.9, 5.0]));
        assert!(misses(&tube, [-4.0, 0.9, 0.0], [-2.0, 0.9, 5.0]), "it ends before");
        assert!(misses(&tube, [-2.0, 0.5, 0.0], [-0.5, 0.5, 5.0]), "it ends inside");
        assert!(misses(&tube, [2.0, 0.5, 0.0], [2.0, 0.5, 5.0]), "along the axis");
        let above = Round::Cylinder { radius: 1.0, side: Some((1, 1.0)) };
        assert!(misses(&above, [-2.0, 1.1, 0.0], [2.0, 1.1, 0.0]));
        assert!(!misses(&above, [-2.0, -1.1, 0.0], [2.0, -1.1, 0.0]), "it would be pulled round");
        let egg = Round::Ellipsoid(Vector3::new(1.0, 2.0, 3.0));
        assert!(misses(&egg, [-2.0, 2.1, 0.0], [2.0, 2.1, 0.0]));
        assert!(!misses(&egg, [-2.0, 1.9, 0.0], [2.0, 1.9, 0.0]));
        assert!(misses(&egg, [-2.0, 0.0, 0.0], [0.0, 0.0, 0.0]), "it ends inside");
    }
}
