//! Steppers: orders, closed forms, events, and what they refuse.

mod closed_forms;
mod events;
mod orders;
pub(crate) mod problems;
mod refusals;
