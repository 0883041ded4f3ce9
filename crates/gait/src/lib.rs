#![doc = include_str!("../README.md")]

mod beside;
mod body;
pub mod determinants;
mod error;
mod foot;
mod grid;
mod journey;
mod judge;
mod keyed;
mod lacks;
mod laws;
mod leg;
mod legs;
mod map;
mod measure;
pub mod metrics;
mod momentum;
mod pace;
mod parameter;
mod parts;
mod passing;
pub mod people;
mod posture;
mod prescribed;
mod request;
mod route;
mod stance;
mod stick;
mod stride;
mod stride_loop;
mod style;
mod styled;
pub mod sweep;
mod swing;
mod thesis;
mod upper;
mod walk;
mod walker;

pub use beside::Beside;
pub use error::GaitError;
pub use journey::{Journey, LONGEST_STAND, Stage};
pub use judge::FRICTION;
pub use keyed::{InBetween, KeyScript, KeyedOptions, KeyedWalk, ScriptCycle};
pub use lacks::lacks;
pub use leg::LegGeometry;
pub use map::{Edge, FeasibleMap, MapCondition};
pub use measure::{
    Band, BandCheck, JointPeaks, LoneForce, Peak, RECIPE_BANDS, SteadyStride, TEXTBOOK_BANDS, WalkMeasures,
    check_bands, free_moment, lone_forces, measure, measure_stride,
};
pub use pace::DEFAULT_STEP_FREQUENCY;
pub use parameter::{PARAMETERS, Parameter, Unit};
pub use request::{
    CHANGING_STEPS, Extent, SHORTEST_DISTANCE, STEP_FREQUENCY, STEPS, TURN, TURN_IN_ALL, WalkPart,
    WalkRequest,
};
pub use stick::stick_figures;
pub use stride::{Resolution, StridePlan};
pub use stride_loop::{StrideLoop, Walking, on_the_spot};
pub use style::{Style, StyleTable, WALK_RATIO};
pub use styled::{StyledPlan, StyledRequest, WalkForces};
pub use thesis::{KeyChoice, THESIS_STEP_FREQUENCY, ThesisRequest, ThesisWalk, thesis_walk};
pub use walk::{FEET, WalkNumbers, WalkPlan};
pub use walker::walk;
