//! The smooth walker: forces first, as people walk, and legs that follow.

mod band;
mod footfall;
mod laid;
mod laws;
mod legs;
mod manner;
mod options;
mod parameter;
mod plan_check;
mod prescribed;
mod route;
mod sequence;
mod sheet_numbers;
mod sheet_text;
mod slope;
mod stairs;
mod stride;
mod style;
mod styling;
mod terrain;
mod walk;
mod walker;

pub use crate::limbs::swing::Toes;
pub use footfall::Footfall;
pub use manner::Manner;
pub use parameter::{PARAMETERS, Parameter, Unit};
pub use plan_check::FRICTION;
pub use sequence::{LONGEST_STAND, WalkSegment, WalkSequence};
pub use sheet_numbers::{SHEET_NUMBERS, SheetNumber, SheetUnit};
pub use sheet_text::{MANNERS, SIDE_MANNERS, ShippedManner, manner, read_sheet, sheet_of, side_sheet_of};
pub use slope::{SLOPES, step_length_on_slope};
pub use stairs::{STAIRS, StairNumbers};
pub use stride::StridePlan;
pub use style::{Style, StyleTable};
pub use walk::{WalkNumbers, WalkPlan};
pub use walker::{walk, walk_in_part};
