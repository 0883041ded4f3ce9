//! Curves whose position is a function with a name: they meet the position at both ends, and some of them the velocity too.
//!
//! With u = t/T the elapsed fraction of the duration T, D the way from start to end:
//!
//! | curve | way gone at u | meets |
//! |---|---|---|
//! | [`Line`] | D·u | both positions |
//! | [`Trigonometric`] | D·sin²(π·u/2) | both positions, at rest |
//! | [`Power`] | D·uⁿ | both positions |
//! | [`Exponential`] | D·(1 − (1 − s·u)ⁿ)/(1 − (1 − s)ⁿ) | both positions |
//! | [`Hyperbolic`] | D·sinh(k·u)/sinh k | both positions |
//! | [`TrigonometricVelocities`] | 1, u, sin π·u, cos π·u | positions and velocities |
//! | [`Tension`] | 1, u, sinh k·u, cosh k·u | positions and velocities |
//! | [`ExponentialVelocities`] | (1 − s·u)ⁿ⁻³ times a quadratic is the velocity | positions and velocities |
//!
//! [`TrigonometricVelocities`], [`CubicHermite`](crate::CubicHermite) and [`Tension`] are one family, that with k² = −π²,
//! 0 and k² ≥ 0: with growing k the curve is drawn towards the straight line between its ends.
//!
//! The half of the motion that is nearer to its end is computed backwards from there: start and end are met exactly.
//!
//! # Source
//!
//! Vasilonikolidakis (1991), §5.3 and §A.1. The thesis divides all its constants by the end position, so that no motion can
//! end at zero; here nothing is divided by but the duration.

mod exponential;
pub(crate) mod exponential_velocities;
mod hyperbolic;
mod line;
mod power;
pub(crate) mod tension;
mod trigonometric;
mod trigonometric_velocities;

pub use exponential::Exponential;
pub use exponential_velocities::ExponentialVelocities;
pub use hyperbolic::Hyperbolic;
pub use line::Line;
pub use power::Power;
pub use tension::Tension;
pub use trigonometric::Trigonometric;
pub use trigonometric_velocities::TrigonometricVelocities;

use crate::Elementary;
use crate::curve::within;
use crate::error::{ProfileError, check_duration, check_finite};

/// A time as fractions of the duration, from the nearer end and from the farther one, and whether the nearer is the end.
struct Place<F> {
    near: F,
    far: F,
    from_end: bool,
}

impl<F: Elementary> Place<F> {
    fn new(t: F, duration: F) -> Self {
        let t = within(t, duration);
        let from_end = 2.0 * t.value() > duration.value();
        let near = if from_end { (duration - t) / duration } else { t / duration };
        Self { near, far: F::from_f64(1.0) - near, from_end }
    }

    /// `x` on the way from the start, −`x` on the way back from the end.
    fn forward(&self, x: F) -> F {
        if self.from_end { -x } else { x }
    }

    /// The same two in the order (near, far).
    fn ends(&self, start: F, end: F) -> (F, F) {
        if self.from_end { (end, start) } else { (start, end) }
    }

    /// The fractions elapsed and left.
    fn elapsed_and_left(&self) -> (F, F) {
        self.ends(self.near, self.far)
    }
}

/// `from + f·delta`, from `to` backwards where f is nearer to 1: exact for f = 0 and f = 1.
fn between<F: Elementary>(from: F, to: F, delta: F, f: F) -> F {
    if f.value() > 0.5 { to - delta * (F::from_f64(1.0) - f) } else { from + delta * f }
}

/// What all the constructors ask of their first three numbers.
pub(crate) fn check_motion<F: Elementary>(duration: F, from: F, to: F) -> Result<(), ProfileError> {
    check_duration(duration)?;
    check_finite("from", &[from])?;
    check_finite("to", &[to])
}

/// And of the velocities.
fn check_velocities<F: Elementary>(start: F, end: F) -> Result<(), ProfileError> {
    check_finite("start velocity", &[start])?;
    check_finite("end velocity", &[end])
}
