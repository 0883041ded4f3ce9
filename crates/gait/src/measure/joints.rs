//! Angles, moments and powers of the legs' joints and the pelvis over a walk's samples.

use super::series::{Series, angle, flexions};
use super::{JointPeaks, Peak};
use crate::body::roles::{PELVIS_ANGLES, SIDED_ANGLES};
use crate::body::{root_order, rotations};
use crate::error::{GaitError, MeasureError};
use nalgebra::Vector3;
use solaris_model::{Figure, Motion, RootOrder};

/// Joints of the leg whose moments are told, by their place in [`JointSeries::moments`].
const JOINTS: [&str; 3] = ["hip", "knee", "ankle"];

/// Series over the samples; left and right are 0 and 1, angles rad, moments N m/kg.
pub(super) struct JointSeries {
    pub(super) hip: [Vec<f64>; 2],
    pub(super) ankle: [Vec<f64>; 2],
    /// Tilt, obliquity and rotation of the pelvis.
    pub(super) pelvis: [Vec<f64>; 3],
    /// Moments of [`JOINTS`] about the axes of the distal segment (x, y, z), by side.
    pub(super) moments: [[Vec<Vector3<f64>>; 3]; 2],
    /// Powers of [`JOINTS`] (W/kg), by side.
    powers: [[Vec<f64>; 3]; 2],
}

impl JointSeries {
    pub(super) fn new(figure: &Figure, motion: &Motion) -> Result<Self, GaitError> {
        if motion.tau(0).is_none() {
            return Err(MeasureError::NothingToMeasure { what: "joint forces" }.into());
        }
        // About z, y, x in the world, whichever order the root turns in.
        let seen = root_order(figure) == RootOrder::Yzx;
        let pelvis = |axis: usize| -> Result<Vec<f64>, GaitError> {
            let name = format!("pelvis.{}", PELVIS_ANGLES[axis]);
            let Some(own) = figure.anatomical_angle(&name).filter(|_| seen) else {
                return angle(figure, motion, name);
            };
            let first = figure.layout().joints()[0].q + 3;
            let of = |q: &[f64]| {
                let [y, z, x] = [0, 1, 2].map(|k| q[first + k]);
                let turned = rotations::about_y(y) * rotations::about_z(z) * rotations::about_x(x);
                let [z, y, x] = rotations::euler(&turned);
                [x, z, y][axis]
            };
            Ok((0..motion.len()).map(|i| own.sign * of(motion.q(i))).collect())
        };
        let mass = figure.mass();
        let joint = |side: usize, joint: usize| {
            let name = format!("{}_{}", ["left", "right"][side], JOINTS[joint]);
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
            hip: flexions(figure, motion, SIDED_ANGLES[0])?,
            ankle: flexions(figure, motion, SIDED_ANGLES[2])?,
            pelvis: [pelvis(0)?, pelvis(1)?, pelvis(2)?],
            moments,
            powers,
        })
    }

    pub(super) fn peaks(&self, series: &Series<'_>) -> Vec<JointPeaks> {
        let both = |j: usize, sign: f64, f: &dyn Fn(usize, usize) -> f64| {
            let side = |side: usize| series.greatest((0..series.time.len()).map(|i| sign * f(side, i)));
            let peak = if self.moments[0][j].is_empty() { side(1) } else { side(0).max(side(1)) };
            Peak { value: sign * peak.value, ..peak }
        };
        (0..3)
            .map(|j| {
                // About x, positive moments extend the hip and point the toes down, and flex the knee.
                let extend = if JOINTS[j] == "knee" { -1.0 } else { 1.0 };
                let moment = |side: usize, i: usize| self.moments[side][j][i].x;
                let power = |side: usize, i: usize| self.powers[side][j][i];
                let positive = |peak: Peak| Peak { value: peak.value.abs(), ..peak };
                JointPeaks {
                    joint: JOINTS[j],
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
