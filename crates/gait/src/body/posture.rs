//! A whole posture, from pelvis, trunk, arms and legs to the figure's coordinates.

use super::foot::{FootPlane, mirror, mirror_rotation};
use super::leg::LegPose;
use super::rotations::{self, Euler};
use super::segments::{Body, Segment};
use nalgebra::{Matrix3, Vector3};
use solaris_model::RootOrder;

/// Rotation of the hand about x (rad): the fingers a little forward.
const HAND_FLEXION: f64 = -0.08;

/// How upper arms hang (rad).
#[derive(Clone, Copy, Debug)]
pub(crate) struct ArmCarriage {
    /// Outward against the thorax.
    pub(crate) abduction: f64,
    /// Inward about the arm's own length, so that a bent forearm points across the body.
    pub(crate) inward: f64,
    /// How far the shoulder girdle turns about the vertical with the arm, as a part of the shoulder's angle.
    pub(crate) clavicle: f64,
    /// How far the hand swings on, as a part of the elbow's angle.
    pub(crate) wrist: f64,
    /// By how much the thorax leans to the right (rad): both arms hang as if it did not.
    pub(crate) lean: f64,
}

impl ArmCarriage {
    /// Of people who walk: 6° outward.
    pub(crate) const WALKING: Self = Self {
        abduction: 6.0 * std::f64::consts::PI / 180.0,
        inward: 0.0,
        clavicle: 0.0,
        wrist: 0.0,
        lean: 0.0,
    };

    /// Between this one and another one: `part` of the way.
    pub(crate) fn mixed(&self, other: &Self, part: f64) -> Self {
        let mix = |a: f64, b: f64| a + (b - a) * part;
        Self {
            abduction: mix(self.abduction, other.abduction),
            inward: mix(self.inward, other.inward),
            clavicle: mix(self.clavicle, other.clavicle),
            wrist: mix(self.wrist, other.wrist),
            lean: mix(self.lean, other.lean),
        }
    }

    /// Angle of a clavicle about the vertical against the thorax, forward with the arm.
    pub(crate) fn girdle(&self, side: usize, shoulder: f64) -> f64 {
        let forward = -self.clavicle * shoulder;
        if side == 0 { -forward } else { forward }
    }

    /// Angle of a hand about x.
    pub(crate) fn hand(&self, elbow: f64) -> f64 {
        HAND_FLEXION + self.wrist * elbow
    }

    /// Rotation of an upper arm (left 0, right 1) against the thorax, for the shoulder's angle s: `Rz(±a) Rx(s) Ry(∓i)`.
    pub(crate) fn rotation(&self, side: usize, shoulder: f64) -> Matrix3<f64> {
        let [abduction, inward] = self.sided(side);
        rotations::about_z(abduction) * rotations::about_x(shoulder) * rotations::about_y(-inward)
    }

    /// Rotations of clavicle, upper arm, forearm and hand, for that of the thorax and the angles of shoulder and elbow.
    pub(crate) fn chain(
        &self,
        side: usize,
        thorax: &Matrix3<f64>,
        [shoulder, elbow]: [f64; 2],
    ) -> [Matrix3<f64>; 4] {
        let clavicle = thorax * rotations::about_y(self.girdle(side, shoulder));
        let upper = clavicle * self.rotation(side, shoulder);
        let forearm = upper * rotations::about_x(elbow);
        [clavicle, upper, forearm, forearm * rotations::about_x(self.hand(elbow))]
    }

    /// The same by its three angles.
    fn angles(&self, side: usize, shoulder: f64) -> Euler {
        let [abduction, inward] = self.sided(side);
        if inward == 0.0 {
            return [abduction, 0.0, shoulder];
        }
        rotations::euler(&self.rotation(side, shoulder))
    }

    fn sided(&self, side: usize) -> [f64; 2] {
        let sign = if side == 0 { 1.0 } else { -1.0 };
        [sign * self.abduction - self.lean, sign * self.inward]
    }
}

/// A whole posture: where the pelvis is, how trunk and arms are turned, and both legs' poses (left, right).
pub(crate) struct Posture {
    pub(crate) pelvis: Vector3<f64>,
    pub(crate) trunk: [Euler; 5],
    pub(crate) arms: [[f64; 2]; 2],
    /// How a cane is turned in the fist, to the side and forward, if a hand holds one (rad).
    pub(crate) cane: [f64; 2],
    pub(crate) carriage: ArmCarriage,
    pub(crate) legs: [LegPose; 2],
    /// Which way the body faces, and each foot against it (rad, to the left).
    pub(crate) heading: f64,
    pub(crate) feet: [f64; 2],
}

impl Posture {
    /// The mirror image in the body's middle plane. Each leg's pose is one of a left leg, whichever side it is on.
    pub(crate) fn mirrored(self) -> Self {
        let ([left_arm, right_arm], [left_leg, right_leg]) = (self.arms, self.legs);
        Self {
            pelvis: mirror(&self.pelvis),
            trunk: self.trunk.map(|[z, y, x]| [-z, -y, x]),
            arms: [right_arm, left_arm],
            cane: [-self.cane[0], self.cane[1]],
            carriage: ArmCarriage { lean: -self.carriage.lean, ..self.carriage },
            legs: [right_leg, left_leg],
            heading: -self.heading,
            feet: [-self.feet[1], -self.feet[0]],
        }
    }

    /// Writes the figure's coordinates to `q` (length `nq`).
    pub(crate) fn write(&self, body: &Body, plane: &FootPlane, q: &mut [f64]) {
        let root = self.pelvis - body.middle[0].offset;
        q[body.root..body.root + 3].copy_from_slice(root.as_slice());
        if let Some(cane) = &body.cane {
            q[cane.segment.q..cane.segment.q + 2].copy_from_slice(&self.cane);
        }
        let mut set = |segment: &Segment, angles: Euler| q[segment.q..segment.q + 3].copy_from_slice(&angles);
        let rotations = self.trunk.map(rotations::matrix);
        let facing = match body.root_order {
            // The heading is outermost, and goes on past a whole turn: R = Ry(h)·Ry(a) Rz(b) Rx(c).
            RootOrder::Yzx => {
                let [y, z, x] = rotations::heading_first(&rotations[0]);
                [self.heading + y, z, x]
            }
            RootOrder::Zyx if self.heading == 0.0 => self.trunk[0],
            RootOrder::Zyx => rotations::euler(&(rotations::about_y(self.heading) * rotations[0])),
        };
        set(&body.middle[0], facing);
        for i in 1..5 {
            set(&body.middle[i], rotations::euler(&(rotations[i - 1].transpose() * rotations[i])));
        }
        for (side, (arm, [shoulder, elbow])) in body.arms.iter().zip(self.arms).enumerate() {
            set(&arm[0], [0.0, self.carriage.girdle(side, shoulder), 0.0]);
            set(&arm[1], self.carriage.angles(side, shoulder));
            set(&arm[2], [0.0, 0.0, elbow]);
            set(&arm[3], [0.0, 0.0, self.carriage.hand(elbow)]);
        }
        for (side, (leg, pose)) in body.legs.iter().zip(&self.legs).enumerate() {
            let [thigh, shank, foot, _] = plane.frames(pose);
            let ankle = rotations::euler(&(shank.transpose() * foot));
            let (thigh, ankle) = if side == 0 {
                (thigh, ankle)
            } else {
                (mirror_rotation(&thigh), [-ankle[0], -ankle[1], ankle[2]])
            };
            let turn = self.feet[side];
            let thigh = if turn == 0.0 { thigh } else { rotations::about_y(turn) * thigh };
            set(&leg[0], rotations::euler(&(rotations[0].transpose() * thigh)));
            set(&leg[1], [0.0, 0.0, pose.knee]);
            set(&leg[2], ankle);
            set(&leg[3], [0.0, 0.0, pose.toes - pose.pitch]);
        }
    }
}
