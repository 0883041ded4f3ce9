//! Force plates: from channels to force, centre of pressure and free moment.

use solaris_model::{Matrix3, Vector3};

/// A force plate: where it lies, and what its channels said.
///
/// Its own axes are those of its corners c₁…c₄, in the laboratory's axes: x from c₂ to c₁, y from c₄ to c₁, z = x × y, about the
/// middle of the four.
#[derive(Clone, Debug)]
pub struct Plate {
    /// Its number in the file, from 1.
    pub number: usize,
    /// What its channels mean.
    pub kind: PlateKind,
    /// Its corners (m, laboratory axes), in the order of the file.
    pub corners: [Vector3<f64>; 4],
    /// Where the sensors' origin is (m, plate axes) from the middle of the surface; of type 3 half the sensors' distances.
    pub origin: Vector3<f64>,
    /// Samples a second (Hz). The first is at the time of the first frame.
    pub rate: f64,
    /// What the channels say in N and N·m (of type 1 also m), channel by channel; of type 4 what they say before `matrix`.
    pub channels: Vec<Vec<f64>>,
    /// The calibration of type 4: force (N) and moment (N·m) of the six channels, row by row.
    pub matrix: Option<[[f64; 6]; 6]>,
    /// Kistler's polynomials of the centre of pressure along x and y (type 3, in metres), where the file has them.
    pub polynomials: Option<[[f64; 6]; 2]>,
    /// The samples in which the plate was empty, if the file names some.
    pub baseline: Option<std::ops::Range<usize>>,
    /// Whether the channels hold what the subject does to the plate, so that loads are the opposite of them.
    pub is_opposite: bool,
}

/// What the channels of a plate mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PlateKind {
    /// Fx Fy Fz, centre of pressure x y, free moment (type 1).
    Pressure,
    /// Fx Fy Fz Mx My Mz (type 2: AMTI, Bertec).
    Wrench,
    /// Fx12 Fx34 Fy14 Fy23 Fz1 Fz2 Fz3 Fz4 (type 3: Kistler).
    Corners,
    /// Fx Fy Fz Mx My Mz through a 6 × 6 matrix (type 4).
    Matrix,
}

impl PlateKind {
    /// The number by which C3D files call it.
    pub fn number(self) -> u8 {
        match self {
            Self::Pressure => 1,
            Self::Wrench => 2,
            Self::Corners => 3,
            Self::Matrix => 4,
        }
    }
}

/// How loads are found of channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadOptions {
    /// Below this force along the plate's normal (N) nothing is taken to act: there is noise and no centre of pressure.
    pub least_force: f64,
    /// Whether the mean of [`Plate::baseline`] is taken off first.
    pub subtract_baseline: bool,
}

impl Default for LoadOptions {
    /// At least 20 N, no baseline.
    fn default() -> Self {
        Self { least_force: 20.0, subtract_baseline: false }
    }
}

/// What acts on the subject through a plate at a time (laboratory axes).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// The force (N), at the centre of pressure.
    pub force: Vector3<f64>,
    /// The centre of pressure (m); none where the plate is not loaded.
    pub centre: Option<Vector3<f64>>,
    /// The moment about the plate's normal through the centre of pressure (N·m).
    pub free_moment: Vector3<f64>,
}

impl Load {
    fn is_finite(&self) -> bool {
        let parts = [self.force, self.centre.unwrap_or_default(), self.free_moment];
        parts.iter().all(|part| part.iter().all(|x| x.is_finite()))
    }

    /// Nothing.
    pub const NONE: Self =
        Self { force: Vector3::new(0.0, 0.0, 0.0), centre: None, free_moment: Vector3::new(0.0, 0.0, 0.0) };
}

impl Plate {
    /// How many samples there are.
    pub fn len(&self) -> usize {
        self.channels.iter().map(Vec::len).min().unwrap_or(0)
    }

    /// Whether there is no sample.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The middle of the surface (m, laboratory axes).
    pub fn middle(&self) -> Vector3<f64> {
        self.corners.iter().sum::<Vector3<f64>>() / 4.0
    }

    /// The plate's axes in the laboratory's, column by column; `None` where the corners span no surface.
    ///
    /// ```text
    /// x ∝ c₁ − c₂,   z ∝ x × (c₁ − c₄),   y = z × x
    /// ```
    pub fn axes(&self) -> Option<Matrix3<f64>> {
        let [first, second, _, fourth] = self.corners;
        let x = (first - second).try_normalize(1e-9)?;
        let z = x.cross(&(first - fourth)).try_normalize(1e-9)?;
        Some(Matrix3::from_columns(&[x, z.cross(&x), z]))
    }

    /// What acts on the subject in each sample.
    ///
    /// They are what the file holds: the plate on the subject in most, the other way round in some
    /// ([`Recording::turned`](super::Recording::turned) tells by which way is up).
    ///
    /// # Source
    ///
    /// The C3D file format user guide (Motion Lab Systems), "Force platform"; Kistler's formulas for the eight channels and
    /// the polynomials. As ezc3d, `CAL_MATRIX` counts for type 4 alone. Differs from it: the free moment is about the normal
    /// alone, and an unloaded plate has no load. So has a sample with a channel that is no number, or forces beyond all numbers.
    pub fn loads(&self, options: &LoadOptions) -> Vec<Load> {
        let Some(axes) = self.axes() else { return vec![Load::NONE; self.len()] };
        let middle = self.middle();
        let sign = if self.is_opposite { -1.0 } else { 1.0 };
        let offsets = self.offsets(options.subtract_baseline);
        let mut sample = vec![0.0; self.channels.len()];
        (0..self.len())
            .map(|at| {
                for (value, (channel, offset)) in sample.iter_mut().zip(self.channels.iter().zip(&offsets)) {
                    *value = channel[at] - offset;
                }
                let Some(local) = self.local(&sample, options.least_force) else { return Load::NONE };
                let load = Load {
                    force: axes * local.force * sign,
                    centre: local.centre.map(|centre| axes * centre + middle),
                    free_moment: axes * local.free_moment * sign,
                };
                if load.is_finite() { load } else { Load::NONE }
            })
            .collect()
    }

    /// The mean force (N, laboratory axes) over the samples in which the plate is loaded, and their share.
    pub fn mean_force(&self, options: &LoadOptions) -> (Vector3<f64>, f64) {
        let loads = self.loads(options);
        let loaded: Vec<_> =
            loads.iter().filter(|load| load.centre.is_some()).map(|load| load.force).collect();
        let count = loaded.len() as f64;
        (loaded.iter().sum::<Vector3<f64>>() / count.max(1.0), count / (loads.len() as f64).max(1.0))
    }

    /// What each channel shows of an empty plate.
    fn offsets(&self, subtract: bool) -> Vec<f64> {
        let range =
            self.baseline.clone().filter(|range| subtract && range.end <= self.len() && !range.is_empty());
        let mean = |channel: &Vec<f64>| {
            let range = range.clone()?;
            let count = range.len() as f64;
            Some(channel[range].iter().sum::<f64>() / count)
        };
        self.channels.iter().map(|channel| mean(channel).unwrap_or(0.0)).collect()
    }

    /// The load of a sample along the plate's axes, about the middle of its surface; `None` below `least` (N).
    fn local(&self, c: &[f64], least: f64) -> Option<Load> {
        if !c.iter().all(|value| value.is_finite()) {
            return None;
        }
        let o = self.origin;
        let (force, moment) = match self.kind {
            PlateKind::Pressure => {
                let force = Vector3::new(c[0], c[1], c[2]);
                let centre = Some(Vector3::new(c[3], c[4], 0.0));
                let free_moment = Vector3::new(0.0, 0.0, c[5]);
                return (force.z.abs() >= least).then_some(Load { force, centre, free_moment });
            }
            PlateKind::Wrench => (Vector3::new(c[0], c[1], c[2]), Vector3::new(c[3], c[4], c[5])),
            PlateKind::Matrix => {
                let matrix = self.matrix.as_ref()?;
                let row = |i: usize| (0..6).map(|j| matrix[i][j] * c[j]).sum::<f64>();
                (Vector3::new(row(0), row(1), row(2)), Vector3::new(row(3), row(4), row(5)))
            }
            PlateKind::Corners => (
                Vector3::new(c[0] + c[1], c[2] + c[3], c[4] + c[5] + c[6] + c[7]),
                Vector3::new(
                    o.y * (c[4] + c[5] - c[6] - c[7]),
                    o.x * (c[5] + c[6] - c[4] - c[7]),
                    o.y * (c[1] - c[0]) + o.x * (c[2] - c[3]),
                ),
            ),
        };
        // From the sensors' origin to the middle of the surface.
        let arm = if self.kind == PlateKind::Corners { Vector3::new(0.0, 0.0, o.z) } else { o };
        let moment = moment + force.cross(&arm);
        if force.z.abs() < least.max(f64::MIN_POSITIVE) {
            return None;
        }
        let mut centre = Vector3::new(-moment.y / force.z, moment.x / force.z, 0.0);
        if let Some([of_x, of_y]) = self.polynomials.as_ref().filter(|_| self.kind == PlateKind::Corners) {
            let (x, y) = (centre.x, centre.y);
            centre.x -= polynomial(of_x, x, y);
            centre.y -= polynomial(of_y, y, x);
        }
        let free = (moment - centre.cross(&force)).z;
        Some(Load { force, centre: Some(centre), free_moment: Vector3::new(0.0, 0.0, free) })
    }
}

/// Kistler's correction of a coordinate `a` of the centre of pressure, of which `b` is the other.
///
/// ```text
/// Δa = (p₁b⁴ + p₂b² + p₃)a³ + (p₄b⁴ + p₅b² + p₆)a
/// ```
fn polynomial(p: &[f64; 6], a: f64, b: f64) -> f64 {
    let square = b * b;
    let cubic = (p[0] * square + p[1]) * square + p[2];
    let linear = (p[3] * square + p[4]) * square + p[5];
    (cubic * a * a + linear) * a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sample_that_is_no_number_is_no_load() {
        let corner = |x: f64, y: f64| Vector3::new(x, y, 0.0);
        let plate = Plate {
            number: 1,
            kind: PlateKind::Wrench,
            corners: [corner(0.5, 0.5), corner(-0.5, 0.5), corner(-0.5, -0.5), corner(0.5, -0.5)],
            origin: Vector3::zeros(),
            rate: 1000.0,
            channels: [[0.0; 3], [0.0; 3], [500.0, f64::NAN, f64::INFINITY], [0.0; 3], [0.0; 3], [0.0; 3]]
                .map(|channel| channel.to_vec())
                .to_vec(),
            matrix: None,
            polynomials: None,
            baseline: None,
            is_opposite: false,
        };
        let loads = plate.loads(&LoadOptions::default());
        assert!((loads[0].force.norm() - 500.0).abs() < 1e-12);
        assert_eq!(loads[1..], [Load::NONE; 2]);
    }
}
