//! The smooth walker: forces first, as people walk, and legs that follow.

mod band;
mod laws;
mod legs;
mod manner;
mod options;
mod parameter;
mod plan_check;
mod prescribed;
mod route;
mod sequence;
mod stride;
mod style;
mod walk;
mod walker;

pub use crate::limbs::swing::Toes;
pub use manner::Manner;
pub use parameter::{PARAMETERS, Parameter, Unit};
pub use plan_check::FRICTION;
pub use sequence::{LONGEST_STAND, WalkSegment, WalkSequence};
pub use stride::StridePlan;
pub use style::{Style, StyleTable};
pub use walk::{WalkNumbers, WalkPlan};
pub use walker::walk;
