//! Outlines of what stands on the ground, in the ground's own two axes.

use nalgebra::{Vector2, Vector3};

/// An outline drawn in by its margin must leave room for a strip this wide (m).
const ROOM: f64 = 1e-6;

/// Two axes of the ground, at right angles; seen from above the second is to the left of the first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ground {
    pub(super) up: Vector3<f64>,
    axes: [Vector3<f64>; 2],
}

impl Ground {
    pub(super) fn new(up: Vector3<f64>) -> Self {
        let steepest = up.iamin();
        let mut first = Vector3::zeros();
        first[steepest] = 1.0;
        first = (first - up * up[steepest]).normalize();
        Self { up, axes: [first, up.cross(&first)] }
    }

    pub(super) fn flat(&self, v: &Vector3<f64>) -> Vector2<f64> {
        Vector2::from(self.axes.map(|axis| axis.dot(v)))
    }

    pub(super) fn raise(&self, flat: &Vector2<f64>, height: f64) -> Vector3<f64> {
        self.axes[0] * flat.x + self.axes[1] * flat.y + self.up * height
    }
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

/// How far (m) a point is outside of an outline; zero inside.
pub(super) fn outside(edges: &[Edge], point: &Vector2<f64>) -> f64 {
    if edges.iter().all(|edge| edge.out.dot(&(point - edge.point)) <= 0.0) {
        return 0.0;
    }
    let distances = edges.iter().zip(edges.iter().cycle().skip(1)).map(|(edge, next)| {
        let way = next.point - edge.point;
        let part = (way.dot(&(point - edge.point)) / way.norm_squared()).clamp(0.0, 1.0);
        (point - edge.point - way * part).norm()
    });
    distances.fold(f64::INFINITY, f64::min)
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
            assert_relative_eq!(outside(&edges, &Vector2::from(point)), distance, epsilon = 1e-15);
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

    #[test]
    fn the_axes_are_right_handed() {
        for up in [Vector3::y(), Vector3::z(), -Vector3::x(), Vector3::new(0.36, 0.48, 0.8)] {
            let ground = Ground::new(up);
            let v = Vector3::new(0.3, -1.2, 0.7);
            assert_relative_eq!(ground.raise(&ground.flat(&v), up.dot(&v)), v, epsilon = 1e-15);
            assert_relative_eq!(ground.axes[0].cross(&ground.axes[1]), up, epsilon = 1e-15);
        }
    }
}
