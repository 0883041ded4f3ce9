//! The first level, from outside.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "what was measured")]

mod balance;
mod carries;
#[cfg(feature = "collide")]
mod collisions;
mod contact;
mod drives;
mod governor;
mod hanging;
mod holds;
mod limits;
mod limits_random;
mod loops;
mod loops_by_forces;
mod plan;
mod present;
mod pushes;
#[cfg(feature = "serde")]
mod reports;
mod running;
mod sequence;
mod steppers;
#[cfg(feature = "stiff")]
mod steppers_stiff;
mod study;
mod sweep;
