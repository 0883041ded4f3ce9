//! Polynomials of degree five, and the two that meet boundary values.

mod cubic;
mod quintic;

pub use cubic::CubicHermite;
pub use quintic::Quintic;

use crate::Elementary;
use crate::sample::{Boundary, Sample};

/// `x(t) = Σ cₖ tᵏ`, k = 0 … 5.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Polynomial<F = f64>(pub [F; 6]);

impl<F: Elementary> Polynomial<F> {
    /// The value at any `t`, by Horner's rule.
    #[inline]
    pub fn position(&self, t: F) -> F {
        let c = &self.0;
        c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))))
    }

    /// The value and its first three derivatives at any `t`, by Horner's rule.
    #[inline]
    pub fn at(&self, t: F) -> Sample<F> {
        let c = &self.0;
        let n = F::from_f64;
        Sample {
            position: self.position(t),
            velocity: c[1]
                + t * (n(2.0) * c[2] + t * (n(3.0) * c[3] + t * (n(4.0) * c[4] + t * (n(5.0) * c[5])))),
            acceleration: n(2.0) * c[2] + t * (n(6.0) * c[3] + t * (n(12.0) * c[4] + t * (n(20.0) * c[5]))),
            jerk: n(6.0) * c[3] + t * (n(24.0) * c[4] + t * (n(60.0) * c[5])),
        }
    }

    /// The quintic that meets six boundary values over `h > 0`, of the time t = u·h:
    ///
    /// ```text
    /// c₀ = x₀     c₁ h = v₀ h     c₂ h² = a₀ h²/2
    /// c₃ h³ =  10 Δ − (4 v₁ + 6 v₀) h − (3 a₀ − a₁) h²/2
    /// c₄ h⁴ = −15 Δ + (7 v₁ + 8 v₀) h + (3 a₀ − 2 a₁) h²/2
    /// c₅ h⁵ =   6 Δ − 3 (v₁ + v₀) h + (a₁ − a₀) h²/2        Δ = x₁ − x₀
    /// ```
    pub(crate) fn quintic(h: F, start: &Boundary<F>, end: &Boundary<F>) -> Self {
        let n = F::from_f64;
        let (v0, v1) = (start.velocity * h, end.velocity * h);
        let (a0, a1) = (start.acceleration * h * h, end.acceleration * h * h);
        let delta = end.position - start.position;
        let c3 = n(10.0) * delta - n(4.0) * v1 - n(6.0) * v0 - n(1.5) * a0 + n(0.5) * a1;
        let c4 = n(-15.0) * delta + n(7.0) * v1 + n(8.0) * v0 + n(1.5) * a0 - a1;
        let c5 = n(6.0) * delta - n(3.0) * (v1 + v0) + n(0.5) * (a1 - a0);
        let mut power = F::from_f64(1.0);
        Self([start.position, v0, n(0.5) * a0, c3, c4, c5].map(|c| {
            let coefficient = c / power;
            power *= h;
            coefficient
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_has_the_derivatives_of_its_powers() {
        // 1 + t + t² + t³ + t⁴ + t⁵ at 2.
        let sample = Polynomial([1.0; 6]).at(2.0);
        assert_eq!(sample, Sample::from_array([63.0, 129.0, 222.0, 294.0]));
    }

    #[test]
    fn the_quintic_of_time_is_that_of_the_span() {
        let (start, end) = (Boundary::new(1.0, -1.0, 3.0), Boundary::new(0.0, 2.0, -4.0));
        let end_of = Polynomial::quintic(2.0, &start, &end).at(2.0);
        assert!((end_of.position - 0.0).abs() < 1e-13 && (end_of.velocity - 2.0).abs() < 1e-13);
        assert!((end_of.acceleration + 4.0).abs() < 1e-13);
    }
}
