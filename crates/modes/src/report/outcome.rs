//! How drives ended, and what was hit on the way.

use solaris_model::AxisKind;

/// How a drive ended.
///
/// With the feature `serde` its keys are `dof` (the name), `drive`, `start_s`, `end_s`, `result`, `position`, `velocity`, `missed_by`
/// and `acceleration`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Outcome {
    /// The degree of freedom, as an index in `v`.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub dof: usize,
    /// Its name.
    #[cfg_attr(feature = "serde", serde(rename = "dof"))]
    pub name: String,
    /// Whether it turns or slides.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub axis_kind: AxisKind,
    /// Whether it has a position: the velocities of ball and free joints are the rates of no coordinate.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub has_position: bool,
    /// What drove it: `target-angle`, `intensive, cubic`, …
    pub drive: &'static str,
    /// When it began (s).
    #[cfg_attr(feature = "serde", serde(rename = "start_s"))]
    pub start: f64,
    /// When it ended (s).
    #[cfg_attr(feature = "serde", serde(rename = "end_s"))]
    pub end: f64,
    /// What came of it.
    pub result: OutcomeKind,
    /// Position at the end (rad or m); zero where there is none.
    pub position: f64,
    /// Velocity at the end (rad/s or m/s).
    pub velocity: f64,
    /// By how much the target was missed (rad or m), where that is what came of it.
    pub missed_by: Option<f64>,
    /// The acceleration that the analysis of simple mode gave (rad/s² or m/s²).
    pub acceleration: Option<f64>,
}

/// What came of a drive.
///
/// With the feature `serde` it is its [name](Self::name).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum OutcomeKind {
    /// At the target, with its velocity.
    Reached,
    /// At the target, with another velocity than its own.
    ReachedWithVelocity,
    /// The analysis gave no acceleration.
    NoMotion,
    /// The acceleration points away from the target.
    WrongSign,
    /// The degree of freedom turns round before the target.
    Unreachable,
    /// The course goes from rest to rest, and the degree of freedom was moving.
    NeedsRest,
    /// Not at the target, because the force was at its limit.
    LimitedByTorque,
    /// Not at the target at the end of the time; [`Outcome::missed_by`] says by how much.
    Missed,
    /// A limit of the joint was hit.
    LimitHit,
    /// Ended; there was no target.
    Ended,
    /// The next drive took over before the end.
    Interrupted,
    /// The run ended first.
    Unfinished,
    /// The run ended before it began.
    NotBegun,
}

impl OutcomeKind {
    /// What it is called.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Reached => "reached",
            Self::ReachedWithVelocity => "reached with velocity",
            Self::NoMotion => "no motion",
            Self::WrongSign => "wrong sign",
            Self::Unreachable => "unreachable",
            Self::NeedsRest => "needs rest",
            Self::LimitedByTorque => "limited by torque",
            Self::Missed => "missed",
            Self::LimitHit => "limit hit",
            Self::Ended => "ended",
            Self::Interrupted => "interrupted",
            Self::Unfinished => "unfinished",
            Self::NotBegun => "not begun",
        }
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for OutcomeKind {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// A jump of the velocities.
///
/// With the feature `serde` its keys are `time_s`, `dof` (the name), `what`, `velocity_before`, `velocity_after`, `impulse` and `loss_j`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Impact {
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "time_s"))]
    pub time: f64,
    /// The degree of freedom that caused it, as an index in `v`.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub dof: usize,
    /// Its name.
    #[cfg_attr(feature = "serde", serde(rename = "dof"))]
    pub name: String,
    /// Whether it turns or slides.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub axis_kind: AxisKind,
    /// What happened: `limit`, `stop`.
    pub what: &'static str,
    /// Its velocity before (rad/s or m/s).
    pub velocity_before: f64,
    /// Its velocity after (rad/s or m/s).
    pub velocity_after: f64,
    /// The impulse on it (N m s or N s).
    pub impulse: f64,
    /// The kinetic energy that this impulse took (J).
    #[cfg_attr(feature = "serde", serde(rename = "loss_j"))]
    pub loss: f64,
}
