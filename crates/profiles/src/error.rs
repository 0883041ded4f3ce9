//! The errors of curves.

use crate::Elementary;
use crate::range::{Range, Ranges};
use alloc::format;
use alloc::string::String;

/// The error of a curve: why there is none with these values.
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
    /// A number is outside of what it may be.
    #[error("{what} is {value}; it must be {range}")]
    OutOfRange {
        /// Which number.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What it may be.
        range: Range,
    },
    /// A number that must be whole is not.
    #[error("{what} is {value}; it must be a whole number")]
    NotWhole {
        /// Which number.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A parameter has no value.
    #[error("{kind} needs its {parameter}")]
    Missing {
        /// The kind of profile.
        kind: &'static str,
        /// The parameter's name.
        parameter: &'static str,
    },
    /// A parameter cannot be left free.
    #[error("{kind} has no free {parameter}; {instead}")]
    NotFree {
        /// The kind of profile.
        kind: &'static str,
        /// The parameter's name.
        parameter: &'static str,
        /// What may be free.
        instead: &'static str,
    },
    /// The motion turns round, and no single parameter can keep it from that.
    #[error(
        "the motion turns round at {time}, and no one parameter of this profile is known to keep it from that"
    )]
    TurnsRound {
        /// When, for the first time.
        time: f64,
    },
    /// The numbers are good ones each, but there is no such curve with all of them.
    #[error("{what} is {value}: {why}; {}", instead(what, feasible))]
    Infeasible {
        /// Which number to change.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What is wrong with it beside the others.
        why: &'static str,
        /// What it may be beside the others.
        feasible: Ranges,
    },
    /// The numbers lead beyond what numbers can hold.
    #[error("{what} comes out as {value}; the values are too large for so short a time, or too small")]
    Overflow {
        /// What was computed.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// The weights of the layers of a blend vanish together.
    #[error("at {time} no layer of the blend has any weight; let the fades overlap")]
    Weightless {
        /// When.
        time: f64,
    },
    /// The knots do not rise.
    #[error("time {time} (number {}) does not lie after the one before it, {before}; times must rise", index + 1)]
    Knots {
        /// Index of the knot, from 0.
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

fn instead(what: &str, feasible: &Ranges) -> String {
    if feasible.is_empty() { format!("no {what} would do") } else { format!("it may be {feasible}") }
}

/// Refuses what is not finite.
pub(crate) fn check_finite<F: Elementary>(what: &'static str, values: &[F]) -> Result<(), ProfileError> {
    match values.iter().find(|value| !value.is_finite()) {
        Some(value) => Err(ProfileError::NotFinite { what, value: value.value() }),
        None => Ok(()),
    }
}

/// Refuses a duration that is not finite or not positive.
pub(crate) fn check_duration<F: Elementary>(duration: F) -> Result<(), ProfileError> {
    check_finite("duration", &[duration])?;
    let duration = duration.value();
    if duration > 0.0 { Ok(()) } else { Err(ProfileError::Duration { duration }) }
}

/// Refuses a number that is not finite or not in its range.
pub(crate) fn check_range<F: Elementary>(
    what: &'static str,
    value: F,
    range: Range,
) -> Result<(), ProfileError> {
    check_finite(what, &[value])?;
    let value = value.value();
    if range.contains(value) { Ok(()) } else { Err(ProfileError::OutOfRange { what, value, range }) }
}

/// Refuses computed numbers that are not finite, such as an acceleration that overflows in a very short time.
pub(crate) fn check_overflow<F: Elementary>(what: &'static str, values: &[F]) -> Result<(), ProfileError> {
    match values.iter().find(|value| !value.is_finite()) {
        Some(value) => Err(ProfileError::Overflow { what, value: value.value() }),
        None => Ok(()),
    }
}
