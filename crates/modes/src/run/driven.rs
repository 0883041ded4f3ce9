//! The state of the drive of one degree of freedom.

use crate::drive::force::Force;
use crate::drive::path::Path;
use crate::drive::tracking::Tracker;
use crate::drive::{Drive, EndCondition, Step};
use crate::phase::Role;

pub(crate) use crate::impact::Side;

/// What a drive comes down to while it lasts.
#[derive(Clone)]
pub(crate) enum Mode {
    /// It stands still.
    Still,
    /// It has a motion of its own.
    Path(Path),
    /// A force acts, and dynamics move it.
    Force(Force),
    /// A force that is found anew each frame, and the one of this frame (N m or N).
    Track(Box<Tracker>, f64),
}

/// What an event means.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Meaning {
    /// The drive of a degree of freedom gives way.
    DriveEnds(usize),
    /// A degree of freedom passes its lower or upper limit.
    Limit(usize, Side),
    /// A limit lets go.
    Release(usize, Side),
    /// A force changes its law.
    Kink,
    /// What the part of a sequence that goes on waits for has come.
    StageEnds,
    /// The push of a limit's spring and damper passes zero: it lets go, or pushes again.
    Push(usize),
    /// Something that can touch the ground does, by its index.
    Touch(usize),
    /// A lever of a contact patch gives way, by their indices.
    Pull(usize, usize),
}

/// What drives one degree of freedom at the moment.
#[derive(Clone)]
#[allow(clippy::struct_excessive_bools, reason = "each is a fact of its own")]
pub(crate) struct Driven {
    /// Place of the drive in the sequence; beyond its end the degree of freedom stands still.
    pub(crate) step: usize,
    /// When it began (s).
    pub(crate) start: f64,
    pub(crate) mode: Mode,
    /// When it will be done by itself (s).
    pub(crate) end: f64,
    /// Done by itself, and waiting for what its [`EndCondition`] says.
    pub(crate) waits: bool,
    /// Whether the force has been at its limit.
    pub(crate) limited: bool,
    /// Whether a limit of the joint has been hit.
    pub(crate) hit: bool,
    /// What the analysis of simple mode gave.
    pub(crate) acceleration: Option<f64>,
    /// Whether a limit that pushes back, and that it is beyond, has let go.
    pub(crate) lets_go: bool,
    /// At which limit it rests.
    pub(crate) held: Option<(Side, f64)>,
}

impl Driven {
    /// A drive that begins.
    pub(crate) fn new(step: usize, start: f64, mode: Mode, end: f64) -> Self {
        let (held, lets_go) = (None, false);
        Self {
            step,
            start,
            mode,
            end,
            waits: false,
            limited: false,
            hit: false,
            acceleration: None,
            lets_go,
            held,
        }
    }

    /// What it is to the dynamics.
    pub(crate) fn role(&self) -> Role {
        match self.mode {
            Mode::Still => Role::Still,
            Mode::Path(_) => Role::Prescribed,
            Mode::Force(_) | Mode::Track(..) if self.held.is_some() => Role::Prescribed,
            Mode::Force(_) | Mode::Track(..) => Role::Dynamic,
        }
    }

    /// The force of the drive (N m or N) at a time (s), in a state of its degree of freedom.
    pub(crate) fn force(&self, time: f64, state: (f64, f64)) -> f64 {
        match &self.mode {
            Mode::Force(force) => force.at(time, state),
            Mode::Track(_, force) => *force,
            Mode::Still | Mode::Path(_) => 0.0,
        }
    }

    /// When it ends by the clock (s).
    pub(crate) fn ends(&self, steps: &[Step]) -> f64 {
        let until = match steps.get(self.step).map(|step| &step.until) {
            Some(EndCondition::Time(time)) => *time,
            Some(EndCondition::Lasting(time)) => self.start + time,
            _ => f64::INFINITY,
        };
        if self.waits { until } else { self.end.min(until) }
    }

    /// Times (s) at which its curve jumps.
    pub(crate) fn breaks(&self) -> Vec<f64> {
        match &self.mode {
            Mode::Path(path) => path.breaks(),
            Mode::Force(force) => force.breaks(),
            _ => Vec::new(),
        }
    }

    /// Whether its force depends on the state: then it may be what makes a step too long.
    pub(crate) fn feels(&self) -> bool {
        matches!(&self.mode, Mode::Force(force) if force.feels())
    }
}

/// The name of a drive, with what comes after the last one.
pub(crate) fn name(step: Option<&Step>) -> &'static str {
    step.map_or("at rest", |step| step.drive.name())
}

/// Whether the drive needs an analysis when it begins.
pub(crate) fn target(drive: &Drive) -> Option<crate::drive::Target> {
    match drive {
        Drive::Simple { target, .. } | Drive::FreeStyle { target: Some(target), .. } => Some(*target),
        _ => None,
    }
}
