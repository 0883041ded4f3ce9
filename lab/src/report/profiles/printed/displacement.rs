//! Appendix A.1.

use super::solve::solve;
use super::{Number, Printed};

/// A.1.1 without velocities.
///
/// ```text
/// θ = θ₁·(A·sin(πt/T − π/2) + B)     A = (θ₁ − θ₀)/2θ₁     B = (θ₁ + θ₀)/2θ₁
/// ```
pub(crate) struct Trigonometric<F> {
    rate: F,
    to: F,
    a: F,
    b: F,
}

impl<F: Number> Trigonometric<F> {
    pub(crate) fn new(duration: F, from: F, to: F) -> Self {
        let two = F::number(2.0);
        Self { rate: F::PI() / duration, to, a: (to - from) / (two * to), b: (to + from) / (two * to) }
    }
}

impl<F: Number> Printed<F> for Trigonometric<F> {
    #[inline]
    fn at(&self, t: F) -> [F; 3] {
        let Self { rate, to, a, b } = *self;
        let (sine, cosine) = (t * rate - F::FRAC_PI_2()).sin_cos();
        [to * (a * sine + b), to * (a * rate * cosine), -to * (a * rate * rate * sine)]
    }
}

/// A.1.1 with velocities, with E1 and E2.
///
/// ```text
/// θ = θ₁·(A·sin(πt/T − Bπ/2) + C·t + D)
/// k₁ = 1 − θ₀/θ₁ − T·(v₀ + v₁)/2θ₁     k₂ = (v₀ − v₁)/2θ₁     B = 2/π·atan(k₁π/2Tk₂)
/// A = T·k₂/(π·cos(Bπ/2))     C = (v₀ + v₁)/2θ₁     D = θ₀/θ₁ + A·sin(Bπ/2)
/// ```
pub(crate) struct TrigonometricVelocities<F> {
    rate: F,
    to: F,
    phase: F,
    a: F,
    c: F,
    d: F,
}

impl<F: Number> TrigonometricVelocities<F> {
    pub(crate) fn new(duration: F, (from, v0): (F, F), (to, v1): (F, F)) -> Self {
        let (one, two) = (F::one(), F::number(2.0));
        let k1 = one - from / to - duration * (v0 + v1) / (two * to);
        let k2 = (v0 - v1) / (two * to);
        let b = two / F::PI() * (k1 * F::PI() / (two * duration * k2)).atan();
        let phase = b * F::PI() / two;
        let a = duration * k2 / (F::PI() * phase.cos());
        let c = (v0 + v1) / (two * to);
        Self { rate: F::PI() / duration, to, phase, a, c, d: from / to + a * phase.sin() }
    }
}

impl<F: Number> Printed<F> for TrigonometricVelocities<F> {
    #[inline]
    fn at(&self, t: F) -> [F; 3] {
        let Self { rate, to, phase, a, c, d } = *self;
        let (sine, cosine) = (t * rate - phase).sin_cos();
        [to * (a * sine + c * t + d), to * (a * rate * cosine + c), -to * (a * rate * rate * sine)]
    }
}

/// A.1.2 with s, with E5.
///
/// ```text
/// θ = θ₁·(A·(t − T/s)ⁿ + (T/s)ⁿ)/(B·(T/s)ⁿ)
/// A = (θ₁ − θ₀)/((s − 1)ⁿ·θ₀ − (−1)ⁿ·θ₁)     B = A·(s − 1)ⁿ + 1
/// ```
pub(crate) struct Exponential<F> {
    to: F,
    a: F,
    below: F,
    pole: F,
    power: F,
    n: i32,
    count: F,
}

impl<F: Number> Exponential<F> {
    pub(crate) fn new(duration: F, from: F, to: F, n: i32, s: F) -> Self {
        let one = F::one();
        let sign = (-one).powi(n);
        let a = (to - from) / ((s - one).powi(n) * from - sign * to);
        let b = a * (s - one).powi(n) + one;
        let pole = duration / s;
        let power = pole.powi(n);
        Self { to, a, below: b * power, pole, power, n, count: F::number(f64::from(n)) }
    }
}

impl<F: Number> Printed<F> for Exponential<F> {
    #[inline]
    fn at(&self, t: F) -> [F; 3] {
        let Self { to, a, below, pole, power, n, count } = *self;
        let y = t - pole;
        let y2 = y.powi(n - 2);
        let (y1, y0) = (y2 * y, y2 * y * y);
        [
            to * ((a * y0 + power) / below),
            to * (a * count * y1 / below),
            to * (a * count * (count - F::one()) * y2 / below),
        ]
    }
}

/// A.1.2 with velocities: four linear equations for A to D.
///
/// ```text
/// θ = θ₁·(A·(t − T/s)ⁿ + B·(t − T/s)ⁿ⁻¹ + C·(t − T/s)ⁿ⁻² + D)
/// ```
pub(crate) struct ExponentialVelocities<F> {
    to: F,
    pole: F,
    n: i32,
    position: [F; 4],
    velocity: [F; 3],
    acceleration: [F; 3],
}

impl<F: Number> ExponentialVelocities<F> {
    pub(crate) fn new(duration: F, (from, v0): (F, F), (to, v1): (F, F), n: i32, s: F) -> Self {
        let (zero, one) = (F::zero(), F::one());
        let pole = duration / s;
        let count = |less: i32| F::number(f64::from(n - less));
        let position = |t: F| {
            let y = t - pole;
            [y.powi(n), y.powi(n - 1), y.powi(n - 2), one]
        };
        let velocity = |t: F| {
            let y = t - pole;
            [count(0) * y.powi(n - 1), count(1) * y.powi(n - 2), count(2) * y.powi(n - 3), zero]
        };
        let rows = [position(zero), position(duration), velocity(zero), velocity(duration)];
        let [a, b, c, d] = solve(rows, [from / to, one, v0 / to, v1 / to]);
        let rate = [a * count(0), b * count(1), c * count(2)];
        Self {
            to,
            pole,
            n,
            position: [a, b, c, d],
            velocity: rate,
            acceleration: [rate[0] * count(1), rate[1] * count(2), rate[2] * count(3)],
        }
    }
}

impl<F: Number> Printed<F> for ExponentialVelocities<F> {
    #[inline]
    fn at(&self, t: F) -> [F; 3] {
        let Self { to, pole, n, position: [a, b, c, d], velocity: v, acceleration: w } = *self;
        let y = t - pole;
        let y4 = y.powi(n - 4);
        let (y3, y2) = (y4 * y, y4 * y * y);
        let (y1, y0) = (y2 * y, y2 * y * y);
        [
            to * (a * y0 + b * y1 + c * y2 + d),
            to * (v[0] * y1 + v[1] * y2 + v[2] * y3),
            to * (w[0] * y2 + w[1] * y3 + w[2] * y4),
        ]
    }
}

/// A.1.3 with velocities, with E7: four linear equations for A to D.
///
/// ```text
/// θ = θ₁·(A·sinh(t/T) + B·t·sinh t + C·sinh t + D)
/// ```
pub(crate) struct HyperbolicVelocities<F> {
    to: F,
    duration: F,
    constants: [F; 4],
}

impl<F: Number> HyperbolicVelocities<F> {
    pub(crate) fn new(duration: F, (from, v0): (F, F), (to, v1): (F, F)) -> Self {
        let (zero, one) = (F::zero(), F::one());
        let position = |t: F| [(t / duration).sinh(), t * t.sinh(), t.sinh(), one];
        let velocity = |t: F| [(t / duration).cosh() / duration, t.sinh() + t * t.cosh(), t.cosh(), zero];
        let rows = [position(zero), position(duration), velocity(zero), velocity(duration)];
        Self { to, duration, constants: solve(rows, [from / to, one, v0 / to, v1 / to]) }
    }
}

impl<F: Number> Printed<F> for HyperbolicVelocities<F> {
    #[inline]
    fn at(&self, t: F) -> [F; 3] {
        let Self { to, duration, constants: [a, b, c, d] } = *self;
        let (slow, fast) = ((t / duration).sinh(), t.sinh());
        let (slow_rate, fast_rate) = ((t / duration).cosh(), t.cosh());
        [
            to * (a * slow + b * t * fast + c * fast + d),
            to * (a / duration * slow_rate + b * fast + b * t * fast_rate + c * fast_rate),
            to * (a / (duration * duration) * slow
                + F::number(2.0) * b * fast_rate
                + b * t * fast
                + c * fast),
        ]
    }
}
