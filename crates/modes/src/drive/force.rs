//! The force of a drive on one degree of freedom, in the time of the run.

use solaris_profiles::{Clip, Curve};
use std::sync::Arc;

/// What a drive does to a degree of freedom that dynamics move.
#[derive(Clone)]
pub(crate) enum Force {
    /// As much all the time (N m or N); zero for a free one.
    Constant(f64),
    /// A curve that begins at a time of the run; after its end, as at its end.
    Along(Clip<Arc<dyn Curve + Send + Sync>>),
}

impl Force {
    /// The force (N m or N) at a time of the run.
    pub(crate) fn at(&self, time: f64) -> f64 {
        match self {
            Self::Constant(force) => *force,
            Self::Along(clip) => clip.at(time).position,
        }
    }
}
