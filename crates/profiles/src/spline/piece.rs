//! The cubic between two keys.

use crate::Elementary;
use crate::error::{ProfileError, check_overflow};
use crate::sample::Sample;

/// The Taylor series of one cubic about its start and about its end: each is used for the half next to it, so that the
/// curve is exact at both ends, and neither is far from where it is exact.
///
/// In `f64` a piece is one line of the cache, and aligned to it; in `f32` half of the line stays empty.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub(super) struct Piece<F> {
    /// At the start and at the end.
    pub(super) ends: [End<F>; 2],
    jerk: F,
}

/// The series about one end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct End<F> {
    pub(super) position: F,
    pub(super) velocity: F,
    pub(super) acceleration: F,
}

impl<F: Elementary> Piece<F> {
    /// Of two positions with their velocities; with m the mean velocity,
    ///
    /// ```text
    /// ε₀ = m − v₀   ε₁ = v₁ − m        a₀ = 2(2ε₀ − ε₁)/h   a₁ = 2(2ε₁ − ε₀)/h   j = 6(ε₁ − ε₀)/h²
    /// ```
    ///
    /// Refuses what leaves the range of numbers.
    pub(super) fn new(duration: F, (x0, v0): (F, F), (x1, v1): (F, F)) -> Result<Self, ProfileError> {
        let number = F::from_f64;
        let mean = (x1 - x0) / duration;
        // A bound of all velocities on the way, and with it of all that is added up for an answer.
        let velocity = number(6.0) * (v0.abs() + v1.abs() + mean.abs());
        check_overflow("velocity between two keys", &[velocity])?;
        check_overflow("position between two keys", &[velocity * duration])?;
        let (rest0, rest1) = (mean - v0, v1 - mean);
        let (a0, a1) = (rest0 + rest0 - rest1, rest1 + rest1 - rest0);
        let end = |position, velocity, a| End { position, velocity, acceleration: (a + a) / duration };
        let piece = Self {
            ends: [end(x0, v0, a0), end(x1, v1, a1)],
            jerk: number(6.0) * ((rest1 - rest0) / duration / duration),
        };
        check_overflow("acceleration at a key", &[piece.ends[0].acceleration, piece.ends[1].acceleration])?;
        check_overflow("jerk between two keys", &[piece.jerk])?;
        Ok(piece)
    }

    /// The curve `after` a time since the start, `before` a time until the end. `with` has the value 0 and the
    /// derivatives of the time.
    ///
    /// ```text
    /// x = xₙ + τ(vₙ + τ(aₙ/2 + τ j/6))   v = vₙ + τ(aₙ + τ j/2)   a = aₙ + τ j
    /// n: the nearer end   τ: the time from there
    /// ```
    #[inline]
    pub(super) fn at(&self, after: f64, before: f64, with: F) -> Sample<F> {
        // Chosen by index, not by a branch, which random times would mispredict half of the time.
        let late = after > before;
        let End { position, velocity, acceleration } = self.ends[usize::from(late)];
        let tau = F::from_f64(if late { -before } else { after }) + with;
        let half = F::from_f64(0.5);
        let change = tau * self.jerk;
        let half_change = half * change;
        Sample {
            position: position
                + tau * (velocity + tau * (half * acceleration + F::from_f64(1.0 / 6.0) * change)),
            velocity: velocity + tau * (acceleration + half_change),
            acceleration: acceleration + change,
            jerk: self.jerk,
        }
    }
}
