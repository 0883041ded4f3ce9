//! A whole walk.

mod band;
mod check;
mod feet;
mod laws;
mod numbers;
mod passes;
mod plan;
mod repeat;
mod schedule;
mod solve;
mod standing;
pub(crate) mod steps;

pub use plan::WalkPlan;
pub use schedule::FEET;
