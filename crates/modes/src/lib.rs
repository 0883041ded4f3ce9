#![doc = include_str!("../README.md")]

mod balance;
mod body;
mod carrier;
mod complete;
mod contact;
mod drive;
mod element;
mod error;
pub mod ground;
mod hull;
mod impact;
mod inverse;
mod loads;
mod nearness;
mod passive;
mod phase;
mod range;
mod reaction;
mod recorded;
mod report;
mod rooted;
mod run;
mod settings;
mod simulation;
mod split;
pub mod study;
pub mod time;
mod trouble;

pub use balance::balance_momentum;
pub use complete::{CompleteError, Completed, Filter, complete};
pub use contact::{ContactLaw, GroundPlane, Touch, touches};
pub use drive::{Course, Drive, Law, Outcome, OutcomeKind, Shape, Step, Target, Until};
pub use element::{Anchor, LimitLaw, PointSpring};
pub use error::ReactionError;
pub use inverse::{DofLoad, InverseError, InverseOptions, InverseReport, Residual, inverse_motion};
pub use loads::{LoadError, Loads};
pub use nearness::{Near, Nearest, Nearness, NearnessError, nearness};
pub use passive::add_passive_forces;
pub use reaction::{ReactionReport, Support, SupportLaw, ground_reactions};
pub use recorded::Recorded;
pub use report::{
    Counts, Energy, EnergyReport, ErrorEstimate, GroundReport, Impact, Landing, LinkContact, PhaseReport,
    Remark, Run, RunReport, Watch,
};
pub use rooted::{RootReport, reactions_from_feet};
pub use settings::{Guard, Method, Rule, Settings};
pub use simulation::Simulation;
pub use split::{FootSupport, TotalWrench, split_at_pivot};
pub use trouble::{Cause, Remedy, RunError, SetupError, Trouble};
