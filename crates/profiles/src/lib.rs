//! Kinematic curves of one degree of freedom.
//!
//! Every curve answers with a [`Sample`]: position, velocity, acceleration and jerk in one call. A [`Quintic`] meets all
//! six boundary values, a [`CubicHermite`] four; [`Piecewise`] joins polynomials ([`Piecewise::quintic_spline`],
//! [`Piecewise::monotone_cubic`]); [`UniformSpline`] is smooth through equally spaced samples, at rest beyond its ends or
//! periodic; [`step`] has the smooth steps that blend one thing into another.
//!
//! Units are the caller's: a position in rad over a time in s has a velocity in rad/s.
//!
//! ```
//! use solaris_profiles::{Boundary, Quintic};
//!
//! // Rest to rest over one unit in two seconds: the minimum-jerk curve.
//! let curve = Quintic::new(2.0, Boundary::rest(0.0), Boundary::rest(1.0))?;
//! let middle = curve.at(1.0);
//! assert!((middle.position - 0.5).abs() < 1e-15);
//! assert!((middle.velocity - 15.0 / 16.0).abs() < 1e-15); // 15/8 of the mean
//! # Ok::<(), solaris_profiles::ProfileError>(())
//! ```

mod piecewise;
mod polynomial;
mod sample;
pub mod step;
mod uniform;

pub use piecewise::{Outside, Piecewise};
pub use polynomial::{CubicHermite, Polynomial, Quintic};
pub use sample::{Boundary, ProfileError, Sample};
pub use uniform::UniformSpline;
