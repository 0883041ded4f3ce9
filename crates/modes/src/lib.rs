#![doc = include_str!("../README.md")]

mod balance;
mod error;
mod reaction;
mod split;

pub use balance::balance_momentum;
pub use error::ReactionError;
pub use reaction::{ReactionReport, Support, SupportLaw, ground_reactions};
pub use split::{FootSupport, TotalWrench, split_at_pivot};
