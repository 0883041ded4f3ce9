//! Errors of finding the ground's forces in a motion.

use super::ConsistencyError;
use crate::prepared::StateError;
use solaris_dynamics::DynamicsError;
use std::fmt;

/// A number that the search for the ground's forces is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum GroundOption {
    /// [`StanceOptions::height`](super::StanceOptions::height).
    Height,
    /// [`StanceOptions::speed`](super::StanceOptions::speed).
    Speed,
    /// [`StanceOptions::shortest`](super::StanceOptions::shortest).
    Shortest,
    /// [`Belt::Speed`](super::Belt::Speed), by its length.
    Belt,
    /// [`Stances::level`](super::Stances::level).
    Level,
}

impl GroundOption {
    /// What it is in.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Height | Self::Level => "m",
            Self::Speed | Self::Belt => "m/s",
            Self::Shortest => "s",
        }
    }
}

impl fmt::Display for GroundOption {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Height => "the height of what stands",
            Self::Speed => "the speed of what stands",
            Self::Shortest => "the shortest stance",
            Self::Belt => "the speed of the belt",
            Self::Level => "the level of the ground",
        })
    }
}

/// Why a motion has no ground forces.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GroundError {
    /// Nothing says which way is up.
    #[error(
        "gravity is {} {} {} m/s²; it must be finite and not zero, or nothing says which way the ground lies",
        .gravity[0], .gravity[1], .gravity[2]
    )]
    NoGravity {
        /// What was given (m/s²).
        gravity: [f64; 3],
    },
    /// Nothing weighs anything.
    #[error("figure '{figure}' has no mass, so nothing presses on the ground; give its links masses")]
    NoMass {
        /// The figure.
        figure: String,
    },
    /// No feet.
    #[error(
        "figure '{figure}' has no soles; give its feet sole points (heel, ball, toe tip), or name the soles"
    )]
    NoSoles {
        /// The figure.
        figure: String,
    },
    /// A sole that is none.
    #[error("sole '{sole}': {what} is {value}; {remedy}")]
    Sole {
        /// Its name.
        sole: String,
        /// What is wrong.
        what: &'static str,
        /// What it is.
        value: String,
        /// What it must be.
        remedy: &'static str,
    },
    /// What was found before is of another motion or of other soles.
    #[error("{what} has {found} entries; this motion and these soles have {expected}")]
    Length {
        /// What it is.
        what: &'static str,
        /// Entries that it has.
        found: usize,
        /// Entries that it must have.
        expected: usize,
    },
    /// No frames.
    #[error("the motion has no frames; it needs one at least")]
    Empty,
    /// Times that are none.
    #[error("frame {frame} is at {time} s; times must be finite and rise")]
    Time {
        /// Index of the frame.
        frame: usize,
        /// Its time (s).
        time: f64,
    },
    /// A number that cannot be used.
    #[error("{option} is {value} {}; it must be {range}", .option.unit())]
    Option {
        /// Which one.
        option: GroundOption,
        /// What was given.
        value: f64,
        /// What it may be.
        range: &'static str,
    },
    /// A stance of no foot, or of no time.
    #[error(
        "stance {stance}: foot {foot} of {feet} from {start} s to {end} s; it must be of a sole that is there, and last"
    )]
    Stance {
        /// Its index.
        stance: usize,
        /// Index of its sole.
        foot: usize,
        /// Number of soles.
        feet: usize,
        /// From when (s).
        start: f64,
        /// Until when (s).
        end: f64,
    },
    /// A split for two feet, and more of them stand.
    #[error("at {time} s {feet} feet stand; the split '{split}' is for two: choose 'pivot' or 'effort'")]
    TooManyFeet {
        /// Name of the split.
        split: &'static str,
        /// When (s).
        time: f64,
        /// How many stand.
        feet: usize,
    },
    /// A sole without breadth, where its outline is asked.
    #[error("sole '{sole}' has no breadth, so it is not known what it stands on; give it a width")]
    NoBreadth {
        /// The sole.
        sole: String,
    },
    /// A footing that is no plane.
    #[error("what stance {stance} stands on is no plane: its point must be finite, its normal of length 1")]
    NoPlane {
        /// Index of the stance.
        stance: usize,
    },
    /// A motion on stairs or a slope, of which a question for level ground is asked.
    #[error(
        "feet stand {apart:.2} m apart in height; a shift of the root is found on level ground alone: take a part of the \
         motion that is on level ground, or leave it as it is"
    )]
    NotLevel {
        /// How far apart (m).
        apart: f64,
    },
    /// Frames that are not equally far apart.
    #[error("frame {frame}, at {time} s, is not where equal frames have it; give the motion at a fixed rate")]
    Uneven {
        /// Its index.
        frame: usize,
        /// When (s).
        time: f64,
    },
    /// A balance that cannot be set right.
    #[error(transparent)]
    Consistency(#[from] ConsistencyError),
    /// The figure cannot be computed with.
    #[error(transparent)]
    Tree(DynamicsError),
    /// A state that cannot be computed with.
    #[error("at {time} s: {source}")]
    State {
        /// When (s).
        time: f64,
        /// Why.
        source: DynamicsError,
    },
}

impl From<StateError> for GroundError {
    fn from(StateError { time, source }: StateError) -> Self {
        Self::State { time, source }
    }
}
