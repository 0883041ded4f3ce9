//! Contact patches: points that stand on the ground as one rigid part, and what must not happen for them to stay so.

use nalgebra::{Vector2, Vector3};
use solaris_dynamics::Wrench;
use solaris_model::{GroundAxes, convex_hull};

/// In what time (s) a velocity that integration has left to what stands dies out.
pub(crate) const CALM: f64 = 0.02;

/// Points of a hull that is narrower than this (m) are in a line, and those of a line that is shorter in one place.
const NARROW: f64 = 1e-6;

/// Touches of one rigid part of a figure that are held where they are on the ground.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ContactPatch {
    /// All of them, by their indices, in ascending order.
    pub(crate) contact_points: Vec<usize>,
    /// Those that hold it: one, the two ends of a line, or the corners of an area, which holds the part as a whole.
    pub(crate) corners: Vec<usize>,
    /// What keeps it as it is.
    pub(crate) levers: Vec<Lever>,
    /// Whether it slides along the ground, without friction.
    pub(crate) slides: bool,
}

/// A force that must not fall below zero for a contact patch to stay as it is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Lever {
    pub(crate) arm: Arm,
    /// The contact points that are left where it has fallen.
    pub(crate) left: Vec<usize>,
}

/// Which force (N) that is. Touches by their indices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Arm {
    /// That of a single point.
    Point,
    /// That at the end of a line, which begins at the other touch.
    End { from: usize, to: usize },
    /// That at the point opposite to an edge, `reach` (m) from it, if it bore all that does not bear on the edge.
    Edge { from: usize, to: usize, reach: f64 },
}

impl ContactPatch {
    /// One that is held by these contact points, which are `at` these places of the world (m); none without any. `up` has length 1.
    pub(crate) fn new(
        mut contact_points: Vec<usize>,
        at: impl Fn(usize) -> Vector3<f64>,
        up: &Vector3<f64>,
    ) -> Option<Self> {
        contact_points.sort_unstable();
        contact_points.dedup();
        let ground = GroundAxes::new(up);
        let flat: Vec<Vector2<f64>> = contact_points.iter().map(|touch| ground.flat(&at(*touch))).collect();
        let corners = convex_hull(&flat);
        let &first = corners.first()?;
        let distance = |i: usize| (flat[i] - flat[first]).norm();
        let far = (0..flat.len()).max_by(|i, j| distance(*i).total_cmp(&distance(*j)))?;
        if distance(far) < NARROW {
            let levers = vec![Lever { arm: Arm::Point, left: Vec::new() }];
            return Some(Self {
                corners: vec![contact_points[first]],
                contact_points,
                levers,
                slides: false,
            });
        }
        // Of each edge of the hull: how far inside each point is.
        let edge = |k: usize| {
            let (from, to) = (corners[k], corners[(k + 1) % corners.len()]);
            let along = (flat[to] - flat[from]).normalize();
            let inside: Vec<f64> = flat.iter().map(|p| along.perp(&(p - flat[from]))).collect();
            (from, to, inside)
        };
        let edges: Vec<_> = (0..corners.len()).map(edge).collect();
        let reach = |inside: &[f64]| inside.iter().fold(0.0, |most: f64, x| most.max(*x));
        if corners.len() < 3 || edges.iter().any(|(_, _, inside)| reach(inside) < NARROW) {
            // The hull of what is nearly in a line may have corners beside its ends.
            let from = (0..flat.len())
                .max_by(|i, j| (flat[*i] - flat[far]).norm().total_cmp(&(flat[*j] - flat[far]).norm()))?;
            let ends = [contact_points[from], contact_points[far]];
            let end = |from: usize, to: usize| Lever { arm: Arm::End { from, to }, left: vec![from] };
            let levers = vec![end(ends[0], ends[1]), end(ends[1], ends[0])];
            return Some(Self { contact_points, corners: ends.to_vec(), levers, slides: false });
        }
        let lever = |(from, to, inside): &(usize, usize, Vec<f64>)| {
            let on = inside.iter().enumerate().filter(|(_, inside)| **inside < NARROW);
            let arm =
                Arm::Edge { from: contact_points[*from], to: contact_points[*to], reach: reach(inside) };
            Lever { arm, left: on.map(|(i, _)| contact_points[i]).collect() }
        };
        let levers = edges.iter().map(lever).collect();
        let corners = corners.iter().map(|i| contact_points[*i]).collect();
        Some(Self { corners, contact_points, levers, slides: false })
    }

    /// Whether none of the part's points can come nearer to the ground.
    pub(crate) fn is_area(&self) -> bool {
        self.corners.len() > 2
    }

    /// Whether it holds its part as a whole, which neither moves nor turns.
    pub(crate) fn is_whole(&self) -> bool {
        self.is_area() && !self.slides
    }
}

impl Arm {
    /// Its force (N) where `wrench` (world axes, about the world's origin) is what the ground does to the part, whose touches
    /// are `at` these places (m).
    ///
    /// With `F`, `M` the wrench, `A` and `B` the contact points, `u` from `A` to `B` with length 1, `n` = `up` and `M_A = M − A×F`,
    ///
    /// ```text
    /// point   n·F            end   M_A·(u × n)/|B − A|            edge   M_A·u/reach
    /// ```
    pub(crate) fn force(
        &self,
        wrench: &Wrench<f64>,
        at: impl Fn(usize) -> Vector3<f64>,
        up: &Vector3<f64>,
    ) -> f64 {
        let along = |from: usize, to: usize| {
            let way = at(to) - at(from);
            let flat = way - up * way.dot(up);
            (flat.normalize(), flat.norm(), wrench.moment_about(&at(from)))
        };
        match *self {
            Self::Point => wrench.force.dot(up),
            Self::End { from, to } => {
                let (u, length, moment) = along(from, to);
                moment.dot(&u.cross(up)) / length
            }
            Self::Edge { from, to, reach } => {
                let (u, _, moment) = along(from, to);
                moment.dot(&u) / reach
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    const CORNERS: [[f64; 3]; 6] = [
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 0.3],
        [0.1, 0.0, 0.3],
        [0.1, 0.0, 0.0],
        [0.1, 0.0, 0.15],
        [0.05, 0.0, 0.1],
    ];

    fn at(touch: usize) -> Vector3<f64> {
        Vector3::from(CORNERS[touch])
    }

    fn hold(contact_points: &[usize]) -> ContactPatch {
        ContactPatch::new(contact_points.to_vec(), at, &Vector3::y()).expect("touches")
    }

    /// 100 N that press, and push along the ground, at a place of it.
    fn pressed(x: f64, z: f64) -> Wrench<f64> {
        Wrench::at(&Vector3::new(x, 0.0, z), Vector3::new(30.0, 100.0, -20.0), Vector3::new(0.0, 5.0, 0.0))
    }

    #[test]
    fn an_area_stays_while_its_center_of_pressure_is_inside() {
        let hold = hold(&[0, 1, 2, 3, 4, 5]);
        assert!(hold.is_whole() && !ContactPatch { slides: true, ..hold.clone() }.is_whole());
        assert_eq!(hold.corners.len(), 4);
        let least = |x: f64, z: f64| {
            let forces = hold.levers.iter().map(|lever| lever.arm.force(&pressed(x, z), at, &Vector3::y()));
            forces.enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).expect("levers")
        };
        assert!(least(0.02, 0.25).1 > 0.0);
        let (edge, force) = least(0.11, 0.1);
        assert_abs_diff_eq!(force, -10.0, epsilon = 1e-12);
        assert_eq!(hold.levers[edge].left, [2, 3, 4]);
        let (edge, force) = least(0.05, 0.33);
        assert_abs_diff_eq!(force, -10.0, epsilon = 1e-12);
        assert_eq!(hold.levers[edge].left, [1, 2]);
    }

    #[test]
    fn a_line_shares_its_force_between_its_ends() {
        let hold = hold(&[2, 4, 3]);
        assert!(!hold.is_area());
        assert_eq!(hold.levers.len(), 2);
        for lever in &hold.levers {
            let Arm::End { to, .. } = lever.arm else { panic!("not a line: {lever:?}") };
            // 100 N at 0.1 of 0.3 m from the touch 3.
            let share = if to == 3 { 200.0 / 3.0 } else { 100.0 / 3.0 };
            assert_abs_diff_eq!(
                lever.arm.force(&pressed(0.1, 0.1), at, &Vector3::y()),
                share,
                epsilon = 1e-12
            );
            assert_eq!(lever.left, [5 - to]);
        }
    }

    #[test]
    fn a_point_only_presses() {
        let hold = hold(&[1]);
        assert_eq!(hold.corners, [1]);
        assert_abs_diff_eq!(hold.levers[0].arm.force(&pressed(0.0, 0.3), at, &Vector3::y()), 100.0);
        assert!(hold.levers[0].left.is_empty());
        assert!(ContactPatch::new(Vec::new(), at, &Vector3::y()).is_none());
    }
}
