//! Rest poses that are made alike: limbs of a T pose hang as those of an A pose do, bone by bone.

use crate::roles::{Limbs, Roles};
use solaris_model::{Placement, UnitQuaternion, Vector3};

/// For each bone of the target that has a role, the turn of it from its own rest pose to that of the source, both in the frame of the
/// heading: arms, thighs and shanks point as the source's do; feet keep their soles flat and are turned about the vertical alone. Trunk,
/// head and shoulders stand at rest as they are, each in its own manner.
pub(crate) fn alignments(
    from: (&Roles, &[Placement]),
    onto: (&Roles, &[Placement]),
) -> Vec<Option<UnitQuaternion<f64>>> {
    let mut turns = vec![None; onto.1.len()];
    let own =
        [onto.0.pelvis].into_iter().chain(onto.0.trunk.iter().copied()).chain(onto.0.neck.iter().copied());
    for bone in own.chain(onto.0.head) {
        turns[bone] = Some(UnitQuaternion::identity());
    }
    for (source, target) in from.0.sides.iter().zip(&onto.0.sides) {
        side((source, from.1), (target, onto.1), &mut turns);
    }
    turns
}

fn side(
    (source, from): (&Limbs, &[Placement]),
    (target, onto): (&Limbs, &[Placement]),
    turns: &mut [Option<UnitQuaternion<f64>>],
) {
    let along = |places: &[Placement], upper: usize, lower: usize| {
        places[lower].translation.vector - places[upper].translation.vector
    };
    // A limb from its upper bone on: each points as the source's does, and what no bone ends goes on as the one above it.
    let mut limb = |own: &[Option<usize>], other: &[Option<usize>]| {
        let mut above = UnitQuaternion::identity();
        for i in 0..own.len() {
            let next = |bones: &[Option<usize>]| bones[i].zip(bones.get(i + 1).copied().flatten());
            if let (Some((bone, end)), Some((source, lower))) = (next(own), next(other)) {
                above = towards(&(above * along(onto, bone, end)), &along(from, source, lower)) * above;
            }
            if let Some(bone) = own[i] {
                turns[bone] = Some(above);
            }
        }
    };
    let arm = |limbs: &Limbs| [limbs.upper_arm, limbs.forearm, limbs.hand];
    limb(&arm(target), &arm(source));
    let leg = |limbs: &Limbs| [limbs.thigh, limbs.shank, limbs.foot].map(Some);
    limb(&leg(target), &leg(source));
    let flat = |places: &[Placement], limbs: &Limbs| {
        let way = along(places, limbs.foot, limbs.toes?);
        Vector3::new(way.x, 0.0, way.z).try_normalize(1e-9)
    };
    let yaw = flat(onto, target).zip(flat(from, source)).map(|(own, other)| between(&own, &other));
    let yaw = yaw.unwrap_or_else(UnitQuaternion::identity);
    turns[target.foot] = Some(yaw);
    for (bone, turn) in [(target.toes, yaw), (target.clavicle, UnitQuaternion::identity())] {
        if let Some(bone) = bone {
            turns[bone] = Some(turn);
        }
    }
}

/// The turn of a limb from one direction to another: about z, to the side, as far as it goes, and what is left the shortest way. A T pose and
/// an A pose differ by the first, and the limb gets no twist of it.
fn towards(from: &Vector3<f64>, to: &Vector3<f64>) -> UnitQuaternion<f64> {
    let flat = |v: &Vector3<f64>| v.xy().norm() > 0.3 * v.norm();
    let mut side = UnitQuaternion::identity();
    if flat(from) && flat(to) {
        let angle = from.xy().perp(&to.xy()).atan2(from.xy().dot(&to.xy()));
        side = UnitQuaternion::from_scaled_axis(Vector3::z() * angle);
    }
    between(&(side * from), to) * side
}

/// The shortest turn from one direction to another; none where either is none, half a turn about a square axis where they are opposite.
pub(crate) fn between(from: &Vector3<f64>, to: &Vector3<f64>) -> UnitQuaternion<f64> {
    let Some((from, to)) = from.try_normalize(1e-12).zip(to.try_normalize(1e-12)) else {
        return UnitQuaternion::identity();
    };
    // q = (1 + a·b, a × b), made one long: exact also where the angle is small.
    let (w, v) = (1.0 + from.dot(&to), from.cross(&to));
    if w > 1e-9 {
        return UnitQuaternion::from_quaternion(nalgebra::Quaternion::from_parts(w, v));
    }
    let other = if from.x.abs() < 0.7 { Vector3::x() } else { Vector3::z() };
    UnitQuaternion::from_axis_angle(&nalgebra::Unit::new_normalize(from.cross(&other)), std::f64::consts::PI)
}
