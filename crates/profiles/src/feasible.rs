//! Feasible end velocities: those that keep a motion from turning round, given the velocity at the other end.
//!
//! With H the excess of velocity in the middle, the velocity of each of these curves has the signs of a quadratic in a
//! ratio ρ of functions that goes from 0 at the start to ∞ at the end,
//!
//! ```text
//! v₁·ρ² + H·ρ + v₀,        H = c − p·v₀ − q·v₁
//! ```
//!
//! which for velocities v₀ = x², v₁ = y² in the direction of the motion has no simple zero where H ≥ −2·x·y: inside of an
//! ellipse. The velocities are an interval, because v is affine in each of them; the thesis's lists with gaps
//! (Vasilonikolidakis (1991), §5.3.3) cannot be right, and where the given velocity is opposite to the motion, no velocity
//! at the other end will do (E8).

use crate::Elementary;
use crate::displacement::tension::Scaled;
use crate::displacement::{
    ExponentialVelocities, Tension, TrigonometricVelocities, check_motion, exponential_velocities::Moments,
};
use crate::error::{ProfileError, check_finite, check_overflow, check_range};
use crate::polynomial::CubicHermite;
use crate::range::{Range, Ranges};
use core::f64::consts::{FRAC_PI_2, PI};
use core::ops::Bound::{Excluded, Included};

/// The coefficients of the ellipse p·x² − 2·b·x·y + q·y² < c for a mean velocity of 1: x² is the velocity at the end that is
/// looked for, y² the one at the other end.
#[derive(Clone, Copy)]
pub(crate) struct Ellipse {
    pub(crate) p: f64,
    pub(crate) b: f64,
    pub(crate) q: f64,
    pub(crate) c: f64,
}

impl Ellipse {
    /// The velocities for which a motion with this `mean` velocity, and with the velocity `other` at the other end, never
    /// turns round.
    ///
    /// ```text
    /// x² from max(0, x₋)², included, to x₊², excluded        x± = (b·y ± √(b²·y² − p·(q·y² − c)))/p
    /// ```
    fn velocities(self, mean: f64, other: f64) -> Ranges {
        if mean < 0.0 {
            return self.velocities(-mean, -other).negated();
        }
        if other < 0.0 {
            return Ranges::NONE;
        }
        let Self { p, b, q, c } = self;
        let (y, rest) = (Elementary::sqrt(other), q * other - c * mean);
        let discriminant = b * b * other - p * rest;
        if mean.abs() <= 0.0 {
            // Only rest stays at its place without turning round.
            return if other > 0.0 { Ranges::NONE } else { Ranges::from(Range::closed(0.0, 0.0)) };
        }
        if discriminant.is_nan() || discriminant <= 0.0 {
            return Ranges::NONE;
        }
        // x₋·x₊ = rest/p.
        let high = (b * y + Elementary::sqrt(discriminant)) / p;
        let low = (rest / (p * high)).max(0.0);
        Ranges::from(Range::new(Included(low * low), Excluded(high * high)))
    }

    /// With the roles of the ends exchanged.
    fn mirrored(self) -> Self {
        Self { p: self.q, q: self.p, ..self }
    }
}

/// The mean velocity, of checked numbers.
fn mean(duration: f64, from: f64, to: f64, other: (&'static str, f64)) -> Result<f64, ProfileError> {
    check_motion(duration, from, to)?;
    check_finite(other.0, &[other.1])?;
    let mean = (to - from) / duration;
    check_overflow("velocity", &[mean])?;
    Ok(mean)
}

macro_rules! feasible {
    ($curve:ty, $ellipse:expr $(, $parameter:ident: $type:ty)*) => {
        impl $curve {
            /// The velocities at the start with which the motion from one position to another never turns round, where
            /// `end_velocity` is that at the end.
            ///
            /// One interval of velocities in the direction of the motion, or none at all. Its lower bound belongs to it, its
            /// upper bound does not; at a bound other than zero the motion touches standstill. Without a distance to go, the
            /// velocity is 0 where `end_velocity` is, else there is none.
            ///
            /// # Errors
            ///
            /// As for the curve itself.
            pub fn feasible_start_velocity(
                duration: f64,
                from: f64,
                to: f64,
                end_velocity: f64,
                $($parameter: $type,)*
            ) -> Result<Ranges, ProfileError> {
                let mean = mean(duration, from, to, ("end velocity", end_velocity))?;
                let ellipse: Option<Ellipse> = $ellipse($($parameter),*)?;
                Ok(ellipse.map_or(Ranges::NONE, |ellipse| ellipse.velocities(mean, end_velocity)))
            }

            /// The velocities at the end with which the motion from one position to another never turns round, where
            /// `start_velocity` is that at the start: as [`feasible_start_velocity`](Self::feasible_start_velocity).
            ///
            /// # Errors
            ///
            /// As for the curve itself.
            pub fn feasible_end_velocity(
                duration: f64,
                from: f64,
                to: f64,
                start_velocity: f64,
                $($parameter: $type,)*
            ) -> Result<Ranges, ProfileError> {
                let mean = mean(duration, from, to, ("start velocity", start_velocity))?;
                let ellipse: Option<Ellipse> = $ellipse($($parameter),*)?;
                Ok(ellipse.map_or(Ranges::NONE, |ellipse| ellipse.mirrored().velocities(mean, start_velocity)))
            }
        }
    };
}

feasible!(CubicHermite, cubic);
feasible!(TrigonometricVelocities, trigonometric);
feasible!(ExponentialVelocities, exponential, exponent: u32, shape: f64);
feasible!(Tension, tension, stiffness: f64);

#[allow(clippy::unnecessary_wraps, reason = "alike for all curves")]
fn cubic() -> Result<Option<Ellipse>, ProfileError> {
    Ok(Some(Ellipse { p: 2.0, b: 1.0, q: 2.0, c: 6.0 }))
}

#[allow(clippy::unnecessary_wraps, reason = "alike for all curves")]
fn trigonometric() -> Result<Option<Ellipse>, ProfileError> {
    Ok(Some(Ellipse { p: FRAC_PI_2, b: 1.0, q: FRAC_PI_2, c: PI }))
}

/// With v₁/rᵐ = (y/√rᵐ)² in place of v₁. None where the power itself turns the motion round.
fn exponential(exponent: u32, shape: f64) -> Result<Option<Ellipse>, ProfileError> {
    let Moments { sums: [a0, a1, a2], whole } = Moments::new(exponent, shape)?;
    let scale = Elementary::powi(1.0 - shape, exponent - 3);
    if scale < 0.0 {
        return Ok(None);
    }
    check_overflow("power of the shape", &[scale, 1.0 / scale])?;
    Ok(Some(Ellipse { p: a0 / a1, b: 1.0 / Elementary::sqrt(scale), q: a2 / (a1 * scale), c: whole / a1 }))
}

/// All coefficients divided by eʰ, h = k/2.
fn tension(stiffness: f64) -> Result<Option<Ellipse>, ProfileError> {
    check_range("stiffness", stiffness, Range::NOT_NEGATIVE)?;
    let scaled = Scaled::new(stiffness)?;
    let decay = Elementary::exp(-scaled.half);
    let c = 2.0 * scaled.whole_sine * scaled.whole_sine * scaled.per_share;
    let p = 0.5 * c * scaled.tangent - decay * decay / scaled.cosine;
    Ok(Some(Ellipse { p, b: decay, q: p, c }))
}
