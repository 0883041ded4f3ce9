//! Lofts: a body that is told by its sections along an axis.

use super::{Bounds, Sample};
use nalgebra::Vector3;

/// A section across the axis: where on it, and how far the body reaches from it to +x, −x, +z, −z (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Section(pub(crate) f64, pub(crate) [f64; 4]);

/// Sections along y and what is between them; closed by half ellipsoids.
#[derive(Clone, Debug)]
pub(crate) struct Loft {
    sections: Vec<Section>,
    /// Rates of the reaches at the sections.
    slopes: Vec<[f64; 4]>,
    /// Lengths of the two ends (m).
    caps: [f64; 2],
    /// From ellipses (0) to what has flat sides (1).
    square: f64,
}

impl Loft {
    /// `sections` in the order of their places.
    pub(crate) fn new(sections: Vec<Section>, caps: [f64; 2], square: f64) -> Self {
        let slopes = (0..sections.len()).map(|i| std::array::from_fn(|c| slope(&sections, i, c))).collect();
        Self { sections, slopes, caps, square }
    }

    fn ends(&self) -> [f64; 2] {
        [self.sections[0].0, self.sections[self.sections.len() - 1].0]
    }

    /// The box around all points whose values are not above `value` (m).
    pub(super) fn within(&self, value: f64) -> Bounds {
        let least = |section: &Section| section.1.iter().copied().fold(f64::INFINITY, f64::min);
        // Between two sections reaches are between theirs.
        let most = |c: usize| {
            let of = |pair: &[Section]| {
                pair[0].1[c].max(pair[1].1[c]) * (1.0 + value / least(&pair[0]).min(least(&pair[1])))
            };
            // Flat sides do not reach farther than the axes' ends.
            self.sections.windows(2).map(of).fold(0.0, f64::max)
        };
        let [low, high] = self.ends();
        let cap = |i: usize, end: &Section| self.caps[i] * (1.0 + value / least(end));
        let (first, last) = (&self.sections[0], &self.sections[self.sections.len() - 1]);
        Bounds(
            Vector3::new(-most(1), low - cap(0, first), -most(3)),
            Vector3::new(most(0), high + cap(1, last), most(2)),
        )
    }

    /// Reaches at a place between the ends, and their rates.
    fn reaches(&self, y: f64) -> ([f64; 4], [f64; 4]) {
        let after = self.sections.partition_point(|s| s.0 < y).clamp(1, self.sections.len() - 1);
        let (a, b) = (&self.sections[after - 1], &self.sections[after]);
        let width = b.0 - a.0;
        let t = ((y - a.0) / width).clamp(0.0, 1.0);
        let (t2, t3) = (t * t, t * t * t);
        let mut values = [0.0; 4];
        let mut rates = [0.0; 4];
        for c in 0..4 {
            let (p, q) = (a.1[c], b.1[c]);
            let (m, n) = (self.slopes[after - 1][c] * width, self.slopes[after][c] * width);
            values[c] = p + (q - p) * (3.0 * t2 - 2.0 * t3) + m * (t3 - 2.0 * t2 + t) + n * (t3 - t2);
            rates[c] = ((q - p) * 6.0 * (t - t2) + m * (3.0 * t2 - 4.0 * t + 1.0) + n * (3.0 * t2 - 2.0 * t))
                / width;
        }
        (values, rates)
    }

    pub(super) fn sample(&self, p: &Vector3<f64>) -> Sample {
        let [low, high] = self.ends();
        let y = p.y.clamp(low, high);
        let (reach, rates) = self.reaches(y);
        let inside = f64::from(low < p.y && p.y < high);
        let (cx, cz) = (usize::from(p.x < 0.0), 2 + usize::from(p.z < 0.0));
        let (x, z) = (p.x / reach[cx], p.z / reach[cz]);
        let cap = if p.y < low { self.caps[0] } else { self.caps[1] };
        let e = (p.y - y) / cap;
        // The square of a norm of (x, z) between the circle's and that of the fourth power, and then that with the end's.
        let (x2, z2) = (x * x, z * z);
        let fourth = (x2 * x2 + z2 * z2).sqrt();
        let square = (1.0 - self.square) * (x2 + z2) + self.square * fourth + e * e;
        let rho = square.sqrt().max(1e-9);
        let of = |u: f64| {
            let u =
                (1.0 - self.square) * u + self.square * if fourth > 1e-18 { u * u * u / fourth } else { 0.0 };
            u / rho
        };
        let (dx, dz) = (of(x), of(z));
        let least = reach.iter().copied().fold(f64::INFINITY, f64::min);
        let slow = (0..4).find(|c| reach[*c] <= least).map_or(0.0, |c| rates[c]) * inside;
        let along =
            -(dx * x / reach[cx] * rates[cx] + dz * z / reach[cz] * rates[cz]) * inside + e / cap / rho;
        let gradient = Vector3::new(dx / reach[cx], along, dz / reach[cz]) * least;
        (least * (rho - 1.0), gradient + Vector3::y() * ((rho - 1.0) * slow))
    }
}

/// The rate at a section with which a reach neither overshoots nor has a kink: Fritsch & Butland (1984), the harmonic mean of those
/// beside it; zero at a greatest or least one.
fn slope(sections: &[Section], i: usize, c: usize) -> f64 {
    let between = |i: usize| (sections[i + 1].1[c] - sections[i].1[c]) / (sections[i + 1].0 - sections[i].0);
    if i == 0 || i + 1 == sections.len() {
        return 0.0;
    }
    let (a, b) = (between(i - 1), between(i));
    if a * b <= 0.0 { 0.0 } else { 2.0 * a * b / (a + b) }
}
