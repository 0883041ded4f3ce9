//! The force of a drive on one degree of freedom, in the time of the run.

use super::path::Path;

/// What a drive does to a degree of freedom that dynamics move.
#[derive(Clone)]
pub(crate) enum Force {
    /// As much all the time (N m or N); zero for a free one.
    Constant(f64),
    /// A curve whose positions are forces; after its end, as at its end.
    Along(Path),
}

impl Force {
    /// The force (N m or N) at a time of the run.
    pub(crate) fn at(&self, time: f64) -> f64 {
        match self {
            Self::Constant(force) => *force,
            Self::Along(path) => path.at(time).position,
        }
    }

    /// The force over a stretch without breaks inside: see [`Path::during`].
    pub(crate) fn during(&self, from: f64, to: f64) -> Self {
        match self {
            Self::Constant(_) => self.clone(),
            Self::Along(path) => Self::Along(path.during(from, to)),
        }
    }
}
