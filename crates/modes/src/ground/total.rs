//! The whole wrench of the ground in a motion.

use crate::complete::Completed;
use crate::ground::GroundError;
use nalgebra::Vector3;
use solaris_model::Figure;

/// What the ground must do to the figure at one time, and where its centre of mass is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BalanceFrame {
    /// When (s).
    pub time: f64,
    /// Force (N, world axes).
    pub force: Vector3<f64>,
    /// Moment about the world's origin (N m).
    pub moment: Vector3<f64>,
    /// Centre of mass (m).
    pub com: Vector3<f64>,
    /// Centre of pressure (m); `None` where nothing presses on the ground.
    pub cop: Option<Vector3<f64>>,
}

/// The whole wrench of the ground, frame by frame.
///
/// # Errors
///
/// Stub.
pub fn balance(
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &Completed,
    level: f64,
) -> Result<Vec<BalanceFrame>, GroundError> {
    let _ = (figure, gravity, states, level);
    Err(GroundError::Empty)
}
