//! What a walking style asks of a leg: where its foot stands, how it pushes off, what it swings through.

use super::style::Style;
use crate::limbs::jet::LegJet;
use crate::limbs::numbers::{ROUNDED, STEEPEST_PITCH};
use crate::limbs::push::Push;
use crate::limbs::stance::{Footing, Landing};
use crate::limbs::swing::{Clearance, Swing, Way};
use solaris_profiles::{Boundary, Piecewise, ProfileError};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// When the knee has its waypoint in the push (u).
const PUSH_WAYPOINT_AT: f64 = 0.46;
/// Duration of the piece that lands the foot (u).
const LANDING: f64 = 0.02;
/// When the thigh has its waypoint (u), and the thigh of a foot that closes beside the other.
const THIGH_AT: f64 = 0.84;
const CLOSING_THIGH_AT: f64 = 0.82;
/// When the ankle has its waypoint (u).
const ANKLE_AT: f64 = 0.83;
/// When the knee has its late waypoint (u).
const LATE_KNEE_AT: f64 = 0.945;
/// How much later the knee of a closing foot is bent the most (u), and how much more its ankle is.
const CLOSING_KNEE_LATER: f64 = 0.02;
const CLOSING_ANKLE: f64 = 2.0 * DEGREE;
/// How the foot is kept off the ground. A rise in mid-swing ends well before contact: later it would bend the nearly straight leg
/// just before it (2 to 4 % of body weight in the vertical force).
const CLEARANCE: Clearance = Clearance {
    height: 0.0,
    late: 0.0,
    from: (0.05, 0.14),
    until: (0.80, 0.2),
    ends_kept: 0.03,
    most_bumps: 4,
    reach: [0.32; 2],
    least_part: 0.3,
    early_ends: 0.88,
};

/// What a swing aims at, besides its two ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Aim {
    /// Thigh at its waypoint.
    pub(crate) thigh: f64,
    /// Knee at u = .945.
    pub(crate) late_knee: f64,
    /// By which part it is instead where the knee goes by itself between its peak and contact: a leg that lands bent is not stretched first.
    pub(crate) unstretched: f64,
    /// Whether the foot closes beside the other one, where the walk ends.
    pub(crate) beside: bool,
    /// See [`Way`].
    pub(crate) tilt: [f64; 2],
    /// See [`Way::sideways`].
    pub(crate) sideways: [f64; 2],
}

impl Style {
    /// Where and when a foot stands.
    pub(crate) fn footing(&self) -> Footing {
        Footing {
            yaw: self.foot_yaw,
            width: self.step_width,
            flat: self.foot_flat,
            toe_off: self.toe_off(),
            tilt: self.slope,
        }
    }

    /// How a foot lands.
    pub(crate) fn landing(&self) -> Landing {
        match &self.stairs {
            Some(stairs) => Landing::Ball { pitch: stairs.landing_pitch, rate: stairs.landing_rate },
            None => Landing::Heel,
        }
    }

    /// The stride's own push-off.
    pub(crate) fn push(&self) -> Push {
        Push {
            heel_off: self.heel_off,
            waypoint: Some((PUSH_WAYPOINT_AT, self.knee_push)),
            tip_roll_at: self.tip_roll_at(),
            toe_roll: self.toe_roll,
            least_knee: f64::NEG_INFINITY,
            most_knee: self.toe_off_most,
            rounding: (self.push_softness / ROUNDED).clamp(0.0, 1.0),
            most_roll: self.manner.toe_roll_part,
            steepest: STEEPEST_PITCH,
            softness: self.footfall.softness,
            knee_toe_off: Boundary::new(self.knee_toe_off, self.knee_toe_off_rate, self.knee_toe_off_acc),
        }
    }

    /// The knee at contact, with its derivatives by the foot's clock.
    pub(crate) fn contact_knee(&self) -> Boundary {
        Boundary::new(self.knee_contact, self.knee_contact_rate, self.knee_contact_acc)
    }

    /// The swing between two ends.
    pub(crate) fn swing(&self, start: &LegJet, end: &LegJet, aim: &Aim) -> Result<Swing, ProfileError> {
        let peak = (self.knee_peak_at, self.knee_peak);
        let mut late = [peak, (LATE_KNEE_AT, aim.late_knee)];
        if aim.unstretched > 0.0 && !aim.beside {
            let knots = [self.toe_off(), peak.0, 1.0];
            let free = Piecewise::quintic_spline(&knots, &[peak.1], start.knee, end.knee)?;
            late[1].1 += aim.unstretched * (free.position(LATE_KNEE_AT) - aim.late_knee);
        }
        let (thigh_at, knee, ankle): (f64, &[(f64, f64)], f64) = if aim.beside {
            (CLOSING_THIGH_AT, &[(peak.0 + CLOSING_KNEE_LATER, peak.1)], CLOSING_ANKLE)
        } else {
            (THIGH_AT, &late, 0.0)
        };
        let way = Way {
            toe_off: self.toe_off(),
            thigh: &[(thigh_at, aim.thigh)],
            knee,
            ankle: &[(ANKLE_AT, self.ankle_swing + ankle)],
            toes: self.manner.toes,
            landing: self.footfall.soft_landing.unwrap_or(LANDING),
            soft_landing: self.footfall.soft_landing.is_some(),
            tilt: aim.tilt,
            sideways: aim.sideways,
            outward: 0.0,
        };
        Swing::new(&way, start, end)
    }

    /// How its foot is kept off the ground; `late` is the part that is kept until shortly before contact.
    pub(crate) fn ground_clearance(&self, late: f64) -> Clearance {
        Clearance { height: self.clearance, late, until: self.footfall.clear_until, ..CLEARANCE }
    }
}
