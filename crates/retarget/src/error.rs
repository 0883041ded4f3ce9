//! Why a motion cannot be put onto a skeleton.

/// Why a motion cannot be put onto a skeleton.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RetargetError {
    /// A bone that a walker cannot do without was not found.
    #[error(
        "'{skeleton}' has no bone for {}; its bones are {bones}; write down which is which in a map: Bones({}: \"NAME\", …)",
        .roles.join(", "), .roles.first().copied().unwrap_or("pelvis")
    )]
    NoBone {
        /// Whose.
        skeleton: String,
        /// Which roles.
        roles: Vec<&'static str>,
        /// The names of its bones.
        bones: String,
    },
    /// A map names a bone that is not there.
    #[error("the map's {role} is '{bone}', which '{skeleton}' does not have{hint}; its bones are {bones}")]
    Unknown {
        /// Whose bone.
        skeleton: String,
        /// Which role.
        role: String,
        /// The name in the map.
        bone: String,
        /// The nearest name, as a question.
        hint: String,
        /// The names of its bones.
        bones: String,
    },
    /// A bone that must be below another is not.
    #[error("of '{skeleton}', '{lower}' ({role}) is not below '{upper}'; write down other bones in a map")]
    Order {
        /// Whose.
        skeleton: String,
        /// What the lower one should be.
        role: &'static str,
        /// The bone.
        lower: String,
        /// The one that it should be below.
        upper: String,
    },
    /// A rest pose in which nobody stands.
    #[error(
        "'{skeleton}' does not stand in its rest pose: {why}; name a frame in which it does (of a motion), or save it standing in a T or A pose"
    )]
    Rest {
        /// Whose.
        skeleton: String,
        /// What is wrong.
        why: &'static str,
    },
    /// A frame that is not there.
    #[error("the rest pose is to be frame {frame}, and there are {frames}")]
    Frame {
        /// What was asked, from 0.
        frame: usize,
        /// How many there are.
        frames: usize,
    },
    /// A motion of another figure, or without frames.
    #[error(transparent)]
    Motion(#[from] solaris_model::MotionError),
    /// A motion without frames.
    #[error("the motion has no frames; there is nothing to be put onto '{skeleton}'")]
    Empty {
        /// Whose.
        skeleton: String,
    },
    /// A number that is none.
    #[error("{what} of '{bone}' is {value}; it must be finite")]
    NotFinite {
        /// Which.
        what: &'static str,
        /// The bone.
        bone: String,
        /// Its value.
        value: f64,
    },
}
