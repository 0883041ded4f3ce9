//! The curve whose velocity follows a straight line.

use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary, Turn};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_duration, check_finite, check_overflow};
use crate::range::{Range, Ranges};
use crate::sample::Sample;
use alloc::vec::Vec;

/// A motion whose velocity goes from one value to another along a straight line.
///
/// ```text
/// x = x₀ + t·(v₀ + v)/2        v = v₀·(1 − u) + v₁·u        a = (v₁ − v₀)/T        u = t/T
/// ```
///
/// It is [`acceleration::Constant`](crate::acceleration::Constant) told by its velocities.
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.5.1 and A.3.1. It says that the displacement has no stationary point; it has one where
/// v₀ and v₁ have opposite signs, and velocity and displacement need not have slopes of one sign (E21). The appendix
/// divides by v₁; here nothing does.
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, velocity::Line};
///
/// let slowing = Line::new(2.0, 0.0, (3.0, 1.0))?;
/// assert_eq!(slowing.at(2.0).position, 4.0);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<F = f64> {
    duration: F,
    from: F,
    velocities: (F, F),
    acceleration: F,
}

impl<F: Elementary> Line<F> {
    /// Over `duration`, from position `from`, with velocity `v0` at the start and `v1` at the end.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, numbers that are not finite or lead to such.
    pub fn new(duration: F, from: F, (v0, v1): (F, F)) -> Result<Self, ProfileError> {
        check_duration(duration)?;
        check_finite("from", &[from])?;
        check_finite("start velocity", &[v0])?;
        check_finite("end velocity", &[v1])?;
        let acceleration = (v1 - v0) / duration;
        check_overflow("acceleration", &[acceleration])?;
        check_overflow("position", &[from.abs() + (v0.abs() + v1.abs()) * duration])?;
        Ok(Self { duration, from, velocities: (v0, v1), acceleration })
    }

    /// With the end velocity that leads to `to`: v₁ = 2D/T − v₀.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn reaching(duration: F, (from, v0): (F, F), to: F) -> Result<Self, ProfileError> {
        check_duration(duration)?;
        check_finite("from", &[from])?;
        check_finite("start velocity", &[v0])?;
        check_finite("to", &[to])?;
        let v1 = F::from_f64(2.0) * ((to - from) / duration) - v0;
        check_overflow("end velocity", &[v1])?;
        Self::new(duration, from, (v0, v1))
    }

    /// The velocity at the end.
    pub fn end_velocity(&self) -> F {
        self.velocities.1
    }
}

impl Line {
    /// The start velocities with which a motion of this end velocity never turns round: those that are not of the
    /// opposite sign.
    ///
    /// # Errors
    ///
    /// A velocity that is not finite.
    pub fn feasible_start_velocity(end_velocity: f64) -> Result<Ranges, ProfileError> {
        check_finite("end velocity", &[end_velocity])?;
        Ok(same_sign(end_velocity))
    }

    /// The end velocities likewise.
    ///
    /// # Errors
    ///
    /// A velocity that is not finite.
    pub fn feasible_end_velocity(start_velocity: f64) -> Result<Ranges, ProfileError> {
        check_finite("start velocity", &[start_velocity])?;
        Ok(same_sign(start_velocity))
    }
}

impl<F: Elementary> Curve<F> for Line<F> {
    fn duration(&self) -> F {
        self.duration
    }

    #[inline]
    fn at(&self, t: F) -> Sample<F> {
        self.extrapolated(within(t, self.duration))
    }

    /// Goes on as the same parabola.
    #[inline]
    fn extrapolated(&self, t: F) -> Sample<F> {
        let (v0, v1) = self.velocities;
        let u = t / self.duration;
        let velocity = v0 * (F::from_f64(1.0) - u) + v1 * u;
        // No time, no acceleration.
        let zero = F::from_f64(0.0) * u;
        Sample {
            position: self.from + F::from_f64(0.5) * t * (v0 + velocity),
            velocity,
            acceleration: self.acceleration + zero,
            jerk: zero,
        }
    }
}

impl Answers for Line {
    /// T·v₀/(v₀ − v₁).
    fn stationary(&self) -> Stationary {
        let (v0, v1) = self.velocities;
        if v0.abs().max(v1.abs()) <= 0.0 {
            Stationary::everywhere(self.duration)
        } else if (v0 < 0.0 && v1 > 0.0) || (v0 > 0.0 && v1 < 0.0) {
            Stationary::at([(self.duration * (v0 / (v0 - v1)), Turn::Reversal)], self.duration)
        } else {
            Stationary::NONE
        }
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        match quantity {
            Quantity::Position => self.stationary().points.iter().map(|point| point.time).collect(),
            _ => Vec::new(),
        }
    }
}

/// What is not of the sign opposite to that of `velocity`.
fn same_sign(velocity: f64) -> Ranges {
    if velocity > 0.0 {
        Ranges::from(Range::NOT_NEGATIVE)
    } else if velocity < 0.0 {
        Ranges::from(Range::at_most(0.0))
    } else {
        Ranges::all()
    }
}
