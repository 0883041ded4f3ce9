//! Squad: a smooth turn through orientations at given times.

use super::motion::{Motion, exp, exp_of, log, shortest};
use super::{Turning, checked};
use crate::Elementary;
use crate::curve::within;
use crate::error::{ProfileError, check_finite, check_overflow};
use alloc::vec::Vec;
use core::f64::consts::FRAC_PI_2;
use nalgebra::{UnitQuaternion, Vector3};

/// Spherical quadrangle interpolation through keys at any times: orientation and angular velocity are continuous, the angular
/// acceleration jumps at keys.
///
/// ```text
/// q(u) = slerp(slerp(q₀, q₁, u), slerp(s₀, s₁, u), 2u(1 − u))        u = (t − t₀)/h
/// s₀ = q₀·e^((h·Ω₀ − L)/2)    s₁ = q₁·e^((L − h·Ω₁)/2)    L = log(q₀⁻¹·q₁)
/// Ωᵢ = (hᵢ·Lᵢ₋₁/hᵢ₋₁ + hᵢ₋₁·Lᵢ/hᵢ)/(hᵢ₋₁ + hᵢ)
/// ```
///
/// 2·Ω is the angular velocity at a key: that of the parabola through the key and its neighbours; at the first and last key, that
/// of the chord. Through two keys it is a slerp. Where spans are so uneven that a quadrangle would be more than a quarter turn
/// wide (|h·Ω − L| > π/2), Ω is made smaller, so that the curve never runs over the back of the sphere.
///
/// # Source
///
/// K. Shoemake, "Quaternion calculus and fast animation", SIGGRAPH course notes (1987), for keys at even times, where the
/// quadrangle is his: s = q·e^(−(log(q⁻¹·q₊) + log(q⁻¹·q₋))/4). That one point would not do for spans of unequal length: the
/// angular velocity would jump; here each span has its own.
#[doc(alias = "spherical quadrangle interpolation")]
#[doc(alias = "quaternion spline")]
#[derive(Clone, Debug, PartialEq)]
pub struct Squad {
    /// Since the first key.
    times: Vec<f64>,
    spans: Vec<Span>,
}

/// Between two keys.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Span {
    from: UnitQuaternion<f64>,
    /// log(q₀⁻¹·q₁).
    side: Vector3<f64>,
    /// s₀.
    inner: UnitQuaternion<f64>,
    /// log(s₀⁻¹·s₁).
    inner_side: Vector3<f64>,
}

impl Squad {
    /// Through keys at rising times (s); the first key is its beginning.
    ///
    /// # Errors
    ///
    /// Fewer than two keys; times that are not finite or do not rise; an orientation that is not finite or whose quaternion is
    /// not of length 1 (to 1e-6); an angular velocity that overflows.
    pub fn new(keys: &[(f64, UnitQuaternion<f64>)]) -> Result<Self, ProfileError> {
        let count = keys.len();
        if count < 2 {
            return Err(ProfileError::Count { what: "keys", found: count, needed: 2 });
        }
        for (index, &(time, _)) in keys.iter().enumerate() {
            check_finite("time of a key", &[time])?;
            let before = if index > 0 { keys[index - 1].0 } else { f64::NEG_INFINITY };
            if time <= before {
                return Err(ProfileError::Knots { index, time, before });
            }
        }
        let times: Vec<f64> = keys.iter().map(|(time, _)| time - keys[0].0).collect();
        check_overflow("duration", &times[count - 1..])?;
        // Far from zero, times that rise may not rise once the first is subtracted.
        if let Some(index) = (1..count).find(|&i| times[i] <= times[i - 1]) {
            return Err(ProfileError::Knots { index, time: keys[index].0, before: keys[index - 1].0 });
        }
        let orientations = keys.iter().map(|(_, q)| checked(q)).collect::<Result<Vec<_>, _>>()?;
        let lengths: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let sides: Vec<_> = orientations.windows(2).map(|pair| shortest(&pair[0], &pair[1])).collect();
        let rates = rates(&lengths, &sides)?;
        let spans: Vec<Span> = (0..count - 1)
            .map(|i| Span::new(orientations[i], sides[i], rates[i] * lengths[i], rates[i + 1] * lengths[i]))
            .collect();
        for (span, length) in spans.iter().zip(&lengths) {
            for u in [0.0, 1.0] {
                check_overflow("angular acceleration", span.at(u, 1.0 / length).acceleration.as_slice())?;
            }
        }
        Ok(Self { times, spans })
    }

    /// From the first key to the last (s).
    pub fn duration(&self) -> f64 {
        self.times[self.times.len() - 1]
    }

    /// The orientation at a time since the first key, held at the ends; a time that is NaN gives NaN. Allocates nothing.
    ///
    /// At a key, the angular acceleration is what holds after it, and at the last one what holds before.
    pub fn at(&self, t: f64) -> Turning {
        let t = within(t, self.duration());
        let i = self.times.partition_point(|&time| time <= t).clamp(1, self.spans.len()) - 1;
        let length = self.times[i + 1] - self.times[i];
        self.spans[i].at((t - self.times[i]) / length, 1.0 / length)
    }
}

impl Span {
    /// From the rates times the length of the span at its ends.
    fn new(from: UnitQuaternion<f64>, side: Vector3<f64>, start: Vector3<f64>, end: Vector3<f64>) -> Self {
        let unit = UnitQuaternion::new_normalize;
        let to = from.into_inner() * exp(side);
        let inner = unit(from.into_inner() * exp((start - side) * 0.5));
        let inner_to = unit(to * exp((side - end) * 0.5));
        let inner_side = log(inner.into_inner().conjugate() * inner_to.into_inner());
        Self { from, side, inner, inner_side }
    }

    fn at(&self, u: f64, rate: f64) -> Turning {
        let outer = Motion::along(self.from, self.side, [u, 1.0, 0.0]);
        let inner = Motion::along(self.inner, self.inner_side, [u, 1.0, 0.0]);
        let across = outer.conjugate().product(inner).log();
        // p = 2u(1 − u), p′ = 2 − 4u, p″ = −4.
        let (p, dp, ddp) = (2.0 * u * (1.0 - u), 2.0 - 4.0 * u, -4.0);
        let [a, da, dda] = across;
        let part = exp_of([a * p, a * dp + da * p, a * ddp + da * (2.0 * dp) + dda * p]);
        let Motion([q, dq, ddq]) = outer.product(part);
        // q⁻¹·q′ = ω/2, and the rate of that is the vector part of q⁻¹·q″.
        let back = q.conjugate();
        Turning {
            orientation: UnitQuaternion::new_normalize(q),
            velocity: (back * dq).imag() * (2.0 * rate),
            acceleration: (back * ddq).imag() * (2.0 * rate * rate),
        }
    }
}

/// Ω at all keys.
fn rates(lengths: &[f64], sides: &[Vector3<f64>]) -> Result<Vec<Vector3<f64>>, ProfileError> {
    let chords: Vec<Vector3<f64>> = sides.iter().zip(lengths).map(|(side, &h)| side / h).collect();
    let last = chords.len();
    let mut rates = Vec::with_capacity(last + 1);
    rates.push(chords[0]);
    for i in 1..last {
        let share = 1.0 / (1.0 + lengths[i] / lengths[i - 1]);
        let rate = chords[i - 1] * (1.0 - share) + chords[i] * share;
        let part = largest_part(rate, lengths[i - 1], sides[i - 1]);
        rates.push(rate * part.min(largest_part(rate, lengths[i], sides[i])));
    }
    rates.push(chords[last - 1]);
    for rate in &rates {
        check_overflow("angular velocity", (rate * 2.0).as_slice())?;
    }
    Ok(rates)
}

/// The greatest λ up to 1 with |λ·h·Ω − L| ≤ π/2. There is one, since |L| ≤ π/2.
fn largest_part(rate: Vector3<f64>, length: f64, side: Vector3<f64>) -> f64 {
    let reach = rate * length;
    if (reach - side).norm() <= FRAC_PI_2 {
        return 1.0;
    }
    let along = reach.dot(&side) / reach.norm();
    let room = (FRAC_PI_2 * FRAC_PI_2 - side.norm_squared()).max(0.0);
    let part = (along + Elementary::sqrt(along * along + room)) / reach.norm();
    part.clamp(0.0, 1.0)
}
