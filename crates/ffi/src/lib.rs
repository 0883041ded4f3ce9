#![doc = include_str!("../README.md")]
//!
//! # Safety
//!
//! Of every function here: a pointer is `NULL`, or points at what its type says, made by this library where it is a handle; an array has as
//! many numbers as its length says; a text ends with a zero.

mod dynamics;
mod error;
mod figure;
mod given;
mod simulation;
mod walker;

pub use dynamics::*;
pub use error::*;
pub use figure::*;
pub use simulation::*;
pub use walker::*;
