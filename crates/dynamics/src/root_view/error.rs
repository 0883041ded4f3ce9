//! The errors of root views.

use crate::error::DynamicsError;
use solaris_model::RerootError;

/// The error of a root view: why a figure has no view from a link, or a state no place in the declared figure.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RootViewError {
    /// The figure cannot hang on that link.
    #[error(transparent)]
    Reroot(#[from] RerootError),
    /// A state or force is not valid.
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
    /// The joint of the declared root cannot follow every motion.
    #[error(
        "joint '{joint}' of the declared root cannot take every motion: it needs a free joint, or three slides along \
         different coordinate axes and then three turns about different coordinate axes"
    )]
    Root {
        /// The joint.
        joint: String,
    },
    /// The rates of three turns are not determined.
    #[error(
        "joint '{joint}' of the declared root is at its gimbal lock: the cosine of its middle turn is {cosine:e}; turn the \
         figure or give its root a free joint"
    )]
    Lock {
        /// The joint.
        joint: String,
        /// Cosine of the middle turn.
        cosine: f64,
    },
}
