//! What a walker is told.

use crate::axes::level;
use bevy_ecs::component::Component;
use bevy_math::{Dir3, Vec3};
use solaris::gait::Command;

/// Where a [`Walker`](crate::Walker) is to go, and which way it is to face; it holds until it is changed, and stands at first.
///
/// All is seen from the walker's entity, in Bevy's axes (x right, y up, −z forward; m, m/s); heights are left aside. What cannot be walked is bent to the nearest that
/// can: see `solaris::gait::Walker`.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq)]
pub struct Steering(pub(crate) Command);

impl Steering {
    /// To come to a stand, or to stay.
    #[must_use]
    pub fn stop() -> Self {
        Self(Command::stop())
    }

    /// To walk with a velocity (m/s), and to turn to where it goes.
    #[must_use]
    pub fn velocity(velocity: Vec3) -> Self {
        let [x, z] = level(velocity);
        Self(Command::velocity(x, z))
    }

    /// To walk with a velocity in the axes of the person (m/s): x to their right, −z ahead. They keep the way they face.
    #[must_use]
    pub fn own_velocity(velocity: Vec3) -> Self {
        let [left, forward] = level(velocity);
        Self(Command::own_velocity(left, forward))
    }

    /// To walk to a point (m) with a speed (m/s), and to stop there.
    #[must_use]
    pub fn to_point(point: Vec3, speed: f32) -> Self {
        let [x, z] = level(point);
        Self(Command::to_point(x, z, speed.into()))
    }

    /// To face a direction wherever it goes. One that points straight up or down changes nothing.
    #[must_use]
    pub fn facing(self, direction: Dir3) -> Self {
        let [x, z] = level(*direction);
        if x.hypot(z) < 1e-6 {
            return self;
        }
        Self(self.0.facing(x.atan2(z)))
    }

    /// To face a point (m) wherever it goes.
    #[must_use]
    pub fn facing_point(self, point: Vec3) -> Self {
        let [x, z] = level(point);
        Self(self.0.facing_point(x, z))
    }
}
