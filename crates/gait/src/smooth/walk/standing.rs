//! The posture in which a walk begins and ends.

use super::numbers::{KNEE_STANDING, STANDING_AHEAD};
use crate::body::Body;
use crate::body::rotations;
use crate::grid::{Ends, Grid};
use crate::limbs::stance::{Landing, Stance};
use crate::momentum::MomentumKernel;
use crate::momentum::upper::UpperBody;
use crate::smooth::laws::{self, Swings};
use crate::smooth::style::Style;
use nalgebra::Vector3;

/// Pelvis and centre of mass when standing with both heels at z = 0 (m).
#[derive(Clone, Copy, Debug)]
pub(super) struct Standing {
    pub(super) pelvis: Vector3<f64>,
    pub(super) com: Vector3<f64>,
}

impl Standing {
    /// Knees slightly bent, trunk and arms at their means, the centre of mass a little ahead of the ankles: a few passes
    /// of raising the pelvis to the knees and shifting it under the centre of mass.
    pub(super) fn new(body: &Body, style: &Style) -> Self {
        let leg = &body.leg;
        let ahead = leg.heel_behind + STANDING_AHEAD * body.scale();
        let grid = Grid { count: 1, step: 1.0, ends: Ends::Resting };
        let (trunk, arms) = (laws::trunk(style, 0.0, Swings::NONE), laws::arms(style, 0.0, Swings::NONE));
        let upper = UpperBody::new(body, &grid, style.manner.carriage(), |_| (trunk, arms, 0.0));
        let hip_offset = rotations::matrix(trunk[0]) * leg.hip;
        let stance = Stance::new(leg, &style.footing(), Landing::Flat, style.push());
        let ankle = stance.flat_ankle();
        let mut kernel = MomentumKernel::new(body, &grid, &upper, stance.plane, |_, _| 0.0, |_, _| 0.0);
        let mut pelvis = Vector3::new(0.0, 0.95 * leg.length(), ahead);
        let mut com = pelvis;
        for _ in 0..25 {
            let hip = pelvis + hip_offset;
            let level =
                leg.reach_squared(KNEE_STANDING) - (hip.x - ankle.x).powi(2) - (hip.z - ankle.z).powi(2);
            pelvis.y += ankle.y + level.max(0.0).sqrt() - hip.y;
            let pose = stance.pose(0.0, &(pelvis + hip_offset));
            com = pelvis + kernel.momentum(&upper, |_| [pose; 2]).com[0];
            pelvis.z += ahead - com.z;
        }
        Self { pelvis, com }
    }
}
