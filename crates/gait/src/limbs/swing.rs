//! One foot in the air: joint splines between the end of one stance and the begin of the next.

use super::jet::LegJet;
use super::numbers::{
    EARLY, LACK, LATE_ENDS, LATE_FROM, LEAST_TURNED, LONGEST_SETTLING, MIDDLE_FROM, MOST_SLOWED, OUTWARD,
    SETTLED, STRAIGHTENED,
};
use crate::body::foot::FootPlane;
use crate::body::leg::{LegGeometry, LegPose};
use nalgebra::Vector3;
use solaris_profiles::{Boundary, Outside, Piecewise, ProfileError, step};

/// What a swing goes through between its two ends, on the foot's own clock.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Way<'a> {
    pub(crate) toe_off: f64,
    /// Waypoints: when and how much.
    pub(crate) thigh: &'a [(f64, f64)],
    pub(crate) knee: &'a [(f64, f64)],
    /// Of the ankle's dorsiflexion.
    pub(crate) ankle: &'a [(f64, f64)],
    pub(crate) toes: Toes,
    /// Duration of the piece that lands the foot.
    pub(crate) landing: f64,
    /// Pitch of the ground at its two ends.
    pub(crate) tilt: [f64; 2],
    /// Whether the foot's pitch is C² at contact.
    pub(crate) soft_landing: bool,
    /// By how much the leg leans sideways at its two ends only because the body faces elsewhere than the foot, see [`sideways`].
    pub(crate) sideways: [f64; 2],
    /// By how much the leg leans outward in mid-swing, so that it passes the other one (rad).
    pub(crate) outward: f64,
}

/// How the toes come back to the foot after toe-off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Toes {
    /// In one piece, straight from so many strides after contact on. They claw on the way: their rate at toe-off is large.
    StraightAt(f64),
    /// As soon as they can without clawing, to this extension (rad) in mid-swing; straight when the foot lands.
    Extended(f64),
}

impl Toes {
    /// Their extension over the swing, from its jet at toe-off to that at the contact (u = 1), if they are not straight there; they come
    /// to rest at `settled` first.
    pub(super) fn spline(
        self,
        toe_off: f64,
        settled: f64,
        start: Boundary,
        end: Option<Boundary>,
    ) -> Result<Piecewise, ProfileError> {
        let rest = Boundary::rest(0.0);
        match self {
            Self::StraightAt(at) => match end {
                None => Piecewise::quintic_spline(&[toe_off, at], &[], start, rest),
                Some(end) => Piecewise::quintic_spline(&[toe_off, at, 1.0], &[0.0], start, end),
            },
            Self::Extended(extension) => {
                let (v, a) = (-start.velocity.min(0.0), -start.acceleration.min(0.0));
                // How far they turn until they rest, and when they do: the quintic from a rest at D below to (0, −v, −a) is
                // (1 − t)³·(D(1 + 3t + 6t²) − V·t(1 + 3t) − ½A·t²) with V = v·t₁ and A = a·t₁²; it goes below D nowhere if
                // 10·D ≥ 4·V + ½·A.
                let turned = (start.position - settled).max(v * v / (2.0 * MOST_SLOWED)).max(LEAST_TURNED);
                let within = 20.0 * turned / (4.0 * v + (16.0 * v * v + 20.0 * a * turned).sqrt());
                let (rests, still) = (start.position - turned, toe_off + within.min(LONGEST_SETTLING));
                let knots = [toe_off, still, 0.5 * (still + 1.0), 1.0];
                Piecewise::quintic_hermite(
                    &knots,
                    &[start, Boundary::rest(rests), Boundary::rest(extension), end.unwrap_or(rest)],
                )
            }
        }
    }
}

/// How a swinging foot is kept off the ground; x counts from 0 at toe-off to 1 at contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clearance {
    /// What is asked for in mid-swing (m).
    pub(crate) height: f64,
    /// The part of it that is kept until shortly before contact, so that the foot does not sink between samples.
    pub(crate) late: f64,
    /// From when on (x) and over how long it is asked for, and until when and over how long no more.
    pub(crate) from: (f64, f64),
    pub(crate) until: (f64, f64),
    /// Samples nearer to an end than this (x) are left as they are.
    pub(crate) ends_kept: f64,
    /// How often the ankle is raised.
    pub(crate) most_bumps: usize,
    /// Half the width of a rise (x) in the middle of the swing, and about its ends.
    pub(crate) reach: [f64; 2],
    /// The least part of a rise's height that its worst sample may have of it.
    pub(crate) least_part: f64,
    /// Where a rise ends (x) that is not about a late sample.
    pub(crate) early_ends: f64,
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
pub(super) struct Bump {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) height: f64,
}

impl Bump {
    pub(super) fn at(&self, x: f64) -> f64 {
        hump(((x - self.from) / (self.to - self.from)).clamp(0.0, 1.0)) * self.height
    }
}

/// 0 at 0 and at 1, 1 between, C² at its ends: `(4t(1 − t))³`.
fn hump(t: f64) -> f64 {
    (4.0 * t * (1.0 - t)).powi(3)
}

/// The last piece of a foot's pitch before contact. A near-straight leg forces its rate γ̇ there; before it the foot hardly turns.
#[derive(Clone, Copy, Debug)]
struct Touchdown {
    contact: Boundary,
    /// Duration h (u).
    time: f64,
    soft: bool,
}

impl Touchdown {
    /// The pitch when the part `t` of it is over. It begins with neither rate nor second derivative if it is soft, and ends with those of
    /// the contact; else it is the cubic that takes the rate from nothing to γ̇:
    ///
    /// ```text
    /// γ̇(t) = γ̇ t²      soft: γ̇ (3t² − 2t³) + γ̈ h (t³ − t²)
    /// ```
    fn pitch(&self, t: f64) -> f64 {
        let t = t.clamp(0.0, 1.0);
        let (rate, bend) = (self.contact.velocity, self.contact.acceleration * self.time);
        let cube = t * t * t;
        let turned = if self.soft {
            rate * (cube - 0.5 * cube * t - 0.5) + bend * (0.25 * cube * t - cube / 3.0 + 1.0 / 12.0)
        } else {
            rate / 3.0 * (cube - 1.0)
        };
        self.contact.position + turned * self.time
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
    /// See [`Way`].
    tilt: [f64; 2],
    sideways: [f64; 2],
    outward: f64,
    landing: Touchdown,
    landed_from: f64,
    bumps: Vec<Bump>,
}

impl Swing {
    /// From toe-off to a contact: the toes are straight there, and the foot hardly turns before it.
    pub(crate) fn new(way: &Way<'_>, start: &LegJet, end: &LegJet) -> Result<Self, ProfileError> {
        Self::ending(way, start, end, true)
    }

    /// The same, to an instant at which the foot is still in the air.
    pub(crate) fn until(way: &Way<'_>, start: &LegJet, end: &LegJet) -> Result<Self, ProfileError> {
        Self::ending(way, start, end, false)
    }

    fn ending(way: &Way<'_>, start: &LegJet, end: &LegJet, lands: bool) -> Result<Self, ProfileError> {
        let toe_off = way.toe_off;
        let spline = |waypoints: &[(f64, f64)], until: f64, start, end| {
            let mut knots = vec![toe_off];
            knots.extend(waypoints.iter().map(|(at, _)| *at));
            knots.push(until);
            let values: Vec<f64> = waypoints.iter().map(|(_, value)| *value).collect();
            Piecewise::quintic_spline(&knots, &values, start, end).map(|s| s.outside(Outside::Extrapolate))
        };
        let thigh = spline(way.thigh, 1.0, start.thigh, end.thigh)?;
        let knee = spline(way.knee, 1.0, start.knee, end.knee)?;
        let landing = Touchdown { contact: end.pitch, time: way.landing, soft: way.soft_landing };
        let (landed_from, before) = if lands {
            let landed_from = 1.0 - way.landing;
            let (k, a) = (knee.at(landed_from), thigh.at(landed_from));
            let before = Boundary::new(
                k.position - a.position - landing.pitch(0.0),
                k.velocity - a.velocity,
                k.acceleration - a.acceleration,
            );
            (landed_from, before)
        } else {
            (1.0, dorsiflexion(end))
        };
        let toes = (!lands).then(|| extension(end));
        Ok(Self {
            toe_off,
            side: spline(&[], 1.0, start.side, end.side)?,
            thigh,
            knee,
            dorsiflexion: spline(way.ankle, landed_from, dorsiflexion(start), before)?,
            toes: way.toes.spline(toe_off, SETTLED, extension(start), toes)?,
            tilt: way.tilt,
            sideways: way.sideways,
            outward: way.outward,
            landing,
            landed_from: if lands { landed_from } else { f64::INFINITY },
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
        let pitch = if v < self.landed_from {
            knee - thigh - self.dorsiflexion.position(v)
        } else {
            self.landing.pitch((v - self.landed_from) / self.landing.time)
        };
        let extension = self.toes.position(v);
        // In mid-swing the leg leans as if the body faced where the foot does.
        let x = self.phase(v).clamp(0.0, 1.0);
        let [before, after] = self.sideways;
        let part = step::quintic(x.min(1.0 - x) / STRAIGHTENED).position;
        let straightened = OUTWARD * (before + (after - before) * x) * part;
        let side = self.side.position(v) - straightened - self.outward * hump(x);
        let [tilt, after] = self.tilt;
        let tilt = tilt + (after - tilt) * step::quintic(x).position;
        LegPose { side, thigh, knee, pitch, toes: pitch - extension, tilt }
    }

    /// Raises the ankle where the foot would come too near to level ground: about the worst sample, a few times.
    ///
    /// `samples` are clocks and the hip's heights there.
    pub(crate) fn clear_ground(&mut self, leg: &LegGeometry, clearance: &Clearance, samples: &[(f64, f64)]) {
        let toe = leg.toe_polar();
        let points = samples.iter().map(|&(v, hip)| (v, Vector3::new(0.0, hip, 0.0)));
        self.raise_over(leg, clearance, points, |at| {
            leg.lowest(toe, at.hip.y - at.drop * at.pose.side.cos(), at.pose.pitch, at.pose.toes)
        });
    }

    /// The same over any ground, for the hip's places in the print's frame; `gap` is a point's height above the ground there.
    pub(crate) fn clear_terrain(
        &mut self,
        leg: &LegGeometry,
        plane: &FootPlane,
        clearance: &Clearance,
        samples: &[(f64, Vector3<f64>)],
        gap: impl Fn(&Vector3<f64>) -> f64,
    ) {
        self.raise_over(leg, clearance, samples.iter().copied(), |at| {
            plane.sole(leg, &at.hip, &at.pose, at.drop).iter().map(&gap).fold(f64::INFINITY, f64::min)
        });
    }

    /// Raises the ankle about the sample with the least `gap` over what is wanted, a few times.
    fn raise_over(
        &mut self,
        leg: &LegGeometry,
        clearance: &Clearance,
        samples: impl Iterator<Item = (f64, Vector3<f64>)>,
        gap: impl Fn(&Over) -> f64,
    ) {
        let mut points: Vec<Over> = samples
            .map(|(v, hip)| {
                let (x, pose) = (self.phase(v), self.unlifted(v));
                let drop = leg.ankle_below_hip(&pose);
                let mid_swing = ((x - clearance.from.0) / clearance.from.1)
                    .min((clearance.until.0 - x) / clearance.until.1)
                    .clamp(0.0, 1.0);
                let late = clearance.late * ((1.0 - x) / LATE_ENDS).clamp(0.0, 1.0);
                let late = if x > LATE_FROM { late } else { 0.0 };
                let wanted = clearance.height * mid_swing.max(late);
                Over { x, wanted, hip, drop, pose }
            })
            .filter(|at| at.x > clearance.ends_kept && (at.x < 1.0 - clearance.ends_kept || at.wanted > 0.0))
            .collect();
        for _ in 0..clearance.most_bumps {
            let missing = |at: &Over| at.wanted - gap(at);
            let Some((worst, at)) = points
                .iter()
                .map(|at| (missing(at), at))
                .reduce(|best, next| if next.0 > best.0 { next } else { best })
                .filter(|(worst, _)| *worst > LACK)
            else {
                break;
            };
            let end = if at.x < EARLY { clearance.early_ends } else { 1.0 };
            let [middle, ends] = clearance.reach;
            let reach = if at.x > MIDDLE_FROM && at.x < EARLY { middle } else { ends };
            let unit = Bump { from: (at.x - reach).max(0.0), to: (at.x + reach).min(end), height: 1.0 };
            let bump = Bump { height: worst / unit.at(at.x).max(clearance.least_part), ..unit };
            self.bumps.push(bump);
            for at in &mut points {
                at.drop -= bump.at(at.x) / at.pose.side.cos();
            }
        }
    }
}

/// How far the foot is bent up against the shank.
fn dorsiflexion(LegJet { knee, thigh, pitch, .. }: &LegJet) -> Boundary {
    Boundary::new(
        knee.position - thigh.position - pitch.position,
        knee.velocity - thigh.velocity - pitch.velocity,
        knee.acceleration - thigh.acceleration - pitch.acceleration,
    )
}

/// How far the toes are extended against the foot.
fn extension(jet: &LegJet) -> Boundary {
    let LegJet { pitch, toes, .. } = jet;
    Boundary::new(
        pitch.position - toes.position,
        pitch.velocity - toes.velocity,
        pitch.acceleration - toes.acceleration,
    )
}

/// A sample of a swing over the ground: when, how high it is to be, the hip, how far the ankle is below it in the leg's plane, and the
/// posture that was not raised.
struct Over {
    x: f64,
    wanted: f64,
    hip: Vector3<f64>,
    drop: f64,
    pose: LegPose,
}

/// Raises the ankle by `lift` (m), the pitches kept: inverse kinematics in the leg's plane.
fn raise(leg: &LegGeometry, pose: &mut LegPose, lift: f64) {
    let (down, forward) = (leg.ankle_below_hip(pose), leg.ankle_ahead_of_hip(pose));
    let down = down - lift / pose.side.cos();
    pose.knee = leg.knee_for(down * down + forward * forward);
    pose.thigh = forward.atan2(down) + leg.thigh_against_leg(leg.geometric_knee(pose.knee));
}
