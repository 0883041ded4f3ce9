//! The cycles of a walk and their phases, as both models hand them on.

use super::posture::{KeyPosture, Root};

/// Which cycle: the set of movements that covers one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cycle {
    /// From standing.
    Starting,
    /// From step to step.
    Intermediate,
    /// To standing: the other foot closes beside.
    Finishing,
}

/// What a phase is built up from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PhaseRoot {
    /// Whether the swing leg's foot is meant; the stance leg's otherwise.
    pub swing: bool,
    /// Which point of it.
    pub point: Root,
}

/// A phase: from the posture before it to `end`.
///
/// The legs' parts are exchanged between cycles, not within one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeyPhase {
    /// Its number in the thesis's intermediate cycle, from 1.
    pub number: usize,
    /// What it turns about.
    pub root: PhaseRoot,
    /// The posture at its end.
    pub end: KeyPosture,
}
