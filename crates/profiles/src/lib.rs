#![doc = include_str!("../README.md")]

mod piecewise;
mod polynomial;
mod sample;
pub mod step;
mod uniform;

pub use piecewise::{Outside, Piecewise};
pub use polynomial::{CubicHermite, Polynomial, Quintic};
pub use sample::{Boundary, ProfileError, Sample};
pub use uniform::UniformSpline;
