//! One foot on the ground, from contact to toe-off, in closed form.
//!
//! Near the two ends of stance the knee is a law and the pitch of the foot is solved, never the reverse: there the leg is
//! nearly straight, and a small error in the foot would be a large one in the knee.

use super::jet::{LegJet, jets};
use super::numbers::{
    JET_STEP, KNEE_STEP, LANDING_STRAIGHTER, LEAST_KNEE_SINE, MOST_KNEE_TOE_OFF, MOST_WIDTHS, PUSH_ATTEMPTS,
    PUSH_CHECKED, PUSH_INSTANTS, ROLL_ATTEMPTS, SOFT_WITHIN, STEEPEST_PITCH, STRAIGHTER_THAN_FLAT,
    TOE_OFF_GAIN, TOES_BEYOND, WAYPOINT_ABOVE_FLAT, WAYPOINT_GAIN, WAYPOINT_WIDTH,
};
use super::push::Push;
use crate::body::foot::FootPlane;
use crate::body::leg::{LegGeometry, LegPose, Polar};
use nalgebra::Vector3;
use solaris_profiles::{Boundary, Curve, Outside, Piecewise, ProfileError, Quintic, step};

/// What a foot does at the begin of its stance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Landing {
    /// It turns about the heel until it is flat.
    Heel,
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
}

/// The left foot on the ground; its print's heel stands at z = 0 (the right foot's world is mirrored).
#[derive(Clone, Debug)]
pub(crate) struct Stance {
    leg: LegGeometry,
    pub(crate) plane: FootPlane,
    landing: Landing,
    foot_flat: f64,
    toe_off: f64,
    push: Push,
    pub(crate) heel: Vector3<f64>,
    flat_ankle: Vector3<f64>,
    tip: Vector3<f64>,
    heel_polar: Polar,
    ball_polar: Polar,
    toe_polar: Polar,
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
            landing,
            foot_flat: footing.flat,
            toe_off: footing.toe_off,
            push,
            heel,
            flat_ankle: heel + plane.forward * leg.heel_behind + Vector3::y() * leg.ankle_height,
            tip: heel + plane.forward * leg.foot_length(),
            heel_polar: leg.heel_polar(),
            ball_polar: leg.ball_polar(),
            toe_polar: leg.toe_polar(),
            contact_knee: None,
            push_knee: None,
        }
    }

    /// The ankle of the flat foot.
    pub(crate) fn flat_ankle(&self) -> Vector3<f64> {
        self.flat_ankle
    }

    /// Whether the foot has a push-off, so that its stance ends.
    pub(crate) fn pushes(&self) -> bool {
        self.push_knee.is_some()
    }

    pub(crate) fn heel_off(&self) -> f64 {
        self.push.heel_off
    }

    pub(crate) fn tip_roll_at(&self) -> f64 {
        self.push.tip_roll_at
    }

    /// The knee at contact for a foot that lands on its heel with this pitch: what the leg needs, but hardly straighter than the
    /// style's (`knee`). The more it is bent, the less it goes on bending: not at all from `range` (rad) more than the style's on.
    pub(crate) fn landing_knee(
        &self,
        knee: Boundary,
        pitch: f64,
        range: f64,
        hip: &Vector3<f64>,
    ) -> Boundary {
        let distance = (hip - self.ankle_on_heel(pitch)).norm_squared();
        let flexion = self.leg.knee_for(distance).max(knee.position - LANDING_STRAIGHTER);
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
            (hip(toe_off) - self.ankle_on_ball(&self.ball(toe_off), STEEPEST_PITCH)).norm_squared();
        let mut end = self.push.knee_toe_off;
        end.position = end.position.min(self.leg.knee_for(steepest.min(self.leg.almost_straight_squared())));
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
                let straighter = self.flat_knee(u, &hip) - STRAIGHTER_THAN_FLAT - spline.position(u);
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
                _ => end.position = (end.position + TOE_OFF_GAIN * worst).min(MOST_KNEE_TOE_OFF),
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
        self.plane.pose(&self.leg, &(hip - ankle), pitch, toes)
    }

    /// By how much the leg is too short for the foot (m).
    pub(crate) fn short(&self, u: f64, hip: &Vector3<f64>) -> f64 {
        let (ankle, ..) = self.foot(u, hip);
        ((hip - ankle).norm() - self.leg.thigh - self.leg.shank).max(0.0)
    }

    /// The ankle, and the pitches of foot and toes.
    #[inline]
    fn foot(&self, u: f64, hip: &Vector3<f64>) -> (Vector3<f64>, f64, f64) {
        if u > self.push.heel_off && self.pushes() {
            let (ankle, pitch) = self.push_phase(u, hip);
            (ankle, pitch, self.toes(u))
        } else if u < self.foot_flat && self.landing == Landing::Heel {
            let (ankle, pitch) = self.heel_phase(u, hip);
            (ankle, pitch, pitch)
        } else {
            (self.flat_ankle, 0.0, 0.0)
        }
    }

    /// Angles and derivatives at contact; `knee` is the law's jet, or the leg's own where there is none.
    pub(crate) fn contact_jet(&self, knee: Option<Boundary>, hip: impl Fn(f64) -> Vector3<f64>) -> LegJet {
        self.jet(0.0, knee, |u| {
            let hip = hip(u);
            let (ankle, pitch) = match self.landing {
                Landing::Heel => self.heel_phase(u, &hip),
                Landing::Flat => (self.flat_ankle, 0.0),
            };
            (hip - ankle, pitch, pitch)
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
        let distance = (hip(u) - self.flat_ankle).norm_squared();
        self.leg.knee_for(distance.min(self.leg.almost_straight_squared()))
    }

    fn flat_knee_jet(&self, u: f64, hip: &impl Fn(f64) -> Vector3<f64>) -> Boundary {
        let [distance] = jets(u, JET_STEP, |u| [(hip(u) - self.flat_ankle).norm_squared()]);
        self.knee_jet(&distance)
    }

    /// The ankle of a foot that turns about the heel.
    pub(crate) fn ankle_on_heel(&self, pitch: f64) -> Vector3<f64> {
        let (sin, cos) = pitch.sin_cos();
        let (hz, ha) = (self.leg.heel_behind, self.leg.ankle_height);
        self.heel + self.plane.forward * (hz * cos + ha * sin) + Vector3::y() * (ha * cos - hz * sin)
    }

    #[inline]
    fn heel_phase(&self, u: f64, hip: &Vector3<f64>) -> (Vector3<f64>, f64) {
        let knee = self.contact_knee.as_ref().map_or(0.0, |law| law.extrapolated(u).position);
        let hip = self.plane.split(&(hip - self.heel));
        let law = self.leg.pitch_about(self.heel_polar, hip, knee);
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
        let (b, r) = self.toe_polar;
        let (sin, cos) = (b + self.toes(u)).sin_cos();
        self.tip - self.plane.forward * (r * cos) + Vector3::y() * (r * sin)
    }

    /// The ankle of a foot that turns about the ball joint, which is at `ball`.
    fn ankle_on_ball(&self, ball: &Vector3<f64>, pitch: f64) -> Vector3<f64> {
        let (angle, r) = self.ball_polar;
        let (sin, cos) = (pitch + angle).sin_cos();
        ball - self.plane.forward * (r * cos) + Vector3::y() * (r * sin)
    }

    #[inline]
    fn push_phase(&self, u: f64, hip: &Vector3<f64>) -> (Vector3<f64>, f64) {
        let knee = self.push_knee.as_ref().map_or(0.0, |law| law.position(u));
        let ball = self.ball(u);
        let hip = self.plane.split(&(hip - ball));
        let law = self.leg.pitch_over(self.ball_polar, hip, knee);
        let pitch = not_below_zero(law, self.softness(u - self.push.heel_off));
        (self.ankle_on_ball(&ball, pitch), pitch)
    }
}

/// The greater one of `x` and 0, C² with a width of `soft` to either side:
///
/// ```text
/// 2ε (t³ − t⁴/2)      t = (x + ε)/(2ε) in 0 … 1
/// ```
fn not_below_zero(x: f64, soft: f64) -> f64 {
    if x >= soft {
        x
    } else if x <= -soft {
        0.0
    } else {
        let t = 0.5 * (x / soft + 1.0);
        2.0 * soft * t * t * t * (1.0 - 0.5 * t)
    }
}
