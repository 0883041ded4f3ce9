//! Appendix A.3.

use super::{Number, Printed};

/// A.3.2, with E14, E15 and E16.
///
/// ```text
/// (v − α)² + (t − β)² = γ²
/// k₁ = (T² − T₁² + v₁² − vₘ²)/2(T − T₁)     k₂ = (v₁ − vₘ)/(T − T₁)
/// α = (vₘ² − v₀² − k₁² + (T₁ − k₁)²)/2(vₘ − v₀ − k₁k₂ − (T₁ − k₁)k₂)     β = k₁ − α·k₂     γ² = β² + (v₀ − α)²
/// θ = α·t ± ½·γ²·(½·sin 2x + x) + C     x = asin((t − β)/γ)
/// ```
///
/// The sign is that of the semicircle which v₀ lies on.
pub(crate) struct Circle<F> {
    alpha: F,
    beta: F,
    gamma: F,
    sign: F,
    constant: F,
}

impl<F: Number> Circle<F> {
    pub(crate) fn new(duration: F, from: F, (v0, v1): (F, F), (third_time, third_velocity): (F, F)) -> Self {
        let two = F::number(2.0);
        let (t1, vm) = (third_time, third_velocity);
        let rest = duration - t1;
        let k1 = ((duration * duration - t1 * t1) + (v1 * v1 - vm * vm)) / (two * rest);
        let k2 = (v1 - vm) / rest;
        let alpha = (vm * vm - v0 * v0 - k1 * k1 + (t1 - k1) * (t1 - k1))
            / (two * (vm - v0 - k1 * k2 - (t1 - k1) * k2));
        let beta = k1 - alpha * k2;
        let gamma = (beta * beta + (v0 - alpha) * (v0 - alpha)).sqrt();
        let sign = if v0 >= alpha { F::one() } else { -F::one() };
        let mut circle = Self { alpha, beta, gamma, sign, constant: F::zero() };
        circle.constant = from - circle.at(F::zero())[0];
        circle
    }
}

impl<F: Number> Printed<F> for Circle<F> {
    #[inline]
    fn at(&self, t: F) -> [F; 3] {
        let Self { alpha, beta, gamma, sign, constant } = *self;
        let half = F::number(0.5);
        let x = ((t - beta) / gamma).asin();
        let height = (gamma * gamma - (t - beta) * (t - beta)).sqrt();
        [
            alpha * t + sign * half * gamma * gamma * (half * (x + x).sin() + x) + constant,
            alpha + sign * height,
            -sign * (t - beta) / height,
        ]
    }
}
