//! The model crate from outside: what it refuses, the human figure, and sampling.

mod base;
mod chains;
mod configuration;
mod coupling;
mod euler;
mod faults;
mod fuse;
mod human;
mod human_reference;
mod large;
mod lint;
mod masses;
mod poses;
mod reroot;
mod sampling;
mod scale;
mod stretch;
mod text;
mod tumbling;
