//! A whole walk.

mod band;
mod feet;
mod laws;
mod numbers;
mod plan;
mod solve;
mod standing;
pub(crate) mod steps;

pub use plan::WalkPlan;
