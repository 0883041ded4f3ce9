//! Why a BVH file cannot be read.

use solaris_model::{MotionError, TextError};

/// Why a BVH file cannot be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BvhError {
    /// The text is at fault, at a place.
    #[error(transparent)]
    Text(#[from] TextError),
    /// A mass or a unit that was asked for is none.
    #[error("the {what} is {value}; it must be a finite number above zero")]
    Option {
        /// Which: `mass` (kg) or `unit` (m).
        what: &'static str,
        /// What was asked.
        value: f64,
    },
    /// The table of masses names what is not there.
    #[error("the table of masses names '{name}', which is no joint of the file{hint}")]
    UnknownBone {
        /// The name.
        name: String,
        /// The nearest name, as a question.
        hint: String,
    },
    /// A mass of the table of masses is none.
    #[error("the mass of '{name}' is {mass} kg; it must be zero or more")]
    BoneMass {
        /// The joint.
        name: String,
        /// What the table says (kg).
        mass: f64,
    },
    /// More frames are to be left out than there are.
    #[error("{skip} frames are to be left out, and the file has {frames}")]
    Skip {
        /// Frames to leave out.
        skip: usize,
        /// Frames of the file.
        frames: usize,
    },
    /// The clip is not of the figure that it is asked for.
    #[error("it is no motion of figure '{figure}': link '{link}': {why}")]
    NotTheFigure {
        /// The figure's name.
        figure: String,
        /// Its link.
        link: String,
        /// What is wrong.
        why: String,
    },
    /// The numbers are no motion.
    #[error(transparent)]
    Motion(#[from] MotionError),
}
