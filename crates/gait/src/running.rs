//! Running: forces first as in the smooth walk, but all of them, and a trunk that turns as the angular momentum asks.
//!
//! In flight nothing carries the body: its centre of mass falls and its angular momentum stays. So no part of the force can be left
//! to follow from the rest, as it is in a walk; it is the trunk's three angles that follow.

mod chain;
mod circulant;
mod extremes;
mod forces;
mod laws;
mod legs;
mod open;
mod plan;
mod prints;
mod runner;
mod stride;
mod style;
mod tempo;
mod trunk;
mod walk_side;

pub use extremes::RunExtremes;
pub use plan::RunPlan;
pub(crate) use runner::judged as judged_run;
pub use runner::{RUN_FRICTION, run};
pub use stride::RunStride;
pub use style::RunStyle;
pub use tempo::least_run_steps;
