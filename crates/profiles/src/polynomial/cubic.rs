//! The cubic Hermite curve, which meets positions and velocities at both ends.

use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_duration, check_finite, check_overflow};
use crate::roots;
use crate::sample::Sample;
use alloc::vec::Vec;

/// The curve of degree three that meets position and velocity at both ends.
///
/// ```text
/// x(t) = x₀ + v₀T·u + (3D − 2v₀T − v₁T)·u² + (v₀T + v₁T − 2D)·u³        u = t/T,  D = x₁ − x₀
/// ```
///
/// Like [`Quintic`](crate::Quintic) it is evaluated from the nearer end, and goes on as the same polynomial beyond its
/// ends. It is the middle of the family to which [`Tension`](crate::displacement::Tension) (whose stiffness 0 it is)
/// and [`TrigonometricVelocities`](crate::displacement::TrigonometricVelocities) belong.
///
/// # Examples
///
/// ```
/// use solaris_profiles::{CubicHermite, Curve};
///
/// let curve = CubicHermite::new(2.0, (0.0, 0.0), (1.0, 0.0))?;
/// assert_eq!(curve.at(1.0).velocity, 0.75); // 3/2 of the mean
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[doc(alias = "cubic")]
#[doc(alias = "spline")]
#[doc(alias = "hermite")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubicHermite<F = f64> {
    duration: F,
    /// 1/T, 1/T², 1/T³.
    rates: [F; 3],
    /// Of u, from the start.
    forwards: [F; 4],
    /// Of 1 − u, from the end.
    backwards: [F; 4],
}

impl<F: Elementary> CubicHermite<F> {
    /// Over `duration`, from position `x0` with velocity `v0` to `x1` with `v1`.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, numbers that are not finite or become so by being so large in so short a time.
    pub fn new(duration: F, (x0, v0): (F, F), (x1, v1): (F, F)) -> Result<Self, ProfileError> {
        check_duration(duration)?;
        check_finite("from", &[x0])?;
        check_finite("start velocity", &[v0])?;
        check_finite("to", &[x1])?;
        check_finite("end velocity", &[v1])?;
        let forwards = of_span(x0, v0 * duration, x1, v1 * duration);
        let backwards = of_span(x1, -(v1 * duration), x0, -(v0 * duration));
        let rate = F::from_f64(1.0) / duration;
        let rates = [rate, rate * rate, rate * rate * rate];
        check_overflow("velocity", &[rate])?;
        check_overflow("jerk", &rates)?;
        for curve in [&forwards, &backwards] {
            check_overflow("position", curve)?;
            check_overflow("velocity", &curve.map(|c| F::from_f64(4.0) * c * rate))?;
            check_overflow("acceleration", &curve.map(|c| F::from_f64(8.0) * c * rates[1]))?;
            check_overflow("jerk", &curve.map(|c| F::from_f64(6.0) * c * rates[2]))?;
        }
        Ok(Self { duration, rates, forwards, backwards })
    }

    /// At any time, from the nearer end.
    #[inline]
    fn evaluate(&self, t: F) -> Sample<F> {
        if t.value() + t.value() <= self.duration.value() {
            cubic(&self.forwards, &self.rates, t)
        } else {
            cubic(&self.backwards, &self.rates, self.duration - t).reversed()
        }
    }
}

impl CubicHermite {
    /// The velocity of u, times the duration, as v₀·(1−u)² + h·u·(1−u) + v₁·u².
    fn velocity(&self) -> [f64; 3] {
        let ([x0, v0, ..], [x1, v1, ..]) = (self.forwards, self.backwards);
        [v0, 6.0 * (x1 - x0) - 2.0 * (v0 - v1), -v1]
    }
}

impl<F: Elementary> Curve<F> for CubicHermite<F> {
    fn duration(&self) -> F {
        self.duration
    }

    #[inline]
    fn at(&self, t: F) -> Sample<F> {
        self.evaluate(within(t, self.duration))
    }

    fn extrapolated(&self, t: F) -> Sample<F> {
        self.evaluate(t)
    }
}

impl Answers for CubicHermite {
    /// With r = u/(1 − u), the velocity is zero where v₁·r² + h·r + v₀ = 0, r > 0.
    fn stationary(&self) -> Stationary {
        let [v0, h, v1] = self.velocity();
        if v0.abs().max(h.abs()).max(v1.abs()) <= 0.0 {
            return Stationary::everywhere(self.duration);
        }
        let ratios = roots::quadratic(v1, h, v0).into_iter().filter(|&(r, _)| r > 0.0);
        Stationary::at(ratios.map(|(r, turn)| (self.duration * (r / (1.0 + r)), turn)), self.duration)
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        match quantity {
            Quantity::Position => self.stationary().points.iter().map(|point| point.time).collect(),
            Quantity::Velocity => {
                let (a0, a1) = (self.forwards[2], self.backwards[2]);
                let inside = (a0 < 0.0 && a1 > 0.0) || (a0 > 0.0 && a1 < 0.0);
                if inside { alloc::vec![self.duration * (a0 / (a0 - a1))] } else { Vec::new() }
            }
            Quantity::Acceleration | Quantity::Jerk => Vec::new(),
        }
    }
}

/// The coefficients of u, from p = v₀T and q = v₁T.
fn of_span<F: Elementary>(x0: F, p: F, x1: F, q: F) -> [F; 4] {
    let (two, three) = (F::from_f64(2.0), F::from_f64(3.0));
    let delta = x1 - x0;
    [x0, p, three * delta - two * p - q, p + q - two * delta]
}

/// At the time `s` after the end that the coefficients begin at.
#[inline]
fn cubic<F: Elementary>(c: &[F; 4], rates: &[F; 3], s: F) -> Sample<F> {
    let (two, three, six) = (F::from_f64(2.0), F::from_f64(3.0), F::from_f64(6.0));
    let u = s * rates[0];
    Sample {
        position: c[0] + u * (c[1] + u * (c[2] + u * c[3])),
        velocity: (c[1] + u * (two * c[2] + u * (three * c[3]))) * rates[0],
        acceleration: (two * c[2] + u * (six * c[3])) * rates[1],
        // No time, no jerk.
        jerk: six * (c[3] + u * F::from_f64(0.0)) * rates[2],
    }
}
