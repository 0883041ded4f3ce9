//! Steppers: orders, closed forms, events, and what they refuse.

#[path = "time/closed_forms.rs"]
mod closed_forms;
#[path = "time/events.rs"]
mod events;
#[path = "time/orders.rs"]
mod orders;
#[path = "time/problems.rs"]
mod problems;
#[path = "time/refusals.rs"]
mod refusals;
