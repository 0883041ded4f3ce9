//! The numbers of a running style: from a speed, for any height.

use crate::body::REFERENCE_HEIGHT;
use crate::error::RequestError;
use crate::request::run::at_speed;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Height that the table belongs to (m).
const TABLE_HEIGHT: f64 = 1.76;
/// Speeds between which the table is read (m/s): above, the step keeps its length, below, its time.
const READ: (f64, f64) = (2.0, 6.0);

/// Lean of the thorax and flexion of the elbows in standing.
const STANDING_LEAN: f64 = 1.0 * DEGREE;
const STANDING_ELBOW: f64 = 12.0 * DEGREE;

/// Names the numbers of a style once: as fields, and as rows of the table with columns at 2.5, 3.5 and 4.5 m/s.
macro_rules! run_numbers {
    ($($(#[$doc:meta])* $name:ident: $unit:expr, [$slow:expr, $middle:expr, $fast:expr];)*) => {
        /// The numbers of one running style (rad, m, s; body weights for forces). *u* is the time since left contact over the
        /// stride's, *s* the part of the stance, *x* that of the swing.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct RunStyle {
            /// Speed (m/s).
            #[doc(alias = "velocity")]
            pub speed: f64,
            /// Length of a step, from one heel print to the next one of the other foot (m).
            pub step_length: f64,
            /// Outward turn of the feet.
            #[doc(alias = "toe-out")]
            pub foot_yaw: f64,
            /// Least height of the swinging foot's lowest point in mid-swing (m).
            pub clearance: f64,
            /// By how much shoe, heel pad and floor give in the middle of a stance (m): the foot stands lower by `give · sin³ πs`.
            #[doc(alias = "compliance")]
            pub give: f64,
            /// How far the upper arms stand out from the thorax, and are turned in about their own length.
            pub arm_abduction: f64,
            /// See `arm_abduction`.
            pub arm_inward: f64,
            $($(#[$doc])* pub $name: f64,)*
        }

        impl RunStyle {
            /// The table at a speed (m/s): linear between the columns, and beyond them.
            fn tabulated(at: f64, common: Common) -> Self {
                Self {
                    speed: common.speed,
                    step_length: 0.0,
                    foot_yaw: 6.0 * DEGREE,
                    clearance: 0.012 * common.height / REFERENCE_HEIGHT,
                    give: 0.0,
                    // So that the hands pass the thighs.
                    arm_abduction: 20.0 * DEGREE,
                    arm_inward: 10.0 * DEGREE,
                    $($name: at_speed([$slow, $middle, $fast], at) * $unit,)*
                }
            }

            /// Between this style and another one: `part` of the way.
            pub(super) fn mixed(&self, other: &Self, part: f64) -> Self {
                let mix = |a: f64, b: f64| a + (b - a) * part;
                Self {
                    speed: mix(self.speed, other.speed),
                    step_length: mix(self.step_length, other.step_length),
                    foot_yaw: mix(self.foot_yaw, other.foot_yaw),
                    clearance: mix(self.clearance, other.clearance),
                    give: mix(self.give, other.give),
                    arm_abduction: mix(self.arm_abduction, other.arm_abduction),
                    arm_inward: mix(self.arm_inward, other.arm_inward),
                    $($name: mix(self.$name, other.$name),)*
                }
            }

            /// The numbers of the table with their names.
            fn numbers(&self) -> impl Iterator<Item = (&'static str, f64)> {
                [$((stringify!($name), self.$name),)*].into_iter()
            }
        }
    };
}

struct Common {
    speed: f64,
    height: f64,
}

// Times, contacts and swings after the mean curves of 28 runners (Fukuchi, Fukuchi & Duarte 2017, PeerJ 5:e3298); docs/running.md.
run_numbers! {
    /// Duration of a stride, two steps (s).
    #[doc(alias = "cycle time")]
    stride_time: 1.0, [0.7451, 0.7031, 0.6570];
    /// Part of the stride that a foot is on the ground.
    #[doc(alias = "duty factor")]
    duty: 1.0, [0.378, 0.328, 0.308];
    /// Foot pitch at contact, toe up; negative where it lands on its ball, toe down.
    heel_strike_angle: DEGREE, [13.0, 15.0, 16.5];
    /// Knee flexion at contact.
    knee_contact: DEGREE, [13.0, 14.5, 16.0];
    /// Its rate, by u.
    knee_contact_rate: DEGREE, [480.0, 540.0, 590.0];
    /// Its second derivative, by u.
    knee_contact_acc: DEGREE, [9000.0, 11000.0, 12000.0];
    /// When the foot is flat (s).
    foot_flat: 1.0, [0.17, 0.16, 0.15];
    /// When the heel rises (s).
    heel_off: 1.0, [0.47, 0.47, 0.47];
    /// When the knee has its waypoint in the push (s).
    knee_push_at: 1.0, [0.75, 0.75, 0.75];
    /// Knee flexion there.
    knee_push: DEGREE, [26.0, 27.0, 28.0];
    /// Knee flexion at toe-off.
    knee_toe_off: DEGREE, [18.0, 17.0, 17.0];
    /// Its rate, by u.
    knee_toe_off_rate: DEGREE, [30.0, -20.0, -20.0];
    /// Its second derivative, by u.
    knee_toe_off_acc: DEGREE, [3500.0, 4500.0, 5500.0];
    /// Pitch of the toes at toe-off.
    toe_roll: DEGREE, [12.0, 15.0, 20.0];
    /// When the roll over the tip begins (s).
    tip_roll: 1.0, [0.66, 0.66, 0.66];
    /// Forward angle of the thigh at x = .40.
    thigh_40: DEGREE, [6.2, 2.0, 1.6];
    /// Forward angle of the thigh at x = .69.
    thigh_69: DEGREE, [26.5, 34.0, 40.9];
    /// Forward angle of the thigh at x = .88.
    thigh_88: DEGREE, [18.4, 24.4, 30.4];
    /// Knee flexion at x = .22.
    knee_22: DEGREE, [48.0, 48.0, 54.0];
    /// Knee flexion at x = .50.
    knee_50: DEGREE, [89.8, 105.1, 116.8];
    /// Knee flexion at x = .76.
    knee_76: DEGREE, [45.0, 54.6, 61.0];
    /// Knee flexion at x = .93.
    knee_93: DEGREE, [9.2, 10.3, 12.8];
    /// Dorsiflexion at x = .20.
    ankle_20: DEGREE, [-17.4, -22.0, -24.3];
    /// Dorsiflexion at x = .45.
    ankle_45: DEGREE, [-4.0, -8.5, -10.5];
    /// Dorsiflexion at x = .65.
    ankle_65: DEGREE, [10.0, 3.0, -0.5];
    /// Dorsiflexion at x = .85.
    ankle_85: DEGREE, [10.0, 7.0, 5.0];
    /// Height of the impact's bump in the vertical force.
    #[doc(alias = "impact peak")]
    impact: 1.0, [0.30, 0.45, 0.60];
    /// By how much the rest of the vertical force comes early.
    skew: 1.0, [0.08, 0.08, 0.08];
    /// Amplitude that the fore-aft force is expected to have.
    braking: 1.0, [0.20, 0.29, 0.37];
    /// Mean tilt of the pelvis, forward.
    anterior_tilt: DEGREE, [5.0, 5.5, 6.0];
    /// Amplitude of the tilt, twice a stride.
    tilt_swing: DEGREE, [3.3, 3.5, 3.6];
    /// Amplitude of the pelvis' turn.
    pelvic_rotation: DEGREE, [5.0, 6.0, 7.0];
    /// Amplitude of the pelvis' obliquity.
    pelvic_obliquity: DEGREE, [3.5, 4.0, 4.5];
    /// Mean forward lean of the thorax.
    thorax_lean: DEGREE, [4.0, 5.0, 6.5];
    /// Amplitude of the shoulders' flexion.
    arm_swing: DEGREE, [30.0, 36.0, 42.0];
    /// Mean of the shoulders' flexion.
    arm_mean: DEGREE, [-14.0, -16.0, -18.0];
    /// Mean of the elbows' flexion.
    elbow: DEGREE, [88.0, 90.0, 92.0];
    /// Amplitude of the elbows' flexion.
    elbow_swing: DEGREE, [12.0, 15.0, 18.0];
    /// Amplitude of the turn that the thorax is drawn to.
    thorax_yaw: DEGREE, [6.0, 7.0, 8.0];
    /// Distance of the heel prints' lines (for a height of 1.75 m).
    step_width: 1.0, [0.030, 0.028, 0.026];
}

impl RunStyle {
    /// The style of people at this speed (m/s), for a figure of this height (m). Speeds and times scale with √height:
    ///
    /// ```text
    /// k = √(H/1.76)      v = V/k in [2, 6]      T = k·T(v)·min(1, v·k/V)      S = V·T/2
    /// ```
    ///
    /// No check of ranges: see [`crate::run`].
    pub fn of(height: f64, speed: f64) -> Self {
        let scale = (height / TABLE_HEIGHT).sqrt();
        let at = (speed / scale).clamp(READ.0, READ.1);
        let mut style = Self::tabulated(at, Common { speed, height });
        style.stride_time *= scale * (at * scale / speed).min(1.0);
        style.step_width *= height / 1.75;
        style.step_length = 0.5 * speed * style.stride_time;
        style
    }

    /// The same on the forefoot, for speeds up to [`crate::FOREFOOT_SPEED`]: it lands on the ball with the toes down and the knee more bent, the heel comes down after it, and there is no impact.
    #[must_use]
    #[doc(alias = "forefoot strike")]
    pub fn on_forefoot(self) -> Self {
        Self {
            heel_strike_angle: -10.0 * DEGREE,
            knee_contact: at_speed([20.0, 23.0, 27.0], self.speed) * DEGREE,
            foot_flat: at_speed([0.25, 0.23, 0.21], self.speed),
            impact: 0.0,
            heel_off: 0.50,
            ankle_65: 2.0 * DEGREE,
            ankle_85: 5.0 * DEGREE,
            knee_93: 18.0 * DEGREE,
            ..self
        }
    }

    /// The same with trunk and arms at rest, as in standing.
    pub(super) fn standing(&self) -> Self {
        Self {
            tilt_swing: 0.0,
            pelvic_rotation: 0.0,
            pelvic_obliquity: 0.0,
            thorax_lean: STANDING_LEAN,
            arm_swing: 0.0,
            arm_mean: 0.0,
            elbow: STANDING_ELBOW,
            elbow_swing: 0.0,
            thorax_yaw: 0.0,
            ..*self
        }
    }

    /// Refuses numbers that are none.
    pub(crate) fn check(&self) -> Result<(), RequestError> {
        let common = [
            ("speed", self.speed),
            ("step_length", self.step_length),
            ("foot_yaw", self.foot_yaw),
            ("clearance", self.clearance),
            ("give", self.give),
            ("arm_abduction", self.arm_abduction),
            ("arm_inward", self.arm_inward),
        ];
        match common.into_iter().chain(self.numbers()).find(|(_, value)| !value.is_finite()) {
            Some((name, value)) => Err(RequestError::StyleNotFinite { name, value }),
            None => Ok(()),
        }
    }

    /// Steps a minute.
    #[doc(alias = "cadence")]
    pub fn step_frequency(&self) -> f64 {
        120.0 / self.stride_time
    }

    /// How long a foot is on the ground (s).
    #[doc(alias = "ground contact time")]
    pub fn contact_time(&self) -> f64 {
        self.duty * self.stride_time
    }

    /// How long both feet are in the air between two contacts (s).
    #[doc(alias = "aerial time")]
    pub fn flight_time(&self) -> f64 {
        (0.5 - self.duty) * self.stride_time
    }
}
