//! The report of a run.

use crate::drive::Outcome;
use crate::failure::RunError;
use solaris_dynamics::scalar::Operations;
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
#[derive(Clone, Debug, Default)]
pub struct RunReport {
    /// The method, with its step or tolerance.
    pub method: String,
    /// Why this one.
    pub why: String,
    /// What it took.
    pub counts: Counts,
    /// How long it took (s), where the caller has a clock; all runs that it took together.
    pub seconds: Option<f64>,
    /// How far off it may be, where that was asked.
    pub error: Option<ErrorEstimate>,
    /// Where the energy went.
    pub energy: EnergyReport,
    /// How each drive ended, in the order of time.
    pub outcomes: Vec<Outcome>,
    /// Every impact, in the order of time.
    pub impacts: Vec<Impact>,
    /// What the ground did, where there is one.
    pub ground: Option<ContactReport>,
    /// What was computed and what was left out, one entry for each time that this changed.
    pub phases: Vec<PhaseReport>,
    /// What is worth knowing though nothing failed.
    pub remarks: Vec<Remark>,
}

/// What is worth knowing about a run though nothing failed.
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
    /// The run could not be compared with another.
    NoEstimate,
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
            Self::NoEstimate => {
                f.write_str("no other step or tolerance came to the end: there is no error estimate")
            }
            Self::OutsideLimits { dof, by } => write!(
                f,
                "{dof} starts {by:.4} (rad or m) outside of its limits: they hold it once it has come inside"
            ),
        }
    }
}

/// What the ground did, as far as dynamics computed what touches it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactReport {
    /// The impulse of the ground along the world's axes (N s). With it `impulse + m·g·T` is the change of momentum where dynamics
    /// move the whole figure.
    pub impulse: [f64; 3],
    /// What its damping has taken (J); part of [`EnergyReport::heat`].
    pub damping: f64,
    /// What its friction has taken (J); part of [`EnergyReport::heat`].
    pub friction: f64,
    /// Every link that touches the ground in a frame, in the order of the figure.
    pub links: Vec<LinkContact>,
    /// Whether the ground [plants](crate::ContactLaw::Rigid) what touches it.
    pub planted: bool,
    /// What came down on a ground that [plants](crate::ContactLaw::Rigid) what touches it, in the order of time.
    pub landings: Vec<Landing>,
}

/// Something came down on the ground and stayed there: velocities jumped.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Landing {
    /// When (s).
    pub time: f64,
    /// The links that came down.
    pub links: Vec<String>,
    /// The impulse of the ground on all that stands on it, along the world's axes (N s); part of [`ContactReport::impulse`].
    pub impulse: [f64; 3],
    /// The kinetic energy that was lost (J); part of [`EnergyReport::impacts`]. Drives that keep their motion do work on it: it can be
    /// negative.
    pub loss: f64,
}

impl ContactReport {
    /// The link that went deepest.
    pub fn deepest(&self) -> Option<&LinkContact> {
        self.links.iter().max_by(|a, b| a.depth.total_cmp(&b.depth))
    }

    /// The link that slid fastest.
    pub fn fastest(&self) -> Option<&LinkContact> {
        self.links.iter().max_by(|a, b| a.slip.total_cmp(&b.slip))
    }

    /// The link that took the most friction.
    pub fn roughest(&self) -> Option<&LinkContact> {
        self.links.iter().max_by(|a, b| a.friction.total_cmp(&b.friction))
    }

    /// The link that slid farthest.
    pub fn farthest(&self) -> Option<&LinkContact> {
        self.links.iter().max_by(|a, b| a.slid.total_cmp(&b.slid))
    }
}

/// How one link touched the ground, as the frames show it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinkContact {
    /// Its name.
    pub link: String,
    /// How long it touched (s).
    pub touching: f64,
    /// How deep it was, at most (m).
    pub depth: f64,
    /// When (s).
    pub depth_time: f64,
    /// How fast its material slid along the ground, at most, at a touch that was pressed (m/s).
    pub slip: f64,
    /// When (s).
    pub slip_time: f64,
    /// The friction that it took, at most: the ratio of the force along the ground to that out of it.
    pub friction: f64,
    /// When (s).
    pub friction_time: f64,
    /// How long it took more than the ground's coefficient of friction (s): it ought to have slipped.
    pub slipping: f64,
    /// How far it slid while it touched (m): the mean of its contact points, each with the weight of its pressure, added up over the time.
    pub slid: f64,
}

/// What a run took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Evaluations of the dynamics, those inside of Jacobians not counted.
    pub evaluations: u64,
    /// Jacobians.
    pub jacobians: u64,
    /// Steps that were taken.
    pub steps: u64,
    /// Steps that were tried and rejected.
    pub rejected: u64,
    /// Events that were located.
    pub events: u64,
}

impl Counts {
    /// Adds what another stretch took.
    pub fn add(&mut self, other: &Self) {
        self.evaluations += other.evaluations;
        self.jacobians += other.jacobians;
        self.steps += other.steps;
        self.rejected += other.rejected;
        self.events += other.events;
    }
}

/// How far a run may be off, at most, over all frames.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ErrorEstimate {
    /// Positions (rad or m).
    pub position: f64,
    /// Velocities (rad/s or m/s).
    pub velocity: f64,
}

/// Energy of the part of the figure whose motion is computed (J).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Of motion.
    pub kinetic: f64,
    /// In gravity.
    pub potential: f64,
    /// In springs.
    pub elastic: f64,
}

impl Energy {
    /// All of it.
    pub fn total(&self) -> f64 {
        self.kinetic + self.potential + self.elastic
    }
}

/// Where the energy of a run went (J), as far as dynamics computed it:
///
/// ```text
/// end = start + work − heat − impacts + moved
/// ```
///
/// but for the imbalance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnergyReport {
    /// At the beginning.
    pub start: Energy,
    /// At the end.
    pub end: Energy,
    /// What the drives have done.
    pub work: f64,
    /// What dampers and friction have taken.
    pub heat: f64,
    /// What impacts have taken.
    pub impacts: f64,
    /// What came with links that were computed from then on, less what went with those that were not any more.
    pub moved: f64,
    /// The greatest difference between the energy that there was and the energy that there should have been.
    pub imbalance: f64,
    /// The energy at play: the greatest of what was exchanged, so that `imbalance/scale` says how bad it is.
    pub scale: f64,
}

/// A jump of the velocities.
#[derive(Clone, Debug, PartialEq)]
pub struct Impact {
    /// When (s).
    pub time: f64,
    /// The degree of freedom that caused it.
    pub dof: usize,
    /// What happened: `limit`, `stop`.
    pub what: &'static str,
    /// Its velocity before and after (rad/s or m/s).
    pub velocity: (f64, f64),
    /// The impulse on it (N m s or N s).
    pub impulse: f64,
    /// The kinetic energy that this impulse took (J).
    pub loss: f64,
}

/// What was computed during a stretch of time, and what was left out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PhaseReport {
    /// From when (s).
    pub start: f64,
    /// Until when (s).
    pub end: f64,
    /// Degrees of freedom that dynamics move.
    pub dynamic: Vec<String>,
    /// Degrees of freedom on prescribed motions that the dynamics have to know.
    pub prescribed: Vec<String>,
    /// Degrees of freedom that stand still and were fused away.
    pub fused: Vec<String>,
    /// Links whose prescribed motion nothing that is computed depends on.
    pub dropped: Vec<String>,
    /// Operations of one evaluation: of the whole figure, and of what is left.
    pub cost: (Operations, Operations),
    /// What was left out besides: `contact: the scene has none`, …
    pub omitted: Vec<String>,
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

    /// Called now and then with the share of the work that is done, 0 to 1.
    fn progress(&mut self, share: f64) {
        let _ = share;
    }

    /// Whether to stop.
    fn is_cancelled(&self) -> bool {
        false
    }
}

/// No observer.
impl Observer for () {}
