//! Where a walk's body and feet are over its samples, and what presses on them.

use super::Peak;
use crate::body::roles::{FEET, SIDED_ANGLES};
use crate::body::root_order;
use crate::error::{BodyError, GaitError, MeasureError};
use nalgebra::Vector3;
use solaris_dynamics::{Pose, Tree, Workspace, center_of_mass};
use solaris_model::{Figure, Motion, RootOrder};

/// Series over the samples; left and right are 0 and 1.
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
    /// Flexion (rad).
    pub(super) knee: [Vec<f64>; 2],
}

impl<'a> Series<'a> {
    pub(super) fn new(figure: &Figure, motion: &'a Motion) -> Result<Self, GaitError> {
        let track = |side: usize| {
            motion.contact(FEET[side]).ok_or(MeasureError::NothingToMeasure { what: "contacts of both feet" })
        };
        let tracks = [track(0)?, track(1)?];
        let tree = Tree::<f64>::new(figure, motion.info.gravity)?;
        let mut workspace = Workspace::new(&tree);
        let (mut com, mut poses) = (Vec::new(), Vec::new());
        let stands = |link: &usize| {
            let planted = || motion.planted.iter().any(|planted| planted.link == *link);
            !figure.links()[*link].sole().is_empty() || planted()
        };
        let soled: Vec<usize> = (0..figure.links().len()).filter(stands).collect();
        let places = (0..figure.links().len()).map(|link| soled.iter().position(|&s| s == link)).collect();
        for i in 0..motion.len() {
            com.push(center_of_mass(&tree, &mut workspace, motion.q(i))?);
            poses.extend(soled.iter().map(|&link| *workspace.pose(link)));
        }
        let first = figure.layout().joints()[0].q + 3;
        let heading = first + usize::from(root_order(figure) != RootOrder::Yzx);
        let facing = |i: usize| motion.q(i)[heading].sin_cos();
        let (mut ahead, mut way) = (0.0, 0.0);
        for (i, pair) in com.windows(2).enumerate() {
            let ((sin, cos), step) = (facing(i), pair[1] - pair[0]);
            ahead += sin * step.x + cos * step.z;
            way += step.norm();
        }
        // On the spot nobody goes backward, whatever rounding says.
        let sense = if ahead < -0.5 * way { -1.0 } else { 1.0 };
        Ok(Self {
            time: motion.time(),
            weight: figure.mass() * motion.info.gravity.norm(),
            com,
            sense,
            poses,
            places,
            posed: soled.len(),
            forces: tracks.map(|track| track.samples.iter().map(|contact| contact.force).collect()),
            cops: tracks.map(|track| track.samples.iter().map(|contact| contact.cop).collect()),
            knee: flexions(figure, motion, SIDED_ANGLES[1])?,
        })
    }

    /// A point of a link with a sole, or of one that is planted, in the world.
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
}

/// An anatomical angle (rad).
pub(super) fn angle(figure: &Figure, motion: &Motion, name: String) -> Result<Vec<f64>, GaitError> {
    let angle = figure.anatomical_angle(&name).ok_or(BodyError::MissingAngle { angle: name })?;
    Ok((0..motion.len()).map(|i| angle.sign * motion.q(i)[angle.coordinate]).collect())
}

/// The same one of the left and of the right (rad).
pub(super) fn flexions(figure: &Figure, motion: &Motion, name: &str) -> Result<[Vec<f64>; 2], GaitError> {
    Ok([angle(figure, motion, format!("left_{name}"))?, angle(figure, motion, format!("right_{name}"))?])
}
