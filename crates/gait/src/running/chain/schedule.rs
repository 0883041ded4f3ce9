//! When which foot touches in a chain of steps, and in which style.

use super::carry::Stands;
use super::footstep::Footstep;
use super::stood::{Begin, Finish};
use crate::request::{RunEnd, RunResolution};
use crate::running::style::RunStyle;
use solaris_profiles::spline::NaturalSpline;
use solaris_profiles::{ProfileError, step};
use std::ops::RangeInclusive;

/// Steps at an unchanging speed that are planned before and after those that are shown, and that nobody sees: at their ends nothing is known
/// of what was before and comes after.
const UNSEEN: usize = 3;
/// How long trunk and arms move on after the last landing (s).
const MOVING_ON: f64 = 0.8;
/// Speed at which the push from standing leaves the ground (m/s).
const PUSHED: f64 = 0.85;
/// By how much the knee is more bent in the push and at toe-off of the last step before the stop.
const LAST_KNEE: (f64, f64) = (10.0 * std::f64::consts::PI / 180.0, 14.0 * std::f64::consts::PI / 180.0);
/// Parts of the foot's pitch and of the knee's rate then.
const FIRST_STRIKE: f64 = 0.4;
const FIRST_RATE: f64 = 0.4;
/// By how much more the body leans forward as it begins.
const LEAN: f64 = 8.0 * std::f64::consts::PI / 180.0;
/// How far the first prints after standing may lie beside the line (m).
const ASIDE: [f64; 2] = [0.02, 0.01];
/// By how much the knee is more bent at the first contact after standing.
const FIRST_KNEE: f64 = 15.0 * std::f64::consts::PI / 180.0;

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
    /// Between which times trunk and arms come to move, and come to rest.
    moves: [Option<(f64, f64)>; 2],
    /// Clock of trunk and arms: whole at left contacts.
    clock: NaturalSpline,
}

impl Schedule {
    /// Of steps at these speeds (m/s), of which the left foot's comes first or the right one's. Where it begins in standing the other foot
    /// pushes off before the first of them, where it ends there one more step is made to stop.
    pub(in crate::running) fn new(
        height: f64,
        speeds: &[f64],
        (from, to): (RunEnd, RunEnd),
        left_first: bool,
        resolution: RunResolution,
    ) -> Result<Self, ProfileError> {
        let stands = Stands { first: from == RunEnd::Standing, last: to == RunEnd::Standing };
        let unseen = |stands: bool| if stands { 0 } else { UNSEEN };
        let (lead, tail) = (unseen(stands.first), unseen(stands.last));
        let (first, last) = (speeds[0], speeds[speeds.len() - 1]);
        // The step with which it ends in full run is one more.
        let tail = if stands.last { 0 } else { 1 + tail };
        let run = [&vec![first; lead][..], speeds, &vec![last; tail][..]].concat();
        let mut styles: Vec<RunStyle> = run.iter().map(|&speed| RunStyle::of(height, speed)).collect();
        if stands.first {
            // The body is slow and low: the foot comes down under it, nearly flat, and the knee yields as much more slowly.
            let first = &mut styles[0];
            first.knee_contact += FIRST_KNEE;
            first.heel_strike_angle *= FIRST_STRIKE;
            first.knee_contact_rate *= FIRST_RATE;
            first.knee_contact_acc *= FIRST_RATE * FIRST_RATE;
        }
        if stands.last {
            // Braking, it leaves the foot less far behind.
            let last = styles.len() - 1;
            styles[last].knee_toe_off += LAST_KNEE.1;
            styles[last].knee_push += LAST_KNEE.0;
        }
        let n = styles.len();
        let begin = Begin::new(height);
        // Contacts are at nodes: the foot's acceleration jumps there.
        let step = styles[0].stride_time / resolution.nodes as f64;
        let at_node = |time: f64| (time / step).round() * step;
        let mut time = if stands.first { at_node(begin.last + 0.6 * styles[0].flight_time()) } else { 0.0 };
        let mut times = Vec::new();
        for style in &styles {
            times.push(time);
            time = at_node(time + 0.5 * style.stride_time);
        }
        let side = |k: usize| usize::from((k % 2 == lead % 2) != left_first);
        let flight = |k: usize| styles[k].flight_time();
        let (mut steps, mut means) = (Vec::new(), Vec::new());
        if stands.first {
            steps.push(Footstep::begin(1 - side(0), &styles[0], begin.clone()));
            means.push(PUSHED);
        }
        for k in 0..n {
            let around = styles[k].contact_time() + 0.5 * (flight(k) + flight(k.saturating_sub(1)));
            let beside = if stands.first { ASIDE.get(k).copied().unwrap_or(0.0) } else { 0.0 };
            steps.push(Footstep::running(side(k), times[k], &styles[k], around, beside, resolution.nodes)?);
            means.push(0.5 * (run[k] + run[(k + 1).min(n - 1)]));
        }
        if stands.last {
            steps.push(Footstep::finish(side(n), time, &styles[n - 1], Finish::new(height)));
            means.push(0.0);
        }
        let shown_steps = if stands.first { 0 } else { lead }..=if stands.last {
            steps.len() - 1
        } else {
            lead + speeds.len()
        };
        let margin = 0.5 * flight(0).min(flight(n - 1));
        let start = if stands.first { 0.0 } else { -margin };
        let end = steps[steps.len() - 1].end() + if stands.last { 0.0 } else { margin };
        let shown = (
            if stands.first { 0.0 } else { times[lead] },
            if stands.last { end } else { times[lead + speeds.len()] },
        );
        let phase = 0.5 * (lead % 2) as f64 + if left_first { 0.0 } else { 0.5 };
        let clocks: Vec<f64> = (0..=n).map(|k| phase + 0.5 * k as f64).collect();
        times.push(time);
        let moves = [
            if stands.first { Some((begin.still, times[0])) } else { None },
            if stands.last { Some((time, time + MOVING_ON)) } else { None },
        ];
        Ok(Self {
            steps,
            start,
            end,
            speeds: means,
            shown_steps,
            shown,
            stands,
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
        if self.stands.first {
            flights[0] = self.speeds[0];
        }
        if self.stands.last {
            flights[count - 1] = 0.0;
        }
        let speed = if self.stands.first { 0.0 } else { flights[0] };
        let before = |k: usize| k.checked_sub(1).map_or(speed, |before| flights[before]);
        (speed, (0..count).map(|k| flights[k] - before(k)).collect())
    }

    /// The style of trunk and arms at a time, and their clock.
    pub(super) fn trunk(&self, time: f64) -> (RunStyle, f64) {
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
