#![doc = include_str!("../README.md")]

mod body;
pub mod determinants;
mod error;
mod foot;
mod grid;
mod lacks;
mod laws;
mod leg;
mod legs;
mod measure;
pub mod metrics;
mod momentum;
mod parameter;
mod parts;
mod posture;
mod prescribed;
mod stance;
mod stride;
mod style;
pub mod sweep;
mod swing;
mod upper;
mod walk;
mod walker;

pub use error::GaitError;
pub use lacks::lacks;
pub use leg::LegGeometry;
pub use measure::{
    Band, BandCheck, JointPeaks, Peak, RECIPE_BANDS, SteadyStride, TEXTBOOK_BANDS, WalkMeasures, check_bands,
    measure,
};
pub use parameter::{PARAMETERS, Parameter, Unit};
pub use stride::{Resolution, StridePlan};
pub use style::{Style, WALK_RATIO};
pub use walk::{FEET, WalkPlan};
pub use walker::{
    DEFAULT_STEP_FREQUENCY, Extent, FRICTION, SHORTEST_DISTANCE, STEP_FREQUENCY, STEPS, WalkRequest, walk,
};
