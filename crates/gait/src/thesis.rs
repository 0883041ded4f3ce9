//! The thesis's way of walking: key postures from three or five determinants of gait, and profiles between them.

pub mod determinants;
mod keyframed;
mod map;
mod stick;
mod walk;

pub use keyframed::{InBetween, KeyScript, KeyframedOptions, KeyframedWalk, ScriptCycle};
pub use map::{Edge, FeasibleMap, MapCondition};
pub use stick::stick_figures;
pub(crate) use walk::planned as thesis_judged;
pub use walk::{KeyChoice, THESIS_STEP_FREQUENCY, ThesisRequest, ThesisWalk, thesis_walk};
