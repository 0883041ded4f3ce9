#![doc = include_str!("../README.md")]

mod body;
mod contact;
mod drive;
mod element;
mod impact;
mod phase;
mod range;
mod recorded;
mod report;
mod run;
mod settings;
mod simulation;
pub mod study;
pub mod time;
mod trouble;

pub use contact::{ContactLaw, GroundPlane, Touch, touches};
pub use drive::{Course, Drive, Law, Outcome, OutcomeKind, Shape, Step, Target, Until};
pub use element::{Anchor, LimitLaw, PointSpring};
pub use recorded::Recorded;
pub use report::{
    Counts, Energy, EnergyReport, ErrorEstimate, GroundReport, Impact, Landing, LinkContact, PhaseReport,
    Remark, Run, RunReport, Watch,
};
pub use settings::{Guard, Method, Rule, Settings};
pub use simulation::Simulation;
pub use trouble::{Cause, Remedy, RunError, SetupError, Trouble};
