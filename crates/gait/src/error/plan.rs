//! Errors of plans: why one does not hold.

/// Why what was planned cannot be walked.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs, reason = "each message says what its fields are")]
pub enum PlanError {
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
    #[error(
        "{options} with steps of {step_length:.3} m at {step_frequency} steps/min: {what}; the nearest that holds is {nearest}"
    )]
    Options { options: String, step_length: f64, step_frequency: f64, what: String, nearest: String },
    #[error(
        "part {part} of the walk, step {step}, at {time:.2} s: {what}; change the pace or turn by less at once, or take more steps \
         for it"
    )]
    AbruptChange { part: usize, step: usize, time: f64, what: String },
    #[error("step {step} of the path, near ({x:.2}, {z:.2}) at {time:.2} s: {what}{nearest}")]
    OnPath { step: usize, x: f64, z: f64, time: f64, what: String, nearest: String },
    #[error("a walk backward is one forward in reversed time, and that would not hold: {why}")]
    Backward { why: Box<PlanError> },
    #[error("the manner, or the variability, that is asked for: {why}; {part} of it holds")]
    OnlyPart { part: f64, why: Box<crate::error::GaitError> },
    #[error("a run at {speed:.2} m/s: {what}; {nearest}")]
    NotRunnable { speed: f64, what: String, nearest: String },
    #[error("{what}; {nearest}")]
    NoRise { what: String, nearest: String },
    #[error(
        "step {step}: about {place:.2} m along the way no foot finds a place: a sole needs {} of ground that is even to within 2 mm and rises \
         by no more than 16°, no more than 16° above or below the foot before; smooth the ground, or change the step length or the number of steps",
        "its own length"
    )]
    NoFoothold { step: usize, place: f64 },
    #[error("{what} at step {step}, {time:.2} s, on ground that is not level; {nearest}")]
    TooSteep { step: usize, time: f64, what: String, nearest: String },
    #[error("the centre of mass has no periodic path: the prescribed forces do not carry the body")]
    NoPath,
    #[error(
        "no stride repeats itself where steps are not alike, as from standing, at other speeds or with a load in one hand"
    )]
    StepsDiffer,
    #[error("the walk has no stride that repeats itself; it needs {least} steps at least")]
    NoStride { least: usize },
}
