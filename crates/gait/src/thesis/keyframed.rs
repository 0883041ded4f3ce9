//! A walk through key postures: the postures exactly, and what lies between them.
//!
//! Each phase is built up from its root, a point of a foot on the ground: the pitches of the root's leg are interpolated, the
//! pelvis follows, and with it the other hip. The other foot is pinned where both postures have it on the same spot; else it
//! swings, and is raised where it would sink.

mod contact;
mod foot;
mod options;
mod phase;
mod script;

pub use options::{InBetween, KeyframedOptions};
pub use script::{KeyScript, ScriptCycle};

use crate::body::Body;
use crate::body::foot::FootPlane;
use crate::body::posture::Posture;
use crate::error::GaitError;
use crate::thesis::determinants::Proportions;
use crate::walking::StrideLoop;
use phase::Phase;
use script::Sway;
use solaris_model::{Figure, Trajectory};

/// How long it rests before it begins and after it has ended, in steps: longer than any difference formula reaches.
const REST: f64 = 0.25;
/// Into how many parts a step is divided by [`Trajectory::resolution`].
const PARTS: f64 = 200.0;

/// A walk through key postures, from standing to standing, that can be evaluated at any time.
///
/// In the thesis's style each phase goes from rest to rest: the body stops at every posture.
#[doc(alias = "KeyedWalk")]
#[doc(alias = "key poses")]
pub struct KeyframedWalk {
    body: Body,
    proportions: Proportions,
    options: KeyframedOptions,
    phases: Vec<Phase>,
    sway: Sway,
    step_time: f64,
    /// Heel prints (m) as the steps make them, after the two that it stands on.
    prints: Vec<f64>,
    /// From when to when a stride repeats itself (s).
    loops: Option<(f64, f64)>,
}

impl KeyframedWalk {
    /// The walk of a script.
    ///
    /// # Errors
    ///
    /// A figure that cannot walk, see [`crate::missing_for_walking()`]; a script without cycles; numbers that are none; feet so far to the side
    /// that no leg reaches them.
    pub fn new(figure: &Figure, script: &KeyScript, options: KeyframedOptions) -> Result<Self, GaitError> {
        crate::body::missing::check(figure)?;
        let body = Body::of(figure)?.with_legs_alike()?;
        let proportions = Proportions::of_leg(&body.leg, body.height);
        script.check(&options, proportions.leg())?;
        let rest = REST * script.step_time;
        let (phases, prints) = script::laid_out(&proportions, script, &options, rest);
        let sway = Sway::new(&options, script, &phases);
        let [starting, intermediate, _] = &script.cycles;
        let (first, length) = (starting.phases.len(), intermediate.phases.len());
        let start = |cycle: usize| phases[first + cycle * length].start;
        // The sway has come to its height after the first step, and dies away in the last one.
        let loops = (script.steps >= 6).then(|| (start(1), start(3)));
        Ok(Self { body, proportions, options, sway, step_time: script.step_time, prints, loops, phases })
    }

    /// Heel prints along z (m): each step's, and the closing foot's.
    pub fn prints(&self) -> &[f64] {
        &self.prints
    }

    /// How far the toe of the foot behind would slide forward (m) between two postures that both have it on the ground, if it did
    /// not count as lifted; of the last step that has such a pair.
    pub fn toe_slide(&self) -> Option<f64> {
        self.phases.iter().rev().find_map(|phase| phase.slid)
    }

    /// Duration of a step (s).
    pub fn step_time(&self) -> f64 {
        self.step_time
    }

    /// The proportions of the figure that walks.
    pub fn proportions(&self) -> &Proportions {
        &self.proportions
    }

    /// The times (s) at which a key posture is met, with its name, the first where the movement begins.
    pub fn keys(&self) -> impl Iterator<Item = (f64, &'static str)> {
        self.phases.iter().map(|phase| (phase.start + phase.duration, phase.to.name))
    }

    /// The stride of the second and third intermediate cycle, to be repeated; none of a walk of fewer than six steps.
    pub fn stride_loop(&self) -> Option<StrideLoop<'_, Self>> {
        let &(from, to) = self.loops.as_ref()?;
        let advance = self.prints[2] - self.prints[0];
        Some(StrideLoop::new(self, self.body.nq, self.body.root + 2, (from, to - from), advance))
    }

    fn posture(&self, t: f64) -> Posture {
        let t = t.clamp(self.phases[0].start, self.end());
        let after = self.phases.partition_point(|phase| phase.start <= t);
        let phase = &self.phases[after.saturating_sub(1)];
        let plane = FootPlane::new(0.0);
        phase.posture(&self.body, &self.proportions, &self.options, &plane, (t, self.sway.at(t)))
    }

    /// When the movement ends (s).
    fn end(&self) -> f64 {
        self.phases.last().map_or(0.0, |phase| phase.start + phase.duration)
    }
}

impl Trajectory for KeyframedWalk {
    fn duration(&self) -> f64 {
        self.end() + REST * self.step_time
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        self.posture(t).write(&self.body, &FootPlane::new(0.0), q);
    }

    /// A two-hundredth of a step.
    fn resolution(&self) -> f64 {
        self.step_time / PARTS
    }
}
