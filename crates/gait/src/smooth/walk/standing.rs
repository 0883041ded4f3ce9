//! The posture in which a walk begins and ends.

use super::numbers::{KNEE_BY_SLOPE, KNEE_STANDING, STANDING_AHEAD};
use crate::body::Body;
use crate::body::Cane;
use crate::body::foot::mirror;
use crate::body::rotations;
use crate::grid::{Ends, Grid};
use crate::limbs::stance::{Footing, Landing, Stance};
use crate::momentum::MomentumKernel;
use crate::momentum::upper::UpperBody;
use crate::smooth::laws::{self, Swings};
use crate::smooth::style::Style;
use nalgebra::Vector3;

/// How far ahead of the shoulder the tip of a cane stands then (m, of somebody of the reference height).
const CANE_AHEAD: f64 = 0.10;

/// Flexion of the knees when standing on ground of this pitch (rad).
pub(super) fn knee_standing(tilt: f64) -> f64 {
    KNEE_STANDING + KNEE_BY_SLOPE * tilt.abs()
}

/// Pelvis and centre of mass when standing with both heels at z = 0 (m).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Standing {
    pub(crate) pelvis: Vector3<f64>,
    pub(crate) com: Vector3<f64>,
    /// Where the tip of a cane stands.
    pub(crate) cane: Option<Vector3<f64>>,
}

impl Standing {
    /// Knees slightly bent, trunk and arms at their means, the centre of mass a little ahead of the ankles: a few passes
    /// of raising the pelvis to the knees and shifting it under the centre of mass.
    ///
    /// The ground rises by `tilt` (rad) along z.
    pub(crate) fn new(body: &Body, style: &Style, tilt: f64) -> Self {
        let leg = &body.leg;
        let grid = Grid { count: 1, step: 1.0, ends: Ends::Resting };
        let (trunk, mut arms) = (laws::trunk(style, 0.0, Swings::NONE), laws::arms(style, 0.0, Swings::NONE));
        let carriage = style.manner.carriage();
        let mut upper = UpperBody::new(body, &grid, |_| carriage, |_| (trunk, arms, 0.0));
        // The right side as its mirror image.
        let seen = |side: usize, v: &Vector3<f64>| if side == 0 { *v } else { mirror(v) };
        let turn = rotations::matrix(trunk[0]);
        let offsets = [0, 1].map(|side| seen(side, &(turn * body.legs[side][0].offset)));
        let footing = Footing { tilt, ..style.footing() };
        let stances = body.sides.map(|leg| Stance::new(&leg, &footing, Landing::Flat, style.push()));
        let ankle = stances[0].flat_ankle();
        // Heels behind the ankles as on level ground, which lean with a slope.
        let (sin, cos) = tilt.sin_cos();
        let ankles = leg.heel_behind * cos - leg.ankle_height * sin;
        let ahead = ankles + STANDING_AHEAD * body.scale();
        let mut kernel = MomentumKernel::new(body, &grid, &upper, stances[0].plane, |_, _| 0.0, |_, _| tilt);
        let mut pelvis = Vector3::new(0.0, 0.95 * leg.length(), ahead);
        let mut com = pelvis;
        let mut cane = None;
        for _ in 0..25 {
            // As high as the leg allows that holds its hip lower.
            let [left, right] = [0, 1].map(|side| {
                let hip = seen(side, &pelvis) + offsets[side];
                let level = body.sides[side].reach_squared(knee_standing(tilt))
                    - (hip.x - ankle.x).powi(2)
                    - (hip.z - ankle.z).powi(2);
                ankle.y + level.max(0.0).sqrt() - hip.y
            });
            pelvis.y += left.min(right);
            if let Some(held) = &body.cane {
                let shoulder = held.shoulder(body, &trunk);
                let outward = Cane::outward(&carriage, pelvis.y + shoulder.y);
                let outward = if held.side == 0 { outward } else { -outward };
                let ahead = CANE_AHEAD * body.scale();
                let tip = Vector3::new(shoulder.x + outward, -pelvis.y, shoulder.z + ahead);
                let hold = held.hold(body, &trunk, &carriage, &tip);
                arms[held.side] = hold.arm;
                upper = UpperBody::holding(body, &grid, |_| carriage, |_| (trunk, arms, 0.0), |_| hold.cane);
                cane = Some(tip);
            }
            let poses = [0, 1].map(|side| stances[side].pose(0.0, &(seen(side, &pelvis) + offsets[side])));
            com = pelvis + kernel.momentum(&upper, |_| poses).com[0];
            pelvis.z += ahead - com.z;
        }
        let cane = cane.map(|tip| Vector3::new(tip.x + pelvis.x, 0.0, tip.z + pelvis.z));
        Self { pelvis, com, cane }
    }
}
