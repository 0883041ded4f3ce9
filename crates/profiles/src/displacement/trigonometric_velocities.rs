//! The curve of a sine, a cosine and a straight line, with given velocities at the ends.

use super::{Place, check_motion, check_velocities};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary, Turn};
use crate::curve::Curve;
use crate::error::{ProfileError, check_overflow};
use crate::roots::quadratic;
use crate::sample::Sample;
use alloc::vec::Vec;
use core::f64::consts::PI;

/// A motion from one position and velocity to another along a straight line and half a period of a sine of any phase.
///
/// ```text
/// x = x₀ + D·S + T·v̄·(u − S) + T·(v₀ − v₁)/(2π)·sin π·u        u = t/T,  S = sin²(π·u/2),  D = x₁ − x₀
/// v = v₀·cos²(π·u/2) + v₁·S + K/2·sin π·u                       v̄ = (v₀ + v₁)/2,  K = π·(D/T − v̄)
/// a = π/T·(K/2·cos π·u − (v₀ − v₁)/2·sin π·u)
/// j = −(π/T)²·(K/2·sin π·u + (v₀ − v₁)/2·cos π·u)
/// ```
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.3.1 and §A.1.1, "with velocity constraints". As printed, C and k₁ there have v₀ − v₁ where
/// it must be v₀ + v₁ (E1, E2): with the printed constants velocities of 1.5 and 0.5 come out as 1 and 0. The phase B and
/// the amplitude A of the thesis do not exist for v₀ = v₁; here they are not needed.
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, displacement::TrigonometricVelocities};
///
/// let curve = TrigonometricVelocities::new(2.0, (1.0, 1.5), (4.0, 0.5))?;
/// assert_eq!(curve.at(0.0).velocity, 1.5);
/// assert_eq!(curve.at(2.0).position, 4.0);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrigonometricVelocities<F = f64> {
    duration: F,
    start: (F, F),
    end: (F, F),
    delta: F,
    /// T·v̄.
    even: F,
    /// T·(v₀ − v₁)/π.
    odd: F,
    /// K.
    excess: F,
    /// π/T.
    omega: F,
    /// π/T·K/2 and π/T·(v₀ − v₁)/2.
    accelerations: (F, F),
}

impl<F: Elementary> TrigonometricVelocities<F> {
    /// Over `duration` > 0, from one (position, velocity) to another.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, numbers that are not finite or lead to such.
    pub fn new(duration: F, start: (F, F), end: (F, F)) -> Result<Self, ProfileError> {
        check_motion(duration, start.0, end.0)?;
        check_velocities(start.1, end.1)?;
        let (half, pi) = (F::from_f64(0.5), F::from_f64(PI));
        let (delta, mean, difference) = (end.0 - start.0, half * (start.1 + end.1), start.1 - end.1);
        let (even, odd) = (duration * mean, duration * difference / pi);
        let excess = pi * (delta / duration - mean);
        let omega = pi / duration;
        let accelerations = (half * omega * excess, half * omega * difference);
        check_overflow("distance", &[delta, even, odd])?;
        check_overflow("largest jerk", &[omega * accelerations.0, omega * accelerations.1])?;
        Ok(Self { duration, start, end, delta, even, odd, excess, omega, accelerations })
    }
}

impl<F: Elementary> Curve<F> for TrigonometricVelocities<F> {
    fn duration(&self) -> F {
        self.duration
    }

    #[inline]
    fn at(&self, t: F) -> Sample<F> {
        let place = Place::new(t, self.duration);
        let ((base, near), (_, far)) =
            if place.from_end { (self.end, self.start) } else { (self.start, self.end) };
        // Of half the angle π·u from the nearer end.
        let (sine, cosine) = (F::from_f64(0.5 * PI) * place.near).sin_cos();
        let (square, product) = (sine * sine, sine * cosine);
        let whole_sine = product + product;
        let whole_cosine = place.forward((cosine - sine) * (cosine + sine));
        let (even, odd) = self.accelerations;
        Sample {
            position: base
                + (place.forward(self.delta * square + self.even * (place.near - square))
                    + self.odd * product),
            velocity: near * cosine * cosine + far * square + self.excess * product,
            acceleration: even * whole_cosine - odd * whole_sine,
            jerk: -self.omega * (even * whole_sine + odd * whole_cosine),
        }
    }
}

impl TrigonometricVelocities {
    /// Times at which a·r² + b·r + c = 0 for r = tan(π·u/2) > 0.
    fn times(&self, a: f64, b: f64, c: f64) -> impl Iterator<Item = (f64, Turn)> {
        let duration = self.duration;
        let time = move |r: f64| duration * (2.0 / PI) * Elementary::atan(r);
        quadratic(a, b, c).into_iter().filter(|&(r, _)| r > 0.0).map(move |(r, turn)| (time(r), turn))
    }
}

/// The velocity is cos²(π·u/2) times a quadratic in r = tan(π·u/2),
///
/// ```text
/// v₁·r² + K·r + v₀
/// ```
///
/// so that the motion stands still twice at most.
impl Answers for TrigonometricVelocities {
    fn stationary(&self) -> Stationary {
        let (v0, v1) = (self.start.1, self.end.1);
        if [v0, v1, self.delta].iter().all(|x| x.abs() <= 0.0) {
            return Stationary::everywhere(self.duration);
        }
        Stationary::at(self.times(v1, self.excess, v0), self.duration)
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        let (even, odd) = self.accelerations;
        let times = match quantity {
            Quantity::Position => self.times(self.end.1, self.excess, self.start.1),
            // even·cos π·u = odd·sin π·u; the jerk's derivative is a multiple of the acceleration.
            Quantity::Velocity | Quantity::Jerk => self.times(-even, -2.0 * odd, even),
            // even·sin π·u = −odd·cos π·u.
            Quantity::Acceleration => self.times(-odd, 2.0 * even, odd),
        };
        times.map(|(time, _)| time).collect()
    }
}
