//! The thesis's hyperbolic curve with velocities.

use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary, Turn};
use crate::curve::{Curve, within};
use crate::error::{ProfileError, check_duration, check_finite, check_overflow};
use crate::range::{Range, Ranges};
use crate::roots::{bracketed, pieces};
use crate::sample::Sample;
use alloc::vec::Vec;
use core::ops::Bound::Excluded;

/// Durations with which the equations have no solution.
const POLES: [f64; 2] = [1.0, 2.827_181_757_169_648];

/// A motion from one position and velocity to another in the thesis's basis of hyperbolic functions.
///
/// ```text
/// x = x₀ + A·sinh(t/T) + B·t·sinh t + C·sinh t
///
/// | sinh 1 − sinh T/T      T·sinh T           | | A |   | x₁ − x₀ − v₀·sinh T |
/// | (cosh 1 − cosh T)/T    sinh T + T·cosh T  |·| B | = | v₁ − v₀·cosh T      |        C = v₀ − A/T
/// ```
///
/// The **shape of the curve depends on the unit of time** (E10), because t stands bare within sinh t: the motion of two
/// seconds from 0 to 5 with velocities of 1 and 5 is at 1.649 half way where time is in seconds, at 1.514 where it is in
/// minutes. There is no such curve for
/// durations of 1 and 2.827181757169648 units, whatever is asked of it (E9); it is inaccurate close to these, where it also
/// swings far out (2400 for a motion from 0 to 5 in 2.827). For long durations, from some 25 units on (in f32: 10), it would miss its
/// end, and is refused. Use [`Tension`](crate::displacement::Tension) for new work.
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.3.3 and §A.1.3, "with velocity constraints", with its velocity and acceleration corrected:
/// as printed, each has one D too many (E7).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hyperbolic<F = f64> {
    duration: F,
    from: F,
    to: F,
    start_velocity: F,
    /// A, B, C.
    constants: [F; 3],
}

impl<F: Elementary> Hyperbolic<F> {
    /// Over `duration` > 0, from one (position, velocity) to another.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, or at which less than a third of the digits of the solution would be right (which
    /// happens next to 1 and 2.827181757169648), so long that as many are lost on the way to the end; numbers that are not finite or
    /// lead to such.
    pub fn new(duration: F, (from, v0): (F, F), (to, v1): (F, F)) -> Result<Self, ProfileError> {
        check_duration(duration)?;
        check_finite("from", &[from])?;
        check_finite("to", &[to])?;
        check_finite("start velocity", &[v0])?;
        check_finite("end velocity", &[v1])?;
        let one = F::from_f64(1.0);
        // Both equations divided by sinh T.
        let (sinh, cosh) = (duration.sinh(), duration.cosh());
        if !sinh.is_finite() || !cosh.is_finite() {
            return Err(no_solution::<F>(duration, "its hyperbolic sine is too large"));
        }
        let (sinh1, cosh1, coth) = (one.sinh(), one.cosh(), cosh / sinh);
        let position = (sinh1 / sinh - one / duration, duration, (to - from) / sinh - v0);
        let velocity = ((cosh1 / sinh - coth) / duration, one + duration * coth, v1 / sinh - v0 * coth);
        let (forth, back) = (position.0 * velocity.1, position.1 * velocity.0);
        let determinant = forth - back;
        // The sum of the sizes of all that the determinant is a sum of.
        let size =
            (sinh1 / sinh + one / duration) * velocity.1 + position.1 * (cosh1 / sinh + coth) / duration;
        if determinant.value().abs() <= Elementary::powf(F::EPSILON, 2.0 / 3.0) * size.value() {
            return Err(no_solution::<F>(
                duration,
                "the equations have no solution for 1 and 2.827181757169648",
            ));
        }
        let a = (position.2 * velocity.1 - position.1 * velocity.2) / determinant;
        let b = (position.0 * velocity.2 - velocity.0 * position.2) / determinant;
        let curve = Self { duration, from, to, start_velocity: v0, constants: [a, b, v0 - a / duration] };
        check_overflow("constant", &curve.constants)?;
        check_overflow("largest jerk", &curve.series(duration))?;
        if curve.misses(v1) {
            let why = "too few digits are left of the solution, and the curve misses its end";
            return Err(refused::<F>(duration, why, duration.value()));
        }
        Ok(curve)
    }

    /// Whether it ends farther from where it should, or at another velocity, than a third of the digits allows.
    fn misses(&self, v1: F) -> bool {
        let [way, velocity, ..] = self.series(self.duration);
        let (wanted, duration) = (self.to - self.from, self.duration.value());
        let speed = self.start_velocity.value().abs().max(v1.value().abs());
        let least = Elementary::powf(F::EPSILON, 1.0 / 3.0) * wanted.value().abs().max(speed * duration);
        let off = (way - wanted).value().abs().max((velocity - v1).value().abs() * duration);
        off > least
    }

    /// Way, velocity, acceleration, jerk and the derivative of that.
    #[inline]
    fn series(&self, t: F) -> [F; 5] {
        let [a, b, c] = self.constants;
        let rate = F::from_f64(1.0) / self.duration;
        let (slow_sinh, slow_cosh) = ((t * rate).sinh(), (t * rate).cosh());
        let (sinh, cosh) = (t.sinh(), t.cosh());
        // The n-th derivative of t·sinh t is t·sinh t + n·cosh t or t·cosh t + n·sinh t.
        let even = |n: f64, a: F| a * slow_sinh + b * (t * sinh + F::from_f64(n) * cosh) + c * sinh;
        let odd = |n: f64, a: F| a * slow_cosh + b * (t * cosh + F::from_f64(n) * sinh) + c * cosh;
        let (a1, a2) = (a * rate, a * rate * rate);
        [even(0.0, a), odd(1.0, a1), even(2.0, a2), odd(3.0, a2 * rate), even(4.0, a2 * rate * rate)]
    }
}

impl<F: Elementary> Curve<F> for Hyperbolic<F> {
    fn duration(&self) -> F {
        self.duration
    }

    fn at(&self, t: F) -> Sample<F> {
        let [way, velocity, acceleration, jerk, _] = self.series(within(t, self.duration));
        Sample { position: self.from + way, velocity, acceleration, jerk }
    }
}

/// By Rolle's theorem: with
///
/// ```text
/// g = v/cosh t        g′/(1 + sech² t) = A/T·φ + B        φ = (cosh(t/T)/cosh t)′/(1 + sech² t)
/// ```
///
/// φ has one extremum at most (seen in numbers, not proved), so that g′ has two zeros at most and v three.
impl Answers for Hyperbolic {
    fn stationary(&self) -> Stationary {
        let [a, b, _] = self.constants;
        let (duration, rate) = (self.duration, 1.0 / self.duration);
        let still = |x: f64| x.abs() <= 0.0;
        if still(self.start_velocity) && still(a) && still(b) {
            return Stationary::everywhere(duration);
        }
        // The numerator of (cosh(t/T)/cosh t)′ over cosh² t, and its derivative.
        let parts = |t: f64| {
            let (sinh, cosh) = (Elementary::sinh(t * rate), Elementary::cosh(t * rate));
            let (tanh, sech) = (Elementary::tanh(t), 1.0 / Elementary::cosh(t));
            let numerator = rate * sinh - cosh * tanh;
            let slope = rate * rate * cosh - rate * sinh * tanh - cosh * sech * sech;
            (numerator, slope, tanh, sech)
        };
        let phi = |t: f64| {
            let (numerator, _, _, sech) = parts(t);
            numerator * sech / (1.0 + sech * sech)
        };
        let phi_slope = |t: f64| {
            let (numerator, slope, tanh, sech) = parts(t);
            slope * (1.0 + sech * sech) - numerator * Elementary::powi(tanh, 3)
        };
        let turns = phi_slope(0.0).signum() * phi_slope(duration) < 0.0;
        let extremum = turns.then(|| bracketed(phi_slope, 0.0, duration));
        let none = |_: f64| 0.0;
        let cuts = pieces(|t| a * rate * phi(t) + b, none, extremum, (0.0, duration));
        let velocity = |t: f64| self.at(t).velocity;
        let noise = |t: f64| {
            let (sinh, cosh) = (Elementary::sinh(t), Elementary::cosh(t));
            let [a, b, c] = self.constants.map(f64::abs);
            8.0 * f64::EPSILON * (a * rate * Elementary::cosh(t * rate) + b * (sinh + t * cosh) + c * cosh)
        };
        Stationary::at(pieces(velocity, noise, cuts.into_iter().map(|(t, _)| t), (0.0, duration)), duration)
    }

    /// Those of acceleration and jerk by the changes of sign over a thousandth of the duration: two that are closer to each
    /// other are missed, between which nothing changes.
    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        let order = match quantity {
            Quantity::Position => {
                return self.stationary().points.into_iter().map(|point| point.time).collect();
            }
            Quantity::Velocity => 2,
            Quantity::Acceleration => 3,
            Quantity::Jerk => 4,
        };
        let derivative = |t: f64| self.series(t)[order];
        let grid = (1..1000).map(|i| f64::from(i) / 1000.0 * self.duration);
        let zeros: Vec<(f64, Turn)> = pieces(derivative, |_| 0.0, grid, (0.0, self.duration));
        zeros.into_iter().map(|(t, _)| t).collect()
    }
}

fn no_solution<F: Elementary>(duration: F, why: &'static str) -> ProfileError {
    // ln(2·MAX), beyond which sinh and cosh overflow.
    refused(duration, why, if F::EPSILON > 1e-10 { 89.0 } else { 710.0 })
}

fn refused<F: Elementary>(duration: F, why: &'static str, largest: f64) -> ProfileError {
    let between = |low, high| Range::new(Excluded(low), Excluded(high));
    let feasible =
        Ranges::new([between(0.0, POLES[0]), between(POLES[0], POLES[1]), between(POLES[1], largest)]);
    ProfileError::Infeasible { what: "duration", value: duration.value(), why, feasible }
}
