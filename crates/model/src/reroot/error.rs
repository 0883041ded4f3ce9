//! The errors of re-rooting.

/// The error of re-rooting: why a figure cannot hang on a link.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RerootError {
    /// No link has this name.
    #[error(
        "link '{name}' cannot be the root: the figure has none of that name{}",
        .nearest.as_ref().map_or_else(String::new, |name| format!("; did you mean '{name}'?"))
    )]
    UnknownLink {
        /// What was asked for.
        name: String,
        /// The nearest name, if any is near.
        nearest: Option<String>,
    },
    /// No link has this index.
    #[error("link {link} cannot be the root: the figure's links are 0 to {last}")]
    NoSuchLink {
        /// What was asked for.
        link: usize,
        /// The last link.
        last: usize,
    },
    /// The link is no end-effector.
    #[error("link '{link}' has no tip to be the root by; take its joint or one of its points")]
    NoTip {
        /// The link.
        link: String,
    },
    /// The point is infinite or NaN.
    #[error("link '{link}' cannot be the root by a point at {value} m; give finite numbers")]
    NotFinite {
        /// The link.
        link: String,
        /// The coordinate.
        value: f64,
    },
    /// A degree of freedom is tied to one of the declared root's joint, which the view does not have.
    #[error(
        "dof '{dof}' follows '{leader}', and one of them belongs to the root's joint, which gives way to a free joint when link \
         '{root}' becomes the root: let it follow a dof of another joint, or keep the root"
    )]
    Follower {
        /// The follower.
        dof: String,
        /// Whom it follows.
        leader: String,
        /// The link that was to be the root.
        root: String,
    },
    /// A joint would move links without mass.
    #[error(
        "joint '{joint}' would move links without mass if '{root}' were the root, so no force could be found for it; give \
         the links on its other side mass"
    )]
    Massless {
        /// The joint.
        joint: String,
        /// The new root.
        root: String,
    },
    /// The armature of a free joint on the way counts along the axes of the link that it moves.
    #[error(
        "free joint '{joint}' between '{root}' and the old root has armature, which is that of one direction; only a joint \
         without can be turned round"
    )]
    FreeArmature {
        /// The joint.
        joint: String,
        /// The new root.
        root: String,
    },
}
