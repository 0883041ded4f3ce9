//! The curve that is a power of a shifted time multiplied by a quadratic, with given velocities at the ends.

use super::{Place, check_motion, check_velocities};
use crate::Elementary;
use crate::answers::{Answers, Quantity, Stationary, Turn};
use crate::curve::Curve;
use crate::error::{ProfileError, check_finite, check_overflow, check_range};
use crate::range::{Range, Ranges};
use crate::roots::{bernstein, quadratic};
use crate::sample::Sample;
use alloc::vec::Vec;
use core::ops::Bound::{Excluded, Unbounded};

/// The greatest exponent: not far beyond it, binomial coefficients are more than `f32` can hold.
const LARGEST_EXPONENT: u32 = 100;

/// A motion from one position and velocity to another along a polynomial of degree n whose velocity is the power n − 3 of a shifted
/// time, multiplied by a quadratic.
///
/// ```text
/// v = yᵐ·(v₀·(1 − u)² + H·u·(1 − u) + v₁/rᵐ·u²)        u = t/T,  y = 1 − s·u,  r = 1 − s,  m = n − 3
/// ```
///
/// H is such that the end is met. With the moments
///
/// ```text
/// A₀ = Σ (m−k+1)·(m−k+2)·rᵏ    A₁ = Σ (k+1)·(m−k+1)·rᵏ    A₂ = Σ (k+1)·(k+2)·rᵏ    k = 0 … m
/// N = (m+1)·(m+2)·(m+3)
/// H = (N·(x₁ − x₀)/T − A₀·v₀ − A₂·v₁/rᵐ)/A₁
/// ```
///
/// With n = 3, whatever s, and with s = 0, whatever n, the curve is the cubic. s < 1 always does; s > 1 with an even n makes
/// the motion turn round at u = 1/s, s = 2 with an even n > 3 and s = 1 with n > 3 have no solution. Unlike the other
/// curves, this one may swing far beyond both of its ends: for a large n, and for s close to 1, or to 2 with an even n.
/// From 0 to 5 in 1 s with velocities 1 and 2, n = 20 and s = −2, it swings out to 38 000. [`within`](Self::within) refuses that.
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.3.2 and §A.1.2, "exponential with velocity constraints", whose constants are the solution of
/// four linear equations in the basis (t − T/s)ⁿ, (t − T/s)ⁿ⁻¹, (t − T/s)ⁿ⁻², 1. These have no solution for s = 0, lose all
/// digits for a small s, and give NaN for n = 3 at t = T/s. Here the position is evaluated in Bernstein form. That n = 3 with
/// s = 2 has no solution, as the thesis says, is not so; n = 4 with s = 2 has none (E6).
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Curve, displacement::ExponentialVelocities};
///
/// let curve = ExponentialVelocities::new(2.0, (1.0, 1.0), (4.0, 2.0), 5, -0.5)?.within(10.0)?;
/// assert_eq!((curve.at(2.0).position, curve.at(0.0).velocity), (4.0, 1.0));
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExponentialVelocities<F = f64> {
    duration: F,
    shape: F,
    /// n − 3.
    power: u32,
    /// D, v₀ and v₁.
    motion: (F, F, F),
    /// The curve from the start on, and backwards from the end.
    halves: [Half<F>; 2],
}

/// Everything that a curve from the start, or the same curve backwards, is evaluated by.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Half<F> {
    /// The position at the beginning.
    base: F,
    /// r.
    rest: F,
    /// The quadratic factor of the velocity and those of its derivatives, each multiplied by T, T² or T³, in Bernstein form.
    quadratics: [[F; 3]; 3],
}

impl<F: Elementary> ExponentialVelocities<F> {
    /// Over `duration` > 0, from one (position, velocity) to another, with an `exponent` n from 3 to 100 and the `shape` s.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, an exponent outside of 3 to 100, a shape for which there is no solution, numbers that
    /// are not finite or lead to such.
    pub fn new(
        duration: F,
        start: (F, F),
        end: (F, F),
        exponent: u32,
        shape: F,
    ) -> Result<Self, ProfileError> {
        check_motion(duration, start.0, end.0)?;
        check_velocities(start.1, end.1)?;
        let moments = Moments::new(exponent, shape)?;
        let power = exponent - 3;
        // The cubic does not depend on the shape.
        let shape = if power == 0 { F::from_f64(0.0) } else { shape };
        let (delta, rest) = (end.0 - start.0, F::from_f64(1.0) - shape);
        let scale = rest.powi(power);
        let last = end.1 / scale;
        let [a0, a1, a2] = moments.sums;
        let middle = F::from_f64(0.5) * (moments.whole * (delta / duration) - a0 * start.1 - a2 * last) / a1;
        let forward = Half::new(duration, start.0, power, rest, [start.1, middle, last]);
        // y/r = u + (1 − u)/r: backwards, the curve is of the same kind with 1/r.
        let back = [end.1, scale * middle, scale * start.1];
        let backward = Half::new(duration, end.0, power, F::from_f64(1.0) / rest, back);
        let curve =
            Self { duration, shape, power, motion: (delta, start.1, end.1), halves: [forward, backward] };
        check_overflow("distance", &[delta])?;
        for half in &curve.halves {
            check_overflow("largest jerk", half.quadratics.as_flattened())?;
            check_overflow("largest jerk", &[half.rest, half.rest.powi(power + 2)])?;
        }
        Ok(curve)
    }

    /// The same curve, if its position stays between −`bound` and `bound`, in the unit of the positions.
    ///
    /// # Errors
    ///
    /// The greatest position in magnitude, where it is more than that.
    pub fn within(self, bound: f64) -> Result<Self, ProfileError> {
        let times = self.still().into_iter().map(|(u, _)| u).chain([0.0, 1.0]);
        let size = |u: f64| self.at(self.duration * F::from_f64(u)).position.value().abs();
        check_range("largest position", times.map(size).fold(0.0, f64::max), Range::at_most(bound))?;
        Ok(self)
    }

    /// Fractions of the duration at which the velocity is zero.
    fn still(&self) -> Vec<(f64, Turn)> {
        let [q0, q1, q2] = self.halves[0].quadratics[0].map(Elementary::value);
        // The quadratic is (1 − u)² times q₂·ρ² + 2·q₁·ρ + q₀ in ρ = u/(1 − u).
        let roots = quadratic(q2, 2.0 * q1, q0).into_iter().filter(|&(ratio, _)| ratio > 0.0);
        let mut still: Vec<_> = roots.map(|(ratio, turn)| (1.0 / (1.0 + 1.0 / ratio), turn)).collect();
        if self.shape.value() > 1.0 && self.power > 0 {
            let mut odd = self.power % 2 == 1;
            let u = 1.0 / self.shape.value();
            // Where the quadratic is zero too, the orders add up.
            still.retain(|&(root, turn)| {
                let same = (root - u).abs() <= 4.0 * f64::EPSILON * u;
                odd ^= same && turn == Turn::Reversal;
                !same
            });
            still.push((u, if odd { Turn::Reversal } else { Turn::Touch }));
        }
        still
    }
}

impl<F: Elementary> Half<F> {
    fn new(duration: F, base: F, power: u32, rest: F, velocity: [F; 3]) -> Self {
        let acceleration = derivative(power, rest, velocity);
        let jerk = derivative(power.saturating_sub(1), rest, acceleration);
        let (acceleration, jerk) =
            (acceleration.map(|q| q / duration), jerk.map(|q| q / duration / duration));
        Self { base, rest, quadratics: [velocity, acceleration, jerk] }
    }

    /// The way gone at a fraction of up to one half, divided by T/(n·(m + 1)·(m + 2)): by the Bernstein coefficients
    ///
    /// ```text
    /// b₀ = 0,  bₖ₊₁ = bₖ + T/n·cₖ
    /// (m+1)·(m+2)·cₖ = (m+2−k)·(m+1−k)·rᵏ·q₀ + 2·k·(m+2−k)·rᵏ⁻¹·q₁ + k·(k−1)·rᵏ⁻²·q₂
    /// ```
    ///
    /// where c are the coefficients of the velocity, the product of those of yᵐ and q.
    fn way(&self, place: &Place<F>, power: u32) -> F {
        let [q0, q1, q2] = self.quadratics[0];
        let (zero, one) = (F::from_f64(0.0), F::from_f64(1.0));
        let ratio = place.near / place.far;
        // C(n, k)·uᵏ·(1 − u)ⁿ⁻ᵏ; rᵏ, rᵏ⁻¹, rᵏ⁻².
        let mut weight = place.far.powi(power + 3);
        let mut powers = [one, zero, zero];
        let (mut b, mut sum) = (zero, zero);
        for k in 0..=power + 2 {
            let number = |i: u32| F::from_f64(f64::from(i));
            let (step, left) = (number(k), number(power + 2 - k));
            b = b
                + left * (left - one) * powers[0] * q0
                + (step + step) * left * powers[1] * q1
                + step * (step - one) * powers[2] * q2;
            weight = weight * ratio * number(power + 3 - k) / number(k + 1);
            sum += b * weight;
            powers = [powers[0] * self.rest, powers[0], powers[1]];
        }
        sum
    }
}

impl<F: Elementary> Curve<F> for ExponentialVelocities<F> {
    fn duration(&self) -> F {
        self.duration
    }

    fn at(&self, t: F) -> Sample<F> {
        let place = Place::new(t, self.duration);
        let half = &self.halves[usize::from(place.from_end)];
        let m = self.power;
        let share = F::from_f64(1.0 / f64::from((m + 1) * (m + 2) * (m + 3)));
        let factor = |i: usize| {
            let [a, b, c] = half.quadratics[i];
            let (first, last) = (a * place.far + b * place.near, b * place.far + c * place.near);
            first * place.far + last * place.near
        };
        let y = place.far + half.rest * place.near;
        let jerk_power = y.powi(m.saturating_sub(2));
        let acceleration_power = if m > 1 { jerk_power * y } else { jerk_power };
        let velocity_power = if m > 0 { acceleration_power * y } else { acceleration_power };
        Sample {
            position: half.base + place.forward(self.duration * share * half.way(&place, m)),
            velocity: velocity_power * factor(0),
            acceleration: place.forward(acceleration_power * factor(1)),
            jerk: jerk_power * factor(2),
        }
    }
}

impl Answers for ExponentialVelocities {
    fn stationary(&self) -> Stationary {
        let (delta, v0, v1) = self.motion;
        if [delta, v0, v1].iter().all(|x| x.abs() <= 0.0) {
            return Stationary::everywhere(self.duration);
        }
        Stationary::at(self.still().into_iter().map(|(u, turn)| (u * self.duration, turn)), self.duration)
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        let [_, acceleration, jerk] = self.halves[0].quadratics;
        let roots = match quantity {
            Quantity::Position => self.still(),
            Quantity::Velocity => bernstein(&acceleration),
            Quantity::Acceleration => bernstein(&jerk),
            Quantity::Jerk => bernstein(&derivative(self.power.saturating_sub(2), self.halves[0].rest, jerk)),
        };
        // The power itself is zero at 1/s.
        let own = (self.shape > 1.0).then(|| 1.0 / self.shape);
        roots.into_iter().map(|(u, _)| u).chain(own).map(|u| u * self.duration).collect()
    }
}

/// The moments A₀, A₁, A₂ of yᵐ with (1 − u)², u·(1 − u), u², and N.
pub(crate) struct Moments<F> {
    pub(crate) sums: [F; 3],
    pub(crate) whole: F,
}

impl<F: Elementary> Moments<F> {
    /// Refuses an exponent outside of its range, and a shape for which there is no solution.
    pub(crate) fn new(exponent: u32, shape: F) -> Result<Self, ProfileError> {
        let range = Range::closed(3.0, f64::from(LARGEST_EXPONENT));
        check_range("exponent", f64::from(exponent), range)?;
        check_finite("shape", &[shape])?;
        let m = exponent - 3;
        let rest = if m == 0 { F::from_f64(1.0) } else { F::from_f64(1.0) - shape };
        let number = |x: u32| F::from_f64(f64::from(x));
        let mut sums = [F::from_f64(0.0); 3];
        // Beginning with the highest power, by Horner's rule.
        for k in (0..=m).rev() {
            let terms = [(m - k + 1) * (m - k + 2), (k + 1) * (m - k + 1), (k + 1) * (k + 2)];
            for (sum, term) in sums.iter_mut().zip(terms) {
                *sum = *sum * rest + number(term);
            }
        }
        let infeasible = |why| {
            let value = shape.value();
            let low = Range::new(Unbounded, Excluded(value));
            let feasible = Ranges::new([low, Range::new(Excluded(value), Unbounded)]);
            Err(ProfileError::Infeasible { what: "shape", value, why, feasible })
        };
        if rest.value().abs() <= 0.0 {
            return infeasible("with an exponent above 3 the velocity at the end is always zero");
        }
        if sums[1].value().abs() <= 0.0 {
            return infeasible("with an even exponent above 3 no motion reaches its end");
        }
        check_overflow("moment", &sums)?;
        Ok(Self { sums, whole: number((m + 1) * (m + 2) * (m + 3)) })
    }
}

/// q′ of yᵏ·q′ = d(yᵏ·q)/du without the power: yᵏ⁻¹·(y·dq/du − k·s·q), or dq/du itself where k = 0.
fn derivative<F: Elementary>(k: u32, rest: F, q: [F; 3]) -> [F; 3] {
    let (first, last) = (q[1] - q[0], q[2] - q[1]);
    if k == 0 {
        return [first + first, first + last, last + last];
    }
    let slope = [first + first, last + rest * first, rest * (last + last)];
    let rate = F::from_f64(f64::from(k)) * (F::from_f64(1.0) - rest);
    core::array::from_fn(|i| slope[i] - rate * q[i])
}
