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
    /// A place for each foot, one after the other: stepping stones. They say how many steps there are.
    Footholds(Vec<Foothold>),
}

impl WalkGround {
    /// Steps a minute where no pace is asked for: over slopes and other ground 100, up stairs 88; `None` on level ground, where people's
    /// own pace holds ([`crate::DEFAULT_STEP_FREQUENCY`]).
    pub fn usual_step_frequency(&self) -> Option<f64> {
        match self {
            Self::Level => None,
            Self::Stairs(stairs) if stairs.rise > 0.0 => Some(88.0),
            Self::Slope(_) | Self::Stairs(_) | Self::Relief(_) | Self::Footholds(_) => Some(100.0),
        }
    }
}

/// A place for one foot. Both feet stand on level ground at first, heels at z = 0 and y = 0; the first foothold is the first foot's, the last one that of the
/// last step, and the other foot closes beside it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[doc(alias = "stepping stone")]
#[doc(alias = "footstep")]
pub struct Foothold {
    /// Place of the heel to the left of the middle between the standing feet (m); half a step width on the foot's own side for `None`.
    pub x: Option<f64>,
    /// Place of the heel ahead of where it stands at first (m).
    pub z: f64,
    /// Height there (m).
    pub height: f64,
    /// Pitch of the ground under the sole, uphill positive (rad).
    pub pitch: f64,
    /// Which way the foot points besides its usual turn outward, to the left of z (rad); the body goes along.
    pub heading: f64,
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
