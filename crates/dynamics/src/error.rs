//! The errors of the kernel's operations.

/// The error of an operation: why it gave no result. Values are printed as the scalar prints itself, lanes and all.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DynamicsError {
    /// A constant of the figure or the gravity is not a finite number in the scalar asked for.
    #[error(
        "{what} is {value}, which is not a finite number in this precision; correct it or use a wider scalar"
    )]
    Constant {
        /// Which constant.
        what: String,
        /// Its value.
        value: f64,
    },
    /// A joint is of a kind that this kernel does not know.
    #[error(
        "joint '{joint}' is of a kind that the dynamics cannot move yet; describe it by one-axis degrees of freedom"
    )]
    Joint {
        /// The joint.
        joint: String,
    },
    /// A slice or matrix has the wrong size.
    #[error("{what} has {found} entries, but the figure needs {expected}")]
    Length {
        /// Which argument.
        what: &'static str,
        /// The length that the tree asks for.
        expected: usize,
        /// The length found.
        found: usize,
    },
    /// A frame does not stand at a finite place.
    #[error("the placement of a frame on link '{link}' holds {value}; it must be finite numbers")]
    FrameNotFinite {
        /// The link.
        link: String,
        /// The number.
        value: String,
    },
    /// The workspace was made for another tree.
    #[error("the workspace was made for another tree; make one with Workspace::new for this tree")]
    Workspace,
    /// An entry of the state is infinite or NaN.
    #[error("{what} of dof '{dof}' is {value}; it must be a finite number")]
    NotFinite {
        /// Which argument: `q`, `v` or `a`.
        what: &'static str,
        /// The degree of freedom.
        dof: String,
        /// The value.
        value: String,
    },
    /// The quaternion of a ball or free joint is no rotation.
    #[error(
        "the quaternion that starts at '{name}' has the squared length {squared}; it must be 1: normalise the \
         configuration first (Figure::normalize)"
    )]
    Quaternion {
        /// Its first entry.
        name: String,
        /// Its squared length.
        squared: String,
    },
    /// A frame is said to be on a link that does not exist.
    #[error("there is no link {link}: the figure's links are 0 to {last}")]
    UnknownLink {
        /// The link asked for.
        link: usize,
        /// The last link of the tree.
        last: usize,
    },
    /// No frame and no link has this name.
    #[error("the figure has no frame and no link called '{name}'{}", hint(.nearest.as_ref()))]
    UnknownFrame {
        /// The name asked for.
        name: String,
        /// The nearest name of a frame or link, if any is near.
        nearest: Option<String>,
    },
    /// The root cannot be pushed by the ground in closed form.
    #[error(
        "the root '{link}' does not begin with three translations in different directions, which the ground's \
         acceleration in closed form needs; use hybrid_dynamics"
    )]
    Root {
        /// The root.
        link: String,
    },
    /// An external wrench names a link that does not exist.
    #[error("external wrench {index} acts on link {link}, but the figure's links are 0 to {last}")]
    NoSuchLink {
        /// Its place in the list of wrenches.
        index: usize,
        /// The link it names.
        link: usize,
        /// The last link of the tree.
        last: usize,
    },
    /// An external wrench is infinite or NaN.
    #[error("external wrench {index} on link '{link}' is {wrench}; its entries must be finite numbers")]
    WrenchNotFinite {
        /// Its place in the list of wrenches.
        index: usize,
        /// The link it acts on.
        link: String,
        /// Force and moment.
        wrench: String,
    },
    /// A contact names a link that does not exist, or has a number that is not finite.
    #[error("contact {index} is {contact}; its link must be one of 0 to {last} and its numbers finite")]
    Contact {
        /// Its place in the list of contacts.
        index: usize,
        /// The contact.
        contact: String,
        /// The last link of the tree.
        last: usize,
    },
    /// A force cannot accelerate a degree of freedom.
    #[error(
        "dof '{dof}' has no inertia to oppose its force, none above zero beyond rounding ({inertia:.3e} kg m² or kg is left), so \
         its acceleration cannot be found; give what it moves mass or inertia about its axis that matter can have, give \
         it an armature, or prescribe its acceleration"
    )]
    NoInertia {
        /// The degree of freedom.
        dof: String,
        /// What is left for it once all that hangs from it has given way (kg m² or kg): zero, rounding, or less.
        inertia: f64,
    },
    /// The motion of a figure in which degrees of freedom follow others.
    #[error(
        "dof '{dof}' follows '{leader}' and is not free to be accelerated; Coupling::forward_dynamics finds the motion of \
         figures with followers"
    )]
    Follower {
        /// The first that follows.
        dof: String,
        /// Whom it follows.
        leader: String,
    },
    /// The state is finite but the result is not.
    #[error(
        "{what} came out as {value}: the state is finite, but too large for this precision; \
         check its units or use a wider scalar"
    )]
    Overflow {
        /// Which result.
        what: String,
        /// Its value.
        value: String,
    },
}

/// The nearest name, as a question.
fn hint(nearest: Option<&String>) -> String {
    nearest.map_or_else(String::new, |name| format!("; did you mean '{name}'?"))
}
