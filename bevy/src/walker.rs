//! The walker, and its steps through time.

use crate::axes::raised;
use crate::steering::Steering;
use bevy_ecs::component::Component;
use bevy_ecs::entity::Entity;
use bevy_ecs::error::BevyError;
use bevy_ecs::system::{Query, Res};
use bevy_math::{Quat, Vec3};
use bevy_time::Time;
use bevy_transform::components::Transform;
use solaris::gait::{self, GaitError, LiveError};
use solaris::model::Figure;
use std::sync::Arc;

/// The longest frame of a walker (s); longer ones are gone through in parts.
const LONGEST: f64 = 0.25;

/// Somebody who walks as [`Steering`] says.
///
/// The `Transform` of its entity says where the world is that it walks in: it begins at the origin there and faces −z, and the ground is at y = 0. It is the user's,
/// and stays as it is; where the walker has come to is [`Walker::place`].
///
/// A clone goes on from the same posture, and shares what was planned: make one walker and clone it for a crowd.
#[derive(Component, Clone)]
#[require(Steering, Transform)]
pub struct Walker {
    figure: Arc<Figure>,
    walker: gait::Walker,
}

impl Walker {
    /// Plans for some dozens of milliseconds.
    ///
    /// # Errors
    ///
    /// A figure that cannot walk, and one whose root does not turn by its heading first (`RootOrder::Yzx`).
    pub fn new(figure: Figure) -> Result<Self, GaitError> {
        let walker = gait::Walker::new(&figure)?;
        Ok(Self { figure: Arc::new(figure), walker })
    }

    /// Who walks.
    #[must_use]
    pub fn figure(&self) -> &Figure {
        &self.figure
    }

    /// The walker itself, in its own axes: x left, z forward.
    #[must_use]
    pub fn inner(&self) -> &gait::Walker {
        &self.walker
    }

    /// The same, to free coordinates and to set them.
    #[must_use]
    pub fn inner_mut(&mut self) -> &mut gait::Walker {
        &mut self.walker
    }

    /// Where it is on the ground and which way it faces, seen from its entity.
    #[must_use]
    pub fn place(&self) -> Transform {
        let turn = Quat::from_rotation_y(self.walker.heading() as f32);
        Transform::from_translation(raised(self.walker.place())).with_rotation(turn)
    }

    /// The velocity that its present step makes (m/s), seen from its entity.
    #[must_use]
    pub fn velocity(&self) -> Vec3 {
        raised(self.walker.velocity())
    }

    /// Whether both feet stand and no step has begun.
    #[must_use]
    pub fn is_standing(&self) -> bool {
        self.walker.is_standing()
    }

    /// Goes on by `dt` (s).
    fn advance(&mut self, dt: f64, steering: &Steering) -> Result<(), LiveError> {
        let parts = (dt / LONGEST).ceil();
        for _ in 0..parts as usize {
            self.walker.step(dt / parts, &steering.0)?;
        }
        Ok(())
    }
}

/// Has everybody walk on by the time of this schedule. Who is told what cannot be (a number that is none) stays where they are, and it is the system's
/// error, which the app's handler gets.
pub(crate) fn step(
    time: Res<Time>,
    mut walkers: Query<(Entity, &mut Walker, &Steering)>,
) -> Result<(), BevyError> {
    let dt = time.delta_secs_f64();
    let mut refused = None;
    for (entity, mut walker, steering) in &mut walkers {
        if dt > 0.0
            && let Err(error) = walker.advance(dt, steering)
        {
            refused.get_or_insert_with(|| format!("the walker of entity {entity}: {error}"));
        }
    }
    refused.map_or(Ok(()), |message| Err(message.into()))
}
