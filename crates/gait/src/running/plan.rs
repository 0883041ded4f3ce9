//! A run of some steps: its posture and the ground's force at any time.

use super::stride::RunStride;
use super::style::RunStyle;
use crate::body::FEET;
use crate::body::foot::mirror;
use crate::walking::{G, Prescribing, Stood, StrideLoop, Walking, sampled};
use solaris_analysis::ReactionError;
use solaris_model::{Contact, Event, EventKind, Figure, Interval, Motion, Trajectory};

/// A planned run: some steps of a steady stride, from a contact to a contact, in full run at both ends.
///
/// It goes on before it begins and after it has ended, so that velocities and accelerations at its ends are those of a run that
/// never ends. The first print's heel stands at z = 0. Left and right feet are 0 and 1.
#[doc(alias = "gait")]
#[doc(alias = "locomotion")]
#[doc(alias = "jog")]
#[derive(Clone, Debug)]
pub struct RunPlan {
    stride: RunStride,
    steps: usize,
    left_first: bool,
}

impl RunPlan {
    /// So many steps of a stride, of which the left foot's comes first or the right one's.
    pub fn new(stride: RunStride, steps: usize, left_first: bool) -> Self {
        Self { stride, steps, left_first }
    }

    /// The stride that is repeated; in it the left foot touches first.
    pub fn stride(&self) -> &RunStride {
        &self.stride
    }

    /// The style that was planned.
    pub fn style(&self) -> &RunStyle {
        self.stride.style()
    }

    /// Number of steps.
    pub fn steps(&self) -> usize {
        self.steps
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
        (0..=self.steps).map(move |k| step * k as f64)
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

    /// The first stride, to be repeated; none of a single step.
    pub fn stride_loop(&self) -> Option<StrideLoop<'_, Self>> {
        if self.steps < 2 {
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

    /// When the step's foot touches (s); steps count from 0.
    fn contact_time(&self, step: usize) -> f64 {
        0.5 * step as f64 * self.style().stride_time
    }

    /// The foot that a step is made with.
    fn side(&self, step: usize) -> usize {
        if self.left_first { step % 2 } else { (step + 1) % 2 }
    }
}

impl Trajectory for RunPlan {
    fn duration(&self) -> f64 {
        self.contact_time(self.steps)
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        let u = self.clock(t);
        if self.left_first {
            self.stride.configuration(u, q);
        } else {
            self.stride.mirrored_configuration(u, q);
        }
    }

    /// The distance of the nodes (s).
    fn resolution(&self) -> f64 {
        self.style().stride_time / self.stride.node_count() as f64
    }
}

impl Walking for RunPlan {
    /// The last touch-down is the one with which it ends.
    fn events(&self) -> Vec<Event> {
        let mut events = Vec::new();
        for step in 0..=self.steps {
            let (link, time) = (FEET[self.side(step)].to_owned(), self.contact_time(step));
            events.push(Event { time, kind: EventKind::TouchDown { link: link.clone() } });
            if step < self.steps {
                let time = time + self.style().contact_time();
                events.push(Event { time, kind: EventKind::LiftOff { link } });
            }
        }
        events
    }

    fn planted(&self, figure: &Figure) -> Vec<Interval> {
        let style = self.style();
        let stance = |step: usize| {
            let after = |part: f64| self.contact_time(step) + part * style.contact_time();
            let stood = Stood {
                landed: after(0.0),
                flat: after(style.foot_flat),
                on_ball: false,
                heel_off: after(style.heel_off),
                tip_roll: after(style.tip_roll),
                toe_off: after(1.0),
            };
            stood.planted(figure, self.side(step))
        };
        (0..self.steps).flat_map(stance).collect()
    }
}

impl Prescribing for RunPlan {
    fn contacts(&self, t: f64) -> [Contact; 2] {
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
