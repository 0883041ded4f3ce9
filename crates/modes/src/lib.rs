#![doc = include_str!("../README.md")]

mod balance;
mod carrier;
mod complete;
mod error;
mod inverse;
mod loads;
mod passive;
mod reaction;
mod split;

pub use balance::balance_momentum;
pub use complete::{CompleteError, Completed, Filter, complete};
pub use error::ReactionError;
pub use inverse::{DofLoad, InverseError, InverseOptions, InverseReport, Residual, inverse_motion};
pub use loads::{LoadError, Loads};
pub use passive::add_passive_forces;
pub use reaction::{ReactionReport, Support, SupportLaw, ground_reactions};
pub use split::{FootSupport, TotalWrench, split_at_pivot};
