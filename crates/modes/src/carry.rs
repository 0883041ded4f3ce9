//! Loads that links take up and let go in the course of a run.

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

impl Carry {
    /// Whether it is carried from a time (s) on.
    pub(crate) fn holds(&self, time: f64, near: f64) -> bool {
        self.from <= time + near && time + near < self.until
    }
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
        check_not_negative(|| format!("the beginning of the load on '{}'", link()), carry.from)?;
        if !(carry.until.is_infinite() && carry.until > 0.0) {
            check_positive(|| format!("how long '{}' carries its load", link()), carry.until - carry.from)?;
        }
        self.carries.push(carry);
        Ok(())
    }

    /// What links carry for a time.
    pub fn carries(&self) -> &[Carry] {
        &self.carries
    }

    /// The same with a figure that carries these of its loads.
    pub(crate) fn carrying(&self, carried: &[bool]) -> Result<Self, SetupError> {
        let mut loaded = self.clone();
        for carry in self.carries.iter().zip(carried).filter(|(_, carried)| **carried).map(|(carry, _)| carry)
        {
            loaded.figure = loaded.figure.carrying(&carry.load)?;
        }
        Ok(loaded)
    }
}
