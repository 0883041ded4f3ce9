//! Running: forces first as in the smooth walk, but all of them, and a trunk that turns as the angular momentum asks.
//!
//! In flight nothing carries the body: its centre of mass falls and its angular momentum stays. So no part of the force can be left
//! to follow from the rest, as it is in a walk; it is the trunk's three angles that follow.

mod circulant;
mod forces;
mod laws;
mod legs;
mod plan;
mod prints;
mod runner;
mod stride;
mod style;
mod trunk;

pub use plan::RunPlan;
pub use runner::{RUN_FRICTION, run};
pub use stride::{RunExtremes, RunStride};
pub use style::RunStyle;
