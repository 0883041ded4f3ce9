#![doc = include_str!("../README.md")]
#![cfg_attr(not(feature = "std"), no_std)]

extern crate alloc;

pub mod acceleration;
mod answers;
pub mod blend;
mod butterworth;
mod clip;
mod curve;
pub mod cyclic;
pub mod displacement;
mod error;
mod feasible;
mod float;
pub mod legacy;
pub mod limited;
mod polynomial;
mod profile;
mod range;
mod roots;
#[cfg(feature = "rotation")]
pub mod rotation;
mod sample;
mod segment;
pub mod spline;
pub mod step;
#[cfg(feature = "text")]
pub mod text;
pub mod velocity;

pub use answers::{Answers, Peak, Peaks, Quantity, Stationary, StationaryPoint, Turn};
pub use butterworth::{Butterworth, FilterError, odd_extension};
pub use clip::{Clip, Outside};
pub use curve::Curve;
pub use error::ProfileError;
pub use polynomial::{CubicHermite, Polynomial, Quintic};
pub use profile::{Family, Kind, Measure, Parameter, Profile, ProfileCurve, ProfileLayer};
pub use range::{Range, Ranges};
pub use sample::{Boundary, Sample};
pub use solaris_scalar::{Dual, Elementary, Scalar};
pub use spline::{NaturalSpline, Piecewise, UniformSpline};
