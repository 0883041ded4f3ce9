//! Why a walk cannot be.

use solaris_dynamics::DynamicsError;
use solaris_model::{MotionError, SolePart};
use solaris_modes::ReactionError;
use solaris_modes::ground::PlantedError;
use solaris_profiles::ProfileError;

/// Why a figure cannot walk as asked.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs, reason = "each message says what its fields are")]
pub enum GaitError {
    #[error("figure '{figure}' has no link {}; the walker needs the links of the human figure", quoted(.links))]
    MissingLinks { figure: String, links: Vec<String> },
    #[error(
        "figure '{figure}' has {links} links; the walker knows what to do with the {known} of the human figure"
    )]
    OtherLinks { figure: String, links: usize, known: usize },
    #[error("figure '{figure}' cannot walk; {} things are amiss:{}", .lacks.len(), listed(.lacks))]
    CannotWalk { figure: String, lacks: Vec<GaitError> },
    #[error("link '{link}' hangs on {parent}; the walker needs it on {wanted}")]
    OtherParent { link: String, parent: String, wanted: String },
    #[error(
        "joint '{joint}': the walker needs rotations about z, y, x in this order (the root slides along x, y, z first), \
         with axes parallel to the parent's"
    )]
    OtherJoint { joint: String },
    #[error(
        "link '{link}' has no sole point {part:?}; the walker needs heel and ball on the foot, the tip on the toes"
    )]
    MissingSolePoint { link: &'static str, part: SolePart },
    #[error(
        "the legs differ: left and right {joint} joint stand {difference:.2e} m from being mirror images, which the walker needs"
    )]
    LegsDiffer { joint: &'static str, difference: f64 },
    #[error(
        "the {joint} joint lies {offset:.2e} m to the side of the leg's plane; the walker needs hip, knee, ankle \
         and toes in one plane"
    )]
    OutOfPlane { joint: &'static str, offset: f64 },
    #[error("{parameter} {value}{unit}: it must be {lower} to {upper}{unit}{why}")]
    Range { parameter: &'static str, value: f64, unit: &'static str, lower: f64, upper: f64, why: String },
    #[error("{parameter} {value}{unit}: this figure walks with {lower:.3} to {upper:.3}{unit} {at}{why}")]
    StepLength {
        parameter: &'static str,
        value: f64,
        unit: &'static str,
        lower: f64,
        upper: f64,
        at: String,
        why: String,
    },
    #[error("stage {number} of the journey: {why}")]
    InStage { number: usize, why: Box<GaitError> },
    #[error("a journey without a walk; give it one, if only of a single step")]
    NoWalk,
    #[error(
        "foot-yaw {to:.1}°: the feet stand {from:.1}° outward after the walk before, and standing feet do not turn; give all \
         walks the same"
    )]
    FeetWouldTurn { from: f64, to: f64 },
    #[error("part {number} of the walk: {why}")]
    InPart { number: usize, why: Box<GaitError> },
    #[error(
        "part {part} of the walk, step {step}, at {time:.2} s: {what}; change the pace or turn by less at once, or take more steps \
         for it"
    )]
    Sudden { part: usize, step: usize, time: f64, what: String },
    #[error(
        "a walk of {distance} m is followed by more steps; say how many steps it has, for a distance is met by the whole walk"
    )]
    DistanceThenMore { distance: f64 },
    #[error(
        "the walk turns by {turned:.1}° in all; it may turn by {limit}°, for at a quarter turn the root's three angles are \
         singular"
    )]
    TurnInAll { turned: f64, limit: f64 },
    #[error("the centre of mass has no periodic path: the prescribed forces do not carry the body")]
    NoPath,
    #[error("{passes} passes for a walk: at least 8 are needed, the last four of which only settle")]
    Passes { passes: usize },
    #[error("the style's {name} is {value}; it must be a finite number")]
    StyleNotFinite { name: &'static str, value: f64 },
    #[error("{nodes} nodes a stride: the planner takes an even number from 20 to 10000")]
    Nodes { nodes: usize },
    #[error("there is no style parameter '{name}'; there are {known}")]
    UnknownParameter { name: String, known: String },
    #[error(
        "step frequency, step length and speed are all given ({step_frequency} steps/min, {step_length} m, {speed} m/s); any two decide the third: drop one"
    )]
    Overdetermined { step_frequency: f64, step_length: f64, speed: f64 },
    #[error(
        "step length {step_length:.3} m at {step_frequency} steps/min: {whose} friction would have to be {friction:.2}, and \
         soles hold {limit}{longest}"
    )]
    Friction {
        step_length: f64,
        step_frequency: f64,
        whose: &'static str,
        friction: f64,
        limit: f64,
        longest: String,
    },
    #[error(
        "step length {step_length:.3} m at {step_frequency} steps/min: {what}; shorten the step or go back to the default \
         style"
    )]
    NotWalkable { step_length: f64, step_frequency: f64, what: String },
    #[error("{determinants} determinants cannot walk like this: {why}")]
    Infeasible { determinants: &'static str, why: Box<crate::condition::Infeasible> },
    #[error("{found} values for the {expected} parameters of {determinants} determinants")]
    ParameterCount { determinants: &'static str, found: usize, expected: usize },
    #[error(
        "a walk through key postures needs a step, phases in each of its three cycles, and a duration for each phase"
    )]
    EmptyScript,
    #[error(
        "a walk through key postures: its {name} is {value}; it must be a finite number, and more than nothing"
    )]
    ScriptNumber { name: &'static str, value: f64 },
    #[error(
        "{parameter} from {lower} to {upper} is no span of a map; it needs two numbers, the lesser first"
    )]
    MapSpan { parameter: &'static str, lower: f64, upper: f64 },
    #[error("axis {axis} of a map is parameter {index}; {}", indices(*.parameters))]
    MapAxis { axis: &'static str, index: usize, parameters: usize },
    #[error("{found} values for the {expected} parameters of a map")]
    MapValues { found: usize, expected: usize },
    #[error("a map of {places} places a side; it must be {least} to {most}")]
    MapPlaces { places: usize, least: usize, most: usize },
    #[error("the motion has no {what}; find the ground reactions first")]
    NothingToMeasure { what: &'static str },
    #[error(
        "{duration:.0} s at {rate} samples/s make {samples:.0} samples, more than {most}; walk fewer steps or lower the rate"
    )]
    TooManySamples { duration: f64, rate: f64, samples: f64, most: f64 },
    #[error("gravity is ({}, {}, {}) m/s²; without it nothing says which way is up", .gravity[0], .gravity[1], .gravity[2])]
    NoGravity { gravity: [f64; 3] },
    #[error("{what} of the motion has {found} entries where {expected} are needed")]
    OtherMotion { what: &'static str, found: usize, expected: usize },
    #[error("the walk has no stride that repeats itself; it needs {least} steps at least")]
    NoStride { least: usize },
    #[error("the figure has no anatomical angle '{angle}'")]
    MissingAngle { angle: String },
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
    #[error(transparent)]
    Planted(#[from] PlantedError),
    #[error(transparent)]
    Motion(#[from] MotionError),
    #[error(transparent)]
    Reaction(#[from] ReactionError),
    #[error("the walk does not close: {0}; this is a fault of the planner")]
    Profile(#[from] ProfileError),
}

fn listed(lacks: &[GaitError]) -> String {
    lacks.iter().map(|lack| format!("\n  - {lack}")).collect::<Vec<_>>().concat()
}

/// What an index of so many parameters must be.
fn indices(parameters: usize) -> String {
    match parameters.checked_sub(1) {
        Some(last) => format!("it must be 0 to {last}"),
        None => "there are no parameters".to_owned(),
    }
}

fn quoted(names: &[String]) -> String {
    names.iter().map(|name| format!("'{name}'")).collect::<Vec<_>>().join(", ")
}
