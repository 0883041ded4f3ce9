//! The model crate from outside: what it refuses, the human figure, and sampling.

mod chains;
mod configuration;
mod euler;
mod faults;
mod fuse;
mod human;
mod human_reference;
mod reroot;
mod sampling;
mod tumbling;
