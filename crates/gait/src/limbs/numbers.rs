//! The numbers of a leg's laws that are the same for every style: angles in rad, lengths in m, `u` on the foot's own clock (0 at
//! contact, 1 a stride later).

const DEGREE: f64 = std::f64::consts::PI / 180.0;

// On the heel.

/// A knee that lands so much more bent than the style's does not go on bending.
pub(crate) const LANDING_RANGE: f64 = 24.0 * DEGREE;
/// How much straighter than the style's a knee may land.
pub(super) const LANDING_STRAIGHTER: f64 = 2.0 * DEGREE;

/// How long (u) before a foot is flat, and after its heel rises, its pitch stops at the ground as softly as it does at all.
pub(super) const SOFT_WITHIN: f64 = 0.04;

// In the push.

/// The greatest pitch of the foot at toe-off, also when the body is far ahead.
pub(crate) const STEEPEST_PITCH: f64 = 78.0 * DEGREE;
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
pub(crate) const MOST_KNEE_TOE_OFF: f64 = 60.0 * DEGREE;
/// Over how much pitch (rad) a foot is rounded off in mid-push on a slope.
pub(crate) const ROUNDED: f64 = DEGREE;
/// Until when a foot's pitch is rounded off in the push on a slope (u), and how long that takes to come and go.
pub(super) const PUSH_EASES: (f64, f64) = (0.50, 0.06);
/// How often the toes' roll is held against the foot's pitch.
pub(super) const ROLL_ATTEMPTS: usize = 2;
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

/// The part of a swing, from either end, in which a leg of a turning body comes to lean as if it went straight on, and how
/// much farther it leans then: the thighs pass each other before mid-swing. (More would need more friction than soles have.)
pub(super) const STRAIGHTENED: f64 = 0.3;
pub(super) const OUTWARD: f64 = 1.3;

/// Where the toes come to rest after toe-off, against the foot (rad, extension), unless they are too fast for that: they are slowed down by
/// so much at most (rad by u²), turn so far at least, and within so long (u).
pub(super) const SETTLED: f64 = 2.0 * DEGREE;
pub(super) const MOST_SLOWED: f64 = 70_000.0 * DEGREE;
pub(super) const LEAST_TURNED: f64 = DEGREE;
pub(super) const LONGEST_SETTLING: f64 = 0.12;

// Over the ground; x counts from 0 at toe-off to 1 at contact.

/// From when on (x) the late part of the clearance is kept, and how long before contact it ends.
pub(super) const LATE_FROM: f64 = 0.5;
pub(super) const LATE_ENDS: f64 = 0.03;
/// What the ankle may lack after it was raised (m).
pub(super) const LACK: f64 = 1e-5;
/// From when on (x) a sample is in the middle of the swing, and from when on it is late: a rise about one before it ends early.
pub(super) const MIDDLE_FROM: f64 = 0.2;
pub(super) const EARLY: f64 = 0.75;
