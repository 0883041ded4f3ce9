//! The convex hull of points on the ground.

use nalgebra::{Vector2, Vector3};

/// Two axes of the ground, with `up` (of length 1) as the third.
pub fn ground_axes(up: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let least = up.iamin();
    let mut e = Vector3::zeros();
    e[least] = 1.0;
    let e = (e - up * e.dot(up)).normalize();
    [e, up.cross(&e)]
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
