#![doc = include_str!("../README.md")]

mod balance;
mod carrier;
mod closed;
pub mod cycles;
mod differentiate;
mod error;
pub mod ground;
mod inverse;
mod loads;
pub mod markers;
mod medium;
mod nearness;
mod peak;
pub mod plausibility;
mod prepared;
mod prescribed;
mod random;
mod reach;
mod reaction;
mod rooted;
mod split;
mod uncertainty;

pub use balance::balance_momentum;
pub use closed::{ClosedError, ClosedForces, closed_forces};
pub use differentiate::{DifferentiateError, Differentiated, Filter, differentiate};
pub use error::ReactionError;
pub use inverse::{DofLoad, InverseError, InverseOptions, InverseReport, Residual, inverse_motion};
pub use loads::{LoadError, Loads};
pub use medium::{MediumError, medium_forces};
pub use nearness::{
    Clearance, LimbOverlap, Near, NearSpell, Nearest, NearestLimbs, Nearness, NearnessError, nearness,
    nearness_but,
};
pub use peak::Peak;
pub use prepared::{PrepareError, PreparedMotion};
pub use prescribed::prescribed_reactions;
pub use reach::{Goal, REACHED, Reach, ReachError, Reached};
pub use reaction::{ReactionReport, Support, SupportLaw, ground_reactions, ground_reactions_under};
pub use rooted::{RootReport, reactions_from_feet};
pub use split::{FootSupport, split_at_pivot};
pub use uncertainty::{
    Answer, CUTOFF_FACTOR, ErrorSource, Spread, SpreadError, Uncertainty, filter_spread, position_spread,
    residual_spread,
};
