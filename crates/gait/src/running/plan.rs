//! A run of some steps: its posture and the ground's force at any time.

use super::chain::Chain;
use super::stride::RunStride;
use super::style::RunStyle;
use super::walk_side::WalkSide;
use crate::body::FEET;
use crate::body::foot::mirror;
use crate::walking::{G, Prescribing, Stood, StrideLoop, Walking, sampled};
use solaris_analysis::ReactionError;
use solaris_model::{Contact, Event, EventKind, Figure, Interval, Motion, Trajectory};

/// A planned run: from a contact to a contact in full run, from standing or out of a walk, to a stop or into a walk.
///
/// In full run it goes on before it begins and after it has ended, so that velocities and accelerations at its ends are those of a run that
/// never ends. The first print's heel stands at z = 0, that of standing feet where it begins in a walk. Left and right feet are 0 and 1.
#[doc(alias = "gait")]
#[doc(alias = "locomotion")]
#[doc(alias = "jog")]
#[derive(Clone, Debug)]
pub struct RunPlan {
    stride: RunStride,
    steps: usize,
    left_first: bool,
    /// Steps that are not all alike; none where the stride repeats.
    chain: Option<Box<Chain>>,
    /// The walks that it comes out of and goes over into.
    walks: [Option<WalkSide>; 2],
}

impl RunPlan {
    /// So many steps of a stride, of which the left foot's comes first or the right one's.
    pub fn new(stride: RunStride, steps: usize, left_first: bool) -> Self {
        Self { stride, steps, left_first, chain: None, walks: [None, None] }
    }

    /// Steps that are not all alike, `steps` of them run; `stride` is that of the first speed.
    pub(super) fn changing(
        stride: RunStride,
        chain: Chain,
        steps: usize,
        left_first: bool,
        walks: [Option<WalkSide>; 2],
    ) -> Self {
        let mut plan = Self { stride, steps, left_first, chain: Some(Box::new(chain)), walks };
        plan.steps += plan.walked_steps().iter().sum::<usize>();
        plan
    }

    /// How long it walks before it runs (s).
    fn walks_until(&self) -> f64 {
        self.walks[0].as_ref().map_or(0.0, |walk| walk.seen().end)
    }

    /// When it no longer runs (s).
    fn runs_until(&self) -> f64 {
        self.walks[1].as_ref().map_or_else(|| self.duration(), |walk| walk.seen().start)
    }

    /// The walk that is seen at a time.
    fn walks_at(&self, time: f64) -> Option<&WalkSide> {
        let [before, after] = &self.walks;
        let before = before.as_ref().filter(|walk| time < walk.seen().end);
        before.or(after.as_ref().filter(|walk| time > walk.seen().start))
    }

    /// The stride that is repeated, that of the first speed; in it the left foot touches first.
    pub fn stride(&self) -> &RunStride {
        &self.stride
    }

    /// The style that was planned, at the first speed.
    pub fn style(&self) -> &RunStyle {
        self.stride.style()
    }

    /// Number of steps, those of the walks beside the run among them, and the one that lands in a walk where it does not begin in full run.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// How many of its steps are walked before it runs, and after it.
    pub fn walked_steps(&self) -> [usize; 2] {
        let [before, after] = &self.walks;
        // The step that leaves the ground is the walk's.
        [before.as_ref().map_or(0, |walk| walk.steps() + 1), after.as_ref().map_or(0, WalkSide::steps)]
    }

    /// Whether its steps are not all alike.
    pub fn changes(&self) -> bool {
        self.chain.is_some()
    }

    /// The standing height that the laws scale with (m): the figure's own, or what its legs suggest.
    pub fn stature(&self) -> f64 {
        self.stride.body.height
    }

    /// The body's weight (N).
    pub fn weight(&self) -> f64 {
        self.stride.body.mass * G
    }

    /// How far along z heels are set down (m): each step, and the next one's.
    pub fn prints(&self) -> impl Iterator<Item = f64> + use<> {
        let step = self.style().step_length;
        let prints: Vec<f64> = match &self.chain {
            Some(chain) => {
                let [before, after] =
                    self.walks.each_ref().map(|walk| walk.iter().flat_map(WalkSide::prints));
                before.chain(chain.prints()).chain(after).collect()
            }
            None => (0..=self.steps).map(|k| step * k as f64).collect(),
        };
        prints.into_iter()
    }

    /// The run sampled `rate` times a second, with its events and planted points, without forces
    /// ([`solaris_analysis::prescribed_reactions`] takes [`Prescribing::contacts`]).
    ///
    /// # Errors
    ///
    /// A rate that is none, and another figure than the plan's.
    pub fn motion(&self, figure: &Figure, rate: f64) -> Result<Motion, ReactionError> {
        sampled(figure, self, self.stride.body.fingerprint, rate)
    }

    /// The first stride, to be repeated; none of a single step, and of steps that are not alike.
    pub fn stride_loop(&self) -> Option<StrideLoop<'_, Self>> {
        if self.steps < 2 || self.changes() {
            return None;
        }
        let (body, style) = (&self.stride.body, self.style());
        let advance = 2.0 * style.step_length;
        Some(StrideLoop::new(self, body.nq, body.root + 2, (0.0, style.stride_time), advance))
    }

    /// Clock of the stride at a time.
    fn clock(&self, time: f64) -> f64 {
        time / self.style().stride_time
    }

    /// When feet stand, from the first step to the one with which it ends, by side.
    fn stood(&self) -> Vec<(usize, Stood)> {
        let style = self.style();
        let steady = |step: usize| {
            let touch_down = 0.5 * step as f64 * style.stride_time;
            let after = |part: f64| touch_down + part * style.contact_time();
            let stood = Stood {
                landed: after(0.0),
                flat: after(style.foot_flat),
                on_ball: self.style().lands_on_ball(),
                heel_off: after(style.heel_off),
                tip_roll: after(style.tip_roll),
                toe_off: after(1.0),
            };
            (if self.left_first { step % 2 } else { (step + 1) % 2 }, stood)
        };
        let mut stood: Vec<(usize, Stood)> = match &self.chain {
            Some(chain) => {
                let later = self.walks_until();
                chain.stood().map(|(side, stood)| (side, stood.later(later))).collect()
            }
            None => (0..=self.steps).map(steady).collect(),
        };
        stood.sort_by(|a, b| a.1.landed.total_cmp(&b.1.landed));
        stood
    }
}

impl Trajectory for RunPlan {
    fn duration(&self) -> f64 {
        match &self.chain {
            Some(chain) => match &self.walks[1] {
                Some(walk) => walk.seen().end,
                None => self.walks_until() + chain.duration(),
            },
            None => 0.5 * self.steps as f64 * self.style().stride_time,
        }
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        if let Some(chain) = &self.chain {
            match self.walks_at(t) {
                Some(walk) => walk.configuration(t, self.stride.body.root, q),
                None => chain.configuration(t - self.walks_until(), q),
            }
            return;
        }
        let u = self.clock(t);
        if self.left_first {
            self.stride.configuration(u, q);
        } else {
            self.stride.mirrored_configuration(u, q);
        }
    }

    /// The distance of the nodes (s).
    fn resolution(&self) -> f64 {
        match &self.chain {
            Some(chain) => chain.resolution(),
            None => self.style().stride_time / self.stride.node_count() as f64,
        }
    }
}

impl Walking for RunPlan {
    /// In full run the last touch-down is the one with which it ends.
    fn events(&self) -> Vec<Event> {
        let mut events: Vec<Event> = self.walks.iter().flatten().flat_map(WalkSide::events).collect();
        let end = self.runs_until();
        for (side, Stood { landed, toe_off, .. }) in self.stood() {
            let link = FEET[side].to_owned();
            if landed >= self.walks_until() {
                events.push(Event { time: landed, kind: EventKind::TouchDown { link: link.clone() } });
            }
            if toe_off < end {
                events.push(Event { time: toe_off, kind: EventKind::LiftOff { link } });
            }
        }
        events.sort_by(|a, b| a.time.total_cmp(&b.time));
        events
    }

    fn planted(&self, figure: &Figure) -> Vec<Interval> {
        let (begin, end) = (self.walks_until(), self.runs_until());
        let planted = self
            .stood()
            .into_iter()
            .flat_map(|(side, stood)| stood.planted(figure, side).collect::<Vec<_>>());
        let within = planted.map(|planted| Interval {
            start: planted.start.max(begin),
            end: planted.end.min(end),
            ..planted
        });
        let [before, after] = self
            .walks
            .each_ref()
            .map(|walk| walk.iter().flat_map(|walk| walk.planted(figure)).collect::<Vec<Interval>>());
        let mut all = before;
        for interval in within.filter(|planted| planted.start < planted.end).chain(after) {
            // What is planted at a seam stays so.
            let goes_on = |before: &&mut Interval| {
                before.end >= interval.start
                    && [begin, end].contains(&interval.start)
                    && (before.link, before.point) == (interval.link, interval.point)
            };
            match all.iter_mut().find(goes_on) {
                Some(before) => before.end = interval.end,
                None => all.push(interval),
            }
        }
        all
    }
}

impl Prescribing for RunPlan {
    fn contacts(&self, t: f64) -> [Contact; 2] {
        if let Some(chain) = &self.chain {
            return match self.walks_at(t) {
                Some(walk) => walk.contacts(t),
                None => chain.forces(t - self.walks_until()),
            };
        }
        let feet = self.stride.forces(self.clock(t));
        if self.left_first {
            return feet;
        }
        let [left, right] = feet.map(|Contact { force, moment, cop }| {
            // The mirror turns an axial vector the other way.
            Contact { force: mirror(&force), moment: -mirror(&moment), cop: mirror(&cop) }
        });
        [right, left]
    }
}
