//! Steppers that choose their steps: how far they can be trusted, what they cost, events, and what they refuse.

#[path = "time/chosen_steps.rs"]
mod chosen_steps;
#[path = "time/problems.rs"]
mod problems;
#[path = "time/stiff.rs"]
mod stiff;
#[path = "time/stiff_problems.rs"]
mod stiff_problems;
