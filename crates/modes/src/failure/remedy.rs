//! Remedies, in words of mechanics and numerics.

use solaris_model::EulerOrder;
use std::fmt;

/// What may help after a failure.
///
/// Its [`Display`](fmt::Display) is a request in words of mechanics and numerics (`take a step below 1.0e-4 s`). How to ask for it in a
/// text or on a command line is known to whoever reads that: see [`crate::RunFailure::told`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Remedy {
    /// A shorter step; how short is not known.
    ShorterStep,
    /// A step such as this.
    StepOf {
        /// The step (s).
        step: f64,
    },
    /// A step below this, which is where stability ends.
    StepBelow {
        /// The step (s).
        step: f64,
    },
    /// A step above this, which is as many evaluations as are allowed.
    StepAbove {
        /// The step (s).
        step: f64,
        /// The evaluations that the run would take as it is.
        evaluations: f64,
    },
    /// A tolerance, from which the step follows.
    ToleranceForStep,
    /// A tolerance such as this, smaller than it is.
    SmallerTolerance {
        /// The tolerance.
        tolerance: f64,
    },
    /// A larger tolerance.
    LargerTolerance,
    /// A method for stiff equations.
    StiffMethod,
    /// A method with a step such as this, which is not held to a tolerance.
    NamedMethod {
        /// The step (s).
        step: f64,
    },
    /// Another method or step.
    OtherMethod,
    /// A shorter run.
    ShorterRun,
    /// A shorter run or none: a small change at the start grows without end.
    ShorterChaos,
    /// More evaluations of the dynamics.
    MoreEvaluations,
    /// Other axes for a joint near gimbal lock.
    OtherAxes {
        /// The order of rotations that is farthest from lock there, and how far (rad).
        order: Option<(EulerOrder, f64)>,
    },
    /// Another joint than one that is near gimbal lock, which may have been what went wrong.
    AwayFromLock {
        /// The joint.
        joint: String,
        /// How far it is from lock (rad).
        distance: f64,
    },
    /// More mass or armature.
    MoreInertia,
    /// Softer springs.
    SofterSprings,
    /// What acts at that time is too stiff, or jumps.
    LookAtJumps,
    /// A look at what is asked of the figure at that time.
    LookAtRequest,
    /// A curve that begins where its degree of freedom is.
    CurveFromThere,
    /// A start at the beginning of the curve.
    StartAtCurve,
    /// A move, which begins where its degree of freedom is.
    MoveInstead,
    /// Room between limits or drives that undo each other.
    RoomBetween,
    /// Drives that take time.
    TakeTime,
    /// Limits that give way.
    SoftLimits,
    /// Dynamics for what is prescribed.
    Free,
    /// Another posture or other masses.
    OtherPosture,
    /// A ground that gives way.
    CompliantGround,
    /// Steps of impulses, which bear whatever touches.
    Impulses,
}

impl fmt::Display for Remedy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::StepOf { step } => {
                return write!(f, "take a shorter step, such as a tenth, {step:.1e} s");
            }
            Self::NamedMethod { step } => {
                return write!(
                    f,
                    "name a method with a step, such as Runge-Kutta 4 with {step:.1e} s, and look at its energy balance"
                );
            }
            Self::StepBelow { step } => return write!(f, "take a step below {step:.1e} s"),
            Self::StepAbove { step, evaluations } => {
                return write!(f, "take a step above {step:.1e} s, as this one would take {evaluations:.1e}");
            }
            Self::SmallerTolerance { tolerance } => {
                return write!(f, "take a smaller tolerance, such as a tenth, {tolerance:.1e}");
            }
            Self::OtherAxes { order: Some((order, distance)) } => {
                return write!(
                    f,
                    "use a ball joint or order {order}, which is {:.0}° from it there, or leave fewer of its axes free",
                    distance.to_degrees()
                );
            }
            Self::AwayFromLock { joint, distance } => {
                return write!(
                    f,
                    "give '{joint}', which is {:.0}° from gimbal lock there, a ball joint or another order of rotations",
                    distance.to_degrees()
                );
            }
            Self::OtherAxes { order: None } => "use a ball joint",
            Self::ShorterStep => "take a shorter step",
            Self::ToleranceForStep => "give a tolerance instead of a step",
            Self::LargerTolerance => "ask for a larger tolerance",
            Self::StiffMethod => "take a stiff method",
            Self::OtherMethod => "ask for another method or step",
            Self::ShorterRun => "ask for a shorter run",
            Self::ShorterChaos => {
                "ask for a shorter run: where a small change at the start grows without end, no step helps"
            }
            Self::MoreEvaluations => "allow more evaluations",
            Self::MoreInertia => "give what it moves more mass or an armature, or fix it",
            Self::SofterSprings => "take softer springs",
            Self::LookAtJumps => "look at what acts there: something is too stiff, or jumps",
            Self::LookAtRequest => "if that does not help, look at what is asked of the figure there",
            Self::CurveFromThere => "let the curve begin there",
            Self::StartAtCurve => "start the run with that",
            Self::MoveInstead => "take a move, which begins where it is",
            Self::TakeTime => "let one of the drives that come again take time",
            Self::RoomBetween => "give limits or drives that undo each other room",
            Self::SoftLimits => "make limits soft ones",
            Self::Free => "let dynamics move that",
            Self::OtherPosture => {
                "bend what is stretched and give light links more mass, as every joint of what stands is free already"
            }
            Self::Impulses => "take steps of impulses, which bear whatever touches and slides",
            Self::CompliantGround => "take a ground of springs, where everything slides a little",
        })
    }
}
