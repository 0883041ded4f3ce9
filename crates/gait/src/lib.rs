#![doc = include_str!("../README.md")]

mod body;
mod comparison;
mod condition;
mod error;
mod measure;
pub mod metrics;
pub mod people;
mod request;
mod smooth;
mod styled;
pub mod sweep;
mod thesis;
mod walking;

pub use body::{FEET, LegGeometry, missing_for_walking};
pub use comparison::Beside;
pub use error::GaitError;
pub use measure::{
    Band, BandCheck, JointPeaks, LoneForce, Peak, RECIPE_BANDS, SteadyStride, TEXTBOOK_BANDS, WalkMeasures,
    check_bands, free_moment, lone_forces, measure, measure_stride,
};
pub use request::{
    CHANGING_STEPS, DEFAULT_STEP_FREQUENCY, Extent, Resolution, SHORTEST_DISTANCE, STEP_FREQUENCY, STEPS,
    TURN, TURN_IN_ALL, WALK_RATIO, WalkPart, WalkRequest,
};
pub use smooth::{
    FRICTION, Journey, LONGEST_STAND, PARAMETERS, Parameter, Stage, StridePlan, Style, StyleTable, Unit,
    WalkNumbers, WalkPlan, walk,
};
pub use styled::{StyledPlan, StyledRequest, WalkForces};
pub use thesis::{
    Edge, FeasibleMap, InBetween, KeyChoice, KeyScript, KeyedOptions, KeyedWalk, MapCondition, ScriptCycle,
    THESIS_STEP_FREQUENCY, ThesisRequest, ThesisWalk, determinants, stick_figures, thesis_walk,
};
pub use walking::{StrideLoop, Walking, on_the_spot};
