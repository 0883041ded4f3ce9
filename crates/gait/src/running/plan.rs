//! A run of some steps: its posture and the ground's force at any time.

use super::chain::Chain;
use super::stride::RunStride;
use super::style::RunStyle;
use crate::body::FEET;
use crate::body::foot::mirror;
use crate::walking::{G, Prescribing, Stood, StrideLoop, Walking, sampled};
use solaris_analysis::ReactionError;
use solaris_model::{Contact, Event, EventKind, Figure, Interval, Motion, Trajectory};

/// A planned run: from a contact to a contact in full run, or from standing, or to a stop.
///
/// In full run it goes on before it begins and after it has ended, so that velocities and accelerations at its ends are those of a run that
/// never ends. The first print's heel stands at z = 0. Left and right feet are 0 and 1.
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
}

impl RunPlan {
    /// So many steps of a stride, of which the left foot's comes first or the right one's.
    pub fn new(stride: RunStride, steps: usize, left_first: bool) -> Self {
        Self { stride, steps, left_first, chain: None }
    }

    /// Steps that are not all alike; `stride` is that of the first speed.
    pub(super) fn changing(stride: RunStride, chain: Chain, steps: usize, left_first: bool) -> Self {
        Self { stride, steps, left_first, chain: Some(Box::new(chain)) }
    }

    /// The stride that is repeated, that of the first speed; in it the left foot touches first.
    pub fn stride(&self) -> &RunStride {
        &self.stride
    }

    /// The style that was planned, at the first speed.
    pub fn style(&self) -> &RunStyle {
        self.stride.style()
    }

    /// Number of steps.
    pub fn steps(&self) -> usize {
        self.steps
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
            Some(chain) => chain.prints().collect(),
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
                on_ball: false,
                heel_off: after(style.heel_off),
                tip_roll: after(style.tip_roll),
                toe_off: after(1.0),
            };
            (if self.left_first { step % 2 } else { (step + 1) % 2 }, stood)
        };
        let mut stood: Vec<(usize, Stood)> = match &self.chain {
            Some(chain) => chain.stood().collect(),
            None => (0..=self.steps).map(steady).collect(),
        };
        stood.sort_by(|a, b| a.1.landed.total_cmp(&b.1.landed));
        stood
    }
}

impl Trajectory for RunPlan {
    fn duration(&self) -> f64 {
        match &self.chain {
            Some(chain) => chain.duration(),
            None => 0.5 * self.steps as f64 * self.style().stride_time,
        }
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        if let Some(chain) = &self.chain {
            return chain.configuration(t, q);
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
        let mut events = Vec::new();
        let end = self.duration();
        for (side, Stood { landed, toe_off, .. }) in self.stood() {
            let link = FEET[side].to_owned();
            if landed >= 0.0 {
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
        let end = self.duration();
        let planted = self
            .stood()
            .into_iter()
            .flat_map(|(side, stood)| stood.planted(figure, side).collect::<Vec<_>>());
        let within = planted.map(|planted| Interval {
            start: planted.start.max(0.0),
            end: planted.end.min(end),
            ..planted
        });
        within.filter(|planted| planted.start < planted.end).collect()
    }
}

impl Prescribing for RunPlan {
    fn contacts(&self, t: f64) -> [Contact; 2] {
        if let Some(chain) = &self.chain {
            return chain.forces(t);
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
