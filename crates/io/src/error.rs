//! Why a motion cannot be written or a text cannot be read.

use solaris_model::{MotionError, Vector3};

/// Why a motion cannot be written or a text is not one.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum IoError {
    /// The writer failed: a full disk, a closed pipe.
    #[error("the motion could not be written: {0}")]
    Write(#[from] std::io::Error),
    /// The numbers are no motion, or not of this figure.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// A number to be written is not finite; no format holds it.
    #[error("'{column}' at {time} s is {value}; a file holds finite numbers only")]
    NotFinite {
        /// The column, such as `left_knee.rx.tau`.
        column: String,
        /// When (s).
        time: f64,
        /// The number.
        value: f64,
    },
    /// A contact track that does not fit its motion.
    #[error("contacts of link '{link}': {problem}")]
    Contacts {
        /// The link that the track names.
        link: String,
        /// What is wrong and what to do.
        problem: ContactProblem,
    },
    /// A table has no header.
    #[error("the table is empty; its first line must name the columns: time, DOF.q …, DOF.v …, DOF.a …")]
    NoHeader,
    /// A column that a motion needs is not in the header.
    #[error(
        "line 1: column '{column}' is missing; a motion needs `time` and `.q`, `.v`, `.a` of every degree of freedom, \
         and `.tau` and the nine numbers of a contact whole or not at all"
    )]
    MissingColumn {
        /// The missing column.
        column: String,
    },
    /// A column that means nothing for this figure.
    #[error(
        "line 1, column {column}: '{name}' is no column of a motion of figure '{figure}'; rename or remove it"
    )]
    UnknownColumn {
        /// Its number, from 1.
        column: usize,
        /// Its heading.
        name: String,
        /// The figure's name.
        figure: String,
    },
    /// A heading that stands twice.
    #[error("line 1, column {column}: '{name}' is also the heading of column {first}; remove one of them")]
    DuplicateColumn {
        /// Number of the second, from 1.
        column: usize,
        /// The heading.
        name: String,
        /// Number of the first, from 1.
        first: usize,
    },
    /// A row with too few or too many fields.
    #[error("line {line} has {found} fields, the header has {expected}")]
    RowLength {
        /// Line, from 1.
        line: u64,
        /// Fields of the row.
        found: usize,
        /// Columns of the header.
        expected: usize,
    },
    /// A field that is no finite number.
    #[error("line {line}, column {column} ('{name}'): '{text}' is no finite number")]
    Number {
        /// Line, from 1.
        line: u64,
        /// Number of the column, from 1.
        column: usize,
        /// Its heading.
        name: String,
        /// What stands there.
        text: String,
    },
    /// A time that is not one frame after the row before.
    #[error(
        "line {line}, column {column} ('time'): {time} s comes {step} s after the row before; at {rate} frames/s it must \
         be {} s: correct the rate or resample the table", 1.0 / .rate
    )]
    Time {
        /// Line, from 1.
        line: u64,
        /// Number of the column, from 1.
        column: usize,
        /// The time (s).
        time: f64,
        /// Since the row before (s).
        step: f64,
        /// Frames a second (1/s).
        rate: f64,
    },
    /// A joint that BVH cannot hold.
    #[error("joint '{joint}' cannot be written as BVH: {fault}")]
    BvhJoint {
        /// The joint's name.
        joint: String,
        /// Why.
        fault: BvhFault,
    },
    /// A link's name that would break a BVH file.
    #[error("link '{link}' cannot be written as BVH: names there hold no spaces and no braces; rename it")]
    BvhName {
        /// The link's name.
        link: String,
    },
    /// Gravity says that y is not up.
    #[error(
        "gravity ({}, {}, {}) m/s² does not point down −y, but y is up in BVH: the figure would lie on its side; turn \
         its world first", .gravity.x, .gravity.y, .gravity.z
    )]
    BvhUp {
        /// The motion's gravity (m/s²).
        gravity: Vector3<f64>,
    },
}

/// What is wrong with a contact track.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ContactProblem {
    /// The figure has no such link.
    #[error("figure '{figure}' has no link of that name")]
    UnknownLink {
        /// The figure's name.
        figure: String,
    },
    /// Two tracks have the same link.
    #[error("there are two tracks of that name; merge them")]
    Duplicate,
    /// Not one contact a sample.
    #[error("{found} contacts for {samples} samples; give one a sample")]
    Length {
        /// Contacts of the track.
        found: usize,
        /// Samples of the motion.
        samples: usize,
    },
}

/// Why a joint does not fit BVH.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BvhFault {
    /// The joint's frame is turned against its parent's.
    #[error(
        "its frame is turned against its parent's, and BVH keeps only an offset; give the joint parallel axes"
    )]
    TurnedPlacement,
    /// A rotation about none of x, y, z.
    #[error("degree of freedom {dof} turns about none of x, y, z")]
    ObliqueAxis {
        /// Number in the joint, from 1.
        dof: usize,
    },
    /// Two rotations about the same axis.
    #[error("it turns twice about {axis}; a BVH joint turns once about each axis")]
    RepeatedAxis {
        /// The axis.
        axis: char,
    },
    /// A translation below the root.
    #[error("it slides; only the root's joint may slide in BVH")]
    SlidingJoint,
    /// A root that slides after it has turned.
    #[error("degree of freedom {dof} slides after a rotation; BVH moves the root first and then turns it")]
    SlidesAfterTurning {
        /// Number in the joint, from 1.
        dof: usize,
    },
    /// A kind of joint that this writer does not know.
    #[error("its kind has no order of rotations")]
    Kind,
}
