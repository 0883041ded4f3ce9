//! Errors of requests: numbers out of range, too many or too few of them.

/// Why a request is refused before anything is planned.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs, reason = "each message says what its fields are")]
pub enum RequestError {
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
    #[error(
        "step frequency, step length and speed are all given ({step_frequency} steps/min, {step_length} m, {speed} m/s); any two decide the third: drop one"
    )]
    Overdetermined { step_frequency: f64, step_length: f64, speed: f64 },
    #[error("there is no style parameter '{name}'; there are {known}")]
    UnknownParameter { name: String, known: String },
    #[error(
        "a walk of {distance} m is followed by more steps; say how many steps it has, for a distance is met by the whole walk"
    )]
    DistanceThenMore { distance: f64 },
    #[error(
        "the walk turns by {turned:.1}° in all; this figure may turn by {limit}°, for at a quarter turn its root's angles (about z, y, \
         x) are singular: give it a root that turns by its heading first, in a figure's text Human(..., root: Yzx), in the library \
         Human::root(RootOrder::Yzx)"
    )]
    TurnInAll { turned: f64, limit: f64 },
    #[error(
        "a path with {points} points besides the place where the walker stands; give it 1 to {most}, as x and z in m"
    )]
    PathPoints { points: usize, most: usize },
    #[error("point {number} of the path is ({x}, {z}); both numbers must be finite (m)")]
    PathPoint { number: usize, x: f64, z: f64 },
    #[error(
        "a path of {length:.1} m needs more than {most} steps, the most of a walk that changes on the way; cut it into parts"
    )]
    PathTooLong { length: f64, most: usize },
    #[error(
        "the path bends by {turn:.0}° within a tenth of a step near ({x:.2}, {z:.2}); a step turns by {most:.0}° at most: give \
         the bend more room, or a single corner that can be rounded"
    )]
    PathBends { x: f64, z: f64, turn: f64, most: f64 },
    #[error(
        "a walk along a path is given {what} too; how far it goes and where it turns the path says: drop one"
    )]
    PathAndMore { what: &'static str },
    #[error(
        "foot-yaw {to:.1}°: the feet stand {from:.1}° outward after the walk before, and standing feet do not turn; give all \
         walks the same"
    )]
    FeetWouldTurn { from: f64, to: f64 },
    #[error("{nodes} nodes a stride: the planner takes an even number from 20 to 10000")]
    Nodes { nodes: usize },
    #[error("{passes} passes for a walk: at least 8 are needed, the last four of which only settle")]
    Passes { passes: usize },
    #[error("{nodes} nodes a stride of a run: the planner takes an even number from {lower} to {upper}")]
    RunNodes { nodes: usize, lower: usize, upper: usize },
    #[error("{passes} passes for a run: the planner makes {lower} to {upper}")]
    RunPasses { passes: usize, lower: usize, upper: usize },
    #[error("{steps} steps to change from {from} to {to} m/s: it takes {least} at least; give it as many")]
    RunChange { steps: usize, from: f64, to: f64, least: usize },
    #[error(
        "{steps} steps: to come to {speed} m/s, and from there to how it ends, takes {least} at least; give it as many, or run slower"
    )]
    RunSteps { steps: usize, speed: f64, least: usize },
    #[error("{steps} steps; it must be {fewest} to {most}")]
    RunWalkSteps { steps: usize, fewest: usize, most: usize },
    #[error("a speed of {speed} m/s; it must be {least:.2} to {most:.2} m/s")]
    RunWalkSpeed { speed: f64, least: f64, most: f64 },
    #[error("a run at {speed} m/s beside a walk at {walk:.2} m/s; it must be no slower than the walk")]
    RunSlowerThanWalk { speed: f64, walk: f64 },
    #[error(
        "a run of {steps} steps that changes its speed: it is planned whole, and has {most} at most; run on in full run with another"
    )]
    RunTooLong { steps: usize, most: usize },
    #[error(
        "a run of {distance} m that changes its speed: how far its steps go is found with them; say how many they are"
    )]
    RunDistance { distance: f64 },
    #[error("there is no manner '{name}'; {known}")]
    UnknownManner { name: String, known: String },
    #[error("{part:?} of the manner '{manner}': it must be a number from 0 to {most}, as in sad:0.6")]
    MannerPart { manner: String, part: String, most: f64 },
    #[error("the style's {name} is {value}; it must be a finite number")]
    StyleNotFinite { name: &'static str, value: f64 },
    #[error(transparent)]
    Relief(solaris_model::ReliefError),
    #[error("foothold {number}: {why}")]
    Foothold { number: usize, why: String },
    #[error("{what} on ground that is not level: not planned yet; walk one part straight on there")]
    NotOnTerrain { what: &'static str },
    #[error("{what} backward: not planned yet; walk forward there, or stop and stand before and after it")]
    NotBackward { what: &'static str },
    #[error("{one} and {other} are both given; drop one")]
    Both { one: &'static str, other: &'static str },
    #[error("{option} is given, which is not of {of}; drop it")]
    NotOf { option: &'static str, of: &'static str },
    #[error("there is no {what} '{name}'; {known}")]
    Unknown { what: &'static str, name: String, known: String },
    #[error("what comes next says nothing; give it steps, or stand")]
    NothingNext,
    #[error(
        "what comes next as number {number} is a distance of {distance} m, on the way; say how many steps, or stand before it"
    )]
    DistanceOnTheWay { number: usize, distance: f64 },
    #[error("what comes next as number {number} goes backward, on the way; stand before it")]
    BackwardOnTheWay { number: usize },
    #[error("cane load: the figure holds no cane; give it one, or leave the load out")]
    NoCane,
    #[error("a sequence without a walk; give it one, if only of a single step")]
    NoWalk,
}
