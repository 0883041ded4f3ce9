//! When which foot touches in a chain of steps, and in which style.

use super::bound::Bound;
use super::carry::Stands;
use super::footstep::Footstep;
use super::seam::{LEAD, Seam};
use super::stood::{Begin, Finish};
use crate::body::Body;
use crate::body::posture::{ArmCarriage, Posture};
use crate::body::rotations::Euler;
use crate::request::RunResolution;
use crate::running::style::RunStyle;
use crate::running::trunk;
use solaris_profiles::spline::NaturalSpline;
use solaris_profiles::{ProfileError, step};
use std::ops::RangeInclusive;
use std::sync::Arc;

/// Steps at an unchanging speed that are planned before and after those that are shown, and that nobody sees: at their ends nothing is known
/// of what was before and comes after.
const UNSEEN: usize = 3;
/// How long trunk and arms move on after the last landing (s).
const MOVING_ON: f64 = 0.8;
/// Speed at which the push from standing leaves the ground (m/s).
const PUSHED: f64 = 0.85;
/// By how much the knee is more bent in the push and at toe-off of the last step before a stop or a walk.
const LAST_KNEE: (f64, f64) = (10.0 * std::f64::consts::PI / 180.0, 14.0 * std::f64::consts::PI / 180.0);
/// By how much the knee is more bent at the first contact after standing, and parts of the foot's pitch and of the knee's rate there.
const FIRST_KNEE: f64 = 15.0 * std::f64::consts::PI / 180.0;
const FIRST_STRIKE: f64 = 0.4;
const FIRST_RATE: f64 = 0.4;
/// By how much more the body leans forward as it begins in standing.
const LEAN: f64 = 8.0 * std::f64::consts::PI / 180.0;
/// How far the first prints after standing or a walk, and the last ones before a walk, may lie beside the line (m).
const ASIDE: [f64; 2] = [0.02, 0.01];
/// How long trunk and arms take from a walk's to a run's (s).
const GOING_OVER: f64 = 0.5;

/// Trunk and arms at an instant, for the thorax that the angular momentum asks for.
pub(super) struct Upper {
    pub(super) trunk: [Euler; 5],
    pub(super) arms: [[f64; 2]; 2],
    pub(super) carriage: ArmCarriage,
}

/// The steps of a chain.
#[derive(Clone, Debug)]
pub(in crate::running) struct Schedule {
    pub(super) steps: Vec<Footstep>,
    /// Between which times it is planned (s).
    pub(super) start: f64,
    pub(super) end: f64,
    /// Mean speed from the middle of a stance to that of the next (m/s).
    pub(super) speeds: Vec<f64>,
    /// Which of its steps are shown, and between which times: from the contact of the first to that of the last.
    pub(super) shown_steps: RangeInclusive<usize>,
    pub(super) shown: (f64, f64),
    pub(super) stands: Stands,
    /// With walks before and after it.
    pub(super) seams: [Option<Arc<Seam>>; 2],
    /// Between which times trunk and arms come to move, and come to rest.
    moves: [Option<(f64, f64)>; 2],
    /// Clock of trunk and arms: whole at left contacts.
    clock: NaturalSpline,
}

impl Schedule {
    /// Of steps at these speeds (m/s), of which the left foot's comes first or the right one's. Where it begins in standing the other foot
    /// pushes off before the first of them, where it ends there one more step is made to stop. Out of a walk and into one the flights last such parts of
    /// a run's.
    pub(in crate::running) fn new(
        body: &Body,
        speeds: &[f64],
        (from, to): (&Bound, &Bound),
        left_first: bool,
        [launched, arrives]: [f64; 2],
        resolution: RunResolution,
    ) -> Result<Self, ProfileError> {
        let stands = Stands { first: matches!(from, Bound::Standing), last: matches!(to, Bound::Standing) };
        let unseen = |bound: &Bound| if matches!(bound, Bound::Running) { UNSEEN } else { 0 };
        let (lead, tail) = (unseen(from), unseen(to));
        let (first, last) = (speeds[0], speeds[speeds.len() - 1]);
        // The step with which it ends in full run is one more.
        let tail = if matches!(to, Bound::Running) { 1 + tail } else { 0 };
        let run = [&vec![first; lead][..], speeds, &vec![last; tail][..]].concat();
        let styles = styles(body.height, &run, from, to);
        let walks_on = matches!(to, Bound::Walking(_));
        let n = styles.len();
        let begin = Begin::new(body.height);
        // Contacts are at nodes: the foot's acceleration jumps there.
        let step = styles[0].stride_time / resolution.nodes as f64;
        let at_node = |time: f64| (time / step).round() * step;
        let launch = from.launch(body, step)?;
        let first = match &launch {
            Some(launch) => launch.last + launched * styles[0].flight_time(),
            None if stands.first => begin.last + 0.6 * styles[0].flight_time(),
            None => 0.0,
        };
        // The flight into a walk is short.
        let flight = |k: usize| if walks_on && k + 1 == n { arrives } else { 1.0 } * styles[k].flight_time();
        let mut times = vec![at_node(first)];
        for (k, style) in styles.iter().enumerate() {
            times.push(at_node(times[k] + style.contact_time() + flight(k)));
        }
        let side = |k: usize| usize::from((k % 2 == lead % 2) != left_first);
        let (mut steps, mut means) = (Vec::new(), Vec::new());
        if stands.first {
            steps.push(Footstep::begin(1 - side(0), &styles[0], begin.clone()));
            means.push(PUSHED);
        }
        let seam = launch.as_ref().map(|launch| Arc::clone(&launch.seam));
        if let Some(launch) = launch {
            let (_, rate) = launch.seam.com(launch.seam.at);
            means.push(0.5 * (rate.z + run[0]));
            steps.push(Footstep::launch(&styles[0], launch));
        }
        for k in 0..n {
            let around = styles[k].contact_time() + 0.5 * (flight(k) + flight(k.saturating_sub(1)));
            let near = |k: usize| ASIDE.get(k).copied().unwrap_or(0.0);
            let beside = if stands.first || seam.is_some() { near(k) } else { 0.0 };
            let beside = if walks_on { beside.max(near(n - 1 - k)) } else { beside };
            steps.push(Footstep::running(side(k), times[k], &styles[k], around, beside, resolution.nodes)?);
            means.push(0.5 * (run[k] + run[(k + 1).min(n - 1)]));
        }
        let begun = stands.first || seam.is_some();
        let mut seams = [seam, None];
        let mut last_shown = steps.len();
        match to {
            Bound::Running => last_shown = lead + speeds.len() + usize::from(begun),
            Bound::Standing => {
                steps.push(Footstep::finish(side(n), times[n], &styles[n - 1], Finish::new(body.height)));
            }
            Bound::Walking(walked) => {
                let arrival = walked.arrival(body, times[n], step)?;
                seams[1] = Some(Arc::clone(&arrival.seam));
                means[last_shown - 1] = walked.speed();
                steps.push(Footstep::arrival(&styles[n - 1], arrival));
            }
        }
        // Where it comes to rest, or to walk.
        means.resize(steps.len(), 0.0);
        let shown_steps = if begun { 0 } else { lead }..=last_shown;
        let margin = 0.5 * flight(0).min(flight(n - 1));
        let start = if begun { 0.0 } else { -margin };
        let beyond = match to {
            Bound::Running => margin,
            Bound::Standing => 0.0,
            Bound::Walking(_) => LEAD as f64 * step,
        };
        let end = steps[steps.len() - 1].end() + beyond;
        let shown = (
            match &seams[0] {
                Some(seam) => seam.at,
                None if stands.first => 0.0,
                None => times[lead],
            },
            match &seams[1] {
                Some(seam) => seam.at,
                None if stands.last => end,
                None => times[lead + speeds.len()],
            },
        );
        let phase = 0.5 * (lead % 2) as f64 + if left_first { 0.0 } else { 0.5 };
        let clocks: Vec<f64> = (0..=n).map(|k| phase + 0.5 * k as f64).collect();
        let moves = [
            stands.first.then_some((begin.still, times[0])),
            stands.last.then_some((times[n], times[n] + MOVING_ON)),
        ];
        Ok(Self {
            steps,
            start,
            end,
            speeds: means,
            shown_steps,
            shown,
            stands,
            seams,
            moves,
            clock: NaturalSpline::new(&times, &clocks)?,
        })
    }

    /// The speed at first, and by how much each step makes the body faster (m/s), for what it loses of its way (m): in flight it is faster
    /// than on average.
    pub(super) fn gains(&self, lost: &[f64]) -> (f64, Vec<f64>) {
        let count = self.steps.len();
        let mut flights: Vec<f64> =
            (0..count).map(|k| self.speeds[k] + lost[k] / (0.5 * self.steps[k].style.stride_time)).collect();
        if self.stands.first || self.seams[0].is_some() {
            flights[0] = self.speeds[0];
        }
        if self.stands.last {
            flights[count - 1] = 0.0;
        }
        let speed = match self.seams[0] {
            // By how much the first one does is left to who knows what carries the body out of the walk.
            Some(_) => 0.0,
            None if self.stands.first => 0.0,
            None => flights[0],
        };
        let before = |k: usize| k.checked_sub(1).map_or(speed, |before| flights[before]);
        (speed, (0..count).map(|k| flights[k] - before(k)).collect())
    }

    /// The walk's posture at a time where trunk and arms are still its own in part, and which part is the run's.
    pub(super) fn walks(&self, time: f64) -> Option<(Posture, f64)> {
        let [before, after] = &self.seams;
        let gone = |seam: &Arc<Seam>| step::quintic((time - seam.at) / GOING_OVER).position;
        let left = |seam: &Arc<Seam>| step::quintic((seam.at - time) / GOING_OVER).position;
        let near = |seam: &Arc<Seam>, part: f64| (part < 1.0).then(|| (seam.posture(time), part));
        let begun = before.as_ref().and_then(|seam| near(seam, gone(seam)));
        begun.or_else(|| after.as_ref().and_then(|seam| near(seam, left(seam))))
    }

    /// What the thorax is drawn to.
    pub(super) fn drawn(&self, time: f64, walks: Option<&(Posture, f64)>) -> Euler {
        let (style, u) = self.trunk(time);
        let run = trunk::thorax(&style, u);
        walks.map_or(run, |(posture, part)| mixed(posture.trunk[2], run, *part))
    }

    /// Trunk and arms at a time, for the thorax that the angular momentum asks for.
    pub(super) fn upper(&self, time: f64, thorax: Euler, walks: Option<&(Posture, f64)>) -> Upper {
        let (style, u) = self.trunk(time);
        let run = Upper {
            trunk: trunk::trunk(&style, u, thorax),
            arms: trunk::arms(&style, u),
            carriage: trunk::carriage(&self.steps[0].style),
        };
        let Some((posture, part)) = walks else { return run };
        let mut trunk: [Euler; 5] = std::array::from_fn(|i| mixed(posture.trunk[i], run.trunk[i], *part));
        trunk[2] = thorax;
        Upper {
            trunk,
            arms: std::array::from_fn(|side| {
                std::array::from_fn(|i| {
                    posture.arms[side][i] + (run.arms[side][i] - posture.arms[side][i]) * part
                })
            }),
            carriage: posture.carriage.mixed(&run.carriage, *part),
        }
    }

    /// The style of trunk and arms at a time, and their clock.
    fn trunk(&self, time: f64) -> (RunStyle, f64) {
        let clock = self.clock.at(time).position;
        let next = self.steps.partition_point(|footstep| footstep.time <= time);
        let before = &self.steps[next.saturating_sub(1)];
        let style = match self.steps.get(next) {
            Some(after) if next > 0 => {
                let part = step::quintic((time - before.time) / (after.time - before.time)).position;
                before.style.mixed(&after.style, part)
            }
            _ => before.style,
        };
        let part = |(from, to): (f64, f64)| step::quintic((time - from) / (to - from)).position;
        let [begin, end] = self.moves;
        let running = begin.map_or(1.0, part) * (1.0 - end.map_or(0.0, part));
        let mut style = if running < 1.0 { style.standing().mixed(&style, running) } else { style };
        if let Some((from, to)) = begin {
            let x = (time - from) / (to + 0.4 - from);
            style.thorax_lean += LEAN * (4.0 * x * (1.0 - x)).max(0.0).powi(3);
        }
        (style, clock)
    }
}

/// The styles of steps at these speeds (m/s).
fn styles(height: f64, speeds: &[f64], from: &Bound, to: &Bound) -> Vec<RunStyle> {
    let mut styles: Vec<RunStyle> = speeds.iter().map(|&speed| RunStyle::of(height, speed)).collect();
    if matches!(from, Bound::Standing) {
        // The body is slow and low: the foot comes down under it, nearly flat, and the knee yields as much more slowly.
        let first = &mut styles[0];
        first.knee_contact += FIRST_KNEE;
        first.heel_strike_angle *= FIRST_STRIKE;
        first.knee_contact_rate *= FIRST_RATE;
        first.knee_contact_acc *= FIRST_RATE * FIRST_RATE;
    }
    if !matches!(to, Bound::Running) {
        // Braking, it leaves the foot less far behind.
        let last = styles.len() - 1;
        styles[last].knee_toe_off += LAST_KNEE.1;
        styles[last].knee_push += LAST_KNEE.0;
    }
    // All prints of a chain point the same way: as in the walks, whose usual style has one.
    let walked = [from, to].into_iter().find_map(|bound| match bound {
        Bound::Walking(walked) => Some(walked),
        Bound::Running | Bound::Standing => None,
    });
    if let Some(walked) = walked {
        for style in &mut styles {
            style.foot_yaw = walked.walk.style().foot_yaw;
        }
    }
    styles
}

fn mixed(from: Euler, to: Euler, part: f64) -> Euler {
    std::array::from_fn(|k| from[k] + (to[k] - from[k]) * part)
}
