//! When which foot stands.

use crate::complete::Completed;
use crate::ground::{GroundError, Sole};
use nalgebra::Vector3;
use solaris_model::{Figure, Interval};

/// A time during which a foot is on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stance {
    /// Index in the soles.
    pub foot: usize,
    /// From when (s).
    pub start: f64,
    /// Until when (s).
    pub end: f64,
}

/// How the ground itself moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Belt {
    /// It does not.
    Still,
    /// With this velocity (m/s, world axes): a treadmill.
    Speed(Vector3<f64>),
    /// As the feet on it do.
    #[default]
    Auto,
}

/// What counts as standing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StanceOptions {
    /// How far (m) above its own lowest height a point of the sole may be and still be down.
    pub height: f64,
    /// How fast (m/s) it may be against the ground and still be down.
    pub speed: f64,
    /// Stances, and gaps between two of one foot, that are shorter than this (s) are none.
    pub shortest: f64,
    /// The ground's own motion.
    pub belt: Belt,
}

impl Default for StanceOptions {
    /// 3 cm, 0.5 m/s, 0.1 s; the ground's motion as the feet tell it.
    fn default() -> Self {
        Self { height: 0.03, speed: 0.5, shortest: 0.1, belt: Belt::Auto }
    }
}

/// When which foot stands, and what on.
#[derive(Clone, Debug, PartialEq)]
pub struct Stances {
    /// By foot, each foot's in the order of time, not overlapping.
    pub list: Vec<Stance>,
    /// Velocity of the ground (m/s, world axes).
    pub belt: Vector3<f64>,
    /// Height of the ground along up, the direction against gravity (m).
    pub level: f64,
    /// How they were found.
    pub method: &'static str,
}

/// Finds the stances.
///
/// # Errors
///
/// Stub.
pub fn find_stances(
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &Completed,
    soles: &[Sole],
    options: &StanceOptions,
) -> Result<Stances, GroundError> {
    let _ = (figure, gravity, states, soles, options);
    Err(GroundError::Empty)
}

/// Stances of a motion whose planted points are known: a foot stands while a point of its links is planted. `level` is the
/// height of the ground (m), which stands still.
pub fn stances_of_planted(soles: &[Sole], planted: &[Interval], level: f64) -> Stances {
    let _ = (soles, planted);
    Stances { list: Vec::new(), belt: Vector3::zeros(), level, method: "planted points" }
}
