//! The push-off of a foot: when its heel and its toes rise, and how its knee bends.

use solaris_profiles::Boundary;

/// When and how the push-off happens.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Push {
    /// When the heel rises, on the foot's own clock.
    pub(crate) heel_off: f64,
    /// A waypoint of the knee: when and how much.
    pub(crate) waypoint: Option<(f64, f64)>,
    /// When the roll over the tip begins.
    pub(crate) tip_roll_at: f64,
    /// Pitch of the toes at toe-off.
    pub(crate) toe_roll: f64,
    /// The greatest part of the foot's pitch that they have then: more would bend them down as the foot leaves.
    pub(crate) most_roll: f64,
    /// The least flexion of the knee, and the greatest one that its end is bent to where it would be too straight (rad).
    pub(crate) least_knee: f64,
    pub(crate) most_knee: f64,
    /// The greatest pitch of the foot at toe-off: where the body is so far ahead that it would be steeper, the knee is straighter.
    pub(crate) steepest: f64,
    /// Over how much pitch (rad) the foot comes to be flat or begins to rise where the knee's law would press it through the ground.
    pub(crate) softness: f64,
    /// By which part the foot's pitch is rounded off in mid-push, where it would stay at the ground on slopes; by the rest it is as soft as elsewhere.
    pub(crate) rounding: f64,
    /// Knee at toe-off: value, rate, second derivative by the foot's clock.
    pub(crate) knee_toe_off: Boundary,
}
