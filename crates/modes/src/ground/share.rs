//! How the feet that stand share the ground's wrench.

use crate::complete::Completed;
use crate::ground::{BalanceFrame, GroundError, Sole, Stances};
use nalgebra::Vector3;
use solaris_model::{Contact, Figure};

/// A rule that shares the ground's wrench between the feet that stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Split {
    /// The smooth transition assumption.
    Transition,
    /// Forces that point at one pivot above the centre of mass.
    #[default]
    Pivot,
    /// The least moments at the joints.
    Effort,
}

impl Split {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Transition, Self::Pivot, Self::Effort];

    /// What it is called.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Transition => "transition",
            Self::Pivot => "pivot",
            Self::Effort => "effort",
        }
    }

    /// The split of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|split| split.name() == name)
    }
}

/// What each foot got.
#[derive(Clone, Debug, PartialEq)]
pub struct Shared {
    /// By foot, one contact a frame; zero where the foot does not stand.
    pub contacts: Vec<Vec<Contact>>,
    /// Frames in which the split does not apply and the pivot split stands in for it.
    pub replaced: usize,
}

/// Shares the whole wrench between the feet that stand.
///
/// # Errors
///
/// Stub.
pub fn share(
    split: Split,
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &Completed,
    soles: &[Sole],
    stances: &Stances,
    total: &[BalanceFrame],
) -> Result<Shared, GroundError> {
    let _ = (split, figure, gravity, states, soles, stances, total);
    Err(GroundError::Empty)
}
