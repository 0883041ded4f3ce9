//! Drives of a degree of freedom: the modes of the thesis, and what has been added to them.

mod check;
pub(crate) mod force;
pub(crate) mod forced;
pub(crate) mod path;
pub(crate) mod servo;
pub(crate) mod simple;
pub(crate) mod tracking;

pub use servo::{Aim, Servo};

use solaris_profiles::Profile;
use std::sync::Arc;

use crate::recorded::RecordedMotion;

/// What drives one degree of freedom.
///
/// | mode | given | motion | force |
/// |---|---|---|---|
/// | kinematic | a curve | the curve | what the curve needs |
/// | frozen | nothing | none: left out of the dynamics | what holds it |
/// | simple | a target | closed form after one dynamic analysis | what that motion needs |
/// | intensive | a target and a duration | integrated | found anew each frame, within limits |
/// | torque | a curve of the force | integrated | the curve |
/// | servo | a motion to be led to | integrated | that of a spring and damper, within a limit |
/// | sum | several forces | integrated | all of them |
/// | free | nothing | integrated | none |
#[doc(alias = "actuator")]
#[doc(alias = "motor")]
#[doc(alias = "joint control")]
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Drive {
    /// No force but the passive ones.
    Free,
    /// Stands where it is.
    Frozen,
    /// Follows a curve (rad or m) that begins when the drive begins, at the position and the velocity that the degree of
    /// freedom then has.
    Kinematic(Profile),
    /// Moves from where it is, with the velocity that it has, to a position, where it rests.
    Move {
        /// Where to (rad or m).
        to: f64,
        /// In what time (s).
        over: f64,
        /// Along which curve.
        along: Shape,
    },
    /// Follows a recorded motion of the figure, by its own clock.
    Recorded(Arc<RecordedMotion>),
    /// A force (N m or N) over the time since the drive began; after its end, that of its end.
    Torque(Profile),
    /// One dynamic analysis of a target, then a motion in closed form.
    Simple {
        /// The state whose force is analysed, and whose position is to be reached.
        target: Target,
        /// What is made of the acceleration that this force gives.
        course: Course,
    },
    /// The force that the analysis of a target gives, or none, held for a time: the figure does with it what it does.
    FreeStyle {
        /// The state whose force is analysed; without one there is no force.
        target: Option<Target>,
        /// For how long (s).
        duration: f64,
    },
    /// A dynamic analysis each frame, the state fed back.
    Intensive {
        /// The state to be in at the end.
        target: Target,
        /// When to be there, since the drive began (s).
        duration: f64,
        /// How the force is found.
        law: Law,
        /// The greatest force (N m or N), if it has one.
        limit: Option<f64>,
    },
    /// A force that leads back to a motion.
    Servo(Servo),
    /// Several forces at once: [`Drive::Torque`], [`Drive::Servo`] and sums of them. It is done when the last of those that end
    /// has ended; what ends before goes on as it ended.
    Sum(Vec<Drive>),
}

/// The curve of [`Drive::Move`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Shape {
    /// Degree five, with no acceleration at either end: from rest, the least jerk.
    #[default]
    MinimumJerk,
    /// Degree three.
    Cubic,
}

/// A state of one degree of freedom.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Target {
    /// Position (rad or m).
    pub position: f64,
    /// Velocity (rad/s or m/s).
    pub velocity: f64,
    /// Acceleration (rad/s² or m/s²).
    pub acceleration: f64,
}

impl Target {
    /// At rest at a position (rad or m).
    pub fn at(position: f64) -> Self {
        Self { position, ..Self::default() }
    }
}

/// What simple mode makes of the acceleration `α` that one analysis gives; `δ` is the way to the target, `V₀` the
/// velocity at the beginning.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Course {
    /// `θ = θ₀ + V₀·t + α·t²/2` until the target is met.
    TargetAngle,
    /// `θ = θ₀ + V₀·t + (δ − V₀·T)·(t/T)²`: there after exactly this time (s).
    TimeOriented {
        /// `T` (s).
        duration: f64,
    },
    /// `A = |α|·sign δ` until halfway, then `−A`: from rest to rest in `2·√(|δ|/A)`.
    BangBang,
    /// The acceleration falls along the way, `A·(1 − 2φ)`: half a cosine in `π·√(|δ|/(2A))`.
    HalfCosine,
    /// The acceleration is a whole sine over the time, zero at beginning, middle and end, in `√(2π·|δ|/A)`.
    FullSine,
}

/// How intensive mode finds the force of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Law {
    /// The force that goes with the target's state, as the thesis has it: it does not lead there.
    Literal,
    /// The force that gives the acceleration of a cubic from where the degree of freedom is to where it has to be.
    Cubic,
    /// The same with a quintic, which also meets the acceleration.
    Quintic,
}

/// A drive, and when the next one takes over.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// What drives.
    pub drive: Drive,
    /// Until when.
    pub until: EndCondition,
}

impl From<Drive> for Step {
    fn from(drive: Drive) -> Self {
        Self { drive, until: EndCondition::Done }
    }
}

/// When a drive gives way to the next one.
#[doc(alias = "until")]
#[doc(alias = "termination")]
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum EndCondition {
    /// When it is done by itself: a curve at its end, a target reached. [`Drive::Free`] and [`Drive::Frozen`] never are.
    Done,
    /// At a time of the run (s).
    Time(f64),
    /// After a time since it began (s).
    Lasting(f64),
    /// When a part of a [sequence](crate::Simulation::sequence) is over, by its index; never where there is none.
    Part(usize),
    /// When a degree of freedom passes through a position (rad or m).
    Position {
        /// Which.
        dof: String,
        /// The position.
        value: f64,
    },
    /// When a degree of freedom passes through a velocity (rad/s or m/s).
    Velocity {
        /// Which.
        dof: String,
        /// The velocity.
        value: f64,
    },
    /// When a link that dynamics move comes down on the ground, with the first of its points.
    TouchDown {
        /// Which.
        link: String,
    },
    /// When a link that dynamics move leaves the ground, with the last of its points.
    LiftOff {
        /// Which.
        link: String,
    },
}
