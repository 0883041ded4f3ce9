//! Polynomials of degree five, and the two that meet boundary values.

use crate::sample::{Boundary, ProfileError, Sample, check_duration, check_finite};

/// `x(t) = Σ cₖ tᵏ`, k = 0 … 5.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Polynomial(pub [f64; 6]);

impl Polynomial {
    /// The value and its first three derivatives at `t`, by Horner's rule.
    #[inline]
    pub fn at(&self, t: f64) -> Sample {
        let c = &self.0;
        Sample {
            position: c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5])))),
            velocity: c[1] + t * (2.0 * c[2] + t * (3.0 * c[3] + t * (4.0 * c[4] + t * 5.0 * c[5]))),
            acceleration: 2.0 * c[2] + t * (6.0 * c[3] + t * (12.0 * c[4] + t * 20.0 * c[5])),
            jerk: 6.0 * c[3] + t * (24.0 * c[4] + t * 60.0 * c[5]),
        }
    }

    /// The quintic that meets six boundary values over `h > 0`:
    ///
    /// ```text
    /// c₃ h³ =  10 Δ − (4 v₁ + 6 v₀) h − (3 a₀ − a₁) h²/2
    /// c₄ h⁴ = −15 Δ + (7 v₁ + 8 v₀) h + (3 a₀ − 2 a₁) h²/2
    /// c₅ h⁵ =   6 Δ − 3 (v₁ + v₀) h + (a₁ − a₀) h²/2        Δ = x₁ − x₀
    /// ```
    pub(crate) fn quintic(h: f64, start: &Boundary, end: &Boundary) -> Self {
        let (v0, a0, v1, a1) =
            (start.velocity * h, start.acceleration * h * h, end.velocity * h, end.acceleration * h * h);
        let delta = end.position - start.position;
        let c3 = 10.0 * delta - 4.0 * v1 - 6.0 * v0 - 1.5 * a0 + 0.5 * a1;
        let c4 = -15.0 * delta + 7.0 * v1 + 8.0 * v0 + 1.5 * a0 - a1;
        let c5 = 6.0 * delta - 3.0 * (v1 + v0) + 0.5 * (a1 - a0);
        let (h3, h2) = (h * h * h, h * h);
        Self([
            start.position,
            start.velocity,
            start.acceleration / 2.0,
            c3 / h3,
            c4 / (h2 * h2),
            c5 / (h3 * h2),
        ])
    }

    /// The cubic that meets position and velocity at both ends over `h > 0`.
    pub(crate) fn cubic(h: f64, x0: f64, v0: f64, x1: f64, v1: f64) -> Self {
        let slope = (x1 - x0) / h;
        Self([x0, v0, (3.0 * slope - 2.0 * v0 - v1) / h, (v0 + v1 - 2.0 * slope) / (h * h), 0.0, 0.0])
    }
}

/// The curve of degree five that meets position, velocity and acceleration at both ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quintic {
    duration: f64,
    polynomial: Polynomial,
}

impl Quintic {
    /// Over `duration`, from `start` at time 0 to `end`.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, numbers that are not finite.
    pub fn new(duration: f64, start: Boundary, end: Boundary) -> Result<Self, ProfileError> {
        check_duration(duration)?;
        check_finite("start", &start.numbers())?;
        check_finite("end", &end.numbers())?;
        let polynomial = Polynomial::quintic(duration, &start, &end);
        // A span too short for its values overflows.
        check_finite("coefficient", &polynomial.0)?;
        Ok(Self { duration, polynomial })
    }

    /// The curve at `t`; beyond its ends it goes on as the same polynomial.
    pub fn at(&self, t: f64) -> Sample {
        self.polynomial.at(t)
    }

    /// How long it lasts.
    pub fn duration(&self) -> f64 {
        self.duration
    }
}

/// The curve of degree three that meets position and velocity at both ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubicHermite {
    duration: f64,
    polynomial: Polynomial,
}

impl CubicHermite {
    /// Over `duration`, from position `x0` with velocity `v0` to `x1` with `v1`.
    ///
    /// # Errors
    ///
    /// A duration that is not positive, numbers that are not finite.
    pub fn new(duration: f64, (x0, v0): (f64, f64), (x1, v1): (f64, f64)) -> Result<Self, ProfileError> {
        check_duration(duration)?;
        check_finite("start", &[x0, v0])?;
        check_finite("end", &[x1, v1])?;
        let polynomial = Polynomial::cubic(duration, x0, v0, x1, v1);
        check_finite("coefficient", &polynomial.0)?;
        Ok(Self { duration, polynomial })
    }

    /// The curve at `t`; beyond its ends it goes on as the same polynomial.
    pub fn at(&self, t: f64) -> Sample {
        self.polynomial.at(t)
    }

    /// How long it lasts.
    pub fn duration(&self) -> f64 {
        self.duration
    }
}
