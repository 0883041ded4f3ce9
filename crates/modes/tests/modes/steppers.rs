//! Steppers: orders, closed forms, events, and what they refuse.

mod chosen_steps;
mod closed_forms;
mod events;
mod explicit;
mod orders;
pub(crate) mod problems;
mod refusals;
