//! Standing up from a seat and sitting down.
//!
//! Feet stand flat before the seat. While it bears, the trunk leans forward; once the pressure has come to the feet the hips rise. How trunk and hips go
//! is of the least jerk that keeps the feet pressed where people's are, and within the joints' ranges. All forces are those of the motion: nothing is
//! left at the root. Sitting down is the same backward in time, which has the same forces.

mod fit;
mod forces;
mod laws;
mod plan;
mod sitter;

pub use plan::{ChairPlan, chair};
