//! Somebody and a seat: from what the laws say to a posture.

use super::laws::{At, Hips};
use crate::body::Body;
use crate::body::foot::{FootPlane, mirror};
use crate::body::posture::{ArmCarriage, Posture};
use crate::body::rotations::{self, Euler};
use crate::error::GaitError;
use crate::limbs::stance::{Landing, Stance};
use crate::smooth::laws::{self, Swings};
use crate::smooth::{Standing, standing_style};
use nalgebra::Vector3;
use solaris_model::Figure;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Height of the hip joints over the seat that bears, and how far behind them it is pressed, below the pelvis' bones, as parts of the standing height.
const HIP_OVER_SEAT: f64 = 0.05;
const BEHIND_HIPS: f64 = 0.02;
/// From the hips to the seat's front edge, as a part of the thigh, how far that is behind the heels at least and how deep the seat is, as parts of
/// the standing height.
const EDGE: f64 = 0.45;
const BEHIND_HEELS: f64 = 0.01;
const DEPTH: f64 = 0.24;
/// Tilt of the pelvis in sitting, backward.
const SLUMP: f64 = 10.0 * DEGREE;
/// How far pelvis, abdomen, thorax, neck and head go with the lean of the trunk.
const WITH_TRUNK: [f64; 5] = [0.75, 0.875, 1.0, 0.6, 0.3];
/// Flexion of shoulders and elbows in sitting, and how far the arms hang down from a trunk that leans.
const SHOULDER: f64 = 12.0 * DEGREE;
const ELBOW: f64 = 56.0 * DEGREE;
const HANGING: f64 = 0.7;
/// Forward angle of thighs on which hands rest so, and by how much more elbows bend over thighs that are turned up farther and as the trunk comes down to
/// them, as parts of that.
const RESTED_ON: f64 = 83.0 * DEGREE;
const OVER_THIGHS: f64 = 1.0;
const UNDER_TRUNK: f64 = 0.35;

/// Somebody whose feet stand before a seat, the heels at z = 0. In standing it is as before a walk at people's pace.
#[derive(Clone, Debug)]
pub(super) struct Sitter {
    pub(super) body: Body,
    /// Height of the seat (m).
    pub(super) seat: f64,
    /// Hips, trunk and arms in standing.
    pub(super) standing: Hips,
    trunk: [Euler; 5],
    arms: [[f64; 2]; 2],
    carriage: ArmCarriage,
    plane: FootPlane,
    /// Ankles (m), the right one mirrored.
    ankles: [Vector3<f64>; 2],
}

impl Sitter {
    /// Of a figure, `seat` m over the ground.
    pub(super) fn new(figure: &Figure, body: Body, seat: f64) -> Result<Self, GaitError> {
        let style = standing_style(figure, &body)?;
        let trunk = laws::trunk(&style, 0.0, Swings::NONE);
        let stances = body.sides.map(|leg| Stance::new(&leg, &style.footing(), Landing::Flat, style.push()));
        let middle =
            Standing::new(&body, &style, 0.0).pelvis + rotations::matrix(trunk[0]) * between_hips(&body);
        Ok(Self {
            seat,
            standing: Hips { height: middle.y, along: middle.z },
            trunk,
            arms: laws::arms(&style, 0.0, Swings::NONE),
            carriage: style.manner.carriage(),
            plane: stances[0].plane,
            ankles: stances.map(|stance| stance.flat_ankle()),
            body,
        })
    }

    /// A length of somebody of 1.75 m, as this one has it.
    pub(super) fn scaled(&self, length: f64) -> f64 {
        length * self.body.height / 1.75
    }

    /// The hips in sitting, for shanks that lean forward by so much (rad): the thighs lie from the knees to the seat.
    pub(super) fn seated(&self, shank: f64) -> Hips {
        let leg = &self.body.leg;
        let height = self.seat + HIP_OVER_SEAT * self.body.height;
        let knee = leg.ankle_height + leg.shank * shank.cos();
        let back = (leg.thigh.powi(2) - (knee - height).powi(2)).max(0.0).sqrt();
        Hips { height, along: leg.heel_behind + leg.shank * shank.sin() - back }
    }

    /// By how much (m) hips are farther from the ankles than in standing.
    pub(super) fn too_far(&self, hips: &Hips) -> f64 {
        let away = |hips: &Hips| (hips.height - self.ankles[0].y).hypot(hips.along - self.ankles[0].z);
        (away(hips) - away(&self.standing)).max(0.0)
    }

    /// Where the seat is pressed along z (m), of somebody whose hips are so in sitting.
    pub(super) fn on_seat(&self, seated: &Hips) -> f64 {
        seated.along - BEHIND_HIPS * self.body.height
    }

    /// The seat's back and front edge along z (m).
    pub(super) fn edges(&self, seated: &Hips) -> [f64; 2] {
        let front = (seated.along + EDGE * self.body.leg.thigh).min(-BEHIND_HEELS * self.body.height);
        [front - DEPTH * self.body.height, front]
    }

    /// Where both feet's soles are along z at a part of their length from the heel (m).
    pub(super) fn sole(&self, part: f64) -> f64 {
        self.foot(part)[0].z
    }

    /// The part of the feet's length from the heel that is at a place along z (m).
    pub(super) fn part_of_sole(&self, z: f64) -> f64 {
        let [heel, tip] = [0.0, 1.0].map(|part| self.sole(part));
        (z - heel) / (tip - heel)
    }

    /// The place of each sole at a part of its length from the heel (m).
    pub(super) fn foot(&self, part: f64) -> [Vector3<f64>; 2] {
        [0, 1].map(|side| {
            let leg = &self.body.sides[side];
            let along = part * leg.foot_length() - leg.heel_behind;
            let at = self.ankles[side] - Vector3::y() * leg.ankle_height + self.plane.forward * along;
            if side == 0 { at } else { mirror(&at) }
        })
    }

    /// Writes the coordinates of the posture that the laws ask for.
    pub(super) fn write(&self, at: &At, q: &mut [f64]) {
        let seated = 1.0 - at.risen;
        let trunk = std::array::from_fn(|i| {
            let [z, y, x] = self.trunk[i].map(|angle| angle * at.risen);
            let slump = if i == 0 {
                SLUMP
            } else if i == 1 {
                0.5 * SLUMP
            } else {
                0.0
            };
            [z, y, x + WITH_TRUNK[i] * at.lean - slump * seated]
        });
        let turned = rotations::matrix(trunk[0]);
        let middle = Vector3::new(0.0, at.hips.height, at.hips.along);
        let mut pelvis = middle - turned * between_hips(&self.body);
        // As in standing, where it hangs to one side, too.
        pelvis.x = 0.0;
        let legs = [0, 1].map(|side| {
            let hip = pelvis + turned * self.body.legs[side][0].offset;
            let hip = if side == 0 { hip } else { mirror(&hip) };
            self.plane.pose(&self.body.sides[side], &(hip - self.ankles[side]), 0.0, 0.0)
        });
        let thighs = 0.5 * (legs[0].thigh + legs[1].thigh);
        let elbow = ELBOW + OVER_THIGHS * (thighs - RESTED_ON) + UNDER_TRUNK * at.lean;
        let arms = self.arms.map(|[shoulder, standing]| {
            [
                shoulder * at.risen - SHOULDER * seated - HANGING * at.lean,
                standing * at.risen - elbow * seated,
            ]
        });
        let (carriage, feet) = (self.carriage, [0.0; 2]);
        let posture = Posture { pelvis, trunk, arms, cane: [0.0; 2], carriage, legs, heading: 0.0, feet };
        posture.write(&self.body, &self.plane, q);
    }
}

/// The middle between the hips in the pelvis' frame (m).
fn between_hips(body: &Body) -> Vector3<f64> {
    (body.legs[0][0].offset + body.legs[1][0].offset) * 0.5
}
