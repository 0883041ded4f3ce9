//! Parts of a walk, from the time 0 on.

use super::plan::WalkPlan;
use crate::walking::{Walking, balanced};
use solaris_analysis::{ReactionError, Support, SupportLaw};
use solaris_model::{Contact, Event, Figure, Interval, Motion, Trajectory};

/// A walk from a time to a later one; it goes on before and after.
pub(crate) struct Excerpt<'a> {
    walk: &'a WalkPlan,
    from: f64,
    to: f64,
}

impl<'a> Excerpt<'a> {
    pub(crate) fn new(walk: &'a WalkPlan, from: f64, to: f64) -> Self {
        Self { walk, from, to }
    }

    /// Its samples, as [`WalkPlan::motion`] has them, without its events and planted points.
    pub(crate) fn samples(&self, figure: &Figure, rate: f64) -> Result<Motion, ReactionError> {
        let mut motion = balanced(figure, self, self.walk.body.fingerprint, rate)?;
        motion.relief = self.walk.relief().cloned();
        Ok(motion)
    }
}

impl SupportLaw for Excerpt<'_> {
    fn support(&self, t: f64) -> Support {
        SupportLaw::support(self.walk, self.from + t)
    }

    fn beside(&self, t: f64) -> Option<(&str, Contact)> {
        self.walk.beside(self.from + t)
    }
}

impl Trajectory for Excerpt<'_> {
    fn duration(&self) -> f64 {
        self.to - self.from
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        self.walk.configuration(self.from + t, q);
    }

    fn resolution(&self) -> f64 {
        self.walk.resolution()
    }
}

impl Walking for Excerpt<'_> {
    fn events(&self) -> Vec<Event> {
        let slack = 1e-9;
        let mut events = self.walk.events();
        for event in &mut events {
            event.time -= self.from;
        }
        events.retain(|event| (-slack..=self.duration() + slack).contains(&event.time));
        for event in &mut events {
            event.time = event.time.clamp(0.0, self.duration());
        }
        events
    }

    fn planted(&self, figure: &Figure) -> Vec<Interval> {
        let mut planted = self.walk.planted(figure);
        // Before the walk and after it feet stand where they do.
        let lasts = self.walk.duration() - 1e-9;
        for interval in &mut planted {
            let (start, end) = (interval.start, interval.end);
            interval.start = if start <= 0.0 { 0.0 } else { (start - self.from).max(0.0) };
            interval.end =
                if end >= lasts { self.duration() } else { (end - self.from).min(self.duration()) };
        }
        planted.retain(|interval| interval.start < interval.end);
        planted
    }
}
