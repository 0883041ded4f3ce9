//! Outlines on the ground: of a sole, their edges, and how far a point is outside of one.

use super::{PlacedFeet, SOLE_BREADTH};
use nalgebra::{Vector2, Vector3};
use solaris_model::{GroundAxes, convex_hull};

/// An outline drawn in by its margin must leave room for a strip this wide (m).
const ROOM: f64 = 1e-6;

impl PlacedFeet<'_> {
    /// The outline of a foot in a frame, seen from above: the convex hull of heel, ball and tip, each half a breadth to either
    /// side, on the ground at `level` (m, along up), counter-clockwise seen from above. Empty where the sole has no breadth.
    pub fn outline(&self, row: usize, foot: usize, level: f64) -> Vec<Vector3<f64>> {
        self.soles()[foot].width.map_or_else(Vec::new, |width| self.outline_of(row, foot, level, width))
    }

    /// The same; a sole that has no breadth has the usual one.
    pub(super) fn usual_outline(&self, row: usize, foot: usize, level: f64) -> Vec<Vector3<f64>> {
        let [heel, ball, tip] = self.frame(row)[foot].points;
        let usual = || SOLE_BREADTH * ((ball - heel).norm() + (tip - ball).norm());
        self.outline_of(row, foot, level, self.soles()[foot].width.unwrap_or_else(usual))
    }

    fn outline_of(&self, row: usize, foot: usize, level: f64, width: f64) -> Vec<Vector3<f64>> {
        let points = self.frame(row)[foot].points;
        let ground = GroundAxes::new(&self.prepared().up);
        let along = ground.flat(&(points[2] - points[0]));
        // A sole that stands upright has no direction on the ground: any will do.
        let along = along.try_normalize(1e-9).unwrap_or_else(Vector2::x);
        let side = ground.raise(&Vector2::new(-along.y, along.x), 0.0) * (width / 2.0);
        around(points.into_iter().flat_map(|point| [point + side, point - side]), &ground, level)
    }
}

/// The convex hull of points (m, world) as seen from above, on the ground at `level` (m, along up), counter-clockwise; empty
/// of none.
pub(super) fn around(
    points: impl Iterator<Item = Vector3<f64>>,
    ground: &GroundAxes,
    level: f64,
) -> Vec<Vector3<f64>> {
    let flat: Vec<Vector2<f64>> = points.map(|point| ground.flat(&point)).collect();
    convex_hull(&flat).into_iter().map(|i| ground.raise(&flat[i], level)).collect()
}

/// An edge of an outline: a point of it, and the unit vector out of the outline.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) point: Vector2<f64>,
    pub(super) out: Vector2<f64>,
}

/// The edges of a convex outline, counter-clockwise, none of them without length; `None` for any other outline.
pub(super) fn edges(outline: &[Vector2<f64>]) -> Option<Vec<Edge>> {
    let extent = outline.iter().map(|point| (point - outline[0]).norm()).fold(0.0, f64::max);
    let next = outline.iter().cycle().skip(1);
    let pairs = outline.iter().zip(next).filter(|(from, to)| (*to - *from).norm() > 1e-9 * extent);
    let edges: Vec<Edge> = pairs
        .map(|(from, to)| {
            let along = (to - from).normalize();
            Edge { point: *from, out: Vector2::new(along.y, -along.x) }
        })
        .collect();
    let inside = |point: &Vector2<f64>, edge: &Edge| edge.out.dot(&(point - edge.point)) <= 1e-9 * extent;
    let convex = edges.iter().all(|edge| outline.iter().all(|point| inside(point, edge)));
    (edges.len() > 2 && convex).then_some(edges)
}

/// Whether anything is left of an outline whose edges are drawn in by `margin`.
pub(super) fn has_room(outline: &[Vector2<f64>], edges: &[Edge], margin: f64) -> bool {
    let mut left = outline.to_vec();
    for edge in edges {
        let beyond = |point: &Vector2<f64>| edge.out.dot(&(point - edge.point)) + margin + 0.5 * ROOM;
        let mut clipped = Vec::with_capacity(left.len() + 1);
        for (from, to) in left.iter().zip(left.iter().cycle().skip(1)) {
            let (a, b) = (beyond(from), beyond(to));
            if a <= 0.0 {
                clipped.push(*from);
            }
            if (a < 0.0) != (b < 0.0) && (a - b).abs() > 0.0 {
                clipped.push(from + (to - from) * (a / (a - b)));
            }
        }
        left = clipped;
    }
    !left.is_empty()
}

/// How far (m) a point is outside of a convex outline with these corners, counter-clockwise; zero inside.
pub(super) fn outside(corners: &(impl Iterator<Item = Vector2<f64>> + Clone), point: &Vector2<f64>) -> f64 {
    let inside = |(a, b): (Vector2<f64>, Vector2<f64>)| (b - a).perp(&(point - a)) >= 0.0;
    if sides(corners).all(inside) { 0.0 } else { (nearest(corners, point) - point).norm() }
}

/// The point of the edge of an outline with these corners that is nearest to a point; infinitely far without corners.
pub(super) fn nearest(
    corners: &(impl Iterator<Item = Vector2<f64>> + Clone),
    point: &Vector2<f64>,
) -> Vector2<f64> {
    let on = |(a, b): (Vector2<f64>, Vector2<f64>)| {
        let (edge, to) = (b - a, point - a);
        let length = edge.norm_squared();
        a + edge * if length > 0.0 { (to.dot(&edge) / length).clamp(0.0, 1.0) } else { 0.0 }
    };
    let far = Vector2::repeat(f64::INFINITY);
    sides(corners).map(on).fold(far, |a, b| if (b - point).norm() < (a - point).norm() { b } else { a })
}

/// From each corner to the next.
fn sides(
    corners: &(impl Iterator<Item = Vector2<f64>> + Clone),
) -> impl Iterator<Item = (Vector2<f64>, Vector2<f64>)> {
    corners.clone().zip(corners.clone().cycle().skip(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn rectangle() -> Vec<Vector2<f64>> {
        [[0.0, 0.0], [0.3, 0.0], [0.3, 0.0], [0.3, 0.1], [0.0, 0.1]].map(Vector2::from).to_vec()
    }

    #[test]
    fn distances_from_a_rectangle() {
        let edges = edges(&rectangle()).expect("convex");
        assert_eq!(edges.len(), 4);
        for (point, distance) in
            [([0.1, 0.05], 0.0), ([0.3, 0.1], 0.0), ([0.34, 0.05], 0.04), ([-0.03, -0.04], 0.05)]
        {
            assert_relative_eq!(
                outside(&edges.iter().map(|edge| edge.point), &Vector2::from(point)),
                distance,
                epsilon = 1e-15
            );
        }
    }

    #[test]
    fn margins_that_leave_room() {
        let (outline, sides) = (rectangle(), edges(&rectangle()).expect("convex"));
        assert!(has_room(&outline, &sides, 0.0) && has_room(&outline, &sides, 0.0499));
        assert!(!has_room(&outline, &sides, 0.0501));
    }

    #[test]
    fn what_is_no_outline() {
        let mut clockwise = rectangle();
        clockwise.reverse();
        let dented = [[0.0, 0.0], [0.3, 0.0], [0.1, 0.05], [0.0, 0.1]].map(Vector2::from).to_vec();
        let line = [[0.0, 0.0], [0.3, 0.1]].map(Vector2::from).to_vec();
        for outline in [clockwise, dented, line, vec![Vector2::zeros()], vec![Vector2::zeros(); 4]] {
            assert!(edges(&outline).is_none(), "{outline:?}");
        }
    }
}
