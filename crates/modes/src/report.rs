//! The report of a run.

mod between;
mod contact;
mod cost;
mod energy;
mod outcome;
mod phase;

pub use between::{LinkCollision, LoopReport};
pub use contact::{ContactReport, Landing, LinkContact};
pub use cost::{Cost, Counts, ErrorEstimate};
pub use energy::{Energy, EnergyReport};
pub use outcome::{Impact, Outcome, OutcomeKind};
pub use phase::PhaseReport;

use crate::failure::{RunError, RunFailure};
use solaris_model::Motion;
use std::fmt;

/// A run: its motion, and what there is to say of it.
#[derive(Clone, Debug)]
pub struct Run {
    /// The motion, in frames.
    pub motion: Motion,
    /// How it was found, and how far it can be trusted.
    pub report: RunReport,
}

/// How a run was found, and how far it can be trusted.
///
/// With the feature `serde` its keys are `method`, `why`, `error`, `cost`, `energy`, `drives`, `impacts`, `phases`, and where there
/// are any `contact`, `collisions`, `loops` and `remarks` (sentences).
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RunReport {
    /// The method, with its step or tolerance.
    pub method: String,
    /// Why this one.
    pub why: String,
    /// How far off it may be, where that was asked.
    pub error: Option<ErrorEstimate>,
    /// What it took.
    pub cost: Cost,
    /// Where the energy went.
    pub energy: EnergyReport,
    /// How each drive ended, in the order of time.
    #[cfg_attr(feature = "serde", serde(rename = "drives"))]
    pub outcomes: Vec<Outcome>,
    /// Every impact, in the order of time.
    pub impacts: Vec<Impact>,
    /// What was computed and what was left out, one entry for each time that this changed.
    pub phases: Vec<PhaseReport>,
    /// What the ground did, where there is one.
    #[cfg_attr(feature = "serde", serde(rename = "contact", skip_serializing_if = "Option::is_none"))]
    pub ground: Option<ContactReport>,
    /// The links that touched each other, in the order of the figure.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
    pub collisions: Vec<LinkCollision>,
    /// How each loop was held.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
    pub loops: Vec<LoopReport>,
    /// What is worth knowing though nothing failed.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
    pub remarks: Vec<Remark>,
}

/// What is worth knowing about a run though nothing failed.
///
/// With the feature `serde` it is its sentence.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Remark {
    /// A stiff method, behind this crate's feature `stiff`, would take fewer evaluations.
    StiffNotBuiltIn {
        /// The stiffest eigenvalue (1/s).
        eigenvalue: f64,
    },
    /// A stiff method was tried and did not come to the end.
    StiffFailed(Box<RunError>),
    /// On rigid ground, forces that keep what stands came to no end: steps are by impulses, of order one.
    ImpulsesInstead {
        /// What positions should have been off by (rad or m).
        tolerance: f64,
        /// How the run by forces ended.
        failure: Box<RunFailure>,
    },
    /// The run could not be compared with another.
    NoEstimate,
    /// What whoever made the simulation has to say of it.
    Said(String),
    /// The energy does not balance.
    Energy {
        /// The part of the energy at play that came from nowhere or is gone.
        share: f64,
    },
    /// A degree of freedom starts outside of a hard limit.
    OutsideLimits {
        /// Its name.
        dof: String,
        /// By how much (rad or m).
        by: f64,
    },
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StiffNotBuiltIn { eigenvalue } => write!(
                f,
                "the equations are stiff ({eigenvalue:.3e} 1/s): a stiff method, which is not built in, would take fewer \
                 evaluations"
            ),
            Self::StiffFailed(error) => write!(f, "the stiff method did not come to the end: {error}"),
            Self::ImpulsesInstead { tolerance, failure } => write!(
                f,
                "forces that keep what stands on rigid ground, within {tolerance:e}, came to no end at t = {:.4} s ({}): steps are by \
                 impulses, which are of order one; name a method to have it otherwise",
                failure.time, failure.cause
            ),
            Self::NoEstimate => {
                f.write_str("no other step or tolerance came to the end: there is no error estimate")
            }
            Self::Said(what) => f.write_str(what),
            Self::Energy { share } => write!(
                f,
                "{:.2} % of the energy at play came from nowhere or is gone: a shorter step or a smaller tolerance tells whether the \
                 motion can be trusted",
                100.0 * share
            ),
            Self::OutsideLimits { dof, by } => write!(
                f,
                "{dof} starts {by:.4} (rad or m) outside of its limits: they hold it once it has come inside"
            ),
        }
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Remark {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// Where a run is. It goes through all of its time once for its motion, and once more where an error is estimated; the automatic method
/// does so until two passes agree, and how many these will be is not known before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunPass<'a> {
    /// Which pass, from 1.
    pub number: usize,
    /// The method that it tries, in words.
    pub method: &'a str,
    /// How far it has come (s).
    pub time: f64,
    /// How far it will go (s).
    pub duration: f64,
}

/// Receives progress, keeps the clock and may cancel a run. Nothing below the command line has a clock of its own.
#[doc(alias = "watch")]
#[doc(alias = "callback")]
#[doc(alias = "progress")]
pub trait Observer {
    /// Seconds since some instant.
    fn now(&self) -> Option<f64> {
        None
    }

    /// Called now and then with the share of the work that is done, 0 to 1; by the automatic method nobody knows it, and it is not called.
    fn progress(&mut self, share: f64) {
        let _ = share;
    }

    /// Called now and then, whatever the method, with the pass that a run is in and how far that has come.
    fn pass(&mut self, pass: &RunPass<'_>) {
        let _ = pass;
    }

    /// Whether to stop.
    fn is_cancelled(&self) -> bool {
        false
    }
}

/// No observer.
impl Observer for () {}
