//! One phase: postures between two key postures, built up from the root.

use super::foot::{Free, Lift, SAME_PLACE, SideLeg};
use super::options::{InBetween, KeyframedOptions};
use crate::body::Body;
use crate::body::foot::FootPlane;
use crate::body::leg::LegPose;
use crate::body::posture::{ArmCarriage, Posture};
use crate::body::rotations;
use crate::thesis::determinants::{
    ArmAngles, KeyPosture, LegAngles, PhaseRoot, Proportions, Root, TrunkAngles,
};
use nalgebra::{Matrix3, Vector3};
use solaris_profiles::step;

/// One phase of a walk.
#[derive(Clone, Copy, Debug)]
pub(super) struct Phase {
    /// When it begins, and how long it lasts (s).
    pub(super) start: f64,
    pub(super) duration: f64,
    /// Side of the stance leg: 0 left, 1 right.
    pub(super) stance: usize,
    pub(super) root: PhaseRoot,
    /// Where the root is: forward, up (m).
    at: [f64; 2],
    pub(super) from: KeyPosture,
    pub(super) to: KeyPosture,
    /// What the other foot does.
    pub(super) free: Free,
    /// How far its toe would slide (m) if it stayed on the ground, as both postures have it, and did not lift.
    pub(super) slid: Option<f64>,
}

impl Phase {
    pub(super) fn new(
        p: &Proportions,
        options: &KeyframedOptions,
        (start, duration): (f64, f64),
        stance: usize,
        heels: [f64; 2],
        root: PhaseRoot,
        (from, to): (KeyPosture, KeyPosture),
    ) -> Self {
        let side = if root.swing { 1 - stance } else { stance };
        let ahead = match root.point {
            Root::Heel => 0.0,
            Root::Sole => p.heel_behind,
            Root::Ball => p.heel_behind + p.ball_ahead,
            Root::Tip => p.heel_behind + p.forefoot(),
        };
        let up = if root.point == Root::Ball { p.ball_height } else { 0.0 };
        let mut phase = Self {
            start,
            duration,
            stance,
            root,
            at: [heels[side] + ahead, up],
            from,
            to,
            free: Free::Swings(Lift::default()),
            slid: None,
        };
        let [a, b] = [from, to].map(|posture| phase.other_foot(p, &posture));
        let near = SAME_PLACE * p.height;
        let same = |a: [f64; 2], b: [f64; 2], height: f64| {
            [a, b].iter().all(|x| (x[1] - height).abs() < near) && (a[0] - b[0]).abs() < near
        };
        phase.free = if same(a.tip, b.tip, 0.0) {
            Free::Pinned { point: Root::Tip, at: [b.tip[0], 0.0] }
        } else if same(a.ball, b.ball, p.ball_height) {
            Free::Pinned { point: Root::Ball, at: [b.ball[0], p.ball_height] }
        } else {
            let lowest =
                |joints: &crate::thesis::determinants::Joints| joints.heel[1].min(joints.tip[1]).max(0.0);
            let on_ground = [a, b].iter().all(|joints| (joints.ball[1] - p.ball_height).abs() < near);
            // A foot that ends on its ball is about to leave; one that ends flat has been in the air.
            let leaves = to.legs[phase.legs()[1]].foot > 0.0;
            phase.slid = (on_ground && leaves).then_some(b.ball[0] - a.ball[0]);
            Free::Swings(Lift::new(p, lowest(&a), lowest(&b), options.clearance))
        };
        phase
    }

    /// Whether both postures have both feet on the ground, though a toe that would slide lifts.
    pub(super) fn is_double_support(&self) -> bool {
        matches!(self.free, Free::Pinned { .. }) || self.slid.is_some()
    }

    /// Which of a posture's legs is the root's, and which the other.
    fn legs(&self) -> [usize; 2] {
        let root = usize::from(self.root.swing);
        [root, 1 - root]
    }

    /// Side of a posture's leg.
    pub(super) fn side(&self, leg: usize) -> usize {
        if leg == 0 { self.stance } else { 1 - self.stance }
    }

    fn other_foot(&self, p: &Proportions, posture: &KeyPosture) -> crate::thesis::determinants::Joints {
        let [root, other] = self.legs();
        let hip = posture.legs[root].hip_over(p, self.root.point, self.at);
        let offset = posture.swing_hip(p);
        let sign = if other == 1 { 1.0 } else { -1.0 };
        posture.legs[other].joints(p, [hip[0] + sign * offset[0], hip[1] + sign * offset[1]])
    }

    /// The posture at a time (s), the pelvis `sway` to the left (m).
    pub(super) fn posture(
        &self,
        body: &Body,
        p: &Proportions,
        options: &KeyframedOptions,
        plane: &FootPlane,
        (t, sway): (f64, f64),
    ) -> Posture {
        let clock = ((t - self.start) / self.duration).clamp(0.0, 1.0);
        let eased = step::quintic(clock).position;
        let s = match options.in_between {
            InBetween::Rest => eased,
            InBetween::Linear => clock,
        };
        let [root, other] = self.legs();
        let left_stands = self.stance == 0;
        let turn = |tilt: f64, rotation: f64| {
            let sign = if left_stands { 1.0 } else { -1.0 };
            about_y(-sign * rotation) * rotations::about_z(sign * tilt)
        };
        let pelvis = [self.from.pelvis, self.to.pelvis];
        let rotation = turn(
            between(pelvis[0].tilt, pelvis[1].tilt, s),
            between(pelvis[0].rotation, pelvis[1].rotation, s),
        );
        let middle_of_hips = {
            let hip = body.legs[0][0].offset;
            Vector3::new(0.0, hip.y, hip.z)
        };
        // From the middle of the hips to the hip of a side, and where the line of its foot is.
        let sideways = |side: usize| if side == 0 { 1.0 } else { -1.0 };
        let to_hip = |side: usize| rotation * Vector3::new(sideways(side) * 0.5 * p.hips, 0.0, 0.0);
        let line = |side: usize| sideways(side) * 0.5 * options.step_width.unwrap_or(p.hips);

        // What swings is eased whatever the root's leg does.
        let swings = if matches!(self.free, Free::Swings(_)) { eased } else { s };
        let planned = [(root, s), (other, swings)]
            .map(|(leg, s)| (leg, leg_between(&self.from.legs[leg], &self.to.legs[leg], s)));
        let [z, y] = planned[0].1.hip_over(p, self.root.point, self.at);
        let root_hip = to_hip(self.side(root));
        let sides = planned.map(|(leg, angles)| {
            let side = self.side(leg);
            let hip = to_hip(side);
            let planar = [z + hip.z - root_hip.z, y + hip.y - root_hip.y];
            let ankle = angles.joints(p, planar).ankle;
            let off = sway + hip.x - line(side);
            SideLeg { side, angles, hip: planar, across: sway + hip.x, ankle, off: sideways(side) * off }
        });
        // Both legs reach: the one that leans farther to the side says how low the hips are.
        let drop = sides[0].drop().max(sides[1].drop());
        let mut legs = [LegPose::default(); 2];
        for (index, leg) in sides.iter().enumerate() {
            let free = if index == 0 { None } else { Some((&self.free, clock)) };
            legs[leg.side] = leg.pose(&body.leg, p, plane, drop, free);
        }
        let middle = Vector3::new(sides[0].across, sides[0].hip[1] - drop, sides[0].hip[0]) - root_hip;

        Posture {
            pelvis: middle - rotation * middle_of_hips,
            trunk: trunk(&rotation, &trunk_between(&self.from.trunk, &self.to.trunk, eased), left_stands),
            arms: self.arms(eased),
            cane: [0.0; 2],
            carriage: ArmCarriage::WALKING,
            legs,
            heading: 0.0,
            feet: [0.0; 2],
        }
    }

    /// Shoulder and elbow of the left and of the right arm, about x.
    fn arms(&self, s: f64) -> [[f64; 2]; 2] {
        let mut arms = [[0.0; 2]; 2];
        for leg in [0, 1] {
            let [ArmAngles { shoulder: a, elbow: b }, ArmAngles { shoulder: c, elbow: d }] =
                [self.from.arms[leg], self.to.arms[leg]];
            arms[self.side(leg)] = [-between(a, c, s), -between(b, d, s)];
        }
        arms
    }
}

/// World orientations of pelvis, abdomen, thorax, neck and head.
fn trunk(pelvis: &Matrix3<f64>, angles: &TrunkAngles, left_stands: bool) -> [rotations::Euler; 5] {
    // Towards the left is a negative turn about z.
    let sign = if left_stands { -1.0 } else { 1.0 };
    let abdomen = [sign * angles.pelvis_bend, 0.0, angles.lean];
    let thorax = [sign * (angles.pelvis_bend + angles.torso_bend), 0.0, angles.lean];
    [rotations::euler(pelvis), abdomen, thorax, thorax.map(|x| 0.5 * x), [0.0; 3]]
}

fn about_y(angle: f64) -> Matrix3<f64> {
    rotations::matrix([0.0, angle, 0.0])
}

fn between(a: f64, b: f64, s: f64) -> f64 {
    a + (b - a) * s
}

fn leg_between(a: &LegAngles, b: &LegAngles, s: f64) -> LegAngles {
    LegAngles {
        thigh: between(a.thigh, b.thigh, s),
        shank: between(a.shank, b.shank, s),
        foot: between(a.foot, b.foot, s),
        toes: between(a.toes, b.toes, s),
    }
}

fn trunk_between(a: &TrunkAngles, b: &TrunkAngles, s: f64) -> TrunkAngles {
    TrunkAngles {
        pelvis_bend: between(a.pelvis_bend, b.pelvis_bend, s),
        torso_bend: between(a.torso_bend, b.torso_bend, s),
        lean: between(a.lean, b.lean, s),
    }
}
