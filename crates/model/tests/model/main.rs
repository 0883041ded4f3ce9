//! The model crate from outside: what it refuses, the human figure, and sampling.

mod faults;
mod human;
mod human_reference;
mod sampling;
