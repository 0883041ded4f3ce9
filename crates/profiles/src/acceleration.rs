//! Curves that are given by their acceleration.
//!
//! | curve | acceleration | from a start velocity v₀ it reaches the velocity |
//! |---|---|---|
//! | [`Constant`] | a | v₀ + a·T |
//! | [`Trigonometric`] | aₘ·sin πu | v₀ + 2aₘT/π |
//! | [`Ellipse::quarter`] | (2aₘ/√3)·√(u·(2 − u)) | v₀ + πaₘT/(2√3) |
//! | [`Ellipse::half`] | 2aₘ·√(u·(1 − u)) | v₀ + πaₘT/4 |
//!
//! u = t/T is the share of the duration that has passed. Each begins at a position with a velocity and ends where its
//! acceleration leads it; its `reaching` finds the acceleration that leads to a position, for which the thesis has no
//! formula. Where start velocity and acceleration have opposite signs, the motion may turn round once, although the
//! thesis calls these curves monotone (E21); `feasible_start_velocity` says when it does not.

mod constant;
mod ellipse;
mod trigonometric;

pub use constant::Constant;
pub use ellipse::Ellipse;
pub use trigonometric::Trigonometric;

use crate::Elementary;
use crate::error::{ProfileError, check_duration, check_finite, check_overflow};
use crate::range::Ranges;

/// Refuses what these curves begin with where it is not finite, or where the position could overflow on its way: `gain`
/// is what the acceleration adds to the velocity, and on its way the position stays within |from| + (|v₀| + |gain|)·T.
fn check<F: Elementary>(
    duration: F,
    (from, v0): (F, F),
    what: &'static str,
    amplitude: F,
) -> Result<(), ProfileError> {
    check_duration(duration)?;
    check_finite("from", &[from])?;
    check_finite("start velocity", &[v0])?;
    check_finite(what, &[amplitude])?;
    let gain = F::from_f64(2.0) * amplitude.abs() * duration;
    check_overflow("velocity", &[v0.abs() + gain])?;
    check_overflow("position", &[from.abs() + (v0.abs() + gain) * duration])
}

/// The same of what `reaching` is given.
fn check_reaching<F: Elementary>(duration: F, (from, v0): (F, F), to: F) -> Result<(), ProfileError> {
    check_duration(duration)?;
    check_finite("from", &[from])?;
    check_finite("start velocity", &[v0])?;
    check_finite("to", &[to])
}

/// 2·(D − v₀·T)/T²: the constant acceleration that leads from `from` to `to`; others are multiples of it.
fn constant_to<F: Elementary>(duration: F, (from, v0): (F, F), to: F) -> Result<F, ProfileError> {
    check_reaching(duration, (from, v0), to)?;
    let acceleration = F::from_f64(2.0) * ((to - from) / duration - v0) / duration;
    check_overflow("acceleration", &[acceleration])?;
    Ok(acceleration)
}

/// The start velocities with which a motion that gains `gain` of velocity never turns round: all but those that it
/// takes through zero.
fn feasible(duration: f64, what: &'static str, amplitude: f64, gain: f64) -> Result<Ranges, ProfileError> {
    check_duration(duration)?;
    check_finite(what, &[amplitude])?;
    check_overflow("velocity", &[gain])?;
    Ok(Ranges::outside((0.0 - gain).min(0.0), (0.0 - gain).max(0.0)))
}
