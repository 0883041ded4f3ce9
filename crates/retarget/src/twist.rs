//! Bones that share out how a limb turns about its own axis, so that its skin does not wring at one joint.

use crate::roles::{Limbs, Roles};
use crate::skeleton::Skeleton;
use nalgebra::Unit;
use solaris_model::rig::is_twist;
use solaris_model::{Placement, UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// How far one may be from the limb's axis, and before or behind its ends (of the limb).
const BESIDE: f64 = 0.3;
const BEYOND: f64 = 0.05;
/// The cosine of half an angle, and its sine about the axis, below which there is no telling the one from the other.
const LEAST: f64 = 1e-6;
/// Within what time (s) whole turns are undone to e⁻¹.
const UNWINDING: f64 = 0.1;

/// A bone between two joints of a limb.
pub(crate) struct Twist {
    bone: usize,
    /// What the limb hangs on, and the limb's bone.
    chain: [usize; 2],
    /// The next bone, where its turn about the limb's axis is the limb's as well: a hand's and a foot's, and not what an elbow or a knee
    /// gives, which the next limb shares out.
    next: Option<usize>,
    /// From the limb's joint to the next, at rest.
    limb: Unit<Vector3<f64>>,
    /// What the bone turns about: the limb's axis, or where something of the limb hangs on it, the line to that.
    axis: Unit<Vector3<f64>>,
    /// How far along it is, 0 to 1.
    share: f64,
    /// By how much the limb turned in what it hangs on, and the next one in it.
    turned: [Roll; 2],
}

impl Twist {
    /// All that a skeleton has, but for those that are `driven`; `rest` are the places of its bones at rest.
    pub(crate) fn all(
        skeleton: &Skeleton,
        roles: &Roles,
        rest: &[Placement],
        driven: &[Option<UnitQuaternion<f64>>],
    ) -> Vec<Self> {
        let of = |limbs: &Limbs| {
            [
                (limbs.upper_arm.zip(limbs.forearm), false),
                (limbs.forearm.zip(limbs.hand), true),
                (Some((limbs.thigh, limbs.shank)), false),
                (Some((limbs.shank, limbs.foot)), true),
            ]
        };
        let is_one = |bone: &usize| {
            let called = &skeleton.bones[*bone];
            called.is_bone && driven[*bone].is_none() && is_twist(&called.name)
        };
        let named: Vec<usize> = (0..skeleton.bones.len()).filter(is_one).collect();
        let mut found = Vec::new();
        for (pair, is_shared) in roles.sides.iter().flat_map(of) {
            let Some((of, next)) = pair else { continue };
            let Some(above) = skeleton.bones[of].parent else { continue };
            let at = |bone: usize| rest[bone].translation.vector;
            let way = |from: usize, to: usize| Unit::try_new_and_get(at(to) - at(from), 1e-9);
            let Some((limb, length)) = way(of, next) else { continue };
            for bone in named.iter().copied() {
                if bone == next || !skeleton.is_below(bone, of) || skeleton.is_below(bone, next) {
                    continue;
                }
                let off = at(bone) - at(of);
                let share = off.dot(&limb) / length;
                let aside = (off - *limb * (share * length)).norm();
                if aside > BESIDE * length || !(-BEYOND..=1.0 + BEYOND).contains(&share) {
                    continue;
                }
                let carries = skeleton.is_below(next, bone);
                let on = || way(bone, skeleton.between(bone, next).first().copied().unwrap_or(next));
                let Some((axis, _)) = (if carries { on() } else { Some((limb, length)) }) else { continue };
                let next = is_shared.then_some(next);
                let share = share.clamp(0.0, 1.0);
                found.push(Self {
                    bone,
                    chain: [above, of],
                    next,
                    limb,
                    axis,
                    share,
                    turned: Default::default(),
                });
            }
        }
        found
    }

    /// How the bone is turned where all others are in their places, `dt` (s) after the frame before: with `D` how far each is turned from
    /// its rest, of the limb by its angles in what it hangs on and of the next one in it about the limb's axis,
    ///
    /// ```text
    /// S = D·Rot(a, s·τₙ − (1 − s)·τ)·S₀        τ of D₀⁻¹·D        τₙ of D⁻¹·Dₙ, or zero
    /// ```
    ///
    /// so that next to the joint it goes with what is beyond.
    pub(crate) fn turn(
        &mut self,
        rest: &[Placement],
        places: &[Placement],
        dt: f64,
    ) -> (usize, UnitQuaternion<f64>) {
        let turned = |i: usize| places[i].rotation * rest[i].rotation.inverse();
        let [above, limb] = self.chain.map(turned);
        let own = self.turned[0].follow(&self.limb, &(above.inverse() * limb), dt);
        let next = self.next.map(|next| limb.inverse() * turned(next));
        let beyond = next.map_or(0.0, |next| self.turned[1].follow(&self.limb, &next, dt));
        let angle = self.share * beyond - (1.0 - self.share) * own;
        let more = UnitQuaternion::from_axis_angle(&self.axis, angle);
        (self.bone, limb * more * rest[self.bone].rotation)
    }
}

/// How far something is turned about an axis, frame after frame, past half a turn without a leap: the angle within half a turn and whole
/// turns that were gone through, which are undone within some tenths of a second: what comes back to its posture has its angle again.
///
/// ```
/// use nalgebra::{UnitQuaternion, Vector3};
/// use solaris_retarget::Roll;
/// let (axis, mut roll) = (Vector3::y_axis(), Roll::default());
/// for angle in [0.0, 1.5, 3.0, 4.5] {
///     let turn = UnitQuaternion::from_axis_angle(&axis, angle);
///     assert!((roll.follow(&axis, &turn, 0.0) - angle).abs() < 1e-12);
/// }
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Roll {
    /// Within half a turn (rad).
    within: f64,
    /// What whole turns have left (rad).
    more: f64,
}

impl Roll {
    /// By how much `turn` turns about `axis` (rad), `dt` (s) after the last time. Of one that lies nearly half a turn off the axis, which tells nothing,
    /// the angle stays.
    pub fn follow(&mut self, axis: &Unit<Vector3<f64>>, turn: &UnitQuaternion<f64>, dt: f64) -> f64 {
        self.more *= (-dt.max(0.0) / UNWINDING).exp();
        let (sine, cosine) = (turn.imag().dot(axis), turn.scalar());
        if sine.hypot(cosine) >= LEAST {
            // Half the angle may be in any quarter: a quaternion and its opposite are the same turn.
            let within = 2.0 * (sine * cosine.signum()).atan2(cosine.abs());
            self.more -= TAU * ((within - self.within) / TAU).round();
            self.within = within;
        }
        self.within + self.more
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn a_turn_about_an_axis_goes_on_past_half_a_turn_and_comes_back() {
        let axis = Vector3::y_axis();
        let swing = UnitQuaternion::from_scaled_axis(Vector3::new(0.4, 0.0, -0.3));
        let mut angle = Roll::default();
        let mut follow =
            |by: f64, dt: f64| angle.follow(&axis, &(swing * UnitQuaternion::from_axis_angle(&axis, by)), dt);
        // It goes on as it does.
        for k in 0..=60 {
            let goal = 0.1 * f64::from(k);
            let found = follow(goal, 0.0);
            assert!((found - goal).abs() < 1e-12, "{goal}: {found}");
        }
        // It rests there: the whole turn goes within some tenths of a second, and never faster than it would in that time.
        let mut before = 6.0;
        for _ in 0..60 {
            let found = follow(6.0, 1.0 / 60.0);
            assert!(found < before && before - found < TAU / 6.0, "{before} to {found}");
            before = found;
        }
        assert!((before - (6.0 - TAU)).abs() < 1e-3, "{before}");

        // Turned upside down, nothing tells how far about the axis.
        let over = UnitQuaternion::from_scaled_axis(Vector3::x() * PI);
        let mut angle = Roll { within: 0.7, more: 0.0 };
        assert!((angle.follow(&axis, &over, 1.0) - 0.7).abs() < 1e-15);
        // A turn and its opposite quaternion are one.
        let turn = UnitQuaternion::from_axis_angle(&axis, 1.0);
        let opposite = UnitQuaternion::new_unchecked(-turn.into_inner());
        for turn in [turn, opposite] {
            assert!((Roll::default().follow(&axis, &turn, 1.0) - 1.0).abs() < 1e-12);
        }
    }
}
