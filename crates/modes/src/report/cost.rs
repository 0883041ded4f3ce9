//! What a run took, and how far off it may be.

/// What a run took.
///
/// With the feature `serde` its keys are those of [`Counts`], and `seconds`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Cost {
    /// What was computed.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub counts: Counts,
    /// How long it took (s), where the caller has a clock; all runs that it took together.
    pub seconds: Option<f64>,
}

/// What was computed in a run.
///
/// With the feature `serde` its keys are `evaluations`, `jacobians`, `steps`, `rejected_steps` and `events`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Counts {
    /// Evaluations of the dynamics, those inside of Jacobians not counted.
    pub evaluations: u64,
    /// Jacobians.
    pub jacobians: u64,
    /// Steps that were taken.
    pub steps: u64,
    /// Steps that were tried and rejected.
    #[cfg_attr(feature = "serde", serde(rename = "rejected_steps"))]
    pub rejected: u64,
    /// Events that were located.
    pub events: u64,
}

impl Counts {
    /// Adds what another stretch took.
    pub fn add(&mut self, other: &Self) {
        self.evaluations += other.evaluations;
        self.jacobians += other.jacobians;
        self.steps += other.steps;
        self.rejected += other.rejected;
        self.events += other.events;
    }
}

/// How far a run may be off, at most, over all frames.
///
/// With the feature `serde` its keys are `position` and `velocity`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ErrorEstimate {
    /// Positions (rad or m).
    pub position: f64,
    /// Velocities (rad/s or m/s).
    pub velocity: f64,
}
