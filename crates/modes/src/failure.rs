//! Failures: faults of what was asked, and failures of runs.

mod remedy;

pub use remedy::Remedy;

use solaris_dynamics::DynamicsError;
use solaris_model::{ConfigurationError, FuseError, LoadError, MotionError};
use solaris_profiles::ProfileError;

/// How far points (m), and their velocities (m/s, rad/s), may be apart where a loop is to be held closed by forces.
pub(crate) const OPEN: f64 = 1e-4;

/// What is wrong with what was asked; nothing has been computed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SetupError {
    /// No such degree of freedom.
    #[error("figure '{figure}' has no degree of freedom '{name}'{}", hint(.nearest.as_deref()))]
    UnknownDof {
        /// The figure.
        figure: String,
        /// What was asked.
        name: String,
        /// The nearest name.
        nearest: Option<String>,
    },
    /// No such link.
    #[error("figure '{figure}' has no link '{name}'{}", hint(.nearest.as_deref()))]
    UnknownLink {
        /// The figure.
        figure: String,
        /// What was asked.
        name: String,
        /// The nearest name.
        nearest: Option<String>,
    },
    /// Something waits for a link to touch the ground, or to leave it, and it never can.
    #[error(
        "something waits for '{link}' to come to the ground or to leave it, but there is no ground, or nothing of '{link}' touches it: \
         lay a ground, or name one of the links that touch"
    )]
    NothingTouches {
        /// The link.
        link: String,
    },
    /// A drive that a ball or free joint does not have.
    #[error(
        "'{dof}' belongs to the ball or free joint '{joint}', which has no {drive} drive yet; its velocities can be free or \
         have a torque, and all of them together can be frozen: use a joint of three rotations for other drives"
    )]
    NoSuchDrive {
        /// The degree of freedom.
        dof: String,
        /// Its joint.
        joint: String,
        /// The drive.
        drive: &'static str,
    },
    /// A force for a degree of freedom that something else drives.
    #[error(
        "'{dof}' is neither free nor driven by a constant force, so that no force can be set on it: give it `Free` as its drive first"
    )]
    NotAForce {
        /// The degree of freedom.
        dof: String,
    },
    /// A target for a degree of freedom that no servo leads to one.
    #[error(
        "no servo that goes to a place drives '{dof}', so that it can be given no other target: give it `Servo` as its drive first"
    )]
    NotAServo {
        /// The degree of freedom.
        dof: String,
    },
    /// A degree of freedom that cannot hang loose.
    #[error(
        "'{dof}' cannot hang loose: it is of a ball or free joint, or follows another; use a joint of rotations"
    )]
    NotLoose {
        /// The degree of freedom.
        dof: String,
    },
    /// A follower, or the leader of one, in a drive that it cannot have.
    #[error(
        "'{dof}' and '{leader}', which it follows, can only be frozen, or follow curves or a recorded motion; the drive \
         '{drive}' of '{leader}' needs them free of each other"
    )]
    Follower {
        /// The follower.
        dof: String,
        /// Its leader.
        leader: String,
        /// The drive.
        drive: &'static str,
    },
    /// A sum of drives one of which is no force.
    #[error(
        "the sum of forces of '{dof}' has the drive '{drive}' in it, which is none; it can be of torques and servos"
    )]
    NotInSum {
        /// The degree of freedom.
        dof: String,
        /// The drive.
        drive: &'static str,
    },
    /// A part of a sequence that has no end.
    #[error(
        "part {part} of the sequence never is over, so that nothing comes after it: let something in it come to an end, or wait for a \
         time or an event"
    )]
    Sequence {
        /// Which, from 1 on.
        part: usize,
    },
    /// A drive for a degree of freedom that follows another.
    #[error("'{dof}' follows '{leader}' and has no drive of its own; drive '{leader}'")]
    DrivenFollower {
        /// The follower.
        dof: String,
        /// Its leader.
        leader: String,
    },
    /// A number out of its range.
    #[error("{what} is {value}; it must be {range}")]
    Range {
        /// Whose, and what: "the duration of 'elbow.rx'".
        what: String,
        /// Its value.
        value: f64,
        /// What it has to be.
        range: &'static str,
    },
    /// A ground that is to be found from a gravity that there is none of.
    #[error(
        "there is no gravity to say which way the ground lies and how stiff it is; give it a stiffness (N/m) and a direction up"
    )]
    NoGround,
    /// A figure that cannot be put on the ground.
    #[error(
        "the figure cannot be put on the ground: '{joint}', the joint of its root, does not slide out of it, or nothing of it can \
         touch the ground; give the root a free joint or a slide, or place the figure by hand"
    )]
    NoWayDown {
        /// The joint of the root.
        joint: String,
    },
    /// A curve that is none.
    #[error("the curve of '{dof}': {source}")]
    Profile {
        /// The degree of freedom.
        dof: String,
        /// Why.
        source: ProfileError,
    },
    /// The curve of a push that is none.
    #[error("the curve of the push on '{link}': {source}")]
    PushProfile {
        /// What is pushed.
        link: String,
        /// Why.
        source: ProfileError,
    },
    /// A load that cannot be carried.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// A state that is none.
    #[error(transparent)]
    State(#[from] ConfigurationError),
    /// A figure that cannot be computed with.
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
    /// Degrees of freedom that cannot be frozen.
    #[error(transparent)]
    Fuse(#[from] FuseError),
    /// A motion that is none.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// Links that are to touch each other, in a run by a method that does not know of it.
    #[error(
        "links that touch each other need steps by impulses, of 1 ms to begin with (method: Impulses(step: 1e-3))"
    )]
    NeedsImpulses,
    /// A loop that is open where a run begins that holds it closed by forces.
    #[error(
        "{} and {} are held together, but begin {apart:.3e} m and {speed:.3e} m/s or rad/s apart, more than {OPEN}: start where the loop \
         is closed, or take impulses, which draw them together (method: Impulses(step: 1e-3))", .links[0], .links[1]
    )]
    OpenLoop {
        /// The links, or `world`.
        links: [String; 2],
        /// How far their points are apart (m).
        apart: f64,
        /// How fast they move, or their links turn, away from each other (m/s or rad/s).
        speed: f64,
    },
    /// A loop that is taken hold of, by forces, where it is open.
    #[error(
        "{} and {} are held together from {time} s on, but are {apart:.3e} m apart then, more than {OPEN}: bring them together before, or take \
         impulses, which draw them together (method: Impulses(step: 1e-3))", .links[0], .links[1]
    )]
    FarLoop {
        /// The links, or `world`.
        links: [String; 2],
        /// When (s).
        time: f64,
        /// How far their points are apart (m).
        apart: f64,
    },
    /// A loop from a link to itself, or from the world to the world.
    #[error(
        "a loop holds two links together, or a link and the world, and both ends of this one are on the same"
    )]
    LoopOfNothing,
    /// Links that are to touch each other in a program that was built without it: it is behind this crate's feature `collide`.
    #[error("links that touch each other are not built in; build with the feature `collide`")]
    CollisionsNotBuiltIn,
    /// Links that cannot touch each other.
    #[cfg(feature = "collide")]
    #[error(transparent)]
    Collision(#[from] solaris_collision::CollisionError),
    /// A method that this program was built without: those that choose their steps are behind this crate's feature `stiff`.
    #[error("the method '{method}' is not built in; take Runge-Kutta 4 with a step")]
    NotBuiltIn {
        /// The method.
        method: &'static str,
    },
}

fn hint(nearest: Option<&str>) -> String {
    nearest.map_or_else(String::new, |name| format!("; did you mean '{name}'?"))
}

/// Why a run ended before its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RunError {
    /// What was asked cannot be run.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// A run that failed.
    #[error(transparent)]
    Failed(#[from] Box<RunFailure>),
    /// The observer cancelled it.
    #[error("the run was stopped")]
    Cancelled,
}

impl From<RunFailure> for RunError {
    fn from(failure: RunFailure) -> Self {
        Self::Failed(Box::new(failure))
    }
}

/// The failure of a run: when, where, what, and what to do.
#[doc(alias = "trouble")]
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}", self.told(|_| None))]
pub struct RunFailure {
    /// When (s).
    pub time: f64,
    /// The degree of freedom or joint where it shows most.
    pub dof: Option<String>,
    /// What.
    pub cause: FailureKind,
    /// What may help, each by itself, the likeliest first.
    pub remedies: Vec<Remedy>,
}

impl RunFailure {
    /// When, where, what, and what to do, with how each remedy is `spelled` where one can be asked for in words of a text or a
    /// command line:
    ///
    /// ```
    /// use solaris_modes::{FailureKind, Remedy, RunFailure};
    ///
    /// let remedies = vec![Remedy::StepOf { step: 1e-4 }, Remedy::ToleranceForStep];
    /// let failure = RunFailure { time: 0.5, dof: None, cause: FailureKind::Energy { share: 0.3 }, remedies };
    /// let told = failure.told(|remedy| (*remedy == Remedy::ToleranceForStep).then_some("--tolerance 1e-6"));
    /// assert_eq!(
    ///     told,
    ///     "30 % of the energy at play has come from nowhere or gone at t = 0.5 s: take a shorter step, such as a tenth, \
    ///      1.0e-4 s, or give a tolerance instead of a step (--tolerance 1e-6)"
    /// );
    /// ```
    pub fn told<'a>(&self, spelled: impl Fn(&Remedy) -> Option<&'a str>) -> String {
        let told = |remedy: &Remedy| match spelled(remedy) {
            Some(spelled) => format!("{remedy} ({spelled})"),
            None => remedy.to_string(),
        };
        let advice: Vec<String> = self.remedies.iter().map(told).collect();
        format!("{} at t = {} s: {}", self.cause, shown(self.time), advice.join(", or "))
    }
}

/// A magnitude, where there is one.
fn with(value: f64, unit: &str) -> String {
    if value > 0.0 { format!(" with {value:.1e} {unit}") } else { String::new() }
}

/// How near the best setting came, where two came to the end.
fn nearest(estimate: f64) -> String {
    let within = || format!("; the nearest came within {estimate:.1e}");
    if estimate.is_finite() { within() } else { " within the evaluations that are allowed".to_owned() }
}

fn shown(time: f64) -> String {
    let text = format!("{time:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// What went wrong.
#[doc(alias = "cause")]
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FailureKind {
    /// A joint near gimbal lock.
    #[error("{joint} is {:.1}° from gimbal lock", .distance.to_degrees())]
    GimbalLock {
        /// The joint.
        joint: String,
        /// How far (rad).
        distance: f64,
    },
    /// A mass matrix with hardly any digits.
    #[error("{}, worst about {dof}", conditioned(*condition))]
    IllConditioned {
        /// The condition, each degree of freedom in units in which its own inertia is 1.
        condition: f64,
        /// Where it shows most.
        dof: String,
    },
    /// A fixed step too long for the stiffest eigenvalue.
    #[error(
        "a step of {step:.2e} s is too long for {method}: the stiffest eigenvalue, {eigenvalue:.4e} 1/s, in {dof}, allows {longest:.2e} s"
    )]
    StepTooLong {
        /// The rule.
        method: String,
        /// The step (s).
        step: f64,
        /// The longest stable step (s).
        longest: f64,
        /// The eigenvalue's magnitude (1/s), with the sign of its real part.
        eigenvalue: f64,
        /// The degree of freedom that moves most in its direction.
        dof: String,
    },
    /// Energy from nowhere.
    #[error("{:.0} % of the energy at play has come from nowhere or gone", 100.0 * .share)]
    Energy {
        /// The part of the energy at play.
        share: f64,
    },
    /// A method that cannot go on.
    #[error("{method} cannot go on: {why}")]
    Stuck {
        /// The method.
        method: String,
        /// Why: "its step fell below …", "… steps were rejected".
        why: String,
    },
    /// More work than was allowed.
    #[error("{evaluations} evaluations of the dynamics are spent")]
    Evaluations {
        /// How many.
        evaluations: u64,
    },
    /// Impacts without end.
    #[error("{count} impacts within a frame")]
    Impacts {
        /// How many.
        count: usize,
    },
    /// Drives that come again without any time going on.
    #[error("what drives {dof} is over and begins again, with '{drive}', without any time going on")]
    NoTime {
        /// The degree of freedom.
        dof: String,
        /// The drive that begins again.
        drive: &'static str,
    },
    /// What stands on the ground cannot stay.
    #[error("{link} cannot stay where it stands: {why}, by {missing:.1e} m/s² or m/s at least")]
    ContactLost {
        /// The link.
        link: String,
        /// Why: "what has a motion of its own ('hip.rx') moves it".
        why: String,
        /// What it asks for and cannot have (m/s², or m/s in an impact; rad for m where it turns).
        missing: f64,
    },
    /// There is no way to stand.
    #[error(
        "{links} can neither stay on the ground nor leave it: holding it pulls{}, letting it go makes it sink{}",
        with(*.pull, "N or N s"),
        with(*.sink, "m/s² or m/s")
    )]
    UnresolvedContact {
        /// The links that were held and let go in turn.
        links: String,
        /// What held them at most (N, or N s in an impact).
        pull: f64,
        /// How they sank at most (m/s², or m/s in an impact).
        sink: f64,
    },
    /// A curve that does not begin where its degree of freedom is.
    #[error(
        "the curve of {dof} begins at {begins} with the velocity {velocity}, but {dof} is at {found} with {moving}"
    )]
    Jump {
        /// The degree of freedom.
        dof: String,
        /// Where the curve begins (rad or m).
        begins: f64,
        /// With what velocity.
        velocity: f64,
        /// Where the degree of freedom is.
        found: f64,
        /// With what velocity.
        moving: f64,
    },
    /// A tolerance that no setting met.
    #[error("no setting met the tolerance {tolerance:e}{}", nearest(*.estimate))]
    Tolerance {
        /// The tolerance.
        tolerance: f64,
        /// The smallest estimate of the error; infinite where no two settings came to the end.
        estimate: f64,
    },
    /// A tolerance that no setting met, as none came to the end.
    #[error("no setting met the tolerance {tolerance:e}: with a step of {step:.1e} s, {cause}")]
    NoneFinished {
        /// The tolerance.
        tolerance: f64,
        /// The shortest step that was tried (s).
        step: f64,
        /// What came in its way.
        cause: Box<FailureKind>,
    },
    /// A state that is none.
    #[error("the state is none: {0}")]
    State(String),
    /// Numbers beyond all bounds.
    #[error("the motion runs away: a rate is {value}")]
    NotFinite {
        /// The rate.
        value: f64,
    },
    /// A state that the dynamics refuse.
    #[error("{0}")]
    Dynamics(DynamicsError),
}

/// How bad the condition of a mass matrix is.
fn conditioned(condition: f64) -> String {
    if condition.is_finite() {
        format!("the mass matrix has the condition {condition:.1e}")
    } else {
        "the mass matrix is not positive: some motion meets no inertia, or less than none".to_owned()
    }
}
