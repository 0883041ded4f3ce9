//! Curves through keys and samples.
//!
//! [`CubicSpline`] goes through any number of keys at any rising times; its constructors differ in the velocities that
//! they give the keys:
//!
//! | constructor | velocity at a key | joints | between two keys |
//! |---|---|---|---|
//! | [`catmull_rom`](CubicSpline::catmull_rom) | slope from the key before to the key after | C¹ | may swing out |
//! | [`centripetal`](CubicSpline::centripetal) | of the slopes on both sides, more of the shorter way's | C¹ | swings out less; still beside a hold |
//! | [`monotone`](CubicSpline::monotone) | harmonic mean of the slopes on both sides, 0 where the keys turn | C¹ | never turns |
//! | [`kochanek_bartels`](CubicSpline::kochanek_bartels) | by tension, continuity and bias | C¹, C⁰ if continuity ≠ 0 | as bent |
//! | [`natural`](CubicSpline::natural), [`clamped`](CubicSpline::clamped) | those with which the acceleration does not jump | C² | may swing out far |
//! | [`hermite`](CubicSpline::hermite) | as given | as given | as given |
//!
//! Of quintic pieces, C⁴, in `f64`: [`NaturalSpline`] through samples at any rising times with the least jerk,
//! [`UniformSpline`] through equally spaced ones, [`Piecewise`] with all boundary values of its ends given.

mod answers;
mod cubic;
mod cursor;
mod keys;
mod knots;
mod natural;
mod piece;
mod piecewise;
mod tangents;
mod uniform;

pub use cubic::CubicSpline;
pub use cursor::Cursor;
pub use keys::{Bend, Key};
pub use natural::NaturalSpline;
pub use piecewise::Piecewise;
pub use uniform::UniformSpline;
