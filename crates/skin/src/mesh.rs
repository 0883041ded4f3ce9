//! The mesh that all skins are.

use nalgebra::{Isometry3, Point3, Vector3};

/// How much a vertex goes with a link.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Influence {
    /// Index of the link.
    pub link: u16,
    /// Share, from 0 to 1.
    pub share: f32,
}

/// A surface that moves with the links of a figure.
///
/// Where the links are at `places`, a vertex is at the sum of `share · places[link] · bind[link]⁻¹ · point` over its influences (linear
/// blend skinning, as all animation programs have it).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skin {
    /// Vertices (m), in the world of [`Skin::bind`].
    pub points: Vec<Vector3<f64>>,
    /// Unit vectors outwards, one a vertex.
    pub normals: Vec<Vector3<f64>>,
    /// Place of each vertex in the palette, see [`crate::PALETTE`].
    pub colours: Vec<f32>,
    /// What each vertex goes with, the greatest share first; shares are 1 together, and 0 where there are fewer.
    pub influences: Vec<[Influence; 4]>,
    /// Indices of vertices, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Where the links are when the vertices are at [`Skin::points`].
    pub bind: Vec<Isometry3<f64>>,
}

impl Skin {
    /// What it holds (m³), if it is closed.
    pub fn volume(&self) -> f64 {
        volume(&self.points, &self.triangles)
    }

    /// The vertices (m) where the links are at `places`.
    pub fn posed(&self, places: &[Isometry3<f64>]) -> Vec<Vector3<f64>> {
        let moves: Vec<_> =
            places.iter().zip(&self.bind).map(|(place, bind)| place * bind.inverse()).collect();
        let posed = |(point, influences): (&Vector3<f64>, &[Influence; 4])| {
            let of =
                |i: &Influence| (moves[i.link as usize] * Point3::from(*point)).coords * f64::from(i.share);
            influences.iter().filter(|i| i.share > 0.0).map(of).sum()
        };
        self.points.iter().zip(&self.influences).map(posed).collect()
    }
}

impl Skin {
    /// The skin as it is where the links are at `places`, made anew for that pose. Where several links share a vertex it is no
    /// longer moved as before, for a blend of blends is another one.
    pub fn rebound(mut self, places: &[Isometry3<f64>]) -> Self {
        self.points = self.posed(places);
        let turns: Vec<_> =
            places.iter().zip(&self.bind).map(|(p, b)| p.rotation * b.rotation.inverse()).collect();
        for (normal, influences) in self.normals.iter_mut().zip(&self.influences) {
            let of = |i: &Influence| turns[i.link as usize] * *normal * f64::from(i.share);
            let turned: Vector3<f64> = influences.iter().filter(|i| i.share > 0.0).map(of).sum();
            *normal = turned.try_normalize(1e-9).unwrap_or(*normal);
        }
        self.bind = places.to_vec();
        self
    }
}

/// What a closed surface holds (m³): a sixth of the sum of its triangles' triple products.
pub(crate) fn volume(points: &[Vector3<f64>], triangles: &[[u32; 3]]) -> f64 {
    let of = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| points[i as usize]);
        a.dot(&b.cross(&c))
    };
    triangles.iter().map(of).sum::<f64>() / 6.0
}
