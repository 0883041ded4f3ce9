//! One foot in the air: joint splines between the end of one stance and the begin of the next.

use super::jet::LegJet;
use super::numbers::{
    ANKLE_AT, BUMP_REACH, CLEAR_FROM, CLEAR_UNTIL, CLOSING_ANKLE, CLOSING_KNEE_LATER, CLOSING_THIGH_AT,
    EARLY, EARLY_ENDS, ENDS_KEPT, LACK, LANDING, LATE_ENDS, LATE_FROM, LATE_KNEE_AT, LEAST_PART, MOST_BUMPS,
    OUTWARD, STRAIGHTENED, THIGH_AT, TOES_STRAIGHT_AT,
};
use crate::body::leg::{LegGeometry, LegPose};
use crate::smooth::style::Style;
use solaris_profiles::{Boundary, Outside, Piecewise, ProfileError, step};

/// What a swing aims at, besides its two ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Aim {
    /// Thigh at its waypoint.
    pub(crate) thigh: f64,
    /// Knee at u = .945.
    pub(crate) late_knee: f64,
    /// Whether the foot closes beside the other one, where the walk ends.
    pub(crate) beside: bool,
    /// By how much the leg leans sideways at its two ends only because the body faces elsewhere than the foot, see [`sideways`].
    pub(crate) sideways: [f64; 2],
}

/// By how much a leg leans more to the side in its foot's plane than in that of the body, which is turned by `turn` to the left of
/// it. Between two such ends the leg would swing through the other one.
///
/// ```text
/// η − atan2(D·s cos ρ − D·f sin ρ, D_y)      D = hip − ankle,  ρ = turn
/// ```
pub(crate) fn sideways(leg: &LegGeometry, pose: &LegPose, turn: f64) -> f64 {
    let (drop, behind) = (leg.ankle_below_hip(pose), -leg.ankle_ahead_of_hip(pose));
    let ((sin, cos), (turn_sin, turn_cos)) = (pose.side.sin_cos(), turn.sin_cos());
    pose.side - (drop * sin * turn_cos - behind * turn_sin).atan2(drop * cos)
}

/// A rise of the ankle that keeps the foot clear of the ground: C², over part of the swing.
#[derive(Clone, Copy, Debug)]
struct Bump {
    from: f64,
    to: f64,
    height: f64,
}

impl Bump {
    fn at(&self, x: f64) -> f64 {
        let t = ((x - self.from) / (self.to - self.from)).clamp(0.0, 1.0);
        (4.0 * t * (1.0 - t)).powi(3) * self.height
    }
}

/// A swing on the foot's own clock, from toe-off to 1.
#[derive(Clone, Debug)]
pub(crate) struct Swing {
    toe_off: f64,
    side: Piecewise,
    thigh: Piecewise,
    knee: Piecewise,
    dorsiflexion: Piecewise,
    toes: Piecewise,
    /// See [`Aim`].
    sideways: [f64; 2],
    /// Pitch and its rate at contact.
    landing: (f64, f64),
    bumps: Vec<Bump>,
}

impl Swing {
    pub(crate) fn new(style: &Style, start: &LegJet, end: &LegJet, aim: &Aim) -> Result<Self, ProfileError> {
        let toe_off = style.toe_off();
        let spline = |knots: &[f64], values: &[f64], start, end| {
            Piecewise::quintic_spline(knots, values, start, end).map(|s| s.outside(Outside::Extrapolate))
        };
        let thigh_at = if aim.beside { CLOSING_THIGH_AT } else { THIGH_AT };
        let thigh = spline(&[toe_off, thigh_at, 1.0], &[aim.thigh], start.thigh, end.thigh)?;
        let knee = if aim.beside {
            spline(
                &[toe_off, style.knee_peak_at + CLOSING_KNEE_LATER, 1.0],
                &[style.knee_peak],
                start.knee,
                end.knee,
            )?
        } else {
            let knots = [toe_off, style.knee_peak_at, LATE_KNEE_AT, 1.0];
            spline(&knots, &[style.knee_peak, aim.late_knee], start.knee, end.knee)?
        };
        // The foot's pitch is C¹ at contact: a near-straight leg forces its rate there, and a smoother landing would turn
        // the toes far up before it. A cubic of duration h takes the rate from nothing to γ̇.
        let landing = (end.pitch.position, end.pitch.velocity);
        let landed_from = 1.0 - LANDING;
        let rest = landing.0 - landing.1 * LANDING / 3.0;
        let (k, a) = (knee.at(landed_from), thigh.at(landed_from));
        let before = Boundary::new(
            k.position - a.position - rest,
            k.velocity - a.velocity,
            k.acceleration - a.acceleration,
        );
        let of = |jet: fn(&Boundary) -> f64| jet(&start.knee) - jet(&start.thigh) - jet(&start.pitch);
        let after = Boundary::new(of(|b| b.position), of(|b| b.velocity), of(|b| b.acceleration));
        let ankle = style.ankle_swing + if aim.beside { CLOSING_ANKLE } else { 0.0 };
        let extension = Boundary::new(
            start.pitch.position - start.toes.position,
            start.pitch.velocity - start.toes.velocity,
            start.pitch.acceleration - start.toes.acceleration,
        );
        Ok(Self {
            toe_off,
            side: spline(&[toe_off, 1.0], &[], start.side, end.side)?,
            thigh,
            knee,
            dorsiflexion: spline(&[toe_off, ANKLE_AT, landed_from], &[ankle], after, before)?,
            toes: spline(&[toe_off, TOES_STRAIGHT_AT], &[], extension, Boundary::rest(0.0))?,
            sideways: aim.sideways,
            landing,
            bumps: Vec::new(),
        })
    }

    /// The leg at the clock `v`.
    pub(crate) fn pose(&self, leg: &LegGeometry, v: f64) -> LegPose {
        let mut pose = self.unlifted(v);
        let lift: f64 = self.bumps.iter().map(|bump| bump.at(self.phase(v))).sum();
        if lift > 0.0 {
            raise(leg, &mut pose, lift);
        }
        pose
    }

    /// 0 at toe-off, 1 at contact.
    fn phase(&self, v: f64) -> f64 {
        (v - self.toe_off) / (1.0 - self.toe_off)
    }

    fn unlifted(&self, v: f64) -> LegPose {
        let (thigh, knee) = (self.thigh.position(v), self.knee.position(v));
        let landed_from = 1.0 - LANDING;
        let pitch = if v < landed_from {
            knee - thigh - self.dorsiflexion.position(v)
        } else {
            let (contact, rate) = self.landing;
            let t = ((v - landed_from) / LANDING).clamp(0.0, 1.0);
            contact + rate * LANDING / 3.0 * (t * t * t - 1.0)
        };
        let extension = if v < TOES_STRAIGHT_AT { self.toes.position(v) } else { 0.0 };
        // In mid-swing the leg leans as if the body faced where the foot does.
        let x = self.phase(v).clamp(0.0, 1.0);
        let [before, after] = self.sideways;
        let part = step::quintic(x.min(1.0 - x) / STRAIGHTENED).position;
        let straightened = OUTWARD * (before + (after - before) * x) * part;
        let side = self.side.position(v) - straightened;
        LegPose { side, thigh, knee, pitch, toes: pitch - extension }
    }

    /// Raises the ankle where the foot would come too near to the ground: at most [`MOST_BUMPS`] times, about the worst sample.
    ///
    /// `samples` are clocks and the hip's heights there.
    ///
    /// `late` is the part of the clearance that is kept until shortly before contact, so that the foot does not sink between
    /// samples.
    pub(crate) fn clear_ground(
        &mut self,
        leg: &LegGeometry,
        clearance: f64,
        late: f64,
        samples: &[(f64, f64)],
    ) {
        struct At {
            x: f64,
            wanted: f64,
            hip: f64,
            drop: f64,
            cos_side: f64,
            pitch: f64,
            toes: f64,
        }
        let mut points: Vec<At> = samples
            .iter()
            .map(|&(v, hip)| {
                let (x, pose) = (self.phase(v), self.unlifted(v));
                let drop = leg.ankle_below_hip(&pose);
                let mid_swing = ((x - CLEAR_FROM.0) / CLEAR_FROM.1)
                    .min((CLEAR_UNTIL.0 - x) / CLEAR_UNTIL.1)
                    .clamp(0.0, 1.0);
                let late = if x > LATE_FROM { late * ((1.0 - x) / LATE_ENDS).clamp(0.0, 1.0) } else { 0.0 };
                let wanted = clearance * mid_swing.max(late);
                At { x, wanted, hip, drop, cos_side: pose.side.cos(), pitch: pose.pitch, toes: pose.toes }
            })
            .filter(|at| at.x > ENDS_KEPT && (at.x < 1.0 - ENDS_KEPT || at.wanted > 0.0))
            .collect();
        let toe = leg.toe_polar();
        for _ in 0..MOST_BUMPS {
            let missing =
                |at: &At| at.wanted - leg.lowest(toe, at.hip - at.drop * at.cos_side, at.pitch, at.toes);
            let Some((worst, at)) = points
                .iter()
                .map(|at| (missing(at), at))
                .reduce(|best, next| if next.0 > best.0 { next } else { best })
                .filter(|(worst, _)| *worst > LACK)
            else {
                break;
            };
            let end = if at.x < EARLY { EARLY_ENDS } else { 1.0 };
            let unit =
                Bump { from: (at.x - BUMP_REACH).max(0.0), to: (at.x + BUMP_REACH).min(end), height: 1.0 };
            let bump = Bump { height: worst / unit.at(at.x).max(LEAST_PART), ..unit };
            self.bumps.push(bump);
            for at in &mut points {
                at.drop -= bump.at(at.x) / at.cos_side;
            }
        }
    }
}

/// Raises the ankle by `lift` (m), the pitches kept: inverse kinematics in the leg's plane.
fn raise(leg: &LegGeometry, pose: &mut LegPose, lift: f64) {
    let (down, forward) = (leg.ankle_below_hip(pose), leg.ankle_ahead_of_hip(pose));
    let down = down - lift / pose.side.cos();
    pose.knee = leg.knee_for(down * down + forward * forward);
    pose.thigh = forward.atan2(down) + leg.thigh_against_leg(leg.geometric_knee(pose.knee));
}
