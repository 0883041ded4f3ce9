//! What drives a figure. Here: the ground reactions of a motion that is wholly prescribed.
mod split;
pub use split::{FootSupport, TotalWrench, split_at_pivot};
