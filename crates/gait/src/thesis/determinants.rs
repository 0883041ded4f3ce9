//! The thesis's key postures, closed and corrected: what three and five determinants of gait decide.
//!
//! Both models are planar. An angle of a segment is its *pitch*: positive where its lower end is behind its upper end, and
//! for feet and toes where the toes point down. Lengths are of any unit, as long as it is one. Nothing here knows a figure's
//! coordinates.

mod cycle;
pub mod five;
mod model;
mod posture;
mod proportions;
mod table;
pub mod three;
mod timing;

pub use crate::condition::{Condition, Infeasible, KeyParameter, Nearest};
pub use cycle::{Cycle, KeyPhase, PhaseRoot};
pub use model::{Determinants, KeySolution, TABLES, table};
pub use posture::{ArmAngles, Joints, KeyPosture, LegAngles, Pelvis, Root, TrunkAngles};
pub use proportions::Proportions;
pub(crate) use proportions::USUAL_HEIGHT;
pub use table::{Agreement, Cell, GaitTable};
pub use timing::{DoubleSupport, THESIS_WALK_RATIO, highest_step_frequency, thesis_step_length};
