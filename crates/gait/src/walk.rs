//! A whole walk.

mod band;
mod check;
mod course;
mod feet;
mod gaits;
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

pub(crate) use course::Step;
pub(crate) use plan::Steps;
pub use plan::WalkPlan;
pub use schedule::FEET;
pub(crate) use schedule::sampled;
