#![doc = include_str!("../README.md")]

mod between;
mod body;
mod carry;
mod collision;
mod contact;
mod convex;
mod drive;
mod element;
mod failure;
mod hanging;
mod impact;
mod phase;
mod push;
mod range;
mod recorded;
mod report;
mod run;
mod running;
mod sequence;
mod settings;
mod simulation;
mod stand;
pub mod study;
pub mod time;

pub use carry::Carry;
pub use collision::Collisions;
pub use contact::{ContactLaw, ContactPoint, GroundPlane, contact_points};
pub use drive::{Aim, Course, Drive, EndCondition, Law, Servo, Shape, Step, Target};
pub use element::{Anchor, LimitLaw, Loop, LoopKind, PointSpring};
pub use failure::{FailureKind, Remedy, RunError, RunFailure, SetupError};
pub use hanging::Hanging;
pub use push::{Push, PushLaw};
pub use recorded::RecordedMotion;
pub use report::{
    ContactReport, Cost, Counts, Energy, EnergyReport, ErrorEstimate, Impact, Landing, LinkCollision,
    LinkContact, LoopReport, Observer, Outcome, OutcomeKind, PhaseReport, Remark, Run, RunPass, RunReport,
};
pub use run::{Acting, Touching};
pub use running::{Happened, Running};
pub use sequence::Part;
pub use settings::{Guard, Method, Rule, Settings};
pub use simulation::Simulation;
