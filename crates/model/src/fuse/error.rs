//! The errors of fusing.

/// The error of fusing: why degrees of freedom cannot be fused, or a state not be mapped.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FuseError {
    /// The degree of freedom follows one that is not fused.
    #[error(
        "dof '{dof}' follows '{leader}', so it cannot stand still alone; fuse '{leader}', and it comes along"
    )]
    Follower {
        /// The follower's name.
        dof: String,
        /// The name of the one that leads.
        leader: String,
    },
    /// No degree of freedom has this name.
    #[error(
        "dof '{name}' cannot be fused: the figure has none of that name{}",
        .nearest.as_ref().map_or_else(String::new, |name| format!("; did you mean '{name}'?"))
    )]
    UnknownDof {
        /// What was asked for.
        name: String,
        /// The nearest name, if any is near.
        nearest: Option<String>,
    },
    /// No degree of freedom has this index.
    #[error("dof {dof} cannot be fused: the figure has {count}, numbered from 0")]
    NoSuchDof {
        /// What was asked for.
        dof: usize,
        /// Number of degrees of freedom.
        count: usize,
    },
    /// A degree of freedom is named twice.
    #[error("dof '{dof}' is to be fused twice; name it once")]
    Twice {
        /// Its name.
        dof: String,
    },
    /// A value to be fused at is infinite or NaN.
    #[error("coordinate '{name}' cannot be fused at {value}; give a finite number (rad or m)")]
    NotFinite {
        /// Name of the coordinate.
        name: String,
        /// Its value.
        value: f64,
    },
    /// A velocity of a ball or free joint is the rate of no coordinate.
    #[error(
        "dof '{dof}' has no coordinate of its own: fuse its joint '{joint}' as a whole, at a configuration (fuse_at)"
    )]
    NoCoordinate {
        /// The degree of freedom.
        dof: String,
        /// Its joint.
        joint: String,
    },
    /// Some but not all degrees of freedom of a ball or free joint.
    #[error("joint '{joint}' can be fused only as a whole: name all of its {all} dofs, not {count}")]
    PartOfJoint {
        /// The joint.
        joint: String,
        /// How many were named.
        count: usize,
        /// How many it has.
        all: usize,
    },
    /// A quaternion without length.
    #[error("joint '{joint}' cannot be fused: its quaternion has the length {length}, which is no rotation")]
    NoRotation {
        /// The joint.
        joint: String,
        /// Length of the quaternion.
        length: f64,
    },
    /// A slice has the wrong length.
    #[error("{what} has {found} entries, but {expected} are needed")]
    Length {
        /// Which argument.
        what: &'static str,
        /// The length needed.
        expected: usize,
        /// The length found.
        found: usize,
    },
}

pub(super) fn check_length(what: &'static str, found: usize, expected: usize) -> Result<(), FuseError> {
    if found == expected { Ok(()) } else { Err(FuseError::Length { what, expected, found }) }
}
