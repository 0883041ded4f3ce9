//! The numbers of a leg's laws that are the same for every style: angles in rad, lengths in m, `u` on the foot's own clock (0 at
//! contact, 1 a stride later).

const DEGREE: f64 = std::f64::consts::PI / 180.0;

// On the heel.

/// A knee that lands so much more bent than the style's does not go on bending.
pub(crate) const LANDING_RANGE: f64 = 24.0 * DEGREE;
/// How much straighter than the style's a knee may land.
pub(super) const LANDING_STRAIGHTER: f64 = 2.0 * DEGREE;

// In the push.

/// When the knee has its waypoint (u).
pub(super) const PUSH_WAYPOINT_AT: f64 = 0.46;
/// The greatest pitch of the foot at toe-off, also when the body is far ahead.
pub(super) const STEEPEST_PITCH: f64 = 78.0 * DEGREE;
/// By how much the knee's waypoint is more bent than the leg on a flat foot, and over which width it comes to be.
pub(super) const WAYPOINT_ABOVE_FLAT: f64 = 2.5 * DEGREE;
pub(super) const WAYPOINT_WIDTH: f64 = 2.0 * DEGREE;
/// Widths from which on the soft maximum is the waypoint's excess itself: eˣ stays finite.
pub(super) const MOST_WIDTHS: f64 = 50.0;
/// How much straighter than the leg on a flat foot the knee may be.
pub(super) const STRAIGHTER_THAN_FLAT: f64 = 0.15 * DEGREE;
/// The part of the push in which the knee is looked at: from so long after heel-off to so long before toe-off (u), at how many
/// instants.
pub(super) const PUSH_CHECKED: (f64, f64) = (0.02, 0.03);
pub(super) const PUSH_INSTANTS: i32 = 14;
/// How often the push is made again where the knee is too straight, and the part of what is missing that its waypoint, or its
/// end, bends more each time.
pub(super) const PUSH_ATTEMPTS: usize = 4;
pub(super) const WAYPOINT_GAIN: f64 = 1.3;
pub(super) const TOE_OFF_GAIN: f64 = 1.5;
/// The greatest knee flexion that toe-off is bent to.
pub(super) const MOST_KNEE_TOE_OFF: f64 = 60.0 * DEGREE;
/// How far the law of the toes goes on after toe-off, in parts of the roll over the tip.
pub(super) const TOES_BEYOND: f64 = 1.2;

// Where pieces meet.

/// Step of the difference formulas (u).
pub(super) const JET_STEP: f64 = 2e-3;
/// Step of the difference formula of the angle between thigh and leg (rad).
pub(super) const KNEE_STEP: f64 = 1e-3;
/// Least sine of the knee in its rates: a straight leg has none.
pub(super) const LEAST_KNEE_SINE: f64 = 0.05;

// In the air.

/// Duration of the piece that lands the foot (u).
pub(super) const LANDING: f64 = 0.02;
/// When the thigh has its waypoint (u), and the thigh of a foot that closes beside the other.
pub(super) const THIGH_AT: f64 = 0.84;
pub(super) const CLOSING_THIGH_AT: f64 = 0.82;
/// When the ankle has its waypoint (u).
pub(super) const ANKLE_AT: f64 = 0.83;
/// When the knee has its late waypoint (u).
pub(super) const LATE_KNEE_AT: f64 = 0.945;
/// When the toes are straight again (u).
pub(super) const TOES_STRAIGHT_AT: f64 = 0.80;
/// How much later the knee of a closing foot is bent the most (u), and how much more its ankle is.
pub(super) const CLOSING_KNEE_LATER: f64 = 0.02;
pub(super) const CLOSING_ANKLE: f64 = 2.0 * DEGREE;

/// The part of a swing, from either end, in which a leg of a turning body comes to lean as if it went straight on, and how
/// much farther it leans then: the thighs pass each other before mid-swing. (More would need more friction than soles have.)
pub(super) const STRAIGHTENED: f64 = 0.3;
pub(super) const OUTWARD: f64 = 1.3;

// Over the ground; x counts from 0 at toe-off to 1 at contact.

/// From when on (x) and over how long the clearance is asked for, and until when and over how long no more.
pub(super) const CLEAR_FROM: (f64, f64) = (0.05, 0.14);
pub(super) const CLEAR_UNTIL: (f64, f64) = (0.80, 0.2);
/// From when on (x) the late part of the clearance is kept, and how long before contact it ends.
pub(super) const LATE_FROM: f64 = 0.5;
pub(super) const LATE_ENDS: f64 = 0.03;
/// Samples nearer to an end than this (x) are left as they are.
pub(super) const ENDS_KEPT: f64 = 0.03;
/// How often the ankle is raised, and what it may lack after (m).
pub(super) const MOST_BUMPS: usize = 4;
pub(super) const LACK: f64 = 1e-5;
/// Half the width of a rise (x), and the least part of its height that its worst sample may have of it.
pub(super) const BUMP_REACH: f64 = 0.32;
pub(super) const LEAST_PART: f64 = 0.3;
/// A rise about a sample before this (x) ends here: later it would bend the nearly straight leg just before contact (2 to 4 % of
/// body weight in the vertical force).
pub(super) const EARLY: f64 = 0.75;
pub(super) const EARLY_ENDS: f64 = 0.88;
