//! One foot on the ground, from contact to toe-off, in closed form.
//!
//! Near the two ends of stance the knee is a law and the pitch of the foot is solved, never the reverse: there the leg is
//! nearly straight, and a small error in the foot would be a large one in the knee.

use super::jet::{LegJet, jets};
use super::numbers::{
    JET_STEP, KNEE_STEP, LANDING_STRAIGHTER, LEAST_KNEE_SINE, MOST_WIDTHS, PUSH_ATTEMPTS, PUSH_CHECKED,
    PUSH_EASES, PUSH_INSTANTS, ROLL_ATTEMPTS, ROUNDED, SOFT_WITHIN, STEEPEST_PITCH, STRAIGHTER_THAN_FLAT,
    TOE_OFF_GAIN, TOES_BEYOND, WAYPOINT_ABOVE_FLAT, WAYPOINT_GAIN, WAYPOINT_WIDTH,
};
use super::path::FootJet;
use super::push::Push;
use super::sole::{Sole, not_below_zero};
use crate::body::foot::FootPlane;
use crate::body::leg::{LegGeometry, LegPose};
use nalgebra::Vector3;
use solaris_profiles::{Boundary, Curve, Outside, Piecewise, ProfileError, Quintic, step};

/// What a foot does at the begin of its stance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Landing {
    /// It turns about the heel until it is flat.
    Heel,
    /// It turns about the ball, its toes flat, from this pitch (rad, against the ground) on: `γ = γ₀ (1 − t)³ [1 + 3t + 6t² − r·t (1 + 3t)]` with
    /// `t` = u over the time until it is flat, so that it has the rate `−r γ₀` over that time at first and comes to rest.
    Ball {
        /// γ₀.
        pitch: f64,
        /// r.
        rate: f64,
    },
    /// It stands flat already.
    Flat,
}

/// Where a foot stands, and when, on its own clock.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Footing {
    /// Outward turn of the foot (rad).
    pub(crate) yaw: f64,
    /// Distance of the two feet's heel prints to the side (m).
    pub(crate) width: f64,
    /// When the foot is flat.
    pub(crate) flat: f64,
    /// When it lifts.
    pub(crate) toe_off: f64,
    /// Pitch of the ground under it along z, uphill positive (rad).
    pub(crate) tilt: f64,
}

/// The left foot on the ground; its print's heel stands at y = z = 0 (the right foot's world is mirrored).
///
/// The ground may be pitched. The closed forms of a foot that turns on it are those of level ground in the ground's axes; the leg's
/// angles, and the pitches of foot and toes in every answer, are the world's: `γ_world = γ − β`.
#[derive(Clone, Debug)]
pub(crate) struct Stance {
    leg: LegGeometry,
    pub(crate) plane: FootPlane,
    sole: Sole,
    tilt: f64,
    landing: Landing,
    foot_flat: f64,
    toe_off: f64,
    push: Push,
    contact_knee: Option<Quintic>,
    push_knee: Option<Piecewise>,
}

impl Stance {
    pub(crate) fn new(leg: &LegGeometry, footing: &Footing, landing: Landing, push: Push) -> Self {
        let plane = FootPlane::new(footing.yaw);
        let heel = Vector3::new(footing.width / 2.0, 0.0, 0.0);
        Self {
            leg: *leg,
            plane,
            sole: Sole::new(leg, &plane, footing.tilt, heel),
            tilt: footing.tilt,
            landing,
            foot_flat: footing.flat,
            toe_off: footing.toe_off,
            push,
            contact_knee: None,
            push_knee: None,
        }
    }

    /// The ankle of the flat foot.
    pub(crate) fn flat_ankle(&self) -> Vector3<f64> {
        self.sole.flat_ankle()
    }

    /// Whether the foot has a push-off, so that its stance ends.
    pub(crate) fn pushes(&self) -> bool {
        self.push_knee.is_some()
    }

    pub(crate) fn lands_on_ball(&self) -> bool {
        matches!(self.landing, Landing::Ball { .. })
    }

    pub(crate) fn heel_off(&self) -> f64 {
        self.push.heel_off
    }

    pub(crate) fn tip_roll_at(&self) -> f64 {
        self.push.tip_roll_at
    }

    /// The knee at contact for a foot that lands on its heel with this pitch: what the leg needs, but hardly straighter than the
    /// style's (`straightest`). The more it is bent than `knee`, the less it goes on bending: not at all from `range` (rad) more than the style's on.
    pub(crate) fn landing_knee(
        &self,
        knee: Boundary,
        straightest: f64,
        pitch: f64,
        range: f64,
        hip: &Vector3<f64>,
    ) -> Boundary {
        let distance = (hip - self.ankle_on_heel(pitch)).norm_squared();
        let flexion = self.leg.knee_for(distance).max(straightest - LANDING_STRAIGHTER);
        let factor = (1.0 - (flexion - knee.position) / range).clamp(-1.0, 1.0);
        Boundary::new(flexion, knee.velocity * factor, knee.acceleration * factor)
    }

    /// Gives the knee its law from contact (the jet `contact`) to the flat foot.
    pub(crate) fn set_contact(
        &mut self,
        contact: Boundary,
        hip: impl Fn(f64) -> Vector3<f64>,
    ) -> Result<(), ProfileError> {
        let flat = self.flat_knee_jet(self.foot_flat, &hip);
        self.contact_knee = Some(Quintic::new(self.foot_flat, contact, flat)?);
        Ok(())
    }

    /// Gives the knee its law from heel-off to toe-off: through the waypoint, never straighter than the flat leg.
    pub(crate) fn set_push(&mut self, hip: impl Fn(f64) -> Vector3<f64>) -> Result<(), ProfileError> {
        let (heel_off, toe_off) = (self.push.heel_off, self.toe_off);
        let start = self.flat_knee_jet(heel_off, &hip);
        let steepest =
            (hip(toe_off) - self.sole.ankle_on_ball(&self.ball(toe_off), self.push.steepest)).norm_squared();
        let mut end = self.push.knee_toe_off;
        end.position = end.position.min(self.leg.knee_for(steepest.min(self.leg.almost_straight_squared())));
        let most = self.push.most_knee.max(end.position);
        if self.push.steepest < STEEPEST_PITCH {
            // As much slower as it is straighter, or the foot would go on to tip over.
            let part = (end.position / self.push.knee_toe_off.position).clamp(0.0, 1.0);
            (end.velocity, end.acceleration) = (end.velocity * part.powi(2), end.acceleration * part.powi(2));
        }
        let mut waypoint = self.push.waypoint.map(|(at, knee)| {
            let excess = (self.flat_knee(at, &hip) + WAYPOINT_ABOVE_FLAT - knee) / WAYPOINT_WIDTH;
            (at, knee + WAYPOINT_WIDTH * excess.min(MOST_WIDTHS).exp().ln_1p())
        });
        for attempt in 0..=PUSH_ATTEMPTS {
            let spline = match waypoint {
                Some((at, knee)) => Piecewise::quintic_spline(&[heel_off, at, toe_off], &[knee], start, end)?,
                None => Piecewise::quintic_spline(&[heel_off, toe_off], &[], start, end)?,
            }
            .outside(Outside::Extrapolate);
            let (from, to) = (heel_off + PUSH_CHECKED.0, toe_off - PUSH_CHECKED.1);
            let (mut worst, mut at) = (f64::NEG_INFINITY, from);
            for i in 0..PUSH_INSTANTS {
                let u = from + (to - from) * f64::from(i) / f64::from(PUSH_INSTANTS - 1);
                let least = (self.flat_knee(u, &hip) - STRAIGHTER_THAN_FLAT).max(self.push.least_knee);
                let straighter = least - spline.position(u);
                if straighter > worst {
                    (worst, at) = (straighter, u);
                }
            }
            self.push_knee = Some(spline);
            if attempt == PUSH_ATTEMPTS || worst <= 0.0 {
                break;
            }
            match &mut waypoint {
                Some((knot, knee)) if at < 0.5 * (*knot + toe_off) => *knee += WAYPOINT_GAIN * worst,
                _ => end.position = (end.position + TOE_OFF_GAIN * worst).min(most),
            }
        }
        self.push.knee_toe_off = end;
        // The ball, and with it the pitch, depends a little on the roll.
        for _ in 0..ROLL_ATTEMPTS {
            let pitch = self.push_phase(toe_off, &hip(toe_off)).1;
            self.push.toe_roll = self.push.toe_roll.min(self.push.most_roll * pitch);
        }
        Ok(())
    }

    /// The leg at its own clock `u`, for a hip there.
    #[inline]
    pub(crate) fn pose(&self, u: f64, hip: &Vector3<f64>) -> LegPose {
        let (ankle, pitch, toes) = self.foot(u, hip);
        let pose = self.plane.pose(&self.leg, &(hip - ankle), pitch - self.tilt, toes - self.tilt);
        LegPose { tilt: self.tilt, ..pose }
    }

    /// By how much the leg is too short for the foot (m).
    pub(crate) fn short(&self, u: f64, hip: &Vector3<f64>) -> f64 {
        let (ankle, ..) = self.foot(u, hip);
        ((hip - ankle).norm() - self.leg.thigh - self.leg.shank).max(0.0)
    }

    /// The ankle, and the pitches of foot and toes against the ground.
    #[inline]
    fn foot(&self, u: f64, hip: &Vector3<f64>) -> (Vector3<f64>, f64, f64) {
        if u > self.push.heel_off && self.pushes() {
            let (ankle, pitch) = self.push_phase(u, hip);
            (ankle, pitch, self.toes(u))
        } else if u < self.foot_flat {
            self.landing_foot(u, hip)
        } else {
            (self.sole.flat_ankle(), 0.0, 0.0)
        }
    }

    /// The same while it lands.
    #[inline]
    fn landing_foot(&self, u: f64, hip: &Vector3<f64>) -> (Vector3<f64>, f64, f64) {
        match self.landing {
            Landing::Heel => {
                let (ankle, pitch) = self.heel_phase(u, hip);
                (ankle, pitch, pitch)
            }
            Landing::Ball { pitch, rate } => {
                let t = u / self.foot_flat;
                let left = 1.0 + t * (3.0 + 6.0 * t) - rate * t * (1.0 + 3.0 * t);
                let pitch = pitch * (1.0 - t).powi(3) * left;
                (self.sole.ankle_on_ball(&self.sole.flat_ball(), pitch), pitch, 0.0)
            }
            Landing::Flat => (self.sole.flat_ankle(), 0.0, 0.0),
        }
    }

    /// The ankle when a foot that lands on its ball touches the ground.
    pub(crate) fn landing_ankle(&self, heel_pitch: f64) -> Vector3<f64> {
        match self.landing {
            Landing::Heel => self.ankle_on_heel(heel_pitch),
            Landing::Ball { pitch, .. } => self.sole.ankle_on_ball(&self.sole.flat_ball(), pitch),
            Landing::Flat => self.sole.flat_ankle(),
        }
    }

    /// The ankle at toe-off of a foot with this pitch.
    pub(crate) fn ankle_at_toe_off(&self, pitch: f64) -> Vector3<f64> {
        self.sole.ankle_on_ball(&self.ball(self.toe_off), pitch)
    }

    /// Angles and derivatives at contact; `knee` is the law's jet, or the leg's own where there is none.
    pub(crate) fn contact_jet(&self, knee: Option<Boundary>, hip: impl Fn(f64) -> Vector3<f64>) -> LegJet {
        self.jet(0.0, knee, |u| {
            let hip = hip(u);
            let (ankle, pitch, toes) = self.landing_foot(u, &hip);
            (hip - ankle, pitch, toes)
        })
    }

    /// Angles and derivatives at toe-off.
    pub(crate) fn toe_off_jet(&self, hip: impl Fn(f64) -> Vector3<f64>) -> LegJet {
        self.jet(self.toe_off, Some(self.push.knee_toe_off), |u| {
            let hip = hip(u);
            let (ankle, pitch) = self.push_phase(u, &hip);
            (hip - ankle, pitch, self.toes(u))
        })
    }

    /// The path of ankle and foot at contact.
    pub(crate) fn contact_path(&self, hip: impl Fn(f64) -> Vector3<f64>) -> FootJet {
        self.path(0.0, |u| self.landing_foot(u, &hip(u)))
    }

    /// The path of ankle and foot at toe-off.
    pub(crate) fn toe_off_path(&self, hip: impl Fn(f64) -> Vector3<f64>) -> FootJet {
        self.path(self.toe_off, |u| {
            let (ankle, pitch) = self.push_phase(u, &hip(u));
            (ankle, pitch, self.toes(u))
        })
    }

    fn path(&self, u: f64, foot: impl Fn(f64) -> (Vector3<f64>, f64, f64)) -> FootJet {
        let [x, y, z, pitch, extension] = jets(u, JET_STEP, |u| {
            let (ankle, pitch, toes) = foot(u);
            [ankle.x, ankle.y, ankle.z, pitch - self.tilt, pitch - toes]
        });
        FootJet { ankle: [x, y, z], pitch, extension }
    }

    fn jet(
        &self,
        u: f64,
        knee: Option<Boundary>,
        geometry: impl Fn(f64) -> (Vector3<f64>, f64, f64),
    ) -> LegJet {
        let [side, lean, distance, pitch, toes] = jets(u, JET_STEP, |u| {
            let (hip, pitch, toes) = geometry(u);
            let [side, up, forward] = self.plane.split(&hip);
            let v = side.hypot(up);
            let (pitch, toes) = (pitch - self.tilt, toes - self.tilt);
            [side.atan2(up), (-forward).atan2(v), v * v + forward * forward, pitch, toes]
        });
        let knee = knee.unwrap_or_else(|| self.knee_jet(&distance));
        // α = lean + β(k): chain rule through the angle of thigh and leg line.
        let kg = self.leg.geometric_knee(knee.position);
        let [beta] = jets(kg, KNEE_STEP, |kg| [self.leg.thigh_against_leg(kg)]);
        let thigh = Boundary::new(
            lean.position + beta.position,
            lean.velocity + beta.velocity * knee.velocity,
            lean.acceleration + beta.velocity * knee.acceleration + beta.acceleration * knee.velocity.powi(2),
        );
        LegJet { side, thigh, knee, pitch, toes }
    }

    /// Knee and derivatives from the squared distance of hip and ankle:
    ///
    /// ```text
    /// k′ = −(r²)′ / (2 L1 L2 sin k_g)      k″ = −((r²)″ + 2 L1 L2 cos k_g · k′²) / (2 L1 L2 sin k_g)
    /// ```
    ///
    /// The sine is kept from zero, where a straight leg has no rate.
    fn knee_jet(&self, distance: &Boundary) -> Boundary {
        let b = 2.0 * self.leg.thigh * self.leg.shank;
        let knee = self.leg.knee_for(distance.position);
        let (sin, cos) = self.leg.geometric_knee(knee).sin_cos();
        let sin = sin.max(LEAST_KNEE_SINE);
        let rate = -distance.velocity / (b * sin);
        Boundary::new(knee, rate, -(distance.acceleration + b * cos * rate * rate) / (b * sin))
    }

    fn flat_knee(&self, u: f64, hip: &impl Fn(f64) -> Vector3<f64>) -> f64 {
        let distance = (hip(u) - self.sole.flat_ankle()).norm_squared();
        self.leg.knee_for(distance.min(self.leg.almost_straight_squared()))
    }

    pub(crate) fn flat_knee_jet(&self, u: f64, hip: &impl Fn(f64) -> Vector3<f64>) -> Boundary {
        let [distance] = jets(u, JET_STEP, |u| [(hip(u) - self.sole.flat_ankle()).norm_squared()]);
        self.knee_jet(&distance)
    }

    /// The ankle of a foot that turns about the heel, for its pitch against the ground.
    pub(crate) fn ankle_on_heel(&self, pitch: f64) -> Vector3<f64> {
        self.sole.ankle_on_heel(pitch)
    }

    #[inline]
    fn heel_phase(&self, u: f64, hip: &Vector3<f64>) -> (Vector3<f64>, f64) {
        let knee = self.contact_knee.as_ref().map_or(0.0, |law| law.extrapolated(u).position);
        let law = self.sole.pitch_on_heel(hip, knee);
        let pitch = -not_below_zero(-law, self.softness(self.foot_flat - u));
        (self.ankle_on_heel(pitch), pitch)
    }

    /// Over how much pitch the foot stops at the ground, so long (u) from where it is flat by law: nothing there, so that it joins.
    fn softness(&self, from_flat: f64) -> f64 {
        self.push.softness * step::quintic(from_flat / SOFT_WITHIN).position
    }

    /// Pitch of the toes about the tip: `toe·((u − u_tt)/(u_to − u_tt))³`.
    #[inline]
    fn toes(&self, u: f64) -> f64 {
        let x = (u - self.push.tip_roll_at) / (self.toe_off - self.push.tip_roll_at);
        self.push.toe_roll * x.clamp(0.0, TOES_BEYOND).powi(3)
    }

    /// The ball joint, carried by the toes that roll about the tip.
    #[inline]
    fn ball(&self, u: f64) -> Vector3<f64> {
        self.sole.ball(self.toes(u))
    }

    #[inline]
    fn push_phase(&self, u: f64, hip: &Vector3<f64>) -> (Vector3<f64>, f64) {
        let knee = self.push_knee.as_ref().map_or(0.0, |law| law.position(u));
        let ball = self.ball(u);
        let law = self.sole.pitch_on_ball(hip, &ball, knee);
        // Not below 0; on slopes it would stay there in mid-push, and where it leaves is rounded off.
        let soft = not_below_zero(law, self.softness(u - self.push.heel_off));
        let pitch = if self.push.rounding == 0.0 {
            soft
        } else {
            let part = |from: f64| step::quintic((u - from) / PUSH_EASES.1).position;
            let width = ROUNDED * part(self.push.heel_off) * (1.0 - part(PUSH_EASES.0));
            let rounded = 0.5 * (law + law.hypot(width));
            soft + (rounded - soft) * self.push.rounding
        };
        (self.sole.ankle_on_ball(&ball, pitch), pitch)
    }
}
