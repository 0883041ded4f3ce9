//! A figure and its motion in one file: what is asked of a reader of bones, and what it answers.

pub(crate) mod bones;
pub(crate) mod coordinates;
pub(crate) mod masses;

use crate::bvh::Unit;
use solaris_model::{Figure, Finding, Motion};

/// Which of the file's axes points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Up {
    /// y, as most tools write.
    #[default]
    Y,
    /// z. The file's y, z, x become the figure's x, y, z.
    Z,
}

/// What a file does not say; what is left out is guessed, and a finding says what was.
#[derive(Clone, Debug, Default)]
pub struct ReadOptions {
    /// The unit of lengths.
    pub unit: Option<Unit>,
    /// The axis that points up.
    pub up: Option<Up>,
    /// The body's mass (kg).
    pub mass: Option<f64>,
    /// Masses of bones by their names (kg); those that it does not name have none. Empty where masses are a person's.
    pub masses: Vec<(String, f64)>,
    /// Frames that are left out at the beginning, such as a reference pose.
    pub skip: usize,
    /// Which motion of several, by its name; the first where it is not said. BVH has one.
    pub clip: Option<String>,
}

/// What a file of bones holds.
#[derive(Clone, Debug)]
pub struct Clip {
    /// A link a bone; x left, y up, z forward where the file has that.
    pub figure: Figure,
    /// Its positions; nothing else is known.
    pub motion: Motion,
    /// What was guessed, done and found.
    pub findings: Vec<Finding>,
    /// The unit that lengths were read in.
    pub unit: Unit,
}
