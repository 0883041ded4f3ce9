//! The kinds of profiles, with their names and parameters, apart from any values.

use super::{Parameter, Profile};
use crate::error::ProfileError;
use alloc::vec::Vec;
use core::fmt;

/// The family of a kind of profile: what it prescribes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// A curve for the position, between two positions.
    Displacement,
    /// A curve for the acceleration; where it ends follows from it.
    Acceleration,
    /// A curve for the velocity; where it ends follows from it.
    Velocity,
    /// A polynomial between given ends.
    Polynomial,
    /// From rest to rest between limits; how long it takes follows from them.
    Limits,
    /// A curve through keys.
    Keys,
}

impl fmt::Display for Family {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Displacement => "displacement",
            Self::Acceleration => "acceleration",
            Self::Velocity => "velocity",
            Self::Polynomial => "polynomial",
            Self::Limits => "limits",
            Self::Keys => "keys",
        })
    }
}

/// A kind of profile: its name and its parameters.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// Its name for people: "minimum-jerk".
    pub name: &'static str,
    /// Its name in texts: "`MinimumJerk`".
    pub variant: &'static str,
    /// What it prescribes.
    pub family: Family,
    /// What it is, in one line.
    pub summary: &'static str,
    /// The parameters it cannot do without.
    pub required: &'static [&'static Parameter],
    /// The parameters that are zero when not given.
    pub optional: &'static [&'static Parameter],
    pub(super) make: Make,
}

/// A profile of the values of its parameters, and of its keys.
pub(super) type Make = fn(&mut dyn FnMut(&'static Parameter) -> f64, Vec<(f64, f64)>) -> Profile;

impl Kind {
    /// The kind of this name.
    pub fn named(name: &str) -> Option<&'static Self> {
        Profile::KINDS.iter().find(|kind| kind.name == name)
    }

    /// Its parameters, required ones first.
    pub fn parameters(&self) -> impl Iterator<Item = &'static Parameter> {
        self.required.iter().chain(self.optional).copied()
    }

    /// Whether it goes through keys.
    pub fn has_keys(&self) -> bool {
        self.family == Family::Keys
    }

    /// The profile with these values, and these keys (time, position) where the kind has keys.
    ///
    /// # Errors
    ///
    /// [`ProfileError::Missing`] where `value` answers nothing for a required parameter.
    pub fn profile(
        &self,
        value: impl Fn(&Parameter) -> Option<f64>,
        keys: Vec<(f64, f64)>,
    ) -> Result<Profile, ProfileError> {
        if let Some(parameter) = self.required.iter().find(|parameter| value(parameter).is_none()) {
            return Err(ProfileError::Missing { kind: self.name, parameter: parameter.name });
        }
        Ok((self.make)(&mut |parameter| value(parameter).unwrap_or(0.0), keys))
    }
}

impl Profile {
    /// Its kind; what is made of other curves has none, and a sine, whose parameters are of its own sort.
    pub fn kind(&self) -> Option<&'static Kind> {
        let variant = self.variant();
        Self::KINDS.iter().find(|kind| kind.variant == variant)
    }
}
