//! What a curve answers, what it is given, and what can be wrong with it.

/// Position and its first three derivatives at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// Position.
    pub position: f64,
    /// First derivative.
    pub velocity: f64,
    /// Second derivative.
    pub acceleration: f64,
    /// Third derivative.
    pub jerk: f64,
}

/// Position, velocity and acceleration at an end of a curve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Boundary {
    /// Position.
    pub position: f64,
    /// First derivative.
    pub velocity: f64,
    /// Second derivative.
    pub acceleration: f64,
}

impl Boundary {
    /// Position, velocity and acceleration.
    pub const fn new(position: f64, velocity: f64, acceleration: f64) -> Self {
        Self { position, velocity, acceleration }
    }

    /// At rest at `position`.
    pub const fn rest(position: f64) -> Self {
        Self::new(position, 0.0, 0.0)
    }

    pub(crate) fn numbers(&self) -> [f64; 3] {
        [self.position, self.velocity, self.acceleration]
    }
}

/// Why there is no such curve.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ProfileError {
    /// A number is not finite.
    #[error("{what} is {value}; it must be a finite number")]
    NotFinite {
        /// Which number.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// The duration is not one.
    #[error("duration {duration}: it must be more than zero")]
    Duration {
        /// What was given.
        duration: f64,
    },
    /// The knots do not rise.
    #[error("knot {index} at {time} does not lie after the one before it at {before}; knots must rise")]
    Knots {
        /// Index of the knot.
        index: usize,
        /// Where it is.
        time: f64,
        /// Where the knot before it is.
        before: f64,
    },
    /// There are too few or too many values.
    #[error("{what}: {found} given, {needed} needed")]
    Count {
        /// Of what.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many there must be (at least, for knots and samples).
        needed: usize,
    },
}

pub(crate) fn check_finite(what: &'static str, values: &[f64]) -> Result<(), ProfileError> {
    match values.iter().find(|value| !value.is_finite()) {
        Some(&value) => Err(ProfileError::NotFinite { what, value }),
        None => Ok(()),
    }
}

pub(crate) fn check_duration(duration: f64) -> Result<(), ProfileError> {
    check_finite("duration", &[duration])?;
    if duration > 0.0 { Ok(()) } else { Err(ProfileError::Duration { duration }) }
}
