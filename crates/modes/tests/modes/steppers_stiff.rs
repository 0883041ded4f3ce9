//! The implicit stepper: how far it can be trusted, and what it costs.

#[path = "steppers/stiff.rs"]
mod stiff;
#[path = "steppers/stiff_problems.rs"]
mod stiff_problems;
