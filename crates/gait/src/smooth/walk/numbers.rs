//! The numbers of a whole walk, besides the style of its steady part. Clocks are in u, from the first lift's `u = d`.

use crate::smooth::limbs::stance::LANDING_RANGE;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Rest before and after the movement, in strides: longer than any difference formula reaches, and long enough for the
/// splines to have come to rest (they ring by 0.43 a node).
pub(super) const REST: f64 = 0.2;
/// Begin of the movement.
pub(super) const BEGIN: f64 = -0.75;
/// From the closing contact to rest.
pub(super) const SETTLE: f64 = 0.71;
/// Shortening of the first step, the last but one and the last.
pub(super) const STEP_FACTORS: (f64, f64, f64) = (0.88, 0.80, 0.67);
/// Knee flexion for which height is kept: at contact, on a flat foot, while still standing.
pub(super) const KNEE_CONTACT: f64 = 4.0 * DEGREE;
pub(super) const KNEE_FLAT: f64 = 6.8 * DEGREE;
pub(super) const KNEE_START: f64 = 4.5 * DEGREE;
/// Knee flexion when standing.
pub(super) const KNEE_STANDING: f64 = 4.0 * DEGREE;
/// Centre of mass ahead of the ankles when standing (m, for the reference height).
pub(super) const STANDING_AHEAD: f64 = 0.045;
/// Share of a height need that one pass corrects, the most it corrects, and the range of all corrections (m).
pub(super) const CORRECTION: (f64, f64, f64, f64) = (0.9, 0.01, -0.05, 0.06);

/// How a walk begins, ends and lands: what may be tuned without changing where its feet stand, and when.
///
/// Fades are (begin, duration); those that end a walk count on its finish clock, 0 one stride before the closing contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WalkNumbers {
    /// From the standing height to the walking one, and back.
    pub height_in: (f64, f64),
    /// See [`Self::height_in`].
    pub height_out: (f64, f64),
    /// Begin of everything that swings.
    pub swing_in: (f64, f64),
    /// End of the height's harmonics.
    pub harmonics_out: (f64, f64),
    /// End of the pelvis' swings.
    pub pelvis_out: (f64, f64),
    /// End of the thorax' swings.
    pub thorax_out: (f64, f64),
    /// End of the arms' swings.
    pub arms_out: (f64, f64),
    /// Middle of a height correction after its contact.
    pub correction_at: f64,
    /// Thigh of the closing foot's swing over that of a step.
    pub closing_thigh: f64,
    /// Factors of the foot's pitch at the first and at the last contact.
    pub pitch_first: f64,
    /// See [`Self::pitch_first`].
    pub pitch_last: f64,
    /// A knee that lands so much more bent than the style's does not go on bending (rad); twice as much stretches as fast.
    pub landing_range: f64,
    /// Knee flexion of the last stance for which height is kept while the other foot closes (rad); none for 0.
    pub knee_closing: f64,
    /// Part of the clearance that a foot keeps late in swing.
    pub late_clearance: f64,
}

impl WalkNumbers {
    /// The numbers of the recipe that the golden walks were made with.
    pub fn recipe() -> Self {
        let swing_out = (0.24, 1.01);
        Self {
            height_in: (-0.21, 0.60),
            height_out: (0.09, 1.60),
            swing_in: (0.18, 0.85),
            harmonics_out: swing_out,
            pelvis_out: swing_out,
            thorax_out: swing_out,
            arms_out: swing_out,
            correction_at: 0.22,
            closing_thigh: 0.85,
            pitch_first: 0.40,
            pitch_last: 0.51,
            landing_range: 15.0 * DEGREE,
            knee_closing: 0.0,
            late_clearance: 0.0,
        }
    }
}

impl Default for WalkNumbers {
    /// What ships: the trunk stops before the arms do, and the closing leg swings less, so that the feet twist the ground less.
    fn default() -> Self {
        Self {
            pelvis_out: (-0.14, 0.84),
            thorax_out: (0.39, 0.90),
            arms_out: (0.50, 1.14),
            correction_at: 0.26,
            closing_thigh: 0.78,
            landing_range: LANDING_RANGE,
            knee_closing: 1.5 * DEGREE,
            late_clearance: 0.025,
            ..Self::recipe()
        }
    }
}
