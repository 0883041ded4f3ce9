#![doc = include_str!("../README.md")]
//!
//! # Inside
//!
//! Each folder uses those before it alone, and of two modules in a folder one at most uses the other (`tests/gait/layers.rs`
//! reads the line below and the sources):
//!
//! ```text
//! condition < error < body < request < walking < measure < metrics < thesis < grid < limbs < momentum < smooth < chair < running < live < comparison < styled < asked < people < sweep < crowd < set
//! ```
//!
//! - `condition`, `error`: what a posture asks of its parameters; what can go wrong, one enum a concern.
//! - `body`: the figure by roles, its legs and feet, postures as coordinates. `request`: what may be asked. `walking`: what every
//!   walk is, whoever plans it.
//! - `measure`, `metrics`: numbers of a finished walk of ours, and of any motion of any figure with feet.
//! - `thesis`: key postures of three and five determinants, walks through them, tables, maps, stick figures.
//! - `smooth`: the smooth walker, from laws and closed-form legs over one stride to whole walks and sequences of them.
//! - `chair`: standing up from a seat and sitting down.
//! - `live`: a walker that is steered while it walks.
//! - `asked`: a walk or a run as plain data.
//! - `comparison`, `styled`, `people`, `sweep`, `crowd`, `set`: what needs both walkers or all of this.

mod asked;
mod body;
mod chair;
mod comparison;
mod condition;
pub mod crowd;
mod error;
mod grid;
mod limbs;
mod live;
mod measure;
pub mod metrics;
mod momentum;
pub mod people;
mod request;
mod running;
pub mod set;
mod smooth;
mod styled;
pub mod sweep;
mod thesis;
mod walking;

pub use asked::{
    DEFAULT_RATE, Gait, GaitKind, GaitOptions, Next, PartOptions, Repeats, RunEndOptions, RunWalkOptions,
    Staged, StairOptions, stages,
};
pub use body::{CANE, FEET, LegGeometry, helped_side, missing_for_walking};
pub use chair::{ChairPlan, chair};
pub use comparison::PostureComparison;
pub use error::{
    BodyError, GaitError, LiveError, MapError, MeasureError, PlanError, PostureError, RequestError,
};
pub use live::{Bent, Command, Walker};
pub use measure::{
    Band, BandCheck, BandReport, BeyondRange, ChairMeasures, IsolatedPeak, JointPeaks, JointRange, Peak,
    RECIPE_BANDS, RUN_BANDS, RunBand, SteadyRun, SteadyStride, TEXTBOOK_BANDS, WalkExtremes, WalkMeasures,
    band_reports, check_bands, free_moment, isolated_peaks, measure, measure_chair, measure_run,
    measure_stride, run_bands,
};
pub use request::{
    CANE_LOAD, CANE_LOADS, CHAIR_TIMES, CHANGING_RUN_STEPS, CHANGING_STEPS, ChairMotion, ChairRequest,
    Change, DEFAULT_RUN_SPEED, DEFAULT_STEP_FREQUENCY, Extent, FOREFOOT_SPEED, Foothold, MOST_VARIABILITY,
    Population, RUN_SPEED, Resolution, RunEnd, RunPart, RunRequest, RunResolution, RunWalk,
    SHORTEST_DISTANCE, SOLE_GIVE, STAIR_COUNT, STEP_FREQUENCY, STEPS, Stairs, StyleSheet, TURN, TURN_IN_ALL,
    Variability, WALK_RATIO, WalkGround, WalkPart, WalkPath, WalkRequest,
};
pub use running::{RUN_FRICTION, RunExtremes, RunPlan, RunStride, RunStyle, least_run_steps, run};
pub use smooth::{
    FRICTION, Footfall, LONGEST_STAND, MANNERS, Manner, PARAMETERS, Parameter, PelvicList, SHEET_NUMBERS,
    SIDE_MANNERS, SLOPES, STAIRS, SheetNumber, SheetUnit, ShippedManner, StairNumbers, StridePlan, Style,
    StyleTable, Toes, Unit, WalkNumbers, WalkPlan, WalkSegment, WalkSequence, manner, read_sheet, sheet_of,
    side_sheet_of, step_length_on_slope, walk, walk_in_part,
};
pub use styled::{Pull, StyledPlan, StyledRequest, WalkForces};
pub use thesis::{
    Edge, FeasibleMap, InBetween, KeyChoice, KeyScript, KeyframedOptions, KeyframedWalk, MapCondition,
    ScriptCycle, THESIS_STEP_FREQUENCY, ThesisRequest, ThesisWalk, determinants, stick_figures, thesis_walk,
};
pub use walking::{Prescribing, StrideLoop, Walking, on_the_spot};
