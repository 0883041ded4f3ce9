//! The example of docs/engines.md, with stand-ins for what of the engine this does not depend on: what stands there is what is compiled here.

use bevy_app::{App, Plugin, Startup, Update};
use bevy_ecs::prelude::*;
use bevy_math::Vec3;
use bevy_solaris::solaris::model::{Human, RootOrder};
use bevy_solaris::{Bone, Skeleton, SolarisPlugin, SolarisSystems, Steering, Walker};

const DOCS: &str = include_str!("../../docs/engines.md");

/// What `bevy_input` has.
#[derive(Resource)]
struct ButtonInput<K>(K);

#[derive(PartialEq)]
enum KeyCode {
    KeyW,
}

impl<K: PartialEq> ButtonInput<K> {
    fn pressed(&self, key: K) -> bool {
        self.0 == key
    }
}

/// What `bevy_camera` has.
#[derive(Component, Default)]
struct Visibility;

/// What the whole engine has.
struct DefaultPlugins;

impl Plugin for DefaultPlugins {
    fn build(&self, app: &mut App) {
        app.add_plugins((
            bevy_app::TaskPoolPlugin::default(),
            bevy_time::TimePlugin,
            bevy_transform::TransformPlugin,
        ));
    }
}

/// The words of a text, whatever lines they stand in, without its comments and the commas before ends that a formatter sets.
fn words(text: &str) -> String {
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    let words: String = lines.flat_map(|line| line.chars().filter(|c| !c.is_whitespace())).collect();
    words.replace(",)", ")")
}

macro_rules! shown {
    ($($code:tt)*) => {
        $($code)*
        const SYSTEMS: &str = stringify!($($code)*);
    };
}

shown! {
    fn spawn(mut commands: Commands) -> Result {
        let ann = Human::new(1.65, 58.0).root(RootOrder::Yzx).build()?;
        commands.spawn((Walker::new(ann)?, Skeleton));
        Ok(())
    }

    fn steer(keys: Res<ButtonInput<KeyCode>>, mut walkers: Query<&mut Steering>) {
        let ahead = if keys.pressed(KeyCode::KeyW) { 1.4 } else { 0.0 };
        walkers.iter_mut().for_each(|mut steering| *steering = Steering::velocity(Vec3::new(0.0, 0.0, -ahead)));
    }
}

macro_rules! app {
    ($app:ident, $($call:tt)*) => {
        (*$app)$($call)*;
        const CALLS: &str = stringify!($($call)*);
    };
}

#[test]
fn the_example_of_the_docs_walks() {
    let app = &mut App::new();
    app.insert_resource(ButtonInput(KeyCode::KeyW));
    app! { app,
        .add_plugins((DefaultPlugins, SolarisPlugin::default()))
        .register_required_components::<Bone, Visibility>()
        .add_systems(Startup, spawn)
        .add_systems(Update, steer.before(SolarisSystems))
    }
    for shown in [SYSTEMS, CALLS] {
        assert!(words(DOCS).contains(&words(shown)), "docs/engines.md has not:\n{shown}");
    }
    let step = std::time::Duration::from_millis(16);
    app.insert_resource(bevy_time::TimeUpdateStrategy::ManualDuration(step));
    (0..200).for_each(|_| app.update());
    let world = app.world_mut();
    let mut walkers = world.query::<&Walker>();
    let place = walkers.iter(world).next().expect("somebody").place().translation;
    // Ahead is -z there.
    assert!(place.z < -1.0, "{place:?}");
    let mut bones = world.query::<(&Bone, &Visibility)>();
    assert!(bones.iter(world).count() > 10);
}
