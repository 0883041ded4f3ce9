//! Samples of a curve, and the boundary values at its ends.

use crate::Elementary;

/// Position and its first three derivatives at one instant.
#[doc(alias = "jet")]
#[doc(alias = "state")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample<F = f64> {
    /// Position.
    pub position: F,
    /// First derivative.
    pub velocity: F,
    /// Second derivative.
    pub acceleration: F,
    /// Third derivative.
    pub jerk: F,
}

impl<F: Elementary> Sample<F> {
    /// At rest at `position`.
    pub fn rest(position: F) -> Self {
        let zero = F::from_f64(0.0);
        Self { position, velocity: zero, acceleration: zero, jerk: zero }
    }

    /// The sample `s` later of a motion that keeps this one's velocity.
    pub fn straight_on(self, s: F) -> Self {
        Self { velocity: self.velocity, ..Self::rest(self.position + self.velocity * s) }
    }

    /// The sample of the same curve walked backwards.
    pub fn reversed(self) -> Self {
        Self { velocity: -self.velocity, jerk: -self.jerk, ..self }
    }

    /// Position, velocity, acceleration, jerk.
    pub fn to_array(self) -> [F; 4] {
        [self.position, self.velocity, self.acceleration, self.jerk]
    }

    /// From position, velocity, acceleration, jerk.
    pub fn from_array([position, velocity, acceleration, jerk]: [F; 4]) -> Self {
        Self { position, velocity, acceleration, jerk }
    }
}

/// Position, velocity and acceleration at an end of a curve.
#[doc(alias = "boundary condition")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Boundary<F = f64> {
    /// Position.
    pub position: F,
    /// First derivative.
    pub velocity: F,
    /// Second derivative.
    pub acceleration: F,
}

impl<F: Copy> Boundary<F> {
    /// Position, velocity and acceleration.
    pub const fn new(position: F, velocity: F, acceleration: F) -> Self {
        Self { position, velocity, acceleration }
    }

    pub(crate) fn numbers(&self) -> [F; 3] {
        [self.position, self.velocity, self.acceleration]
    }
}

impl<F: Elementary> Boundary<F> {
    /// At rest at `position`.
    pub fn rest(position: F) -> Self {
        Self::new(position, F::from_f64(0.0), F::from_f64(0.0))
    }
}
