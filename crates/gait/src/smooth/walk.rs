//! A whole walk: its course and tempo, its laws, the passes that solve it, and the plan that comes of them.

mod cane;
mod check;
mod course;
mod edges;
mod excerpt;
mod feet;
mod footholds;
mod gaits;
mod grounded;
mod heights;
mod laws;
mod numbers;
mod passes;
mod plan;
mod repeat;
mod schedule;
mod solve;
mod standing;
pub(crate) mod steps;
mod tempo;
mod terrain;
mod timeline;

pub(crate) use check::LegsCheck;
pub(crate) use course::Step;
pub(crate) use excerpt::Excerpt;
pub(crate) use grounded::Grounded;
pub use numbers::WalkNumbers;
pub use plan::WalkPlan;
pub(crate) use standing::Standing;
pub(crate) use steps::Steps;
pub(crate) use terrain::{Easing, LEAD, StepKind, Terrain, Way};
