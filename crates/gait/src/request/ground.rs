//! The ground that a walk goes over.

use solaris_model::Relief;

/// Numbers of stairs that may be climbed.
pub const STAIR_COUNT: (usize, usize) = (1, 200);

/// What is walked on.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum WalkGround {
    /// A horizontal plane.
    #[default]
    Level,
    /// Ground that rises by this angle along the way (rad), from standing to standing.
    Slope(f64),
    /// Stairs, with some level steps before and after.
    Stairs(Stairs),
    /// Ground of this shape; feet are set down where a whole sole finds place.
    Relief(Relief),
}

/// A flight of stairs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stairs {
    /// Number of risers.
    pub count: usize,
    /// Height of a riser (m), negative for the way down.
    pub rise: f64,
    /// Depth of a tread from nosing to nosing (m).
    pub tread: f64,
}

impl Default for Stairs {
    /// Twelve usual ones up.
    fn default() -> Self {
        Self { count: 12, rise: 0.17, tread: 0.29 }
    }
}
