//! The numbers of a whole walk, besides the style of its steady part. Clocks are in u, from the first lift's `u = d`.

use crate::limbs::numbers::LANDING_RANGE;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Rest before and after the movement, in strides: longer than any difference formula reaches, and long enough for the
/// splines to have come to rest (they ring by 0.43 a node).
pub(super) const REST: f64 = 0.2;
/// Begin of the movement, where it does not follow [`WalkNumbers::start_time`].
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
/// How much more a knee is bent when standing on a slope, over the slope.
pub(super) const KNEE_BY_SLOPE: f64 = 0.8;
/// Centre of mass ahead of the ankles when standing (m, for the reference height).
pub(super) const STANDING_AHEAD: f64 = 0.045;
/// Share of a height need that one pass corrects, the most it corrects, and the range of all corrections (m).
pub(super) const CORRECTION: (f64, f64, f64, f64) = (0.9, 0.01, -0.05, 0.06);

/// Passes whose heights are kept, at the beginning and at the end, so that the rest can settle.
pub(super) const KEPT_PASSES: (usize, usize) = (2, 4);
/// Part of the way to the momentum found that a pass goes: in the first passes, how many these are, and afterwards.
pub(super) const RELAXATION: (f64, usize, f64) = (0.5, 3, 0.8);
/// The same on ground that is not level, the passes that a walk takes there at least, and the range of its corrections (m).
pub(super) const GROUND_RELAXATION: (f64, usize, f64) = (0.4, 6, 0.7);
pub(super) const GROUND_PASSES: usize = 18;
pub(super) const GROUND_CORRECTIONS: (f64, f64) = (-0.12, 0.12);
/// The attempts there.
pub(super) const GROUND_BOUNDS: (usize, f64) = (6, 2.0);
/// How near to an edge the ground counts as high as the edge for a foot in the air, and how much higher an edge is at least (m).
pub(super) const EDGES: (f64, f64) = (0.02, 0.012);
/// How near on stairs, where soles reach nearly to the next riser.
pub(super) const STAIR_EDGES: f64 = 0.008;
/// How much straighter than the style's a knee on a flat foot may be (rad).
pub(super) const KNEE_FLAT_BELOW: f64 = 0.2 * DEGREE;
/// How much straighter than in a steady stride a knee may be whose foot has just become flat, and which flexion is enough in any stride (rad).
pub(super) const FLAT_STRAIGHTER: (f64, f64) = (2.0 * DEGREE, 13.0 * DEGREE);
/// The part of a swing that is over at least when its knee is bent the most, and that of the last one.
pub(super) const PEAK_FROM: (f64, f64) = (0.3, 0.18);
/// Below how many steps/min of somebody with legs of usual length (m), and over how many less, that comes to be so; and over which slope
/// uphill (rad).
pub(super) const USUAL_LEG: f64 = 0.92;
pub(super) const PEAK_BELOW: (f64, f64) = (90.0, 10.0);
pub(super) const PEAK_UPHILL: f64 = 5.0 * DEGREE;
/// From which slope on it is not asked of the last step, and over how much less it comes to be (rad).
pub(super) const PEAK_STEEP: (f64, f64) = (13.0 * DEGREE, DEGREE);
/// On ground that is not level a knee that lands so much more bent than in a steady stride (rad) is more bent in swing, too, by a part of it.
pub(super) const PEAK_FOLLOWS: (f64, f64) = (8.0 * DEGREE, 0.7);
/// A knee that lands so much more bent than in a stride is not stretched before (rad), one less so in part.
pub(super) const UNSTRETCHED: f64 = 6.0 * DEGREE;
/// Where the knee of a foot that lands goes as that of the flat foot does: how much more bent than in a stride it is, and over which range (rad); from
/// which slope on, and over which range (rad); and of which strides, but for the first foot and the last one (s, of somebody of the reference height).
pub(super) const LANDS_AS_FLAT: [(f64, f64); 3] =
    [(3.0 * DEGREE, 9.0 * DEGREE), (5.0 * DEGREE, 5.0 * DEGREE), (1.2, 0.2)];
/// How much more bent than in a stride the knee of the first foot to land may stay (rad): the body has not come far yet.
pub(super) const FIRST_MORE_BENT: f64 = 10.0 * DEGREE;
/// The least flexion of a knee on a flat foot (rad), and until when after its heel has begun to rise (u).
pub(super) const GROUND_LEAST_FLAT: (f64, f64) = (6.0 * DEGREE, 0.02);
/// The least flexion of a knee whose foot goes through the air on a path (rad).
pub(super) const LEAST_IN_AIR: f64 = 16.0 * DEGREE;
/// Least weight by which a need is divided: where a correction hardly lowers the body it is not asked for more than twice.
pub(super) const LEAST_WEIGHT: f64 = 0.5;
/// Least height of a hip over its ankle that is reckoned with, over the length of thigh and shank.
pub(super) const LEAST_HEIGHT: f64 = 0.5;
/// Instants at which a stance is looked at for its height: of a step, of the last step, while the other foot closes, of standing,
/// of a turning step after its heel has risen.
pub(super) const INSTANTS: [i32; 5] = [12, 14, 10, 12, 8];
/// Until when the last step is flat for its height, and from when to when it stands while the other foot closes (u after its
/// contact).
pub(super) const LAST_FLAT_UNTIL: f64 = 0.42;
pub(super) const CLOSING: (f64, f64) = (0.44, 0.80);
/// Until when after a turn.
pub(super) const TURNED_CLOSING: f64 = 1.05;
/// Until when a turning step is looked at for its height (u), and the knee flexion for which it is kept then.
pub(super) const TURNING_UNTIL: f64 = 0.42;
pub(super) const KNEE_TURNING: f64 = 3.0 * DEGREE;
/// The steepest pitch of a foot that pushes off round a turn (rad): the outer one is left far behind.
pub(super) const TURNING_STEEPEST: f64 = 60.0 * DEGREE;
/// From when the standing feet are looked at for their height (u).
pub(super) const STANDING_FROM: f64 = -0.6;
/// Duration of the first height correction's coming in (u).
pub(super) const CORRECTION_IN: f64 = 0.4;
/// Until which clock the knots at the beginning of a walk lie, and from which finish clock on those at its end.
pub(super) const KNOTS: (f64, f64) = (1.0, 0.1);
/// By how many steps earlier than that: a body that brakes is farther behind its feet than in a steady stride.
pub(super) const KNOTS_STEPS: usize = 2;
/// How much their smoothness counts, see [`super::heights::Heights::correct`].
pub(super) const SMOOTHING: f64 = 0.7;
/// Until when (u) a leg that has landed after the first step bends under the load as it comes, and how much it counts until then what
/// a steady stride's would.
pub(super) const LOADING: (f64, f64) = (0.19, 0.1);
/// How much a bound counts, how often they are made to keep above it and how many times as much each time, and what they may miss (m).
pub(super) const BOUND_WEIGHT: f64 = 2.0;
pub(super) const BOUND_ATTEMPTS: (usize, f64) = (3, 1.0);
pub(super) const BOUND_MISSED: f64 = 1e-12;
/// Share of what a leg says there that one pass corrects: the swing of the closing foot answers to it.
pub(super) const KNOT_SHARE: f64 = 0.7;
/// How much they lower the body at first (m).
pub(super) const KNOTS_FROM: f64 = 0.02;
/// How long after its heel has risen a leg still says how high the body should be (u).
pub(super) const TOLD_AFTER: f64 = 0.08;
/// Flexion of a standing knee as its heel rises for the first time (rad).
pub(super) const FIRST_KNEE: f64 = 8.0 * DEGREE;
/// Flexion of a knee that lands where knots are (rad).
pub(super) const FIRST_LANDING: f64 = 21.0 * DEGREE;
/// A knot this near to a landing, in distances of knots, is told by it: a little more than a half, so that two may be.
pub(super) const NEXT_TO: f64 = 0.5 + 1e-9;
/// The least flexion of a knee on a flat foot at a knot (rad).
pub(super) const LEAST_FLAT: f64 = 3.0 * DEGREE;
/// The least flexion of a knee that lands at a later knot (rad).
pub(super) const LEAST_LANDING: f64 = 12.0 * DEGREE;
/// Flexion of the last leg that lands while the other foot closes (rad), from when on (u after its contact) and over how long it comes
/// to it, and likewise from there to standing.
pub(super) const LAST_KNEE: f64 = 6.0 * DEGREE;
pub(super) const LAST_STANDS: (f64, f64) = (0.45, 0.35);
pub(super) const LAST_STRAIGHTENS: (f64, f64) = (0.04, 0.28);
/// How much of what the thigh at contact is ahead of its steady place its swing is, too.
pub(super) const THIGH_FOLLOWS: f64 = 0.8;

/// The foot that stands while the other makes the first step: its knee's waypoint: when (u), and how bent at least (rad).
pub(super) const STANDING_WAYPOINT: (f64, f64) = (0.40, 12.0 * DEGREE);
/// How much slower it bends at toe-off than a step's (rad by u).
pub(super) const STANDING_TOE_OFF_RATE: f64 = 60.0 * DEGREE;
/// The foot that makes the first step: how long before toe-off its toes begin to roll (u).
pub(super) const FIRST_TIP_ROLL: f64 = 0.06;
/// Pitch of its toes at toe-off (rad).
pub(super) const FIRST_TOE_ROLL: f64 = 12.0 * DEGREE;
/// Its knee at toe-off (rad), and how fast it bends (rad by u).
pub(super) const FIRST_TOE_OFF: (f64, f64) = (44.0 * DEGREE, 320.0 * DEGREE);

/// By how much a foot is turned outward in a turn, over what a step turns by: between two that are, and beside one that is not.
pub(super) const OPENED: (f64, f64) = (0.35, 0.6);
/// Part of its pace's length from which on a turning step lands on its heel as much as ever; the shorter, the flatter. It swings as a
/// foot does that closes beside the other one.
pub(super) const LANDS_FLATTER: f64 = 0.6;
/// How much at least: a sole that lands quite flat would sink as it comes down.
pub(super) const LANDS_LEAST: f64 = 0.25;
/// How far ahead of the body the head looks round a turn (s), and by how much at most (rad).
pub(super) const LOOKS_AHEAD: f64 = 0.25;
pub(super) const MOST_AHEAD: f64 = 25.0 * DEGREE;

/// When the load begins to shift to the foot that stands on, between begin and toe-off.
pub(super) const LOAD_SHIFT_FROM: f64 = 0.45;
/// Part of the settling after which both feet bear half.
pub(super) const LOAD_SETTLES: f64 = 0.75;
/// From when to when it does under the foot that makes the first step (u before its toe-off).
pub(super) const FIRST_COP: (f64, f64) = (0.26, 0.06);
/// Under the last foot: how long it rolls after it is flat (u), how far (over the foot's length), and from when on it goes
/// back to its place at rest (u).
pub(super) const LAST_COP_ROLL: (f64, f64) = (0.30, 0.60);
pub(super) const LAST_COP_FROM: f64 = 0.45;
/// How long before it lands a foot in the air counts for its next print (u): its share is zero there.
pub(super) const COUNTS_AHEAD: f64 = 0.15;
/// How long after the first toe-off the shift of load fore and aft ends, and how long before it the one sideways (u).
pub(super) const FIRST_SHIFTS: (f64, f64) = (0.05, 0.02);
/// When, after its heel has risen, the foot that makes the first step begins to be pressed where a step's is, and for how long it does so
/// (u).
pub(super) const FIRST_FREED: (f64, f64) = (-0.06, 0.12);
/// Least share by which is divided.
pub(super) const LEAST_SHARE: f64 = 0.05;

/// How a walk begins, ends and lands: what may be tuned without changing where its feet stand, and when.
///
/// Fades are (begin, duration); those that end a walk count on its finish clock, 0 one stride before the closing contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WalkNumbers {
    /// From the standing height to the walking one, and back.
    pub height_in: (f64, f64),
    /// See [`Self::height_in`].
    pub height_out: (f64, f64),
    /// Begin of everything that swings but the arms.
    pub swing_in: (f64, f64),
    /// Begin of the arms' swings.
    pub arms_in: (f64, f64),
    /// End of the height's harmonics.
    pub harmonics_out: (f64, f64),
    /// End of the pelvis' swings.
    pub pelvis_out: (f64, f64),
    /// End of the thorax' swings.
    pub thorax_out: (f64, f64),
    /// End of the arms' swings.
    pub arms_out: (f64, f64),
    /// From the first movement to the first lift (s, of somebody of the reference height; it goes with the root of height); none where the movement begins at u = −0.75.
    pub start_time: Option<f64>,
    /// Distance of the knots at which height is corrected where a walk begins and ends (s, likewise); 0 for one correction a contact there, too.
    pub knots: f64,
    /// Whether knots lie all along the walk, as where no two steps are alike.
    pub knots_throughout: bool,
    /// The steepest pitch of a foot at toe-off on ground that is not level (rad), for which the body stays low; none if it is not told.
    pub toe_off_pitch: Option<f64>,
    /// The foot that stands while the other makes the first step: when its heel rises (u), and how much later for each first double
    /// support: short steps take the hip less far ahead of the ankle.
    pub standing_heel_off: (f64, f64),
    /// Part of its duration in which the first shift of load comes in, and goes; 0 for a bump.
    pub first_shift_ramp: f64,
    /// Part of the settling in which the last shift fore and aft ends. What the pressure does last decides where a body comes to rest: the sooner the shift
    /// ends, the greater it is, and the slower the steps, the more so.
    pub last_shift: f64,
    /// Until when the pressure under it has come from its place at rest to where a step has it (u).
    pub standing_cop_until: f64,
    /// The foot that makes the first step: how long before toe-off its heel rises (u), and how long at most (s, likewise).
    pub first_heel_off: (f64, f64),
    /// How much less its knee is bent at toe-off than a step's (rad).
    pub standing_toe_off: f64,
    /// How long after toe-off the knee of a foot that has stood since the beginning is bent the most, at least (u).
    pub first_peak_after: f64,
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
            arms_in: (0.18, 0.85),
            harmonics_out: swing_out,
            pelvis_out: swing_out,
            thorax_out: swing_out,
            arms_out: swing_out,
            start_time: None,
            knots: 0.0,
            knots_throughout: false,
            toe_off_pitch: None,
            standing_heel_off: (0.06, 0.0),
            first_shift_ramp: 0.0,
            last_shift: 0.55,
            standing_cop_until: 0.30,
            first_heel_off: (0.22, f64::INFINITY),
            standing_toe_off: 4.0 * DEGREE,
            first_peak_after: 0.0,
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

impl WalkNumbers {
    /// With one correction of height a contact where a walk begins and ends, too: what ships for walks that begin or end in a turn,
    /// where knots would hold the outer leg too straight.
    pub fn by_contact() -> Self {
        Self {
            pelvis_out: (-0.14, 0.84),
            thorax_out: (0.39, 0.90),
            arms_out: (0.50, 1.14),
            correction_at: 0.26,
            closing_thigh: 0.78,
            landing_range: LANDING_RANGE,
            knee_closing: 1.5 * DEGREE,
            late_clearance: 0.025,
            arms_in: (-0.05, 0.75),
            ..Self::recipe()
        }
    }

    /// What ships on ground that is not level: no two steps are alike there, so that the body follows the legs all along.
    pub fn on_ground() -> Self {
        Self { knots_throughout: true, last_shift: 0.85, ..Self::default() }
    }

    /// What is tried next there: the body stays low where it would leave a foot on its tip, at the price of greater forces.
    pub fn low_on_ground() -> Self {
        Self { toe_off_pitch: Some(65.0 * DEGREE), ..Self::on_ground() }
    }
}

impl Default for WalkNumbers {
    /// What ships: the trunk stops before the arms do, and the closing leg swings less, so that the feet twist the ground less; the arms
    /// swing before the first foot has landed.
    fn default() -> Self {
        Self {
            start_time: Some(0.72),
            knots: 0.055,
            standing_heel_off: (0.01, 1.18),
            first_shift_ramp: 0.28,
            standing_cop_until: 0.45,
            first_heel_off: (0.22, 0.24),
            standing_toe_off: 13.0 * DEGREE,
            first_peak_after: 0.12,
            swing_in: (0.05, 0.70),
            ..Self::by_contact()
        }
    }
}
