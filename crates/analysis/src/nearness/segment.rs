//! The shortest way between two segments.

use nalgebra::Vector3;

/// The shortest way (m) from one segment to another, each given by its ends; a segment whose ends are one is a point.
///
/// ```text
/// lines a + s·u, b + t·v      n = u × v      s = (w × v)·n / n²      t = (w × u)·n / n²      w = b − a
/// ```
///
/// Where both feet of the common perpendicular lie on their segments it is theirs; otherwise one of the four ends is the
/// nearest to the other segment. The least of these five is taken, whatever the angle: each is a way that occurs, so
/// parallel segments, where the feet are lost in rounding, need no case of their own. With `n` in place of the usual
/// `u²v² − (u·v)²`, which cancels, feet of nearly parallel lines are as good as their angle allows.
///
/// As long to the bit with the segments exchanged.
pub(super) fn shortest(first: &[Vector3<f64>; 2], second: &[Vector3<f64>; 2]) -> Vector3<f64> {
    let ([a, a_end], [b, b_end]) = (first, second);
    let (u, v) = (a_end - a, b_end - b);
    let (mut least, mut shortest) = (f64::INFINITY, Vector3::zeros());
    let mut take = |way: Vector3<f64>| {
        let square = way.norm_squared();
        if square < least {
            (least, shortest) = (square, way);
        }
    };
    take(-to_point(second, a));
    take(-to_point(second, a_end));
    take(to_point(first, b));
    take(to_point(first, b_end));
    let n = u.cross(&v);
    let square = n.norm_squared();
    if square > 0.0 {
        let w = b - a;
        let (s, t) = (w.cross(&v).dot(&n) / square, w.cross(&u).dot(&n) / square);
        if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
            take((b + v * t) - (a + u * s));
        }
    }
    shortest
}

/// From a segment to a point (m).
fn to_point([a, b]: &[Vector3<f64>; 2], point: &Vector3<f64>) -> Vector3<f64> {
    let (along, to) = (b - a, point - a);
    let square = along.norm_squared();
    let share = if square > 0.0 { (to.dot(&along) / square).clamp(0.0, 1.0) } else { 0.0 };
    // From the nearer end, so that an end is met exactly.
    if share > 0.5 { point - b + along * (1.0 - share) } else { to - along * share }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    fn distance(first: &[Vector3<f64>; 2], second: &[Vector3<f64>; 2]) -> f64 {
        shortest(first, second).norm()
    }

    fn segment(ends: [[f64; 3]; 2]) -> [Vector3<f64>; 2] {
        ends.map(Vector3::from)
    }

    /// The least over a grid that closes in on the best of its points.
    fn searched(first: &[Vector3<f64>; 2], second: &[Vector3<f64>; 2]) -> f64 {
        const STEPS: usize = 20;
        let at = |[a, b]: &[Vector3<f64>; 2], s: f64| a + (b - a) * s;
        let (mut middle, mut half, mut least) = ([0.5, 0.5], 0.5, f64::INFINITY);
        for _ in 0..40 {
            let mut best = middle;
            for i in 0..=STEPS {
                for j in 0..=STEPS {
                    let part = |middle: f64, k: usize| {
                        (middle + half * (2.0 * k as f64 / STEPS as f64 - 1.0)).clamp(0.0, 1.0)
                    };
                    let (s, t) = (part(middle[0], i), part(middle[1], j));
                    let found = (at(first, s) - at(second, t)).norm();
                    if found < least {
                        (least, best) = (found, [s, t]);
                    }
                }
            }
            (middle, half) = (best, half * 0.5);
        }
        least
    }

    #[test]
    fn crossing_parallel_and_pointlike_segments_have_their_closed_forms() {
        let x = segment([[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
        for scale in [1e-6, 1.0, 1e6] {
            let apart = |ends: [[f64; 3]; 2], expected: f64| {
                let other = segment(ends).map(|end| end * scale);
                let found = distance(&x.map(|end| end * scale), &other);
                assert_abs_diff_eq!(found, expected * scale, epsilon = 1e-14 * scale);
            };
            apart([[0.3, -1.0, 0.5], [0.3, 1.0, 0.5]], 0.5); // crossing at a right angle
            apart([[-0.4, -1.0, 0.0], [0.4, 1.0, 0.0]], 0.0); // meeting
            apart([[-0.5, 0.2, 0.0], [0.7, 0.2, 0.0]], 0.2); // parallel, beside
            apart([[0.5, 0.2, 0.0], [7.0, 0.2, 0.0]], 0.2); // parallel, in part beside
            apart([[4.0, 4.0, 0.0], [9.0, 4.0, 0.0]], 5.0); // parallel, behind
            apart([[9.0, 4.0, 0.0], [4.0, 4.0, 0.0]], 5.0); // the other way
            apart([[-0.5, 0.0, 0.0], [3.0, 0.0, 0.0]], 0.0); // on one line, overlapping
            apart([[1.5, 0.0, 0.0], [3.0, 0.0, 0.0]], 0.5); // on one line, apart
            apart([[0.2, 3.0, 4.0], [0.2, 3.0, 4.0]], 5.0); // a point beside
            apart([[4.0, 0.0, 4.0], [4.0, 0.0, 4.0]], 5.0); // a point behind
            apart([[1.0, 0.1, 0.0], [3.0, 9.0, 0.0]], 0.1); // at an end
        }
        let point = segment([[1.0, 2.0, 2.0]; 2]);
        assert_abs_diff_eq!(distance(&point, &segment([[0.0; 3]; 2])), 3.0, epsilon = 1e-15);
        assert_abs_diff_eq!(distance(&point, &point), 0.0, epsilon = 0.0);
    }

    #[test]
    fn nearly_parallel_segments_that_cross_meet() {
        for tilt in [1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-20] {
            let line = segment([[-1.0, -0.3, 0.7], [1.0, 0.4, 0.2]]);
            let side = (line[1] - line[0]).cross(&Vector3::y()).normalize() * tilt;
            for height in [0.0, 1e-3] {
                let up = side.cross(&(line[1] - line[0])).normalize() * height;
                let other = [line[0] - side + up, line[1] + side + up];
                assert_abs_diff_eq!(distance(&line, &other), height, epsilon = 1e-15);
            }
        }
    }

    #[test]
    fn random_segments_are_as_far_apart_as_a_search_finds_and_either_way_round() {
        let random = &mut Random(7);
        for case in 0..300 {
            let scale = [1e-6, 1.0, 1e6][case % 3];
            let mut ends = || [random.vector(scale), random.vector(scale)];
            let (first, mut second) = (ends(), ends());
            if case % 5 == 0 {
                second[1] = second[0] + (first[1] - first[0]) * 0.6;
            }
            if case % 7 == 0 {
                second[1] = second[0];
            }
            let found = distance(&first, &second);
            assert_relative_eq!(
                found,
                searched(&first, &second),
                epsilon = 1e-7 * scale,
                max_relative = 1e-7
            );
            assert_eq!(found.to_bits(), distance(&second, &first).to_bits());
            let [a, b] = first;
            assert_abs_diff_eq!(found, distance(&[b, a], &second), epsilon = 1e-14 * scale);
        }
    }

    /// From the first to the second, whichever end or foot is the nearest.
    #[test]
    fn the_way_leads_from_the_first_segment_to_the_second() {
        let first = segment([[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
        for (ends, expected) in [
            ([[-3.0, -1.0, 0.0], [-3.0, 1.0, 0.0]], [-2.0, 0.0, 0.0]), // from its beginning
            ([[3.0, -1.0, 0.0], [3.0, 1.0, 0.0]], [2.0, 0.0, 0.0]),    // from its end
            ([[0.5, 2.0, 0.0], [0.5, 4.0, 0.0]], [0.0, 2.0, 0.0]),     // to the other's beginning
            ([[0.5, -4.0, 0.0], [0.5, -2.0, 0.0]], [0.0, -2.0, 0.0]),  // to the other's end
            ([[0.5, -1.0, 2.0], [0.5, 1.0, 2.0]], [0.0, 0.0, 2.0]),    // between feet
        ] {
            let (second, expected) = (segment(ends), Vector3::from(expected));
            assert_abs_diff_eq!(shortest(&first, &second), expected, epsilon = 1e-15);
            assert_abs_diff_eq!(shortest(&second, &first), -expected, epsilon = 1e-15);
        }
    }
}
