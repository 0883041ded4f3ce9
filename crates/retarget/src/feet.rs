//! Soles: the points of a foot that can stand, found at rest.

use crate::roles::Roles;
use crate::skeleton::Skeleton;
use nalgebra::Point3;
use solaris_model::{Placement, UnitQuaternion, Vector3};

/// How far (of the leg) above the ground a point of the surface still belongs to the sole.
const LOW: f64 = 0.04;
/// How high (of the leg) the lowest joint of a foot may be above its world's ground.
const JOINT: f64 = 0.15;
/// How thick (of the leg) a sole is where nothing tells.
const SOLE: f64 = 0.03;
/// A foot from heel to ankle, and from ball to tip, of that from ankle to ball; and that one of the leg: an adult's.
const HEEL: f64 = 0.35;
const TIP: f64 = 0.45;
const FOOT: f64 = 0.16;

/// The sole of one foot. All lengths in m.
#[derive(Clone, Debug)]
pub(crate) struct Sole {
    pub(crate) foot: usize,
    /// The bone that carries ball and tip: when the heel rises, the foot turns about the joint above the ball and the toes stay.
    pub(crate) toes: usize,
    /// Heel, ball and tip, in the frames of their bones.
    pub(crate) points: [Point3<f64>; 3],
    /// Height of the ankle above the ground at rest.
    pub(crate) ankle: f64,
    /// Height of the ground at rest, in the frame of the heading.
    pub(crate) ground: f64,
}

impl Sole {
    /// Both soles of a skeleton, turned to its heading: from the points of its surface, or where it has none from its joints.
    pub(crate) fn both(skeleton: &Skeleton, roles: &Roles, turn: &UnitQuaternion<f64>) -> [Self; 2] {
        let at = |bone: usize| turn * skeleton.bones[bone].rest.translation.vector;
        let leg = leg(skeleton, roles);
        let feet = roles.sides.map(|limbs| {
            let of_foot = skeleton.below(limbs.foot);
            let surface: Vec<Vector3<f64>> = skeleton
                .surface
                .iter()
                .filter(|(bone, _)| of_foot[*bone])
                .map(|(_, point)| turn * point)
                .collect();
            let joints: Vec<Vector3<f64>> =
                (0..skeleton.bones.len()).filter(|bone| of_foot[*bone]).map(at).collect();
            (limbs, surface, joints)
        });
        let lowest = |points: &[Vector3<f64>]| points.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
        let surface = feet.iter().map(|(_, surface, _)| lowest(surface)).fold(f64::INFINITY, f64::min);
        let joints = feet.iter().map(|(_, _, joints)| lowest(joints)).fold(f64::INFINITY, f64::min);
        let ground = match () {
            () if surface.is_finite() => surface,
            () if (0.0..JOINT * leg).contains(&joints) => 0.0,
            () => joints - SOLE * leg,
        };
        feet.map(|(limbs, surface, joints)| {
            let ankle = at(limbs.foot);
            let ends = joints.iter().map(|p| p.z - ankle.z).fold(0.0, f64::max);
            let ball = limbs
                .toes
                .map_or(ankle + Vector3::z() * if ends > 0.0 { 0.7 * ends } else { FOOT * leg }, at);
            let length = (ball.z - ankle.z).max(0.1 * FOOT * leg);
            let low = surface.iter().filter(|p| p.y < ground + LOW * leg);
            let heel = low.clone().min_by(|a, b| a.z.total_cmp(&b.z)).copied();
            let tip = low.max_by(|a, b| a.z.total_cmp(&b.z)).copied();
            let heel = heel.unwrap_or(ankle - Vector3::z() * (HEEL * length));
            let tip = tip.unwrap_or(ball + Vector3::z() * (TIP * length));
            let toes = limbs.toes.unwrap_or(limbs.foot);
            let points = [(limbs.foot, heel), (toes, ball), (toes, tip)].map(|(bone, point)| {
                let place = turn * skeleton.bones[bone].rest;
                place.inverse() * Point3::new(point.x, ground, point.z)
            });
            Self { foot: limbs.foot, toes, points, ankle: ankle.y - ground, ground }
        })
    }

    /// Where heel, ball and tip are with the bones at these places.
    pub(crate) fn at(&self, places: &[Placement]) -> [Vector3<f64>; 3] {
        let [heel, ball, tip] = self.points;
        [(self.foot, heel), (self.toes, ball), (self.toes, tip)]
            .map(|(bone, point)| (places[bone] * point).coords)
    }
}

/// Thigh and shank of a skeleton, from joint to joint, the mean of both sides (m).
pub(crate) fn leg(skeleton: &Skeleton, roles: &Roles) -> f64 {
    let at = |bone: usize| skeleton.bones[bone].rest.translation.vector;
    let of = |limbs: &crate::roles::Limbs| {
        (at(limbs.thigh) - at(limbs.shank)).norm() + (at(limbs.shank) - at(limbs.foot)).norm()
    };
    roles.sides.iter().map(of).sum::<f64>() / 2.0
}
