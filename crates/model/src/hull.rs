//! The convex hull of points on the ground.

use nalgebra::{Vector2, Vector3};

/// Two axes of the ground, at right angles; seen from above the second is to the left of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundAxes {
    up: Vector3<f64>,
    axes: [Vector3<f64>; 2],
}

impl GroundAxes {
    /// Axes of the ground that `up` (of length 1) stands on.
    pub fn new(up: &Vector3<f64>) -> Self {
        let least = up.iamin();
        let mut first = Vector3::zeros();
        first[least] = 1.0;
        first = (first - up * first.dot(up)).normalize();
        Self { up: *up, axes: [first, up.cross(&first)] }
    }

    /// The direction away from the ground.
    pub fn up(&self) -> &Vector3<f64> {
        &self.up
    }

    /// The two axes.
    pub fn axes(&self) -> &[Vector3<f64>; 2] {
        &self.axes
    }

    /// A place or direction as seen from above.
    pub fn flat(&self, v: &Vector3<f64>) -> Vector2<f64> {
        Vector2::from(self.axes.map(|axis| axis.dot(v)))
    }

    /// What is seen there at a height (m, along up).
    pub fn raise(&self, flat: &Vector2<f64>, height: f64) -> Vector3<f64> {
        self.axes[0] * flat.x + self.axes[1] * flat.y + self.up * height
    }
}

/// The indices of the corners of the convex hull, counter-clockwise, by Andrew's monotone chain: of points in a line its ends, of
/// points in one place one of them.
pub fn convex_hull(points: &[Vector2<f64>]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&i, &j| {
        let (a, b) = (points[i], points[j]);
        a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
    });
    order.dedup_by(|i, j| points[*i] == points[*j]);
    if order.len() < 2 {
        return order;
    }
    let half = |order: &mut dyn Iterator<Item = usize>| {
        let mut chain: Vec<usize> = Vec::new();
        for i in order {
            while let [.., a, b] = chain[..]
                && (points[b] - points[a]).perp(&(points[i] - points[a])) <= 0.0
            {
                chain.pop();
            }
            chain.push(i);
        }
        chain.pop();
        chain
    };
    let mut lower = half(&mut order.iter().copied());
    lower.extend(half(&mut order.iter().rev().copied()));
    lower
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axes_are_right_handed() {
        for up in [Vector3::y(), Vector3::z(), -Vector3::x(), Vector3::new(0.36, 0.48, 0.8)] {
            let ground = GroundAxes::new(&up);
            let v = Vector3::new(0.3, -1.2, 0.7);
            assert!((ground.raise(&ground.flat(&v), up.dot(&v)) - v).norm() < 1e-15);
            assert!((ground.axes[0].cross(&ground.axes[1]) - up).norm() < 1e-15);
        }
    }

    #[test]
    fn the_hull_leaves_out_what_is_inside_or_on_an_edge() {
        let of = |points: &[(f64, f64)]| {
            convex_hull(&points.iter().map(|p| Vector2::new(p.0, p.1)).collect::<Vec<_>>())
        };
        let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.5, 0.4), (0.0, 1.0)];
        assert_eq!(of(&points), [0, 2, 3, 5]);
        assert_eq!(of(&[(1.0, 1.0), (3.0, 3.0), (2.0, 2.0)]), [0, 1]);
        assert_eq!(of(&[(1.0, 1.0), (1.0, 1.0)]).len(), 1);
        assert!(of(&[]).is_empty());
    }
}
