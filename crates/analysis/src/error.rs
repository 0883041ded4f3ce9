//! Errors of ground reactions.

use crate::inverse::InverseError;
use crate::prepared::PrepareError;
use solaris_dynamics::{DynamicsError, RootViewError};
use solaris_model::MotionError;

/// Why a motion has no ground reactions.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ReactionError {
    /// A foot is not a link.
    #[error("figure '{figure}' has no link '{link}'; name the links that stand on the ground")]
    MissingLink {
        /// The figure.
        figure: String,
        /// What was asked.
        link: String,
    },
    /// Both feet are the same link.
    #[error("link '{link}' is named as both feet; name two links")]
    OneFootTwice {
        /// The link.
        link: String,
    },
    /// A foot has no sole.
    #[error("link '{link}' has no sole points, so it is not known where it presses")]
    NoSole {
        /// The link.
        link: String,
    },
    /// The root cannot slide everywhere.
    #[error(
        "joint '{joint}' does not begin with slides along three axes at right angles, so the whole figure's momentum is not its to set"
    )]
    NoSlides {
        /// The root's joint.
        joint: String,
    },
    /// There is no gravity to say what is up.
    #[error("gravity is zero; without it nothing says which way the ground lies")]
    NoGravity,
    /// The motion pulls at the ground.
    #[error(
        "at {time:.3} s the motion needs a ground that pulls ({normal:.1} N): it cannot be walked on two feet; it flies, or \
         it is too fast for its frames"
    )]
    Pulls {
        /// When (s).
        time: f64,
        /// Normal force (N).
        normal: f64,
    },
    /// A motion without the contact of a foot.
    #[error("the motion has no contact of '{link}'; find the ground reactions first")]
    NoContacts {
        /// The foot.
        link: String,
    },
    /// A link that cannot be the root.
    #[error("link '{link}' cannot be the root: {source}")]
    Root {
        /// The link.
        link: String,
        /// Why.
        source: RootViewError,
    },
    /// The motion is not ready for it.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The kernel refused.
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
    /// A frame cannot be computed with.
    #[error(transparent)]
    Inverse(#[from] InverseError),
    /// The motion is not one of this figure.
    #[error(transparent)]
    Motion(#[from] MotionError),
}
