//! What a walker is told.

use crate::error::LiveError;

/// Where to go. All of it is level: x to the left and z forward of the world (m, m/s).
#[derive(Clone, Copy, Debug, PartialEq)]
enum Go {
    Stop,
    /// With this velocity in the world.
    World([f64; 2]),
    /// With this velocity to the left and forward of the way the walker faces.
    Own([f64; 2]),
    /// To a point, this fast, and to stop there.
    To([f64; 2], f64),
}

/// Which way to face.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Face {
    /// Where it goes; standing, as it stands.
    Way,
    /// To the left of z (rad).
    Heading(f64),
    /// To a point of the world: x and z (m).
    Point([f64; 2]),
}

/// What a walker is to do from now on: where to go, and which way to face.
///
/// It holds until another one is given, and is cheap to make anew for every frame.
#[doc(alias = "input")]
#[doc(alias = "control")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Command {
    go: Go,
    face: Face,
    /// What a push adds to the velocity: x and z of the world (m/s).
    drift: [f64; 2],
}

impl Default for Command {
    fn default() -> Self {
        Self::stop()
    }
}

impl Command {
    /// To come to a stand, or to stay.
    pub fn stop() -> Self {
        Self::of(Go::Stop)
    }

    /// To walk with a velocity in the world: x to the left, z forward (m/s). The walker turns to where it goes unless it is told to face
    /// elsewhere.
    pub fn velocity(x: f64, z: f64) -> Self {
        Self::of(Go::World([x, z]))
    }

    /// To walk with a velocity to the left and forward of the way the walker faces (m/s), which it keeps unless it is told to face
    /// elsewhere.
    #[doc(alias = "strafe")]
    pub fn own_velocity(left: f64, forward: f64) -> Self {
        Self::of(Go::Own([left, forward]))
    }

    /// To walk to a point of the world (x and z, m) with this speed (m/s), and to stop with the feet on either side of it.
    #[doc(alias = "go_to")]
    pub fn to_point(x: f64, z: f64, speed: f64) -> Self {
        Self::of(Go::To([x, z], speed))
    }

    /// To face a heading: an angle to the left of z (rad), any number of turns.
    #[must_use]
    pub fn facing(self, heading: f64) -> Self {
        Self { face: Face::Heading(heading), ..self }
    }

    /// To face a point of the world (x and z, m), wherever it goes.
    #[doc(alias = "look_at")]
    #[must_use]
    pub fn facing_point(self, x: f64, z: f64) -> Self {
        Self { face: Face::Point([x, z]), ..self }
    }

    fn of(go: Go) -> Self {
        Self { go, face: Face::Way, drift: [0.0; 2] }
    }

    /// The same of somebody whom a push takes along.
    pub(super) fn drifting(self, drift: [f64; 2]) -> Self {
        Self { drift, ..self }
    }

    /// Refuses numbers that are none.
    pub(super) fn check(&self) -> Result<(), LiveError> {
        let (what, numbers): (_, [f64; 3]) = match self.go {
            Go::Stop => ("stop", [0.0; 3]),
            Go::World([x, z]) => ("velocity", [x, z, 0.0]),
            Go::Own([left, forward]) => ("velocity", [left, forward, 0.0]),
            Go::To([x, z], speed) => ("point", [x, z, speed]),
        };
        let (facing, angles): (_, [f64; 2]) = match self.face {
            Face::Way => ("facing", [0.0; 2]),
            Face::Heading(heading) => ("facing", [heading, 0.0]),
            Face::Point(point) => ("facing", point),
        };
        let named = numbers.map(|value| (what, value)).into_iter().chain(angles.map(|value| (facing, value)));
        for (what, value) in named {
            if value.is_nan() || value.abs() >= FARTHEST {
                return Err(LiveError::NotFinite { what, value });
            }
        }
        Ok(())
    }

    /// What is wished at a place by a body that faces `heading`.
    pub(super) fn wish(&self, place: [f64; 2], heading: f64) -> Wish {
        let towards = |point: [f64; 2]| [point[0] - place[0], point[1] - place[1]];
        let (velocity, left) = match self.go {
            Go::Stop => ([0.0; 2], f64::INFINITY),
            Go::World(velocity) => (velocity, f64::INFINITY),
            Go::Own([left, forward]) => (ahead(heading, [left, forward]), f64::INFINITY),
            Go::To(point, speed) => {
                let way = towards(point);
                let distance = way[0].hypot(way[1]);
                if distance < ARRIVED {
                    ([0.0; 2], 0.0)
                } else {
                    (way.map(|x| x / distance * speed.abs()), distance)
                }
            }
        };
        let speed = velocity[0].hypot(velocity[1]);
        let (facing, by_way) = match self.face {
            // Within a step of a point it is too late to turn to it: the last centimetres are gone as the feet stand.
            Face::Way if matches!(self.go, Go::Own(_)) || speed < SLOWEST || left < NEAR => (heading, false),
            Face::Way => (velocity[0].atan2(velocity[1]), true),
            Face::Heading(heading) => (heading, false),
            Face::Point(point) => {
                let way = towards(point);
                (if way[0].hypot(way[1]) < NEAR { heading } else { way[0].atan2(way[1]) }, false)
            }
        };
        Wish { velocity, speed, left, facing, by_way, drift: self.drift }
    }
}

/// No number of a command is as large as this (m, m/s, rad): positions keep their last digits.
const FARTHEST: f64 = 1e6;
/// How near a walker comes to a point (m).
const ARRIVED: f64 = 0.02;
/// A speed that is taken for standing (m/s).
pub(super) const SLOWEST: f64 = 0.04;
/// How near a point may be that is faced, or turned to (m).
const NEAR: f64 = 0.3;

/// A command seen from a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wish {
    /// In the world: x and z (m/s).
    pub(super) velocity: [f64; 2],
    pub(super) speed: f64,
    /// How far it is to go (m).
    pub(super) left: f64,
    pub(super) facing: f64,
    /// Whether it faces where it goes.
    pub(super) by_way: bool,
    /// What a push adds: x and z (m/s). Nobody turns to where he is pushed.
    pub(super) drift: [f64; 2],
}

/// A level vector to the left and forward of a heading, in the world.
pub(super) fn ahead(heading: f64, [left, forward]: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = heading.sin_cos();
    [cos * left + sin * forward, cos * forward - sin * left]
}

/// A vector of the world to the left and forward of a heading.
pub(super) fn own(heading: f64, v: [f64; 2]) -> [f64; 2] {
    ahead(-heading, v)
}
