//! Errors of scenes.

use crate::spelled;
use solaris_analysis::ReactionError;
use solaris_modes::RunError;

/// Why a scene has no motion.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// The run: what was asked cannot be run, or trouble on the way; told in the words of a scene.
    #[error("{}", spelled::run(.0))]
    Run(#[from] RunError),
    /// The ground under the feet of a walk.
    #[error("the motion is there, but not what the ground does under its feet: {0}")]
    Reaction(#[from] ReactionError),
}
