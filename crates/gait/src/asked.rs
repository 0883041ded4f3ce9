//! A walk or a run as plain data: what sliders, keywords and JSON say, and the motion that it comes to.

mod field;
mod judge;
mod made;
mod options;
mod range;
mod request;
mod stages;

pub use made::{DEFAULT_RATE, Gait};
pub use options::{GaitKind, GaitOptions, PartOptions, Repeats, RunEndOptions, RunWalkOptions, StairOptions};
pub use stages::{Next, Staged, stages};
