//! Somebody walks to a point, without a window: `cargo run --example walk`.

use bevy_app::{App, AppExit, ScheduleRunnerPlugin, Startup, TaskPoolPlugin, Update};
use bevy_ecs::prelude::*;
use bevy_math::Vec3;
use bevy_solaris::solaris::model::{Human, RootOrder};
use bevy_solaris::{Skeleton, SolarisPlugin, Steering, Walker};
use bevy_time::TimePlugin;
use bevy_transform::TransformPlugin;
use std::time::Duration;

fn spawn(mut commands: Commands) -> Result {
    let ann = Human::new(1.65, 58.0).root(RootOrder::Yzx).build()?;
    commands.spawn((Walker::new(ann)?, Skeleton, Steering::to_point(Vec3::new(2.0, 0.0, -1.0), 1.3)));
    Ok(())
}

fn look(walkers: Query<&Walker>, mut exit: MessageWriter<AppExit>) {
    for walker in &walkers {
        let place = walker.place().translation;
        println!("{place:.2}");
        if walker.is_standing() && place.length() > 1.0 {
            exit.write(AppExit::Success);
        }
    }
}

fn main() {
    let frame = Duration::from_secs_f64(1.0 / 60.0);
    let around =
        (TaskPoolPlugin::default(), ScheduleRunnerPlugin::run_loop(frame), TimePlugin, TransformPlugin);
    App::new()
        .add_plugins(around)
        .add_plugins(SolarisPlugin::default())
        .add_systems(Startup, spawn)
        .add_systems(Update, look)
        .run();
}
