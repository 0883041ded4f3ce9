//! The feet of a walk: every print of one foot, and the swings between them.

use super::course::{Episode, Kind};
use super::gaits::LandingLaw;
use super::heights::Needs;
use super::laws::WalkLaws;
use super::numbers::{
    CLOSING, FIRST_KNEE, FIRST_LANDING, FIRST_MORE_BENT, FIRST_TIP_ROLL, FIRST_TOE_OFF, FIRST_TOE_ROLL,
    FLAT_STRAIGHTER, GROUND_LEAST_FLAT, INSTANTS, KNEE_CONTACT, KNEE_FLAT, KNEE_FLAT_BELOW, KNEE_START,
    KNEE_TURNING, LANDS_AS_FLAT, LANDS_FLATTER, LANDS_LEAST, LAST_FLAT_UNTIL, LAST_KNEE, LAST_STANDS,
    LAST_STRAIGHTENS, LEAST_FLAT, LEAST_HEIGHT, LEAST_IN_AIR, LEAST_LANDING, LEAST_WEIGHT, LOADING, NEXT_TO,
    PEAK_BELOW, PEAK_FOLLOWS, PEAK_FROM, PEAK_STEEP, PEAK_UPHILL, STANDING_FROM, STANDING_TOE_OFF_RATE,
    STANDING_WAYPOINT, THIGH_FOLLOWS, TOLD_AFTER, TURNED_CLOSING, TURNING_STEEPEST, TURNING_UNTIL,
    UNSTRETCHED, USUAL_LEG,
};
use super::standing::knee_standing;
use super::timeline::Timeline;
use crate::body::leg::{LegGeometry, LegPose};
use crate::limbs::jet::LegJet;
use crate::limbs::midstance::above_flexion;
use crate::limbs::path::{Air, PathSwing};
use crate::limbs::push::Push;
use crate::limbs::stance::{Footing, Landing, Stance};
use crate::limbs::swing::sideways;
use crate::smooth::legs::Aim;
use crate::smooth::style::Style;
use nalgebra::Vector3;
use solaris_profiles::{Boundary, ProfileError, UniformSpline, step};

/// One foot over a walk. Each print is a left foot's, see [`super::course::Print::local`].
pub(super) struct Foot {
    side: usize,
    pub(super) stances: Vec<Stance>,
    swings: Vec<Air>,
}

/// The hip over a walk.
pub(super) struct Hip<'a> {
    /// Over the time in strides of the fastest pace.
    pub(super) spline: &'a UniformSpline<3>,
    pub(super) nodes: &'a [[f64; 3]],
    pub(super) timeline: &'a Timeline,
}

impl Foot {
    /// All prints of a foot for a given hip. `needs` take how far the body is too high for the legs.
    pub(super) fn new(
        laws: &WalkLaws,
        leg: &LegGeometry,
        side: usize,
        hip: &Hip<'_>,
        needs: &mut Needs,
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
            note_need(laws, leg, &episode, &stance, seen(episode), needs);
            contacts.push(contact);
            stances.push(stance);
        }
        let mut swings = Vec::with_capacity(count - 1);
        for j in 0..count - 1 {
            let (from, to) = (course.episode(side, j), course.episode(side, j + 1));
            let mut style = laws.gaits.swing(&from, &to);
            if from.kind == Kind::First {
                let after = style.toe_off() + laws.numbers.first_peak_after;
                style.knee_peak_at = style.knee_peak_at.max(after);
            }
            let after = style.toe_off()
                + Self::peak_from(leg, &style, to.index >= laws.course.steps) * (1.0 - style.toe_off());
            style.knee_peak_at = style.knee_peak_at.max(after);
            let end = &contacts[j + 1];
            let start = stances[j].toe_off_jet(seen(from));
            let leans = |episode: &Episode, v: f64, jet: &LegJet| {
                let turn = course.heading(episode.contact + v) - episode.print.heading;
                sideways(leg, &jet.pose(), if side == 0 { turn } else { -turn })
            };
            let sideways = [leans(&from, style.toe_off(), &start), leans(&to, 0.0, end)];
            let tilt = [from.print.tilt, to.print.tilt];
            let aim = if to.kind == Kind::Close {
                Aim {
                    thigh: style.thigh_swing * laws.numbers.closing_thigh,
                    late_knee: 0.0,
                    unstretched: 0.0,
                    beside: true,
                    tilt,
                    sideways,
                }
            } else {
                let steady = laws.gaits.landing(to.index);
                let thigh = style.thigh_swing + THIGH_FOLLOWS * (end.thigh.position - steady.thigh);
                let late_knee = style.knee_late_swing + end.knee.position - steady.knee;
                let beside = shortened(laws, to.index) < LANDS_FLATTER;
                let more = end.knee.position - steady.knee;
                let unstretched =
                    if laws.relief.is_some() { step::quintic(more / UNSTRETCHED).position } else { 0.0 };
                Aim { thigh, late_knee, unstretched, beside, tilt, sideways }
            };
            let passings = laws.gaits.passings(&to);
            if !passings.is_empty() {
                let (lifted, landed) = (&stances[j], &stances[j + 1]);
                let (start, end) = (lifted.toe_off_path(seen(from)), landed.contact_path(seen(to)));
                let ahead = from.local(&to.print.place) - from.local(&from.print.place);
                let mut path =
                    PathSwing::new(leg, style.toe_off(), style.manner.toes, passings, &start, &end, &ahead)?;
                let nodes = hip.timeline.between(from.contact + style.toe_off(), to.contact);
                let hips: Vec<(f64, Vector3<f64>)> =
                    nodes.map(|(node, u)| (u - from.contact, from.local(&hip.nodes[node].into()))).collect();
                let gap = |point: &Vector3<f64>| laws.above_ground(&from.print.world(side, point));
                path.clear_terrain(leg, &laws.plane, style.clearance, &hips, gap);
                note_air(laws, leg, &from, style.toe_off(), &path, seen(from), needs);
                swings.push(Air::Path(path));
                continue;
            }
            if laws.relief.is_some() && to.kind != Kind::Close {
                // A foot that lands with a bent leg swings with a more bent one.
                let bent = end.knee.position - laws.gaits.landing(to.index).knee - PEAK_FOLLOWS.0;
                style.knee_peak += PEAK_FOLLOWS.1 * bent.max(0.0);
            }
            let mut swing = style.swing(&start, end, &aim)?;
            let nodes = hip.timeline.between(from.contact + style.toe_off(), to.contact);
            let clearance = style.ground_clearance(laws.numbers.late_clearance);
            if laws.relief.is_some() {
                let hips: Vec<(f64, Vector3<f64>)> =
                    nodes.map(|(node, u)| (u - from.contact, from.local(&hip.nodes[node].into()))).collect();
                let gap = |point: &Vector3<f64>| laws.above_ground(&from.print.world(side, point));
                swing.clear_terrain(leg, &laws.plane, &clearance, &hips, gap);
            } else {
                let heights: Vec<(f64, f64)> =
                    nodes.map(|(node, u)| (u - from.contact, hip.nodes[node][1])).collect();
                swing.clear_ground(leg, &clearance, &heights);
            }
            let swing = Air::Joints(swing);
            swings.push(swing);
        }
        Ok(Self { side, stances, swings })
    }

    /// The leg at the clock `u`, for a hip of the world.
    pub(super) fn pose(&self, laws: &WalkLaws, leg: &LegGeometry, u: f64, hip: &Vector3<f64>) -> LegPose {
        match self.at(laws, u) {
            (j, episode, v) if self.swings_at(laws, j, &episode, v) => {
                self.swings[j].pose(&laws.plane, leg, v, &episode.local(hip))
            }
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

    /// The part of a swing that is over at least when its knee is bent the most. People's is after a third, and so is that of a foot that
    /// leaves the ground in time; one that leaves it late, in slow steps and uphill, had its peak so soon that the knee went beyond it by half as
    /// much again. Of the last step less is asked, and on the steepest slopes nothing: its foot would not come up in time.
    fn peak_from(leg: &LegGeometry, style: &Style, is_last: bool) -> f64 {
        // As slow as somebody with legs of usual length would be who walks alike.
        let pace = style.step_frequency * (leg.length() / USUAL_LEG).sqrt();
        let late = ((PEAK_BELOW.0 - pace) / PEAK_BELOW.1).max(style.slope / PEAK_UPHILL);
        let most = if is_last {
            PEAK_FROM.1 * ((PEAK_STEEP.0 - style.slope) / PEAK_STEEP.1).clamp(0.0, 1.0)
        } else {
            PEAK_FROM.0
        };
        most * late.clamp(0.0, 1.0)
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
    let law = laws.gaits.stance(episode);
    let style = &law.style;
    let mut push = Push { least_knee: law.least_knee, ..style.push() };
    let landing = match episode.kind {
        Kind::First | Kind::Close => Landing::Flat,
        Kind::Step | Kind::Last => law.landing,
    };
    match (episode.kind, side) {
        (Kind::First, 0) => {
            push.rounding = 0.0;
            push.heel_off = laws.standing_heel_off();
            push.waypoint = Some((STANDING_WAYPOINT.0, style.knee_push.max(STANDING_WAYPOINT.1)));
            push.knee_toe_off.position -= laws.numbers.standing_toe_off;
            push.knee_toe_off.velocity -= STANDING_TOE_OFF_RATE;
        }
        (Kind::First, _) => {
            push.rounding = 0.0;
            push.heel_off = style.toe_off() - laws.first_heel_off();
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
    let footing = Footing { tilt: episode.print.tilt, ..style.footing() };
    let mut stance = Stance::new(leg, &footing, landing, push);
    let mut contact_knee = None;
    if landing == Landing::Heel {
        let (pitch, range) = (-contact_pitch(laws, episode), laws.numbers.landing_range);
        let LandingLaw { knee, straightest, .. } = *laws.gaits.landing(episode.index);
        let wanted = Boundary { position: knee, ..style.contact_knee() };
        let mut jet = stance.landing_knee(wanted, straightest, pitch, range, &hip(0.0));
        let part = lands_as_flat(laws, episode, jet.position - knee);
        if part > 0.0 {
            let flat = stance.flat_knee_jet(0.0, &hip);
            jet.velocity += (flat.velocity - jet.velocity) * part;
            jet.acceleration += (flat.acceleration - jet.acceleration) * part;
        }
        stance.set_contact(jet, &hip)?;
        contact_knee = Some(jet);
    }
    if matches!(episode.kind, Kind::First | Kind::Step) {
        stance.set_push(&hip)?;
    }
    let contact = stance.contact_jet(contact_knee, &hip);
    Ok((stance, contact))
}

/// By which part the knee of a foot that lands goes as it does on a flat foot: uphill the first foot, the last one, and all in slow steps land on a
/// knee that is so much more bent than in a stride (rad), and would turn toe up again if it bent or stretched at its own rate.
fn lands_as_flat(laws: &WalkLaws, episode: &Episode, more_bent: f64) -> f64 {
    if laws.relief.is_none() {
        return 0.0;
    }
    let part = |value: f64, (from, range): (f64, f64)| step::quintic((value - from) / range).position;
    let [bent, tilted, slow] = LANDS_AS_FLAT;
    let is_end = episode.index == 1 || episode.kind == Kind::Last;
    let of_this_step = if is_end { 1.0 } else { part(laws.stride_of(episode.index), slow) };
    of_this_step * part(more_bent, bent) * part(episode.print.tilt, tilted)
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
    laws.gaits.landing(episode.index).style.heel_strike_angle * factor * shorter
}

/// How far the body is above what the leg reaches with the wanted knee, by the correction that can lower it. Signed: a
/// spare height is used too, so nobody crouches.
fn note_need(
    laws: &WalkLaws,
    leg: &LegGeometry,
    episode: &Episode,
    stance: &Stance,
    hip: impl Fn(f64) -> Vector3<f64>,
    needs: &mut Needs,
) {
    let above = |v: f64, ankle: Vector3<f64>, knee: f64| height_above(leg, &(hip(v) - ankle), knee);
    let Needs { told: need, least, weight } = needs;
    let lands = matches!(episode.kind, Kind::Step | Kind::Last);
    let (least_flat, flat_until) = if laws.relief.is_some() { GROUND_LEAST_FLAT } else { (LEAST_FLAT, 0.0) };
    // A foot that is left below a body that rises would stand on its tip, and its ankle point ever farther in the air.
    let style = &laws.gaits.stance(episode).style;
    let steepest =
        laws.numbers.toe_off_pitch.filter(|_| episode.kind == Kind::Step && style.stairs.is_none());
    let toe_off = laws.toe_off(episode);
    for (knot, clock) in laws.heights.knots() {
        let v = clock - episode.contact;
        let lifts = steepest.filter(|_| (v - toe_off).abs() <= NEXT_TO * laws.heights.spacing());
        if let Some(pitch) = lifts {
            let ankle = stance.ankle_at_toe_off(pitch);
            least[knot] = least[knot].max(above(toe_off, ankle, style.knee_toe_off));
        }
        if lands && v.abs() <= NEXT_TO * laws.heights.spacing() {
            // The first landing tells the knot next to it; later ones only that a leg must reach.
            let ankle = stance.landing_ankle(-contact_pitch(laws, episode));
            if episode.index == 1 {
                let knee = if laws.relief.is_some() {
                    FIRST_LANDING.max(laws.gaits.landing(1).knee + FIRST_MORE_BENT)
                } else {
                    FIRST_LANDING
                };
                need[knot] = need[knot].max(above(0.0, ankle, knee));
            } else {
                let knee = if stance.lands_on_ball() {
                    LEAST_LANDING.max(laws.gaits.landing(episode.index).knee)
                } else {
                    LEAST_LANDING
                };
                least[knot] = least[knot].max(above(0.0, ankle, knee));
            }
        } else if let Some((ankle, knee)) = wanted(laws, episode, stance, v) {
            need[knot] = need[knot].max(above(v, ankle, knee));
            if !stance.pushes() || v <= stance.heel_off() + flat_until {
                least[knot] = least[knot].max(above(v, ankle, least_flat));
            }
            if lands && episode.index > 1 && v < LOADING.0 {
                weight[knot] = LOADING.1;
            }
        }
    }
    if !laws.heights.has(episode.index) {
        return;
    }
    let mut note = |v: f64, ankle: Vector3<f64>, knee: f64| {
        let weight = laws.heights.weight(episode.contact + v, episode.index).max(LEAST_WEIGHT);
        need[episode.index] = need[episode.index].max(above(v, ankle, knee) / weight);
    };
    let spread = |from: f64, to: f64, count: i32| {
        (0..count).map(move |i| from + (to - from) * f64::from(i) / f64::from(count - 1))
    };
    if matches!(episode.kind, Kind::Step | Kind::Last) {
        note(0.0, stance.landing_ankle(-contact_pitch(laws, episode)), KNEE_CONTACT);
    }
    let law = &laws.gaits.stance(episode).style;
    let (flat, ankle) = (law.foot_flat, stance.flat_ankle());
    match episode.kind {
        Kind::Step => {
            let knee = law.least_knee - KNEE_FLAT_BELOW;
            spread(flat, stance.heel_off(), INSTANTS[0]).for_each(|v| note(v, ankle, knee));
            if !laws.heights.has(episode.index + 1) {
                // The last contact before the knots of the end, which lower the body for the rest of the stance: here alone the leg would be stretched.
                let steady = laws.gaits.of_contact(episode.index).stance_knee(flat);
                note(flat, ankle, (steady - FLAT_STRAIGHTER.0).min(FLAT_STRAIGHTER.1));
            }
        }
        Kind::Last => {
            spread(flat, LAST_FLAT_UNTIL, INSTANTS[1]).for_each(|v| note(v, ankle, KNEE_FLAT));
            let turns = laws.course.turns_near(episode.index);
            let knee = laws.numbers.knee_closing.max(if turns { KNEE_TURNING } else { 0.0 });
            if knee > 0.0 {
                spread(CLOSING.0, if turns { TURNED_CLOSING } else { CLOSING.1 }, INSTANTS[2])
                    .for_each(|v| note(v, ankle, knee));
            }
        }
        Kind::First => {
            let until = if episode.side == 0 { stance.heel_off() } else { laws.standing_heel_off() };
            spread(STANDING_FROM, until, INSTANTS[3])
                .for_each(|u| note(u - episode.contact, ankle, KNEE_START));
        }
        Kind::Close => {}
    }
    // Round a turn the hip is farther from the foot behind it than straight on: it is looked at until the push.
    if episode.kind == Kind::Step && laws.course.turns_near(episode.index) {
        spread(stance.heel_off(), TURNING_UNTIL, INSTANTS[4]).for_each(|v| note(v, ankle, KNEE_TURNING));
    }
    let flexion = laws.style(episode.index).flexion;
    if flexion > 0.0 && episode.kind == Kind::Step {
        let (midstance, above) = above_flexion(leg, stance, flexion, (flat, stance.heel_off()), hip);
        let weight = laws.heights.weight(episode.contact + midstance, episode.index).max(LEAST_WEIGHT);
        need[episode.index] = need[episode.index].max(above / weight);
    }
}

/// How far the body is above what a leg in the air reaches whose ankle's path is the law.
fn note_air(
    laws: &WalkLaws,
    leg: &LegGeometry,
    from: &Episode,
    toe_off: f64,
    path: &PathSwing,
    hip: impl Fn(f64) -> Vector3<f64>,
    needs: &mut Needs,
) {
    for (knot, clock) in laws.heights.knots() {
        let v = clock - from.contact;
        if v <= toe_off || v >= 1.0 {
            continue;
        }
        let above = height_above(leg, &(hip(v) - path.ankle(v)), LEAST_IN_AIR);
        needs.least[knot] = needs.least[knot].max(above);
    }
}

/// By how much a hip at `d` from its ankle is higher than one whose knee is bent by `knee` (m).
fn height_above(leg: &LegGeometry, d: &Vector3<f64>, knee: f64) -> f64 {
    let shortest = (LEAST_HEIGHT * (leg.thigh + leg.shank)).powi(2);
    d.y - (leg.reach_squared(knee) - d.x * d.x - d.z * d.z).max(shortest).sqrt()
}

/// Where a leg has its ankle on the ground, and how bent its knee should be there, at the clock `v` of the foot.
fn wanted(laws: &WalkLaws, episode: &Episode, stance: &Stance, v: f64) -> Option<(Vector3<f64>, f64)> {
    let style = laws.style(episode.index);
    let steady = |v: f64| laws.gaits.of_contact(episode.index).stance_knee(v);
    let standing = knee_standing(episode.print.tilt);
    let settled = |v: f64| {
        let last = LAST_KNEE.max(standing);
        let straighter = mix(steady(v), last, (v - LAST_STRAIGHTENS.0) / LAST_STRAIGHTENS.1);
        mix(straighter, standing, (v - LAST_STANDS.0) / LAST_STANDS.1)
    };
    let flat = match episode.kind {
        Kind::First => f64::NEG_INFINITY,
        // A knot may fall on its landing.
        Kind::Close => -1e-9,
        Kind::Step | Kind::Last => style.foot_flat,
    };
    let until = if stance.pushes() { stance.heel_off() + TOLD_AFTER } else { f64::INFINITY };
    if v < flat || v > until {
        return None;
    }
    let knee = match episode.kind {
        Kind::First => {
            let rising = (v - laws.course.begin) / (until - laws.course.begin);
            mix(standing, FIRST_KNEE.max(standing), rising)
        }
        Kind::Step => steady(v.min(stance.heel_off())),
        Kind::Last => settled(v),
        Kind::Close => standing,
    };
    Some((stance.flat_ankle(), knee))
}

/// From `a` to `b` as `t` goes from 0 to 1.
fn mix(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * step::quintic(t).position
}
