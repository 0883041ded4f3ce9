//! The errors of operations on configurations.

use super::rotation::{read, unit};
use crate::figure::Figure;

/// The error of an operation on configurations: why numbers are no configuration of a figure, or no step of one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConfigurationError {
    /// A slice has the wrong length.
    #[error("{what} has {found} numbers; figure '{figure}' needs {expected}")]
    Length {
        /// Which argument.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The length that it must have: `nq` or `nv`.
        expected: usize,
        /// The figure's name.
        figure: String,
    },
    /// A number that goes in is not finite.
    #[error("{what} '{name}' is {value}; it must be a finite number")]
    NotFinite {
        /// Which argument.
        what: &'static str,
        /// The coordinate or degree of freedom.
        name: String,
        /// The number.
        value: f64,
    },
    /// A quaternion has no direction.
    #[error(
        "{what}: the quaternion of joint '{joint}' is zero, which is no rotation; no rotation at all is 0 0 0 1"
    )]
    ZeroQuaternion {
        /// Which argument.
        what: &'static str,
        /// The joint's name.
        joint: String,
    },
    /// A result is too large for a number.
    #[error("{what} at '{name}' is {value}: what went in is too large")]
    Overflow {
        /// Which result.
        what: &'static str,
        /// The coordinate or degree of freedom.
        name: String,
        /// The number.
        value: f64,
    },
    /// A random source gave what it must not.
    #[error("the random source gave {value}; it must give numbers from 0 up to, but not including, 1")]
    RandomSource {
        /// What it gave.
        value: f64,
    },
}

impl Figure {
    pub(super) fn check_length(
        &self,
        what: &'static str,
        found: usize,
        expected: usize,
    ) -> Result<(), ConfigurationError> {
        if found == expected {
            return Ok(());
        }
        Err(ConfigurationError::Length { what, found, expected, figure: self.name().to_owned() })
    }

    /// Right length, finite.
    pub(super) fn check_numbers(
        &self,
        what: &'static str,
        values: &[f64],
        names: &[String],
    ) -> Result<(), ConfigurationError> {
        self.check_length(what, values.len(), names.len())?;
        match values.iter().position(|x| !x.is_finite()) {
            None => Ok(()),
            Some(i) => Err(ConfigurationError::NotFinite { what, name: names[i].clone(), value: values[i] }),
        }
    }

    /// Right length, finite, and every quaternion with a direction.
    pub(crate) fn check_configuration(
        &self,
        what: &'static str,
        q: &[f64],
    ) -> Result<(), ConfigurationError> {
        self.check_numbers(what, q, self.layout().q_names())?;
        for (link, at) in self.links().iter().zip(self.layout().joints()) {
            if let Some(first) = link.joint().kind().quaternion()
                && unit(&read(&q[at.q + first..])).is_none()
            {
                return Err(ConfigurationError::ZeroQuaternion {
                    what,
                    joint: link.joint().name().to_owned(),
                });
            }
        }
        Ok(())
    }
}
