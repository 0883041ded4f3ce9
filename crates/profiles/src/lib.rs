#![doc = include_str!("../README.md")]

mod butterworth;
mod natural;
mod piecewise;
mod polynomial;
mod sample;
pub mod step;
mod uniform;

pub use butterworth::{Butterworth, FilterError, odd_extension};
pub use natural::NaturalSpline;
pub use piecewise::{Outside, Piecewise};
pub use polynomial::{CubicHermite, Polynomial, Quintic};
pub use sample::{Boundary, ProfileError, Sample};
pub use uniform::UniformSpline;
