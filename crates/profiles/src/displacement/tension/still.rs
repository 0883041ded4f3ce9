//! The stationary points of a curve under tension.

use super::Tension;
use crate::Elementary;
use crate::answers::Turn;
use crate::roots::quadratic;
use alloc::vec::Vec;

impl Tension {
    /// Times at which the velocity is zero; possibly beyond the ends.
    ///
    /// The velocity is a quadratic in r = sinh X/sinh Y, which goes from 0 to ∞:
    ///
    /// ```text
    /// v·sinh² h/sinh² Y = v₁·r² + H·r + v₀        H = (v₀ + v₁)/cosh h + R/T·2h·sinh² h/g(h)
    /// ```
    pub(super) fn still(&self) -> Vec<(f64, Turn)> {
        let (v0, v1, s) = (self.start.1, self.end.1, &self.scaled);
        let k = self.stiffness;
        let decay = Elementary::exp(-s.half);
        // H, of which the second part is eʰ times a number of the size of R/T·h².
        let ends = (v0 + v1) * decay / s.cosine;
        let bow = 2.0 * s.whole_sine * s.whole_sine * s.per_share * self.excess * self.rate;
        let middle = ends + if bow.abs() > 0.0 { bow * Elementary::exp(s.half) } else { 0.0 };
        if middle.is_finite() {
            let roots = quadratic(v1, middle, v0).into_iter().filter(|&(r, _)| r > 0.0);
            return roots.map(|(r, turn)| (self.time(r, decay, k), turn)).collect();
        }
        // The velocities at both ends have died down long before the middle: v₀ + e⁻ʰ·H·(e²ˣ − 1) near the start, the
        // like near the end.
        let near =
            |v: f64| Some(-v / bow).filter(|&ratio| ratio > 0.0).map(|ratio| Elementary::ln_1p(ratio) / k);
        let inside = |&u: &f64| u < 0.5;
        let start = near(v0).filter(inside).map(|u| (self.duration * u, Turn::Reversal));
        let end = near(v1).filter(inside).map(|u| (self.duration * (1.0 - u), Turn::Reversal));
        start.into_iter().chain(end).collect()
    }

    /// The time at which sinh X/sinh Y = r; `decay` is e⁻ʰ. From the nearer end, k·u = ln((1 + r·eʰ)/(1 + r·e⁻ʰ)).
    fn time(&self, r: f64, decay: f64, k: f64) -> f64 {
        let (ratio, from_end) = if r > 1.0 { (1.0 / r, true) } else { (r, false) };
        let below = 1.0 + ratio * decay;
        let u = if k <= 0.0 {
            ratio / (1.0 + ratio)
        } else if decay > 1e-300 {
            Elementary::ln_1p(-self.scaled.below * ratio / decay / below) / k
        } else {
            0.5 + Elementary::ln((ratio + decay) / below) / k
        };
        self.duration * if from_end { 1.0 - u } else { u }
    }
}
