#![doc = include_str!("../README.md")]

mod error;
mod reaction;
mod split;

pub use error::ReactionError;
pub use reaction::{ReactionReport, Support, SupportLaw, ground_reactions};
pub use split::{FootSupport, TotalWrench, split_at_pivot};
