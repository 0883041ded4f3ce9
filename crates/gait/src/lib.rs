//! Walking.
mod body;
mod error;
mod foot;
mod grid;
mod laws;
mod leg;
mod momentum;
mod posture;
mod prescribed;
mod stance;
mod stride;
mod style;
mod swing;

pub use error::GaitError;
pub use leg::LegGeometry;
pub use stride::{Resolution, StridePlan};
pub use style::{Style, WALK_RATIO};
mod walk;
pub use walk::WalkPlan;
