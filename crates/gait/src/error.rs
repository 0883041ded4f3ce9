//! Errors, one enum a concern: the figure, the request, the plan, the postures, the map, the measuring.

mod body;
mod live;
mod map;
mod measure;
mod plan;
mod posture;
mod request;

pub use body::BodyError;
pub use live::LiveError;
pub use map::MapError;
pub use measure::MeasureError;
pub use plan::PlanError;
pub use posture::PostureError;
pub use request::RequestError;

use solaris_analysis::ReactionError;
use solaris_analysis::ground::PlantedError;
use solaris_dynamics::DynamicsError;
use solaris_model::MotionError;
use solaris_profiles::ProfileError;

/// Why a figure cannot walk as asked, or its walk cannot be measured: any of the concerns, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs, reason = "each message says what its fields are")]
pub enum GaitError {
    #[error(transparent)]
    Body(#[from] BodyError),
    #[error(transparent)]
    Request(#[from] RequestError),
    #[error(transparent)]
    Live(#[from] LiveError),
    #[error(transparent)]
    Plan(#[from] PlanError),
    #[error(transparent)]
    Posture(#[from] PostureError),
    #[error(transparent)]
    Map(#[from] MapError),
    #[error(transparent)]
    Measure(#[from] MeasureError),
    #[error("segment {number} of the sequence: {why}")]
    InSegment { number: usize, why: Box<GaitError> },
    #[error("part {number} of the walk: {why}")]
    InPart { number: usize, why: Box<GaitError> },
    #[error("of the walk {} the run: {why}", if *before { "before" } else { "after" })]
    BesideRun { before: bool, why: Box<GaitError> },
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
    #[error(transparent)]
    Planted(#[from] PlantedError),
    #[error(transparent)]
    Motion(#[from] MotionError),
    #[error(transparent)]
    Reaction(#[from] ReactionError),
    #[error("the walk does not close: {0}; this is a fault of the planner")]
    Profile(#[from] ProfileError),
}

impl GaitError {
    /// Whether the figure would have to turn farther than its root can: [`RequestError::TurnInAll`], wherever it is.
    pub fn turns_too_far(&self) -> bool {
        match self {
            Self::Request(RequestError::TurnInAll { .. }) => true,
            Self::InSegment { why, .. } | Self::InPart { why, .. } | Self::BesideRun { why, .. } => {
                why.turns_too_far()
            }
            _ => false,
        }
    }
}
