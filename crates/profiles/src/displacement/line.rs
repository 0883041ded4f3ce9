//! The straight line.

use super::{Place, check_motion};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary};
use crate::curve::Curve;
use crate::error::{ProfileError, check_overflow};
use crate::sample::Sample;
use alloc::vec::Vec;

/// A motion from one position to another with constant velocity.
///
/// ```text
/// x = x₀ + D·u        u = t/T,  D = x₁ − x₀
/// ```
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.3.4 and §A.1.4.
#[doc(alias = "lerp")]
#[doc(alias = "linear interpolation")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<F = f64> {
    duration: F,
    from: F,
    to: F,
    delta: F,
    velocity: F,
}

impl<F: Elementary> Line<F> {
    /// Over `duration` > 0, between two positions.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, numbers that are not finite or lead to such.
    pub fn new(duration: F, from: F, to: F) -> Result<Self, ProfileError> {
        check_motion(duration, from, to)?;
        let delta = to - from;
        let velocity = delta / duration;
        check_overflow("distance", &[delta])?;
        check_overflow("velocity", &[velocity])?;
        Ok(Self { duration, from, to, delta, velocity })
    }
}

impl<F: Elementary> Curve<F> for Line<F> {
    fn duration(&self) -> F {
        self.duration
    }

    fn at(&self, t: F) -> Sample<F> {
        let place = Place::new(t, self.duration);
        let base = if place.from_end { self.to } else { self.from };
        Sample { velocity: self.velocity, ..Sample::rest(base + place.forward(self.delta * place.near)) }
    }
}

impl Answers for Line {
    fn stationary(&self) -> Stationary {
        // The distance, not the velocity: that of a very slow motion is rounded to zero.
        if self.delta.abs() > 0.0 { Stationary::NONE } else { Stationary::everywhere(self.duration) }
    }

    fn critical(&self, _: Quantity) -> Vec<f64> {
        Vec::new()
    }
}
