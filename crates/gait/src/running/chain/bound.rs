//! How a chain begins and ends.

use super::seam::{LEAD, Seam};
use super::walked::{Arrival, Launch};
use crate::body::Body;
use crate::smooth::WalkPlan;
use solaris_profiles::ProfileError;
use std::sync::Arc;

/// What a chain begins with, or ends with.
#[derive(Clone)]
pub(in crate::running) enum Bound {
    Running,
    Standing,
    Walking(Walked),
}

impl Bound {
    /// How fast it walks (m/s).
    pub(in crate::running) fn walks_at(&self) -> Option<f64> {
        match self {
            Self::Walking(walked) => Some(walked.speed()),
            Self::Running | Self::Standing => None,
        }
    }

    /// The stance that leaves the ground out of a walk, for nodes `step` apart (s).
    pub(super) fn launch(&self, body: &Body, step: f64) -> Result<Option<Launch>, ProfileError> {
        match self {
            Self::Walking(walked) => walked.launch(body, step).map(Some),
            Self::Running | Self::Standing => Ok(None),
        }
    }
}

/// A walk, and in which of its steps a run begins or has ended.
#[derive(Clone)]
pub(in crate::running) struct Walked {
    pub(in crate::running) walk: Arc<WalkPlan>,
    pub(in crate::running) step: usize,
}

impl Walked {
    /// How fast it is (m/s).
    pub(super) fn speed(&self) -> f64 {
        let style = self.walk.style();
        style.step_length * style.step_frequency / 60.0
    }

    /// Whether the left foot stands next.
    pub(in crate::running) fn next_left(&self) -> bool {
        self.side() == 1
    }

    /// The foot that stands in its step.
    fn side(&self) -> usize {
        usize::from((self.step % 2 == 1) != self.walk.left_first())
    }

    /// When the other foot has left, when the heel rises, and when the other foot lands (s).
    fn stands(&self) -> [f64; 3] {
        [self.walk.stands_alone(self.step), self.walk.heel_rises(self.step), self.walk.lands(self.step + 1)]
    }

    /// Out of it: the seam is as soon as the other foot is off the ground.
    fn launch(&self, body: &Body, step: f64) -> Result<Launch, ProfileError> {
        let at = LEAD as f64 * step;
        let [alone, _, lands] = self.stands();
        let lands = lands - alone;
        let span = (0.0, Launch::asked(at, lands));
        let seam = Seam::new(body, &self.walk, (self.step, self.side()), (alone + at, at), span, step)?;
        Ok(Launch::new(Arc::new(seam), body.height, lands))
    }

    /// Into it, after a landing at `time`: the seam is when the heel is about to rise.
    pub(super) fn arrival(&self, body: &Body, time: f64, step: f64) -> Result<Arrival, ProfileError> {
        let at = time + (Arrival::lasts(body.height, self.speed()) / step).round() * step;
        let [alone, rises, _] = self.stands();
        let left = alone - rises + at;
        let span = (Arrival::asked(at, left), at + LEAD as f64 * step);
        let seam = Seam::new(body, &self.walk, (self.step, self.side()), (rises, at), span, step)?;
        Ok(Arrival::new(Arc::new(seam), time, left))
    }
}
