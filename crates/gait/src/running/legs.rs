//! What a running style asks of a leg: where its foot stands, how it pushes off, what it swings through.

use super::style::RunStyle;
use crate::limbs::jet::LegJet;
use crate::limbs::numbers::{MOST_KNEE_TOE_OFF, STEEPEST_PITCH};
use crate::limbs::push::Push;
use crate::limbs::stance::{Footing, Landing};
use crate::limbs::swing::{Clearance, Swing, Toes, Way};
use crate::request::run::at_speed;
use solaris_profiles::{Boundary, ProfileError};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Duration of the piece that lands the foot (u).
const LANDING: f64 = 0.025;
/// How fast the heel of a foot that lands on its ball comes down at first, see [`Landing::Ball`].
const HEEL_RATE: f64 = 3.0;
/// When the toes are straight again (x).
const TOES_STRAIGHT_AT: f64 = 0.35;
/// By how much the swinging leg leans outward: its ankle passes the standing one 5 cm away.
const OUTWARD: f64 = 4.0 * DEGREE;
/// How the foot is kept off the ground.
const CLEARANCE: Clearance = Clearance {
    height: 0.0,
    late: 0.0,
    from: (0.03, 0.12),
    until: (0.86, 0.15),
    ends_kept: 0.004,
    most_bumps: 6,
    reach: [0.32, 0.22],
    least_part: 0.2,
    early_ends: 0.97,
};
/// Thigh and knee of people at toe-off and at contact, at 2.5, 3.5 and 4.5 m/s (degrees; Fukuchi 2017): where the planned leg
/// differs there, the waypoints near it are shifted with it.
const PEOPLE_TOE_OFF: [[f64; 3]; 2] = [[-19.2, -23.2, -27.1], [13.8, 11.3, 10.5]];
const PEOPLE_CONTACT: [[f64; 3]; 2] = [[17.0, 21.0, 24.9], [9.4, 10.3, 11.8]];
/// Part of the knee's difference at toe-off that its waypoint at x = .22 has, and of that at contact the one at x = .93.
const KNEE_FOLLOWS: (f64, f64) = (0.6, 0.2);

impl RunStyle {
    /// Where and when a foot stands.
    pub(super) fn footing(&self) -> Footing {
        let flat = self.foot_flat * self.duty;
        Footing { yaw: self.foot_yaw, width: self.step_width, flat, toe_off: self.duty, tilt: 0.0 }
    }

    /// By how much the sole of a foot that touched at 0 has given at the clock `u` of its stance (m): `give · sin³ πs`, smooth to the acceleration at both ends. A
    /// spring that gives as the force rises does so in the first tenth of the stance, and the hip's moments with it.
    pub(super) fn given(&self, u: f64) -> f64 {
        let s = (u / self.duty).clamp(0.0, 1.0);
        self.give * (std::f64::consts::PI * s).sin().powi(3)
    }

    /// Whether a foot lands on its ball.
    pub(super) fn lands_on_ball(&self) -> bool {
        self.heel_strike_angle < 0.0
    }

    /// How a foot lands.
    pub(super) fn landing(&self) -> Landing {
        if self.lands_on_ball() {
            Landing::Ball { pitch: -self.heel_strike_angle, rate: HEEL_RATE }
        } else {
            Landing::Heel
        }
    }

    pub(super) fn push(&self) -> Push {
        Push {
            softness: 0.0,
            heel_off: self.heel_off * self.duty,
            waypoint: Some((self.knee_push_at * self.duty, self.knee_push)),
            tip_roll_at: self.tip_roll * self.duty,
            toe_roll: self.toe_roll,
            least_knee: f64::NEG_INFINITY,
            most_knee: MOST_KNEE_TOE_OFF,
            rounding: 0.0,
            most_roll: f64::MAX,
            steepest: STEEPEST_PITCH,
            knee_toe_off: Boundary::new(self.knee_toe_off, self.knee_toe_off_rate, self.knee_toe_off_acc),
        }
    }

    /// The knee at contact, with its derivatives by u.
    pub(super) fn contact_knee(&self) -> Boundary {
        Boundary::new(self.knee_contact, self.knee_contact_rate, self.knee_contact_acc)
    }

    /// The swing between two ends. The thigh's waypoints are shifted by its differences Δ from people's at the ends,
    /// `(1 − x)² Δ₀ + x² Δ₁`.
    pub(super) fn swing(&self, start: &LegJet, end: &LegJet) -> Result<Swing, ProfileError> {
        let at = |x: f64| self.duty + x * (1.0 - self.duty);
        let from_people = |jet: &LegJet, people: &[[f64; 3]; 2]| {
            let [thigh, knee] = people.map(|row| self.people(row));
            (jet.thigh.position - thigh, jet.knee.position - knee)
        };
        let (thigh_after, knee_after) = from_people(start, &PEOPLE_TOE_OFF);
        let (thigh_before, knee_before) = from_people(end, &PEOPLE_CONTACT);
        let thigh =
            |x: f64, angle: f64| (at(x), angle + (1.0 - x).powi(2) * thigh_after + x * x * thigh_before);
        let way = Way {
            toe_off: self.duty,
            thigh: &[thigh(0.40, self.thigh_40), thigh(0.69, self.thigh_69), thigh(0.88, self.thigh_88)],
            knee: &[
                (at(0.22), self.knee_22 + KNEE_FOLLOWS.0 * knee_after),
                (at(0.50), self.knee_50),
                (at(0.76), self.knee_76),
                (at(0.93), self.knee_93 + KNEE_FOLLOWS.1 * knee_before),
            ],
            ankle: &[
                (at(0.20), self.ankle_20),
                (at(0.45), self.ankle_45),
                (at(0.65), self.ankle_65),
                (at(0.85), self.ankle_85),
            ],
            toes: Toes::StraightAt(at(TOES_STRAIGHT_AT)),
            landing: LANDING,
            tilt: [0.0; 2],
            soft_landing: false,
            sideways: [0.0; 2],
            outward: OUTWARD,
        };
        // The toes of a foot that lands on its ball are bent, and it comes down as the heel goes on to.
        if self.lands_on_ball() { Swing::until(&way, start, end) } else { Swing::new(&way, start, end) }
    }

    /// What is left of a swing that a walk has begun, to its end in a run: the knee bends as much less as the thigh has less far to go.
    pub(super) fn swing_on(&self, start: &LegJet, end: &LegJet) -> Result<Swing, ProfileError> {
        let at = |x: f64| self.duty + x * (1.0 - self.duty);
        let [thigh, knee] = PEOPLE_CONTACT.map(|row| self.people(row));
        let thigh_before = end.thigh.position - thigh;
        let knee_before = end.knee.position - knee;
        let way = Way {
            toe_off: self.duty,
            thigh: &[
                (at(0.55), self.thigh_69 + 0.8 * thigh_before),
                (at(0.82), self.thigh_88 + 0.9 * thigh_before),
            ],
            knee: &[
                (at(0.25), start.knee.position + 0.2 * (self.knee_50 - start.knee.position)),
                (at(0.64), self.knee_76),
                (at(0.90), self.knee_93 + KNEE_FOLLOWS.1 * knee_before),
            ],
            ankle: &[(at(0.40), self.ankle_65), (at(0.80), self.ankle_85)],
            toes: Toes::StraightAt(at(TOES_STRAIGHT_AT)),
            landing: LANDING,
            tilt: [0.0; 2],
            soft_landing: false,
            sideways: [0.0; 2],
            outward: 0.5 * OUTWARD,
        };
        Swing::new(&way, start, end)
    }

    /// The swing from a run's toe-off into the middle of a walk's.
    pub(super) fn swing_into(&self, start: &LegJet, end: &LegJet) -> Result<Swing, ProfileError> {
        let at = |x: f64| self.duty + x * (1.0 - self.duty);
        let knee_after = start.knee.position - self.people(PEOPLE_TOE_OFF[1]);
        let between = |part: f64, from: f64, to: f64| from + part * (to - from);
        let way = Way {
            toe_off: self.duty,
            thigh: &[(at(0.50), between(0.45, start.thigh.position, end.thigh.position))],
            knee: &[
                (at(0.25), self.knee_22 + KNEE_FOLLOWS.0 * knee_after),
                (at(0.55), between(0.6, end.knee.position, self.knee_50)),
            ],
            ankle: &[(at(0.20), self.ankle_20), (at(0.5), self.ankle_45)],
            toes: Toes::StraightAt(at(TOES_STRAIGHT_AT)),
            landing: LANDING,
            tilt: [0.0; 2],
            soft_landing: true,
            sideways: [0.0; 2],
            outward: 0.5 * OUTWARD,
        };
        Swing::until(&way, start, end)
    }

    /// How its foot is kept off the ground.
    pub(super) fn ground_clearance(&self) -> Clearance {
        Clearance { height: self.clearance, ..CLEARANCE }
    }

    /// A row of people's at this speed (rad), held at its ends.
    fn people(&self, row: [f64; 3]) -> f64 {
        at_speed(row, self.speed.clamp(2.5, 4.5)) * DEGREE
    }
}
