//! The convex hull of points.

use super::Triangle;
use solaris_model::Vector3;
use std::collections::HashMap;

/// What is nearer to a plane than this, over the size of all, is on it.
const ON: f64 = 1e-10;

/// The convex hull of points, as triangles that turn to the left seen from outside.
///
/// # Source
///
/// C. B. Barber, D. P. Dobkin and H. Huhdanpaa (1996), The quickhull algorithm for convex hulls, in three dimensions and
/// without merging of facets: what is on a facet to within rounding is left out.
pub(super) fn hull(points: &[Vector3<f64>]) -> Result<Vec<Triangle>, String> {
    let mut hull = Hull::start(points).ok_or("its points lie in a plane, and enclose nothing")?;
    while let Some(face) = hull.open.pop() {
        hull.add(face).ok_or("its points are too near to each other for a convex hull")?;
    }
    let faces = hull.faces.iter().filter(|face| face.lives);
    Ok(faces.map(|face| face.corners.map(|corner| points[corner])).collect())
}

struct Face {
    corners: [usize; 3],
    normal: Vector3<f64>,
    /// Points that see it from outside.
    outside: Vec<usize>,
    lives: bool,
}

struct Hull<'p> {
    points: &'p [Vector3<f64>],
    on: f64,
    faces: Vec<Face>,
    /// The face to the left of each edge.
    edges: HashMap<(usize, usize), usize>,
    /// Faces that may have points outside.
    open: Vec<usize>,
}

impl<'p> Hull<'p> {
    /// Four points that are far from each other.
    fn start(points: &'p [Vector3<f64>]) -> Option<Self> {
        let first = points.first()?;
        let farthest = |far: &dyn Fn(&Vector3<f64>) -> f64| {
            let by = |a: &usize, b: &usize| far(&points[*a]).total_cmp(&far(&points[*b]));
            (0..points.len()).max_by(by).filter(|i| far(&points[*i]).is_finite())
        };
        let a = farthest(&|point| (point - first).norm())?;
        let b = farthest(&|point| (point - points[a]).norm())?;
        let along = points[b] - points[a];
        let on = ON * along.norm();
        let c = farthest(&|point| (point - points[a]).cross(&along).norm())?;
        let normal = along.cross(&(points[c] - points[a])).try_normalize(on * on)?;
        let d = farthest(&|point| (point - points[a]).dot(&normal).abs())?;
        let height = (points[d] - points[a]).dot(&normal);
        if height.abs() <= 1e3 * on {
            return None;
        }
        let (b, c) = if height > 0.0 { (c, b) } else { (b, c) };
        let mut hull = Self { points, on, faces: Vec::new(), edges: HashMap::new(), open: Vec::new() };
        let all: Vec<usize> = (0..points.len()).collect();
        let faces = [[a, b, c], [a, d, b], [b, d, c], [c, d, a]];
        let made: Vec<usize> = faces.into_iter().map(|corners| hull.face(corners)).collect();
        hull.share(all, &made);
        Some(hull)
    }

    fn face(&mut self, corners: [usize; 3]) -> usize {
        let [a, b, c] = corners.map(|corner| self.points[corner]);
        let normal = (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or_else(Vector3::zeros);
        let index = self.faces.len();
        let [a, b, c] = corners;
        for edge in [(a, b), (b, c), (c, a)] {
            self.edges.insert(edge, index);
        }
        self.faces.push(Face { corners, normal, outside: Vec::new(), lives: true });
        self.open.push(index);
        index
    }

    /// How far a point is above a face.
    fn height(&self, point: usize, face: usize) -> f64 {
        let Face { corners, normal, .. } = &self.faces[face];
        (self.points[point] - self.points[corners[0]]).dot(normal)
    }

    /// Gives each point to a face that it sees.
    fn share(&mut self, points: Vec<usize>, faces: &[usize]) {
        for point in points {
            if let Some(face) = faces.iter().find(|face| self.height(point, **face) > self.on) {
                self.faces[*face].outside.push(point);
            }
        }
    }

    /// Takes in the farthest point outside of a face; none where the hull is not closed any more.
    fn add(&mut self, face: usize) -> Option<()> {
        if !self.faces[face].lives {
            return Some(());
        }
        let by = |a: &usize, b: &usize| self.height(*a, face).total_cmp(&self.height(*b, face));
        let Some(point) = self.faces[face].outside.iter().copied().max_by(by) else { return Some(()) };
        let (mut seen, mut open, mut rim, mut orphans) = (vec![face], vec![face], Vec::new(), Vec::new());
        self.faces[face].lives = false;
        while let Some(face) = open.pop() {
            let [a, b, c] = self.faces[face].corners;
            for (a, b) in [(a, b), (b, c), (c, a)] {
                let across = *self.edges.get(&(b, a))?;
                if !self.faces[across].lives {
                    continue;
                }
                if self.height(point, across) > self.on {
                    self.faces[across].lives = false;
                    seen.push(across);
                    open.push(across);
                } else {
                    rim.push((a, b));
                }
            }
        }
        for face in seen {
            orphans.append(&mut self.faces[face].outside);
        }
        // A face that is seen by way of another is no rim.
        rim.retain(|(a, b)| self.edges.get(&(*b, *a)).is_some_and(|across| self.faces[*across].lives));
        orphans.retain(|orphan| *orphan != point);
        let made: Vec<usize> = rim.into_iter().map(|(a, b)| self.face([a, b, point])).collect();
        self.share(orphans, &made);
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn volume(triangles: &[Triangle]) -> f64 {
        triangles.iter().map(|[a, b, c]| a.dot(&b.cross(c)) / 6.0).sum()
    }

    #[test]
    fn what_is_inside_or_on_a_face_adds_nothing() {
        let mut points: Vec<Vector3<f64>> = (0..8_u8)
            .map(|i| Vector3::new(f64::from(i & 1), f64::from(i >> 1 & 1) * 2.0, f64::from(i >> 2) * 3.0))
            .collect();
        points.extend([
            Vector3::new(0.5, 0.5, 0.5),
            Vector3::new(0.5, 0.0, 1.0),
            Vector3::new(1.0, 2.0, 1.5),
        ]);
        let triangles = hull(&points).expect("a hull");
        assert_eq!(triangles.len(), 12);
        assert!((volume(&triangles) - 6.0).abs() < 1e-12);
    }

    /// Of many points of a sphere, nearly all of it.
    #[test]
    fn points_of_a_sphere_make_nearly_a_ball() {
        let point = |i: usize| {
            let (z, turn) = (1.0 - (2 * i + 1) as f64 / 5000.0, i as f64 * 2.399_963_229_728_653);
            let across = (1.0 - z * z).sqrt();
            Vector3::new(across * turn.cos(), across * turn.sin(), z)
        };
        let points: Vec<Vector3<f64>> = (0..5000).map(point).collect();
        let triangles = hull(&points).expect("a hull");
        // Euler: F = 2V − 4.
        assert_eq!(triangles.len(), 2 * 5000 - 4);
        let missing = 4.0 / 3.0 * std::f64::consts::PI - volume(&triangles);
        assert!((0.0..0.01).contains(&missing), "{missing}");
    }

    #[test]
    fn flat_points_have_no_hull() {
        let flat = [Vector3::zeros(), Vector3::x(), Vector3::y(), Vector3::new(1.0, 1.0, 0.0)];
        assert!(hull(&flat).is_err() && hull(&flat[..2]).is_err() && hull(&[]).is_err());
    }
}
