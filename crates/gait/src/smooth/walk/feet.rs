//! The feet of a walk: every print of one foot, and the swings between them.

use super::course::{Episode, Kind};
use super::laws::WalkLaws;
use super::numbers::{
    CLOSING, FIRST_HEEL_OFF, FIRST_TIP_ROLL, FIRST_TOE_OFF, FIRST_TOE_ROLL, INSTANTS, KNEE_CONTACT,
    KNEE_FLAT, KNEE_START, KNEE_TURNING, LANDS_FLATTER, LANDS_LEAST, LAST_FLAT_UNTIL, LEAST_HEIGHT,
    LEAST_WEIGHT, STANDING_FROM, STANDING_HEEL_OFF, STANDING_TOE_OFF, STANDING_WAYPOINT, THIGH_FOLLOWS,
    TURNED_CLOSING, TURNING_STEEPEST, TURNING_UNTIL,
};
use super::timeline::Timeline;
use crate::body::leg::{LegGeometry, LegPose};
use crate::limbs::jet::LegJet;
use crate::limbs::midstance::above_flexion;
use crate::limbs::stance::{Landing, Stance};
use crate::limbs::swing::{Swing, sideways};
use crate::smooth::legs::Aim;
use nalgebra::Vector3;
use solaris_profiles::{Boundary, ProfileError, UniformSpline};

/// One foot over a walk. Each print is a left foot's, see [`super::course::Print::local`].
pub(super) struct Foot {
    side: usize,
    pub(super) stances: Vec<Stance>,
    swings: Vec<Swing>,
}

/// The hip over a walk.
pub(super) struct Hip<'a> {
    /// Over the time in strides of the fastest pace.
    pub(super) spline: &'a UniformSpline<3>,
    pub(super) nodes: &'a [[f64; 3]],
    pub(super) timeline: &'a Timeline,
}

impl Foot {
    /// All prints of a foot for a given hip. `need` takes, by contact, how far the body is too high for the legs.
    pub(super) fn new(
        laws: &WalkLaws,
        leg: &LegGeometry,
        side: usize,
        hip: &Hip<'_>,
        need: &mut [f64],
    ) -> Result<Self, ProfileError> {
        let (course, tempo) = (&laws.course, &laws.gaits.tempo);
        let count = course.episode_count(side);
        let mut stances = Vec::with_capacity(count);
        let mut contacts: Vec<LegJet> = Vec::with_capacity(count);
        // The hip as the print sees it, on the print's clock.
        let seen = |episode: Episode| {
            move |v: f64| {
                let at = Vector3::from(hip.spline.position(tempo.time(v + episode.contact)));
                episode.local(&at)
            }
        };
        for j in 0..count {
            let episode = course.episode(side, j);
            let (stance, contact) = stance(laws, leg, side, &episode, seen(episode))?;
            note_need(laws, leg, &episode, &stance, seen(episode), need);
            contacts.push(contact);
            stances.push(stance);
        }
        let mut swings = Vec::with_capacity(count - 1);
        for j in 0..count - 1 {
            let (from, to) = (course.episode(side, j), course.episode(side, j + 1));
            let style = laws.gaits.swing(&from, &to);
            let end = &contacts[j + 1];
            let start = stances[j].toe_off_jet(seen(from));
            let leans = |episode: &Episode, v: f64, jet: &LegJet| {
                let turn = course.heading(episode.contact + v) - episode.print.heading;
                sideways(leg, &jet.pose(), if side == 0 { turn } else { -turn })
            };
            let sideways = [leans(&from, style.toe_off(), &start), leans(&to, 0.0, end)];
            let aim = if to.kind == Kind::Close {
                Aim {
                    thigh: style.thigh_swing * laws.numbers.closing_thigh,
                    late_knee: 0.0,
                    beside: true,
                    sideways,
                }
            } else {
                let steady = laws.gaits.of_contact(to.index).contact_thigh;
                let thigh = style.thigh_swing + THIGH_FOLLOWS * (end.thigh.position - steady);
                let late_knee = style.knee_late_swing + end.knee.position - style.knee_contact;
                let beside = shortened(laws, to.index) < LANDS_FLATTER;
                Aim { thigh, late_knee, beside, sideways }
            };
            let mut swing = style.swing(&start, end, &aim)?;
            let heights = hip.timeline.between(from.contact + style.toe_off(), to.contact);
            let heights: Vec<(f64, f64)> =
                heights.map(|(node, u)| (u - from.contact, hip.nodes[node][1])).collect();
            swing.clear_ground(leg, &style.ground_clearance(laws.numbers.late_clearance), &heights);
            swings.push(swing);
        }
        Ok(Self { side, stances, swings })
    }

    /// The leg at the clock `u`, for a hip of the world.
    pub(super) fn pose(&self, laws: &WalkLaws, leg: &LegGeometry, u: f64, hip: &Vector3<f64>) -> LegPose {
        match self.at(laws, u) {
            (j, episode, v) if self.swings_at(laws, j, &episode, v) => self.swings[j].pose(leg, v),
            (j, episode, v) => self.stances[j].pose(v, &episode.local(hip)),
        }
    }

    /// By how much the leg is too short for the foot on the ground at the clock `u`; 0 in swing.
    pub(super) fn short(&self, laws: &WalkLaws, u: f64, hip: &Vector3<f64>) -> f64 {
        match self.at(laws, u) {
            (j, episode, v) if self.swings_at(laws, j, &episode, v) => 0.0,
            (j, episode, v) => self.stances[j].short(v, &episode.local(hip)),
        }
    }

    /// The print that it stands on or has left, and the clock since its contact.
    fn at(&self, laws: &WalkLaws, u: f64) -> (usize, Episode, f64) {
        let j = laws.course.episode_at(self.side, u);
        let episode = laws.course.episode(self.side, j);
        (j, episode, u - episode.contact)
    }

    fn swings_at(&self, laws: &WalkLaws, j: usize, episode: &Episode, v: f64) -> bool {
        v > laws.toe_off(episode) && j < self.swings.len()
    }
}

fn stance(
    laws: &WalkLaws,
    leg: &LegGeometry,
    side: usize,
    episode: &Episode,
    hip: impl Fn(f64) -> Vector3<f64>,
) -> Result<(Stance, LegJet), ProfileError> {
    let style = &laws.gaits.stance(episode).style;
    let mut push = style.push();
    let landing = match episode.kind {
        Kind::First | Kind::Close => Landing::Flat,
        Kind::Step | Kind::Last => Landing::Heel,
    };
    match (episode.kind, side) {
        (Kind::First, 0) => {
            push.heel_off = STANDING_HEEL_OFF;
            push.waypoint = Some((STANDING_WAYPOINT.0, style.knee_push.max(STANDING_WAYPOINT.1)));
            push.knee_toe_off.position -= STANDING_TOE_OFF.0;
            push.knee_toe_off.velocity -= STANDING_TOE_OFF.1;
        }
        (Kind::First, _) => {
            push.heel_off = style.toe_off() - FIRST_HEEL_OFF;
            push.waypoint = None;
            push.tip_roll_at = style.toe_off() - FIRST_TIP_ROLL;
            push.toe_roll = FIRST_TOE_ROLL;
            push.knee_toe_off = Boundary::new(FIRST_TOE_OFF.0, FIRST_TOE_OFF.1, 0.0);
        }
        _ => {}
    }
    if laws.course.turns_near(episode.index) {
        push.steepest = TURNING_STEEPEST;
    }
    let mut stance = Stance::new(leg, &style.footing(), landing, push);
    let mut knee = None;
    if landing == Landing::Heel {
        let (pitch, range) = (-contact_pitch(laws, episode), laws.numbers.landing_range);
        let jet = stance.landing_knee(style.contact_knee(), pitch, range, &hip(0.0));
        stance.set_contact(jet, &hip)?;
        knee = Some(jet);
    }
    if matches!(episode.kind, Kind::First | Kind::Step) {
        stance.set_push(&hip)?;
    }
    let contact = stance.contact_jet(knee, &hip);
    Ok((stance, contact))
}

/// Length of a turning step over its pace's; 1 straight on.
fn shortened(laws: &WalkLaws, contact: usize) -> f64 {
    if laws.course.turning(contact) > 0.0 {
        laws.course.step_length(contact) / laws.style(contact).step_length
    } else {
        1.0
    }
}

/// The foot's pitch at contact, toe up.
fn contact_pitch(laws: &WalkLaws, episode: &Episode) -> f64 {
    let factor = match episode {
        Episode { kind: Kind::Last, .. } => laws.numbers.pitch_last,
        Episode { index: 1, .. } => laws.numbers.pitch_first,
        _ => 1.0,
    };
    let shorter = (shortened(laws, episode.index) / LANDS_FLATTER).clamp(LANDS_LEAST, 1.0);
    laws.style(episode.index).heel_strike_angle * factor * shorter
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
    let shortest = (LEAST_HEIGHT * (leg.thigh + leg.shank)).powi(2);
    let mut note = |v: f64, ankle: Vector3<f64>, knee: f64| {
        let d = hip(v) - ankle;
        let level = (leg.reach_squared(knee) - d.x * d.x - d.z * d.z).max(shortest).sqrt();
        let weight = laws.correction(episode.contact + v, episode.index).max(LEAST_WEIGHT);
        need[episode.index] = need[episode.index].max((d.y - level) / weight);
    };
    let spread = |from: f64, to: f64, count: i32| {
        (0..count).map(move |i| from + (to - from) * f64::from(i) / f64::from(count - 1))
    };
    if matches!(episode.kind, Kind::Step | Kind::Last) {
        note(0.0, stance.ankle_on_heel(-contact_pitch(laws, episode)), KNEE_CONTACT);
    }
    let (flat, ankle) = (laws.style(episode.index).foot_flat, stance.flat_ankle());
    match episode.kind {
        Kind::Step => spread(flat, stance.heel_off(), INSTANTS[0]).for_each(|v| note(v, ankle, KNEE_FLAT)),
        Kind::Last => {
            spread(flat, LAST_FLAT_UNTIL, INSTANTS[1]).for_each(|v| note(v, ankle, KNEE_FLAT));
            let turns = laws.course.turns_near(episode.index);
            let knee = laws.numbers.knee_closing.max(if turns { KNEE_TURNING } else { 0.0 });
            if knee > 0.0 {
                spread(CLOSING.0, if turns { TURNED_CLOSING } else { CLOSING.1 }, INSTANTS[2])
                    .for_each(|v| note(v, ankle, knee));
            }
        }
        Kind::First => spread(STANDING_FROM, STANDING_HEEL_OFF, INSTANTS[3])
            .for_each(|u| note(u - episode.contact, ankle, KNEE_START)),
        Kind::Close => {}
    }
    // Round a turn the hip is farther from the foot behind it than straight on: it is looked at until the push.
    if episode.kind == Kind::Step && laws.course.turns_near(episode.index) {
        spread(stance.heel_off(), TURNING_UNTIL, INSTANTS[4]).for_each(|v| note(v, ankle, KNEE_TURNING));
    }
    let flexion = laws.style(episode.index).flexion;
    if flexion > 0.0 && episode.kind == Kind::Step {
        let (midstance, above) = above_flexion(leg, stance, flexion, (flat, stance.heel_off()), hip);
        let weight = laws.correction(episode.contact + midstance, episode.index).max(LEAST_WEIGHT);
        need[episode.index] = need[episode.index].max(above / weight);
    }
}
