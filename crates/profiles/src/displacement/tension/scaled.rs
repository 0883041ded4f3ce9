//! Hyperbolic functions without their exponential, and without the powers of their argument that they vanish with.

use crate::Elementary;
use crate::error::{ProfileError, check_overflow};

/// Constants of a stiffness k = 2h.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scaled<F> {
    /// h.
    pub(crate) half: F,
    /// −1/k; not needed where k is small.
    per_stiffness: F,
    /// e⁻²ʰ − 1.
    pub(crate) below: F,
    /// sinh(h)/h and cosh h, divided by eʰ.
    pub(crate) whole_sine: F,
    pub(crate) cosine: F,
    /// tanh(h)/h.
    pub(crate) tangent: F,
    /// e²ʰ·2h/sinh 2h.
    pub(crate) per_sine: F,
    /// eʰ·h³/g(h).
    pub(crate) per_share: F,
}

impl<F: Elementary> Scaled<F> {
    pub(crate) fn new(stiffness: F) -> Result<Self, ProfileError> {
        let (one, half) = (F::from_f64(1.0), F::from_f64(0.5) * stiffness);
        let below = (-stiffness).exp_m1();
        let (sine, cosine) = (sine(half, below), one + F::from_f64(0.5) * below);
        let per_stiffness = if half.value() < 0.25 * SMALL { one } else { F::from_f64(-0.5) / half };
        let (per_sine, per_share) = (one / (sine * cosine), one / cubic_share(half, below));
        check_overflow("stiffness", &[per_sine, per_share])?;
        Ok(Self {
            half,
            per_stiffness,
            below,
            whole_sine: sine,
            cosine,
            tangent: sine / cosine,
            per_sine,
            per_share,
        })
    }
}

impl<F: Elementary> Scaled<F> {
    /// e⁻ᶻ·sinh(z)/h for z = h·u, where `below` is e⁻²ᶻ − 1.
    #[inline]
    pub(crate) fn sine(&self, u: F, below: F) -> F {
        let z = self.half * u;
        if z.value() < SMALL { u * sine(z, below) } else { below * self.per_stiffness }
    }
}

/// e⁻²ᶻ, where `below` is e⁻²ᶻ − 1: with all its digits where it is small.
#[inline]
pub(crate) fn decay<F: Elementary>(z: F, below: F) -> F {
    if z.value() < 0.3 { F::from_f64(1.0) + below } else { (F::from_f64(-2.0) * z).exp() }
}

/// Where the quotient of two small numbers would do for a number, but not for its derivatives.
const SMALL: f64 = 1e-3;

/// e⁻ᶻ·sinh(z)/z, where `below` is e⁻²ᶻ − 1.
#[inline]
fn sine<F: Elementary>(z: F, below: F) -> F {
    if z.value() < SMALL {
        let series = [2.0 / 15.0, -1.0 / 3.0, 2.0 / 3.0, -1.0, 1.0];
        return series.into_iter().fold(F::from_f64(0.0), |sum, c| sum * z + F::from_f64(c));
    }
    -below / (z + z)
}

/// e⁻ᶻ·g(z)/z³ with g(z) = z·cosh z − sinh z, where `below` is e⁻²ᶻ − 1.
#[inline]
pub(crate) fn cubic_share<F: Elementary>(z: F, below: F) -> F {
    let one = F::from_f64(1.0);
    if z.value() < 1.0 {
        // Σ 2n·z²ⁿ⁻²/(2n + 1)!, n = 9 … 1.
        let series: [f64; 9] = [
            1.0 / 6_758_061_133_824_000.0,
            1.0 / 22_230_464_256_000.0,
            1.0 / 93_405_312_000.0,
            1.0 / 518_918_400.0,
            1.0 / 3_991_680.0,
            1.0 / 45_360.0,
            1.0 / 840.0,
            1.0 / 30.0,
            1.0 / 3.0,
        ];
        let square = z * z;
        let sum = series.into_iter().fold(F::from_f64(0.0), |sum, c| sum * square + F::from_f64(c));
        return sum * (one + below).sqrt();
    }
    (one + F::from_f64(0.5) * below - sine(z, below)) / (z * z)
}
