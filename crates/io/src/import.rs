//! The result of reading a model file of another program.

use solaris_model::{Figure, Finding, Vector3};

/// A figure from a file of another program, with what there is to say about it.
#[derive(Clone, Debug)]
pub struct Import {
    /// The figure; links that cannot move against each other are one.
    pub figure: Figure,
    /// What the file says and a figure cannot hold, what looks wrong, what was done; in the order of the file.
    pub findings: Vec<Finding>,
    /// Gravity (m/s²) along the world's axes: the file's, or else 9.80665 along the format's own down axis.
    pub gravity: Vector3<f64>,
    /// Whether gravity is the file's.
    pub gravity_is_given: bool,
}
