//! Motions to and from the formats that people use.
#![doc = ""]
#![doc = include_str!("../README.md")]

pub mod bvh;
#[cfg(feature = "csv")]
pub mod csv;
mod error;

pub use error::{BvhFault, ContactProblem, IoError};
