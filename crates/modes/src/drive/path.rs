//! The prescribed motion of one degree of freedom, in the time of the run.

use crate::recorded::Recorded;
use solaris_profiles::{Clip, Curve, Sample};
use std::sync::Arc;

/// The prescribed motion of one degree of freedom.
#[derive(Clone)]
pub(crate) enum Path {
    /// It stands at a position.
    Still(f64),
    /// Along a curve that begins at a time of the run; at its ends it holds.
    Along(Clip<Arc<dyn Curve + Send + Sync>>),
    /// As in a record; the degree of freedom by its index in `v` and in `q`.
    Recorded { recorded: Arc<Recorded>, dof: usize, coordinate: usize },
}

impl Path {
    /// Position, velocity, acceleration (the jerk is not used) at a time of the run.
    pub(crate) fn at(&self, time: f64) -> Sample {
        match self {
            Self::Still(position) => Sample::rest(*position),
            Self::Along(clip) => clip.at(time),
            Self::Recorded { recorded, dof, coordinate } => recorded.at(*dof, *coordinate, time),
        }
    }
}
