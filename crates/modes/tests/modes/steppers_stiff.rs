//! Steppers that choose their steps: how far they can be trusted, what they cost, events, and what they refuse.

#[path = "steppers/chosen_steps.rs"]
mod chosen_steps;
#[path = "steppers/stiff.rs"]
mod stiff;
#[path = "steppers/stiff_problems.rs"]
mod stiff_problems;
