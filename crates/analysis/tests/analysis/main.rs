//! What is known of given motions, from outside.
#![allow(clippy::print_stderr, reason = "what was measured")]

mod balance;
mod closed;
mod consistency;
mod ground;
mod inverse;
mod markers;
mod nearness;
#[path = "inverse/pinned.rs"]
mod pinned;
mod plausibility;
#[cfg(feature = "serde")]
mod reports;
mod states;
mod uncertainty;
