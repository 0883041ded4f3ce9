//! Appendix A.2.

use super::{Number, Printed};

/// A.2.2.
///
/// ```text
/// θ = −aₘ·T²/π²·sin(πt/T) + A·t + B     A = v₀ + aₘ·T/π     B = θ₀
/// ```
pub(crate) struct Sine<F> {
    rate: F,
    middle: F,
    a: F,
    b: F,
}

impl<F: Number> Sine<F> {
    pub(crate) fn new(duration: F, (from, v0): (F, F), middle: F) -> Self {
        Self { rate: F::PI() / duration, middle, a: v0 + middle * duration / F::PI(), b: from }
    }
}

impl<F: Number> Printed<F> for Sine<F> {
    #[inline]
    fn at(&self, t: F) -> [F; 3] {
        let Self { rate, middle, a, b } = *self;
        let (sine, cosine) = (t * rate).sin_cos();
        [-middle / (rate * rate) * sine + a * t + b, -middle / rate * cosine + a, middle * sine]
    }
}

/// A.2.3, with E11 and E12.
///
/// ```text
/// a = 2aₘ/(√3·T)·√(T² − (t − T)²)     x = asin((t − T)/T)
/// v = aₘ·T/√3·(x + ½·sin 2x) + v₀ + aₘ·T·π/2√3
/// θ = aₘ·T²/√3·(x·sin x + cos x − ⅓·cos³x) + v₀·t + aₘ·T·π·t/2√3 + θ₀ − π·aₘ·T²/2√3
/// ```
pub(crate) struct QuarterEllipse<F> {
    duration: F,
    /// 2aₘ/(√3·T), aₘ·T/√3 and aₘ·T²/√3.
    scales: [F; 3],
    /// θ₀ − π·aₘ·T²/2√3 and v₀ + aₘ·T·π/2√3.
    constants: [F; 2],
}

impl<F: Number> QuarterEllipse<F> {
    pub(crate) fn new(duration: F, (from, v0): (F, F), middle: F) -> Self {
        let root = F::number(3.0).sqrt();
        let rate = middle * duration / root;
        let reach = rate * duration;
        Self {
            duration,
            scales: [F::number(2.0) * middle / (root * duration), rate, reach],
            constants: [from - F::FRAC_PI_2() * reach, v0 + F::FRAC_PI_2() * rate],
        }
    }
}

impl<F: Number> Printed<F> for QuarterEllipse<F> {
    #[inline]
    fn at(&self, t: F) -> [F; 3] {
        let Self { duration, scales: [scale, rate, reach], constants: [from, velocity] } = *self;
        let before = t - duration;
        let x = (before / duration).asin();
        let (sine, cosine) = x.sin_cos();
        let third = F::number(1.0 / 3.0);
        [
            reach * (x * sine + cosine - third * cosine * cosine * cosine) + velocity * t + from,
            rate * (x + sine * cosine) + velocity,
            scale * (duration * duration - before * before).sqrt(),
        ]
    }
}
