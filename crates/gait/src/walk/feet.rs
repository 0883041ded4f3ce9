//! The feet of a walk: every print of one foot, and the swings between them.

use super::laws::{Episode, Kind, WalkLaws};
use super::numbers::{KNEE_CONTACT, KNEE_FLAT, KNEE_START, PITCH_FIRST, PITCH_LAST};
use crate::leg::{LegGeometry, LegPose};
use crate::stance::{Landing, LegJet, Push, Stance};
use crate::swing::{Aim, Swing};
use nalgebra::Vector3;
use solaris_profiles::{Boundary, ProfileError, UniformSpline};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// One foot over a walk. The right foot's world is mirrored.
pub(super) struct Foot {
    pub(super) side: usize,
    pub(super) stances: Vec<Stance>,
    swings: Vec<Swing>,
}

/// The hip over a walk, in the foot's (mirrored) world.
pub(super) struct Hip<'a> {
    pub(super) spline: &'a UniformSpline<3>,
    pub(super) nodes: &'a [[f64; 3]],
    /// First node's clock and nodes a stride.
    pub(super) first: f64,
    pub(super) rate: f64,
}

impl Foot {
    /// All prints of a foot for a given hip. `need` takes, by contact, how far the body is too high for the legs.
    pub(super) fn new(
        laws: &WalkLaws,
        leg: &LegGeometry,
        side: usize,
        hip: &Hip<'_>,
        steady_thigh: f64,
        need: &mut [f64],
    ) -> Result<Self, ProfileError> {
        let count = laws.episode_count(side);
        let mut stances = Vec::with_capacity(count);
        let mut contacts: Vec<LegJet> = Vec::with_capacity(count);
        for j in 0..count {
            let episode = laws.episode(side, j);
            let at = |v: f64| {
                Vector3::from(hip.spline.position(v + episode.contact))
                    - Vector3::new(0.0, 0.0, episode.print)
            };
            let (stance, contact) = stance(laws, leg, side, &episode, at)?;
            note_need(laws, leg, &episode, &stance, at, need);
            contacts.push(contact);
            stances.push(stance);
        }
        let mut swings = Vec::with_capacity(count - 1);
        for j in 0..count - 1 {
            let (from, to) = (laws.episode(side, j), laws.episode(side, j + 1));
            let at = |v: f64| {
                Vector3::from(hip.spline.position(v + from.contact)) - Vector3::new(0.0, 0.0, from.print)
            };
            let style = &laws.style;
            let end = &contacts[j + 1];
            let aim = if to.kind == Kind::Close {
                Aim { thigh: style.thigh_swing * 0.85, late_knee: 0.0, beside: true }
            } else {
                let thigh = style.thigh_swing + 0.8 * (end.thigh.position - steady_thigh);
                let late_knee = style.knee_late_swing + end.knee.position - style.knee_contact;
                Aim { thigh, late_knee, beside: false }
            };
            let mut swing = Swing::new(style, &stances[j].toe_off_jet(at), end, &aim)?;
            let node = |u: f64| (u - hip.first) * hip.rate;
            let (first, last) =
                (node(from.contact + style.toe_off()).floor() + 1.0, (node(to.contact) - 1e-6).floor());
            let heights: Vec<(f64, f64)> = (first as usize..=last as usize)
                .map(|i| (hip.first + i as f64 / hip.rate - from.contact, hip.nodes[i][1]))
                .collect();
            swing.clear_ground(leg, style.clearance, &heights);
            swings.push(swing);
        }
        Ok(Self { side, stances, swings })
    }

    /// The leg at the clock `u`, for a hip in the foot's world.
    pub(super) fn pose(&self, laws: &WalkLaws, leg: &LegGeometry, u: f64, hip: &Vector3<f64>) -> LegPose {
        let j = laws.episode_at(self.side, u);
        let episode = laws.episode(self.side, j);
        let v = u - episode.contact;
        if v > laws.style.toe_off() && j < self.swings.len() {
            self.swings[j].pose(leg, v)
        } else {
            self.stances[j].pose(v, &(hip - Vector3::new(0.0, 0.0, episode.print)))
        }
    }

    /// By how much the leg is too short for the foot on the ground at the clock `u`; 0 in swing.
    pub(super) fn short(&self, laws: &WalkLaws, u: f64, hip: &Vector3<f64>) -> f64 {
        let j = laws.episode_at(self.side, u);
        let episode = laws.episode(self.side, j);
        let v = u - episode.contact;
        if v > laws.style.toe_off() && j < self.swings.len() {
            0.0
        } else {
            self.stances[j].short(v, &(hip - Vector3::new(0.0, 0.0, episode.print)))
        }
    }
}

fn stance(
    laws: &WalkLaws,
    leg: &LegGeometry,
    side: usize,
    episode: &Episode,
    hip: impl Fn(f64) -> Vector3<f64>,
) -> Result<(Stance, LegJet), ProfileError> {
    let style = &laws.style;
    let mut push = Push::of(style);
    let landing = match episode.kind {
        Kind::First | Kind::Close => Landing::Flat,
        Kind::Step | Kind::Last => Landing::Heel,
    };
    match (episode.kind, side) {
        (Kind::First, 0) => {
            push.heel_off = 0.06;
            push.waypoint = Some((0.40, style.knee_push.max(12.0 * DEGREE)));
            push.knee_toe_off.position -= 4.0 * DEGREE;
            push.knee_toe_off.velocity -= 60.0 * DEGREE;
        }
        (Kind::First, _) => {
            push.heel_off = style.toe_off() - 0.22;
            push.waypoint = None;
            push.tip_roll_at = style.toe_off() - 0.06;
            push.toe_roll = 12.0 * DEGREE;
            push.knee_toe_off = Boundary::new(44.0 * DEGREE, 320.0 * DEGREE, 0.0);
        }
        _ => {}
    }
    let mut stance = Stance::new(leg, style, landing, push);
    let mut knee = None;
    if landing == Landing::Heel {
        let distance = (hip(0.0) - stance.ankle_on_heel(-contact_pitch(laws, episode))).norm_squared();
        let flexion = leg.knee_for(distance).max(style.knee_contact - 2.0 * DEGREE);
        let factor = (1.0 - (flexion - style.knee_contact) / (15.0 * DEGREE)).clamp(-1.0, 1.0);
        let jet = Boundary::new(flexion, style.knee_contact_rate * factor, style.knee_contact_acc * factor);
        stance.set_contact(jet, &hip)?;
        knee = Some(jet);
    }
    if matches!(episode.kind, Kind::First | Kind::Step) {
        stance.set_push(&hip)?;
    }
    let contact = stance.contact_jet(knee, &hip);
    Ok((stance, contact))
}

/// The foot's pitch at contact, toe up.
fn contact_pitch(laws: &WalkLaws, episode: &Episode) -> f64 {
    let factor = match episode {
        Episode { kind: Kind::Last, .. } => PITCH_LAST,
        Episode { index: 1, .. } => PITCH_FIRST,
        _ => 1.0,
    };
    laws.style.heel_strike_angle * factor
}

/// How far the body is above what the leg reaches with the wanted knee, by the correction that can lower it. Signed: a
/// spare height is used too, so nobody crouches.
fn note_need(
    laws: &WalkLaws,
    leg: &LegGeometry,
    episode: &Episode,
    stance: &Stance,
    hip: impl Fn(f64) -> Vector3<f64>,
    need: &mut [f64],
) {
    let shortest = 0.25 * (leg.thigh + leg.shank).powi(2);
    let mut note = |v: f64, ankle: Vector3<f64>, knee: f64| {
        let d = hip(v) - ankle;
        let level = (leg.reach_squared(knee) - d.x * d.x - d.z * d.z).max(shortest).sqrt();
        let weight = laws.correction(episode.contact + v, episode.index).max(0.5);
        need[episode.index] = need[episode.index].max((d.y - level) / weight);
    };
    let spread = |from: f64, to: f64, count: i32| {
        (0..count).map(move |i| from + (to - from) * f64::from(i) / f64::from(count - 1))
    };
    if matches!(episode.kind, Kind::Step | Kind::Last) {
        note(0.0, stance.ankle_on_heel(-contact_pitch(laws, episode)), KNEE_CONTACT);
    }
    let (flat, ankle) = (laws.style.foot_flat, stance.flat_ankle());
    match episode.kind {
        Kind::Step => spread(flat, stance.heel_off(), 12).for_each(|v| note(v, ankle, KNEE_FLAT)),
        Kind::Last => spread(flat, 0.42, 14).for_each(|v| note(v, ankle, KNEE_FLAT)),
        Kind::First => spread(-0.6, 0.06, 12).for_each(|u| note(u - episode.contact, ankle, KNEE_START)),
        Kind::Close => {}
    }
}
