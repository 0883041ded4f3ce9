//! Requests: how far to walk or run, at which pace, planned how finely.

pub(crate) mod chair;
mod ground;
pub(crate) mod pace;
pub(crate) mod path;
pub(crate) mod population;
mod resolution;
pub(crate) mod run;
pub(crate) mod sheet;
pub(crate) mod variability;
mod walk;

pub use chair::{CHAIR_TIMES, ChairMotion, ChairRequest};
pub use ground::{Foothold, STAIR_COUNT, Stairs, WalkGround};
pub use pace::{DEFAULT_STEP_FREQUENCY, STEP_FREQUENCY, WALK_RATIO};
pub use path::WalkPath;
pub use population::Population;
pub use resolution::Resolution;
pub use run::{
    CHANGING_RUN_STEPS, DEFAULT_RUN_SPEED, FOREFOOT_SPEED, RUN_SPEED, RunEnd, RunPart, RunRequest,
    RunResolution, RunWalk, SOLE_GIVE,
};
pub use sheet::{Change, StyleSheet};
pub use variability::{MOST_VARIABILITY, Variability};
pub(crate) use walk::check_turned;
pub use walk::{
    CANE_LOAD, CANE_LOADS, CHANGING_STEPS, Extent, SHORTEST_DISTANCE, STEPS, TURN, TURN_IN_ALL, WalkPart,
    WalkRequest,
};
