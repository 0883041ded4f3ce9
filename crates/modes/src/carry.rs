//! Loads that links take up and let go in the course of a run.

use crate::element::Loop;
use crate::failure::SetupError;
use crate::range::{check_not_negative, check_positive};
use crate::simulation::Simulation;
use solaris_model::Load;

/// A load that a link carries from a time of the run to another.
///
/// What is carried from the beginning moves with its link at the beginning. What is taken up later stands still until then, and is
/// taken up by a plastic impact, which conserves momentum:
///
/// ```text
/// (M + M_load)·v⁺ = M·v⁻
/// ```
///
/// but for what follows curves, which keeps to them. Letting go is no impact: the load flies on and is nobody's any more.
#[doc(alias = "payload")]
#[doc(alias = "grasp")]
#[derive(Clone, Debug, PartialEq)]
pub struct Carry {
    /// What is carried, and by which link.
    pub load: Load,
    /// From when on (s).
    pub from: f64,
    /// Until when (s); infinite for the rest of the run.
    pub until: f64,
}

impl Carry {}

/// Which loads are carried, and which loops are closed, for a time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Held {
    pub(crate) loads: Vec<bool>,
    pub(crate) loops: Vec<bool>,
}

/// Refuses what does not begin, or does not end after that.
pub(crate) fn check_span(
    [from, until]: [f64; 2],
    begins: impl Fn() -> String,
    lasts: impl Fn() -> String,
) -> Result<(), SetupError> {
    check_not_negative(begins, from)?;
    if until > from {
        return Ok(());
    }
    // 0.1 − 0.3 is told as −0.2.
    check_positive(lasts, (1e12 * (until - from)).round() / 1e12 + 0.0)
}

impl Simulation {
    /// Lets a link carry a load for a time.
    ///
    /// # Errors
    ///
    /// [`SetupError::Load`], [`SetupError::Range`].
    pub fn add_carry(&mut self, carry: Carry) -> Result<(), SetupError> {
        self.figure.carrying(&carry.load)?;
        let link = || self.figure.links()[carry.load.link].name().to_owned();
        check_span(
            [carry.from, carry.until],
            || format!("the beginning of the load on '{}'", link()),
            || format!("how long '{}' carries its load", link()),
        )?;
        self.carries.push(carry);
        Ok(())
    }

    /// What links carry for a time.
    pub fn carries(&self) -> &[Carry] {
        &self.carries
    }

    /// The same with a figure that carries these of its loads, and with these of its loops.
    pub(crate) fn holding(&self, held: &Held) -> Result<Self, SetupError> {
        let mut now = self.clone();
        for (carry, _) in self.carries.iter().zip(&held.loads).filter(|(_, carried)| **carried) {
            now.figure = now.figure.carrying(&carry.load)?;
        }
        now.closed.clone_from(&held.loops);
        Ok(now)
    }

    /// What is held from a time (s) on.
    pub(crate) fn held(&self, time: f64, near: f64) -> Held {
        let is_on = |from: f64, until: f64| from <= time + near && time + near < until;
        Held {
            loads: self.carries.iter().map(|carry| is_on(carry.from, carry.until)).collect(),
            loops: self.loops.iter().map(|closed| is_on(closed.from, closed.until)).collect(),
        }
    }

    /// The loops that are closed now, each with its index.
    pub(crate) fn closed(&self) -> impl Iterator<Item = (usize, &Loop)> {
        self.loops
            .iter()
            .enumerate()
            .zip(&self.closed)
            .filter(|(_, closed)| **closed)
            .map(|(closed, _)| closed)
    }
}
