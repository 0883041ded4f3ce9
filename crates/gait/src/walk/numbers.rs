//! The numbers of a whole walk, besides the style of its steady part. Clocks are in u, from the first lift's `u = d`.

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
/// Begin and duration of the change from the standing height to the walking one, and back (on the finish clock).
pub(super) const HEIGHT_IN: (f64, f64) = (-0.21, 0.60);
pub(super) const HEIGHT_OUT: (f64, f64) = (0.09, 1.60);
/// The same for everything that swings.
pub(super) const SWING_IN: (f64, f64) = (0.18, 0.85);
pub(super) const SWING_OUT: (f64, f64) = (0.24, 1.01);
/// Middle of a height correction after its contact.
pub(super) const CORRECTION_AT: f64 = 0.22;
/// Knee flexion for which height is kept: at contact, on a flat foot, while still standing.
pub(super) const KNEE_CONTACT: f64 = 4.0 * DEGREE;
pub(super) const KNEE_FLAT: f64 = 6.8 * DEGREE;
pub(super) const KNEE_START: f64 = 4.5 * DEGREE;
/// Factors of the foot's pitch at the first and at the last contact.
pub(super) const PITCH_FIRST: f64 = 0.40;
pub(super) const PITCH_LAST: f64 = 0.51;
/// Knee flexion when standing.
pub(super) const KNEE_STANDING: f64 = 4.0 * DEGREE;
/// Centre of mass ahead of the ankles when standing (m, for the reference height).
pub(super) const STANDING_AHEAD: f64 = 0.045;
/// Share of a height need that one pass corrects, the most it corrects, and the range of all corrections (m).
pub(super) const CORRECTION: (f64, f64, f64, f64) = (0.9, 0.01, -0.05, 0.06);
