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

/// A bone that a body has and the figure has not: a finger's, an eye. It goes with a link as long as nobody turns it.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// `left_index_1` (the one next to the palm; of a thumb the metacarpal), `right_eye`.
    pub name: String,
    /// Index of the link that it is a part of.
    pub link: usize,
    /// The part that it goes on from, an index of [`Skin::parts`]; none where it hangs on the link itself.
    pub parent: Option<usize>,
    /// Where its joint is in the link's frame (m).
    pub at: Vector3<f64>,
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
    /// Bones beyond the figure's links: fingers and eyes of a person. Parents come before children.
    pub parts: Vec<Part>,
    /// For who has bones for the parts: the vertices that go with some, in place of their [`Skin::influences`]. Parts are counted on from
    /// the links: index `bind.len() + i` is `parts[i]`.
    pub fine: Vec<(u32, [Influence; 4])>,
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
