//! A walk before a run or after it, on its side of their seam.

use crate::smooth::WalkPlan;
use nalgebra::Vector3;
use solaris_analysis::{Support, SupportLaw, split_at_pivot};
use solaris_dynamics::Wrench;
use solaris_model::{Contact, Event, Figure, Interval, Trajectory as _};
use solaris_profiles::{ProfileError, UniformSpline};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// A walk between two times of the whole motion.
#[derive(Clone)]
pub(super) struct WalkSide {
    walk: Arc<WalkPlan>,
    /// When it is seen (s), and by how much its own time is less.
    seen: Range<f64>,
    later: f64,
    /// How much farther along z it is than by itself (m).
    along: f64,
    /// The steps of it that are seen.
    steps: Range<usize>,
    /// Centre of mass, and rate of the angular momentum about it, over its own time (s).
    carried: UniformSpline<6>,
}

impl fmt::Debug for WalkSide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("WalkSide")
            .field("seen", &self.seen)
            .field("steps", &self.steps)
            .finish_non_exhaustive()
    }
}

impl WalkSide {
    /// Until the seam, which its own time (s) is `until`, in the stance of `step`.
    pub(super) fn before(walk: &Arc<WalkPlan>, step: usize, until: f64) -> Result<Self, ProfileError> {
        Self::new(walk, 0.0..until, 0.0, 0.0, 1..step)
    }

    /// From the seam on, which is at `from` in the whole motion and `walked` in the walk (s), in the stance of `step`, whose heel stands `along` z (m).
    pub(super) fn after(
        walk: &Arc<WalkPlan>,
        step: usize,
        from: f64,
        walked: f64,
        along: f64,
    ) -> Result<Self, ProfileError> {
        let later = from - walked;
        let along = along - walk.prints()[step];
        Self::new(walk, from..later + walk.duration(), later, along, step + 1..walk.steps() + 1)
    }

    fn new(
        walk: &Arc<WalkPlan>,
        seen: Range<f64>,
        later: f64,
        along: f64,
        steps: Range<usize>,
    ) -> Result<Self, ProfileError> {
        let (count, _) = walk.nodes();
        let row = |node: usize| {
            let (com, rate) = (walk.com(node), walk.momentum_rate(node));
            [com.x, com.y, com.z, rate.x, rate.y, rate.z]
        };
        let rows: Vec<[f64; 6]> = (0..count).map(row).collect();
        let carried = UniformSpline::resting(walk.time(walk.clock(0)), walk.resolution(), &rows)?;
        Ok(Self { walk: Arc::clone(walk), seen, later, along, steps, carried })
    }

    /// When it is seen (s).
    pub(super) fn seen(&self) -> &Range<f64> {
        &self.seen
    }

    /// How many of its steps are seen.
    pub(super) fn steps(&self) -> usize {
        self.steps.len()
    }

    /// The posture at a time of the whole motion, for the first coordinate of the root.
    pub(super) fn configuration(&self, time: f64, root: usize, q: &mut [f64]) {
        self.walk.configuration(time - self.later, q);
        q[root + 2] += self.along;
    }

    pub(super) fn contacts(&self, time: f64) -> [Contact; 2] {
        let time = time - self.later;
        let [x, y, z, about_x, about_y, about_z] = self.carried.position(time);
        let (com, rate) = (Vector3::new(x, y, z), Vector3::new(about_x, about_y, about_z));
        let Support { feet, pivot, .. } = SupportLaw::support(self.walk.as_ref(), time);
        let force = self.walk.force(self.walk.clock_at(time));
        let total = Wrench { force, moment: com.cross(&force) + rate };
        let feet = split_at_pivot(&total, &com, &Vector3::y(), pivot, &feet).unwrap_or_default();
        let along = Vector3::z() * self.along;
        feet.map(|Contact { force, moment, cop }| {
            if force == Vector3::zeros() {
                return Contact::default();
            }
            Contact { force, moment: moment + along.cross(&force), cop: cop + along }
        })
    }

    /// Its events that are seen.
    pub(super) fn events(&self) -> impl Iterator<Item = Event> + '_ {
        let events = self.walk.events().into_iter();
        let events = events.map(|event| Event { time: event.time + self.later, ..event });
        events.filter(|event| self.seen.contains(&event.time))
    }

    /// Its planted points while they are seen.
    pub(super) fn planted(&self, figure: &Figure) -> impl Iterator<Item = Interval> + '_ {
        let planted = self.walk.planted(figure).into_iter();
        let planted = planted.map(|interval| Interval {
            start: (interval.start + self.later).max(self.seen.start),
            end: (interval.end + self.later).min(self.seen.end),
            ..interval
        });
        planted.filter(|interval| interval.start < interval.end)
    }

    /// How far along z its heels are set down (m) in the steps that are seen.
    pub(super) fn prints(&self) -> impl Iterator<Item = f64> + '_ {
        self.walk.prints()[self.steps.clone()].iter().map(|print| print + self.along)
    }
}
