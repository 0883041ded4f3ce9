#![doc = include_str!("../README.md")]

mod axes;
mod bones;
mod steering;
mod walker;

pub use bones::{Bone, Skeleton};
pub use solaris;
pub use steering::Steering;
pub use walker::Walker;

use bevy_app::{App, Plugin, Update};
use bevy_ecs::intern::Interned;
use bevy_ecs::schedule::{IntoScheduleConfigs, ScheduleLabel, SystemSet};

/// Has every [`Walker`] walk, and its [`Bone`]s follow.
///
/// By default in `Update`, by the time of a frame: a walker is smooth at any. `SolarisPlugin::new(FixedUpdate)` has everybody walk to the
/// same bits on every machine and at every rate of frames.
pub struct SolarisPlugin {
    schedule: Interned<dyn ScheduleLabel>,
}

impl SolarisPlugin {
    /// In another schedule than `Update`.
    pub fn new(schedule: impl ScheduleLabel) -> Self {
        Self { schedule: schedule.intern() }
    }
}

impl Default for SolarisPlugin {
    fn default() -> Self {
        Self::new(Update)
    }
}

/// What the plug-in does in a frame: steer before it, look at bones after it.
#[derive(SystemSet, Debug, Hash, PartialEq, Eq, Clone)]
pub struct SolarisSystems;

impl Plugin for SolarisPlugin {
    fn build(&self, app: &mut App) {
        let systems = (bones::grow, bones::adopt, walker::step, bones::pose);
        app.add_systems(self.schedule, systems.chain().in_set(SolarisSystems));
    }
}
