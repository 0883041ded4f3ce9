//! Figures and motions to and from the formats that people use.
#![doc = ""]
#![doc = include_str!("../README.md")]

pub mod bvh;
#[cfg(feature = "csv")]
pub mod csv;
mod error;
pub mod headings;
#[cfg(any(feature = "urdf", feature = "mjcf", feature = "opensim"))]
mod import;
#[cfg(feature = "mjcf")]
pub mod mjcf;
#[cfg(feature = "opensim")]
pub mod opensim;
#[cfg(feature = "parquet")]
pub mod parquet;
pub mod record;
pub mod sto;
mod table;
#[cfg(any(feature = "urdf", feature = "mjcf", feature = "opensim"))]
mod tree;
#[cfg(feature = "urdf")]
pub mod urdf;
#[cfg(any(feature = "urdf", feature = "mjcf", feature = "opensim"))]
mod xml;

pub use error::{ContactProblem, ExternalForceProblem, IoError};
#[cfg(any(feature = "urdf", feature = "mjcf", feature = "opensim"))]
pub use import::Import;
pub use table::Table;
