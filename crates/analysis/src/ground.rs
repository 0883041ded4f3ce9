//! The ground's forces in a motion that is known, from the motion alone.
//!
//! The laws of motion give the whole wrench of the ground ([`balance`]). Which foot stands when is found from how the
//! soles move ([`find_stances`]), or known to whoever planned the motion ([`stances_of_planted`])
//! or measured its forces ([`stances_of_contacts`]). How two feet share
//! the wrench is an assumption with a name ([`Split`], [`share`]). What is wrong with the result is told, not hidden
//! ([`judge`]), and so is what carries besides feet on the ground ([`find_elsewhere`]). [`ground_forces`] does all of it. [`consistent_shift`] finds the smallest change of the root's path after which
//! the ground can do what is asked of it, and [`shift_root`] makes it.
//!
//! All of them ask [`PlacedFeet`]: soles whose points are found once in all frames.

mod carry;
mod consistency;
mod elsewhere;
mod error;
mod feet;
mod fit;
mod footing;
mod guess;
mod judge;
mod legs;
mod outline;
mod planted;
mod plates;
mod possible;
mod predict;
mod share;
mod sole;
mod stance;
mod total;

pub use consistency::{
    Consistency, ConsistencyError, ConsistencyOptions, ConsistencyOutcome, ShiftError, Violation, consistent,
    shift_root,
};
pub use elsewhere::{Elsewhere, ElsewhereKind, find_elsewhere};
pub use error::{GroundError, GroundOption};
pub use feet::{PlacedFeet, PlacedSole};
pub use footing::Footing;
pub use guess::guessed_soles;
pub use judge::{FootReport, Unsupported, Worst, judge};
pub use planted::{PlantedError, reactions_of_planted};
pub use plates::{PlateLoad, PlateRecord, feet_on_plates};
pub use possible::consistent_shift;
pub use predict::{GroundForces, GroundOptions, GroundReport, ground_forces};
pub use share::{Shared, Split, share};
pub use sole::{SOLE_BREADTH, Sole, soles};
pub use stance::{
    Belt, Stance, StanceOptions, Stances, find_stances, stances_of_contacts, stances_of_planted,
};
pub use total::{BalanceFrame, balance};
