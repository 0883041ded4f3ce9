//! Bones that share out how a limb turns about its own axis, so that its skin does not wring at one joint.

use crate::roles::{Limbs, Roles};
use crate::skeleton::Skeleton;
use nalgebra::Unit;
use solaris_model::{Placement, UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// What such bones are called, among other things.
const WORDS: [&str; 3] = ["twist", "roll", "捩"];
/// How far (of the limb) one may be from the limb's axis, where nothing of the limb hangs on it, and where what is next does.
const BESIDE: f64 = 0.3;
const WITHIN: f64 = 1e-3;
/// The cosine of half an angle, and its sine about the axis, below which there is no telling the one from the other.
const LEAST: f64 = 1e-6;

/// A bone between two joints of a limb.
pub(crate) struct Twist {
    bone: usize,
    /// What the limb hangs on, the limb's bone, and the next one.
    chain: [usize; 3],
    /// From the limb's joint to the next, at rest.
    axis: Unit<Vector3<f64>>,
    /// How far along it is, 0 to 1.
    share: f64,
    /// By how much the limb turned in what it hangs on, and the next one in it, in the frame before (rad).
    turned: [f64; 2],
}

impl Twist {
    /// All that a skeleton has; `rest` are the places of its bones at rest.
    pub(crate) fn all(skeleton: &Skeleton, roles: &Roles, rest: &[Placement]) -> Vec<Self> {
        let of = |limbs: &Limbs| {
            [
                limbs.upper_arm.zip(limbs.forearm),
                limbs.forearm.zip(limbs.hand),
                Some((limbs.thigh, limbs.shank)),
                Some((limbs.shank, limbs.foot)),
            ]
        };
        let mut found = Vec::new();
        for (limb, next) in roles.sides.iter().flat_map(of).flatten() {
            let Some(above) = skeleton.bones[limb].parent else { continue };
            let from = rest[limb].translation.vector;
            let way = rest[next].translation.vector - from;
            let Some((axis, length)) = Unit::try_new_and_get(way, 1e-9) else { continue };
            for (bone, _) in skeleton.bones.iter().enumerate().filter(|(_, bone)| is_called(&bone.name)) {
                if bone == next || !skeleton.is_below(bone, limb) || skeleton.is_below(bone, next) {
                    continue;
                }
                let at = rest[bone].translation.vector - from;
                let along = at.dot(&axis);
                let most = if skeleton.is_below(next, bone) { WITHIN } else { BESIDE };
                if (at - *axis * along).norm() <= most * length {
                    let share = (along / length).clamp(0.0, 1.0);
                    found.push(Self { bone, chain: [above, limb, next], axis, share, turned: [0.0; 2] });
                }
            }
        }
        found
    }

    /// How the bone is turned where all others are in their places: with `D` how far each is turned from its rest, of the limb by its
    /// angles in what it hangs on and of the next one in it about the limb's axis,
    ///
    /// ```text
    /// S = D·Rot(a, s·τₙ − (1 − s)·τ)·S₀        τ of D₀⁻¹·D        τₙ of D⁻¹·Dₙ
    /// ```
    ///
    /// so that next to the joint it goes with what is beyond. Angles go on from frame to frame.
    pub(crate) fn turn(&mut self, rest: &[Placement], places: &[Placement]) -> (usize, UnitQuaternion<f64>) {
        let [above, limb, next] = self.chain.map(|i| places[i].rotation * rest[i].rotation.inverse());
        let own = about(&self.axis, &(above.inverse() * limb), self.turned[0]);
        let beyond = about(&self.axis, &(limb.inverse() * next), self.turned[1]);
        self.turned = [own, beyond];
        let angle = self.share * beyond - (1.0 - self.share) * own;
        let more = UnitQuaternion::from_axis_angle(&self.axis, angle);
        (self.bone, limb * more * rest[self.bone].rotation)
    }
}

fn is_called(name: &str) -> bool {
    let name = name.to_lowercase();
    WORDS.iter().any(|word| name.contains(word))
}

/// By how much something turns about an axis (rad), as near to what it was `before` as whole turns allow.
fn about(axis: &Unit<Vector3<f64>>, turn: &UnitQuaternion<f64>, before: f64) -> f64 {
    let (sine, cosine) = (turn.imag().dot(axis), turn.scalar());
    if sine.hypot(cosine) < LEAST {
        return before;
    }
    let angle = 2.0 * sine.atan2(cosine);
    angle - TAU * ((angle - before) / TAU).round()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_about_an_axis_goes_on_past_half_a_turn() {
        let axis = Vector3::y_axis();
        let mut angle = 0.0;
        for k in 0..=60 {
            let goal = 0.1 * f64::from(k);
            let swing = UnitQuaternion::from_scaled_axis(Vector3::new(0.4, 0.0, -0.3));
            angle = about(&axis, &(swing * UnitQuaternion::from_axis_angle(&axis, goal)), angle);
            assert!((angle - goal).abs() < 1e-12, "{goal}: {angle}");
        }
        // Turned upside down, nothing tells how far about the axis.
        let over = UnitQuaternion::from_scaled_axis(Vector3::x() * std::f64::consts::PI);
        assert!((about(&axis, &over, 0.7) - 0.7).abs() < 1e-15);
    }
}
