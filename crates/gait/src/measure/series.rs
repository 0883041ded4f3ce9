//! The quantities of a walk over its samples.

use super::{JointPeaks, Peak};
use crate::body::roles::{FEET, PELVIS_ANGLES, SIDED_ANGLES};
use crate::body::{root_order, rotations};
use crate::error::{BodyError, GaitError, MeasureError};
use nalgebra::Vector3;
use solaris_dynamics::{Pose, Tree, Workspace, center_of_mass};
use solaris_model::{Figure, Motion, RootOrder};

/// Joints of the leg whose moments are told, with their anatomical flexion.
pub(super) const JOINTS: [(&str, &str); 3] =
    [("hip", "flexion"), ("knee", "flexion"), ("ankle", "dorsiflexion")];

/// Series over the samples; left and right are 0 and 1, angles rad, moments N m/kg.
pub(super) struct Series<'a> {
    pub(super) time: &'a [f64],
    /// Body weight (N).
    pub(super) weight: f64,
    pub(super) com: Vec<Vector3<f64>>,
    /// 1, or −1 where the body goes backward: the sign of its centre of mass's way along where the pelvis faces.
    pub(super) sense: f64,
    /// Poses of the links with soles, by sample.
    poses: Vec<Pose<f64>>,
    /// Place of each link among them.
    places: Vec<Option<usize>>,
    posed: usize,
    /// Force on each foot (N).
    pub(super) forces: [Vec<Vector3<f64>>; 2],
    pub(super) cops: [Vec<Vector3<f64>>; 2],
    pub(super) hip: [Vec<f64>; 2],
    pub(super) knee: [Vec<f64>; 2],
    pub(super) ankle: [Vec<f64>; 2],
    /// Tilt, obliquity and rotation of the pelvis.
    pub(super) pelvis: [Vec<f64>; 3],
    /// Moments of [`JOINTS`] about the axes of the distal segment (x, y, z), by side.
    pub(super) moments: [[Vec<Vector3<f64>>; 3]; 2],
    /// Powers of [`JOINTS`] (W/kg), by side.
    powers: [[Vec<f64>; 3]; 2],
}

impl<'a> Series<'a> {
    pub(super) fn new(figure: &Figure, motion: &'a Motion) -> Result<Self, GaitError> {
        if motion.tau(0).is_none() {
            return Err(MeasureError::NothingToMeasure { what: "joint forces" }.into());
        }
        let track = |side: usize| {
            motion.contact(FEET[side]).ok_or(MeasureError::NothingToMeasure { what: "contacts of both feet" })
        };
        let tracks = [track(0)?, track(1)?];
        let angle = |name: String| -> Result<Vec<f64>, GaitError> {
            let angle = figure.anatomical_angle(&name).ok_or(BodyError::MissingAngle { angle: name })?;
            Ok((0..motion.len()).map(|i| angle.sign * motion.q(i)[angle.coordinate]).collect())
        };
        let sided = |name: &str| -> Result<[Vec<f64>; 2], GaitError> {
            Ok([angle(format!("left_{name}"))?, angle(format!("right_{name}"))?])
        };
        // About z, y, x in the world, whichever order the root turns in.
        let seen = root_order(figure) == RootOrder::Yzx;
        let pelvis = |axis: usize| -> Result<Vec<f64>, GaitError> {
            let name = format!("pelvis.{}", PELVIS_ANGLES[axis]);
            let Some(own) = figure.anatomical_angle(&name).filter(|_| seen) else { return angle(name) };
            let first = figure.layout().joints()[0].q + 3;
            let of = |q: &[f64]| {
                let [y, z, x] = [0, 1, 2].map(|k| q[first + k]);
                let turned = rotations::about_y(y) * rotations::about_z(z) * rotations::about_x(x);
                let [z, y, x] = rotations::euler(&turned);
                [x, z, y][axis]
            };
            Ok((0..motion.len()).map(|i| own.sign * of(motion.q(i))).collect())
        };
        let tree = Tree::<f64>::new(figure, motion.info.gravity)?;
        let mut workspace = Workspace::new(&tree);
        let (mut com, mut poses) = (Vec::new(), Vec::new());
        let soled: Vec<usize> =
            (0..figure.links().len()).filter(|&link| !figure.links()[link].sole().is_empty()).collect();
        let places = (0..figure.links().len()).map(|link| soled.iter().position(|&s| s == link)).collect();
        for i in 0..motion.len() {
            com.push(center_of_mass(&tree, &mut workspace, motion.q(i))?);
            poses.extend(soled.iter().map(|&link| *workspace.pose(link)));
        }
        let first = figure.layout().joints()[0].q + 3;
        let facing = |i: usize| motion.q(i)[first + usize::from(!seen)].sin_cos();
        let (mut ahead, mut way) = (0.0, 0.0);
        for (i, pair) in com.windows(2).enumerate() {
            let ((sin, cos), step) = (facing(i), pair[1] - pair[0]);
            ahead += sin * step.x + cos * step.z;
            way += step.norm();
        }
        // On the spot nobody goes backward, whatever rounding says.
        let sense = if ahead < -0.5 * way { -1.0 } else { 1.0 };
        let mass = figure.mass();
        let joint = |side: usize, joint: usize| {
            let name = format!("{}_{}", ["left", "right"][side], JOINTS[joint].0);
            figure.joint_index(&name).map(|link| figure.layout().joints()[link].v)
        };
        let mut moments: [[Vec<Vector3<f64>>; 3]; 2] = Default::default();
        let mut powers: [[Vec<f64>; 3]; 2] = Default::default();
        for side in [0, 1] {
            for j in 0..3 {
                let Some(v) = joint(side, j) else { continue };
                for i in 0..motion.len() {
                    let Some(tau) = motion.tau(i) else { continue };
                    let rates = &motion.v(i)[v..v + 3];
                    moments[side][j].push(distal_moment(&motion.q(i)[v..v + 3], &tau[v..v + 3]) / mass);
                    powers[side][j].push((0..3).map(|k| tau[v + k] * rates[k]).sum::<f64>() / mass);
                }
            }
        }
        Ok(Self {
            time: motion.time(),
            weight: mass * motion.info.gravity.norm(),
            com,
            sense,
            poses,
            places,
            posed: soled.len(),
            forces: tracks.map(|track| track.samples.iter().map(|contact| contact.force).collect()),
            cops: tracks.map(|track| track.samples.iter().map(|contact| contact.cop).collect()),
            hip: sided(SIDED_ANGLES[0])?,
            knee: sided(SIDED_ANGLES[1])?,
            ankle: sided(SIDED_ANGLES[2])?,
            pelvis: [pelvis(0)?, pelvis(1)?, pelvis(2)?],
            moments,
            powers,
        })
    }

    /// A point of a link with a sole, in the world.
    pub(super) fn place(&self, sample: usize, link: usize, point: &Vector3<f64>) -> Option<Vector3<f64>> {
        self.places[link].map(|place| self.poses[sample * self.posed + place].transform(point))
    }

    /// The greatest value and when; the first sample's where all are NaN.
    pub(super) fn greatest(&self, values: impl Iterator<Item = f64>) -> Peak {
        let mut peak = Peak { value: f64::NEG_INFINITY, time: self.time[0] };
        for (value, &time) in values.zip(self.time) {
            if value > peak.value {
                peak = Peak { value, time };
            }
        }
        peak
    }

    pub(super) fn joint_peaks(&self) -> Vec<JointPeaks> {
        let both = |j: usize, sign: f64, f: &dyn Fn(usize, usize) -> f64| {
            let side = |side: usize| self.greatest((0..self.time.len()).map(|i| sign * f(side, i)));
            let peak = if self.moments[0][j].is_empty() { side(1) } else { side(0).max(side(1)) };
            Peak { value: sign * peak.value, ..peak }
        };
        (0..3)
            .map(|j| {
                // About x, positive moments extend the hip and point the toes down, and flex the knee.
                let extend = if JOINTS[j].0 == "knee" { -1.0 } else { 1.0 };
                let moment = |side: usize, i: usize| self.moments[side][j][i].x;
                let power = |side: usize, i: usize| self.powers[side][j][i];
                let positive = |peak: Peak| Peak { value: peak.value.abs(), ..peak };
                JointPeaks {
                    joint: JOINTS[j].0,
                    extension: positive(both(j, extend, &moment)),
                    flexion: positive(both(j, -extend, &moment)),
                    generated: both(j, 1.0, &power),
                    absorbed: both(j, -1.0, &power),
                }
            })
            .collect()
    }
}

/// The moment about the distal segment's axes, from the generalized forces of a joint Rz(a) Ry(b) Rx(c):
///
/// ```text
/// e_x = x      e_y = (0, cos c, −sin c)      e_z = (−sin b, sin c cos b, cos c cos b)      τᵢ = eᵢ·m
/// ```
fn distal_moment(q: &[f64], tau: &[f64]) -> Vector3<f64> {
    let ((sin_b, cos_b), (sin_c, cos_c)) = (q[1].sin_cos(), q[2].sin_cos());
    let (across, along) = (tau[1], (tau[0] + sin_b * tau[2]) / cos_b);
    Vector3::new(tau[2], cos_c * across + sin_c * along, -sin_c * across + cos_c * along)
}
