//! Errors of making a motion's balance possible.

use solaris_model::MotionError;

/// Why nothing can be said of a motion's balance.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConsistencyError {
    /// A number that is none, or one that no motion has.
    #[error("{what} is {value}; it must be {needed}")]
    Number {
        /// What it is.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        needed: &'static str,
    },
    /// Too few frames for accelerations.
    #[error("the motion has too few frames for accelerations: {frames}; give 3 or more")]
    TooShort {
        /// Frames given.
        frames: usize,
    },
    /// Outlines and frames do not belong together.
    #[error(
        "there are {outlines} outlines for {frames} frames; give one a frame, an empty one where nothing stands"
    )]
    Length {
        /// Frames given.
        frames: usize,
        /// Outlines given.
        outlines: usize,
    },
    /// Nothing stands, so nothing is asked of any frame.
    #[error(
        "no foot stands in any frame, so there is nothing that the ground could bear; check the soles, or say when feet stand"
    )]
    NothingStands,
    /// A frame whose numbers are none, or too great to compute with.
    #[error("frame {frame}: {what} is not finite, or too great to compute with")]
    NotFinite {
        /// Number of the frame, from 0.
        frame: usize,
        /// What it is.
        what: &'static str,
    },
    /// An outline that is none.
    #[error(
        "frame {frame}: the outline of what stands is not convex, not counter-clockwise seen from above, or has no area; give \
         the convex hull of the soles"
    )]
    Outline {
        /// Number of the frame, from 0.
        frame: usize,
    },
    /// An outline narrower than two margins.
    #[error("frame {frame}: nothing of the outline is {margin} m inside of it; choose a smaller margin")]
    Narrow {
        /// Number of the frame, from 0.
        frame: usize,
        /// The margin (m).
        margin: f64,
    },
    /// A centre of mass that is not above the ground.
    #[error(
        "frame {frame}: the centre of mass is {height} m above the ground; what stands has it above; check the level"
    )]
    Low {
        /// Number of the frame, from 0.
        frame: usize,
        /// Its height (m).
        height: f64,
    },
}

/// Why a motion's root cannot be shifted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ShiftError {
    /// The shift is not one of this motion.
    #[error("{what} has {found} frames, the motion {frames}")]
    Length {
        /// Which part of it.
        what: &'static str,
        /// Frames that it has.
        found: usize,
        /// Frames of the motion.
        frames: usize,
    },
    /// A root that cannot be put anywhere.
    #[error(
        "joint '{joint}' of the root is neither free nor does it begin with slides along three axes at right angles that nothing \
         follows, so the figure cannot be shifted; give it a floating base"
    )]
    NoSlides {
        /// The root's joint.
        joint: String,
    },
    /// The motion is another figure's, or what it comes to is no number.
    #[error(transparent)]
    Motion(#[from] MotionError),
}
