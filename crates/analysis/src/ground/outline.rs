//! The outline of a sole on the ground, and how far a point is outside of it.

use super::Sole;
use nalgebra::{Vector2, Vector3};
use solaris_dynamics::Workspace;
use solaris_model::{convex_hull, ground_axes};

impl Sole {
    /// The outline of the sole seen from above, where `workspace` has placed the links: the convex hull of heel, ball
    /// and tip, each half a breadth to either side, on the ground at `level` (m, along `up`, of length 1),
    /// counter-clockwise seen from above. Empty where the sole has no breadth.
    pub fn outline(&self, workspace: &Workspace<f64>, up: &Vector3<f64>, level: f64) -> Vec<Vector3<f64>> {
        let Some(width) = self.width else { return Vec::new() };
        let points = self.points(workspace);
        let [e, f] = ground_axes(up);
        let flat = |v: &Vector3<f64>| Vector2::new(v.dot(&e), v.dot(&f));
        let along = flat(&(points[2] - points[0]));
        // A sole that stands upright has no direction on the ground: any will do.
        let along = along.try_normalize(1e-9).unwrap_or_else(Vector2::x);
        let side = (f * along.x - e * along.y) * (width / 2.0);
        around(points.into_iter().flat_map(|point| [point + side, point - side]), up, level)
    }
}

/// The convex hull of points (m, world) as seen from above, on the ground at `level` (m, along `up`), counter-clockwise; empty
/// of none.
pub(super) fn around(
    points: impl Iterator<Item = Vector3<f64>>,
    up: &Vector3<f64>,
    level: f64,
) -> Vec<Vector3<f64>> {
    let [e, f] = ground_axes(up);
    let flat: Vec<Vector2<f64>> = points.map(|v| Vector2::new(v.dot(&e), v.dot(&f))).collect();
    convex_hull(&flat).into_iter().map(|i| e * flat[i].x + f * flat[i].y + up * level).collect()
}

/// How far (m) a point is outside of a convex outline, along the ground; zero inside. The outline is counter-clockwise
/// seen from above.
pub(super) fn outside(point: &Vector3<f64>, outline: &[Vector3<f64>], up: &Vector3<f64>) -> f64 {
    let flat = |v: Vector3<f64>| v - up * v.dot(up);
    let mut nearest = f64::INFINITY;
    let mut inside = true;
    for (i, a) in outline.iter().enumerate() {
        let b = &outline[(i + 1) % outline.len()];
        let (edge, to) = (flat(b - a), flat(point - a));
        inside &= edge.cross(&to).dot(up) >= 0.0;
        let s = if edge.norm_squared() > 0.0 {
            (to.dot(&edge) / edge.norm_squared()).clamp(0.0, 1.0)
        } else {
            0.0
        };
        nearest = nearest.min((to - edge * s).norm());
    }
    if inside { 0.0 } else { nearest }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_point_beside_an_edge_and_one_beyond_a_corner() {
        let up = Vector3::y();
        let [e, f] = ground_axes(&up);
        let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| e * x + f * y);
        let at = |x: f64, y: f64| outside(&(e * x + f * y + up * 7.0), &square, &up);
        assert_relative_eq!(at(0.5, 0.5), 0.0);
        assert_relative_eq!(at(0.5, -0.2), 0.2, epsilon = 1e-15);
        assert_relative_eq!(at(1.3, 1.4), 0.5, epsilon = 1e-15);
    }
}
