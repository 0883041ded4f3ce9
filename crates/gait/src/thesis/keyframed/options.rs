//! Options of a keyframed walk.

/// How the pitches go from one posture to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum InBetween {
    /// By minimum jerk, from rest to rest: the body stops at every posture, as in the thesis.
    #[default]
    Rest,
    /// The root's leg linearly in the phase, so that the body goes on; the free leg and the arms as before.
    Linear,
}

/// How a keyframed walk is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeyframedOptions {
    /// What lies between two postures.
    pub in_between: InBetween,
    /// Distance of the feet's lines (m); the distance of the hips where none is given.
    pub step_width: Option<f64>,
    /// Amplitude of the pelvis' way to the sides (m), towards the foot that stands.
    pub sway: f64,
    /// Height of a swinging foot over the ground where no posture says more (m).
    pub clearance: f64,
    /// Whether the left foot makes the first step; else the right one.
    pub left_first: bool,
}

impl Default for KeyframedOptions {
    fn default() -> Self {
        Self { in_between: InBetween::Rest, step_width: None, sway: 0.0, clearance: 0.015, left_first: false }
    }
}
