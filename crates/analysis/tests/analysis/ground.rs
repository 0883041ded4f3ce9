//! The ground's forces of motions that are known: laws, hard cases, and measured data where it is present.

mod hard;
mod hopper;
mod laws;
mod measured;
mod placed;
mod planted;
mod plates;
pub(crate) mod support;
mod toes;
