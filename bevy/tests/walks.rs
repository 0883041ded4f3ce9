//! Walkers in an app without a window: planted feet stand in Bevy's world, axes are Bevy's, bones are those of a scene too.

use bevy_app::App;
use bevy_ecs::prelude::*;
use bevy_math::{Dir3, Quat, Vec3};
use bevy_solaris::solaris::model::{Human, RootOrder, SolePart};
use bevy_solaris::{Bone, Skeleton, SolarisPlugin, Steering, Walker};
use bevy_time::{TimePlugin, TimeUpdateStrategy};
use bevy_transform::{
    TransformPlugin,
    components::{GlobalTransform, Transform},
};
use std::time::Duration;

const RATE: f64 = 60.0;

fn app() -> App {
    let mut app = App::new();
    app.add_plugins((
        bevy_app::TaskPoolPlugin::default(),
        TimePlugin,
        TransformPlugin,
        SolarisPlugin::default(),
    ))
    .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_secs_f64(1.0 / RATE)));
    app
}

fn ann() -> Walker {
    let ann = Human::new(1.65, 58.0).root(RootOrder::Yzx).build().expect("a person");
    Walker::new(ann).expect("a walker")
}

fn walk(app: &mut App, seconds: f64) {
    (0..(seconds * RATE) as usize).for_each(|_| app.update());
}

fn is_near(a: Vec3, b: Vec3, within: f32) {
    assert!((a - b).length() < within, "{a} is not {b}");
}

/// Where the bone of a link is in the world.
fn bone(app: &mut App, walker: Entity, name: &str) -> GlobalTransform {
    let link = app.world().get::<Walker>(walker).and_then(|it| it.figure().link_index(name)).expect("a link");
    let world = app.world_mut();
    let mut bones = world.query::<(&Bone, &GlobalTransform)>();
    *bones.iter(world).find(|(bone, _)| **bone == Bone { walker, link }).expect("a bone").1
}

/// Points of both soles in the world; those beneath the joint of the ball, about which the foot turns, are left out.
fn soles(app: &mut App, walker: Entity) -> Vec<Vec3> {
    let parts = [("foot", SolePart::Heel), ("toes", SolePart::Ball), ("toes", SolePart::ToeTip)];
    let mut points = Vec::new();
    for side in ["left_", "right_"] {
        for (name, part) in parts {
            let name = format!("{side}{name}");
            let figure = app.world().get::<Walker>(walker).expect("a walker").figure();
            let link = &figure.links()[figure.link_index(&name).expect("a link")];
            let [x, y, z] = link.sole_point(part).expect("a point").map(|x| x as f32).into();
            points.push(bone(app, walker, &name).transform_point(Vec3::new(x, y, z)));
        }
    }
    points
}

#[test]
fn planted_feet_stand_and_nothing_sinks() {
    let mut app = app();
    let walker = app.world_mut().spawn((ann(), Skeleton)).id();
    walk(&mut app, 0.2);
    let ways = [Vec3::new(0.0, 0.0, -1.3), Vec3::new(1.0, 0.0, -0.5), Vec3::new(-0.8, 0.0, 0.9), Vec3::ZERO];
    let mut anchors: Vec<Option<(Vec3, usize)>> = vec![None; 6];
    let mut longest = 0;
    for way in ways {
        *app.world_mut().get_mut::<Steering>(walker).expect("steering") = Steering::velocity(way);
        for _ in 0..240 {
            app.update();
            let points = soles(&mut app, walker);
            assert!(points.iter().any(|point| point.y < 1e-4), "{points:?}");
            for (point, anchor) in points.into_iter().zip(&mut anchors) {
                assert!(point.y > -1e-5, "{point} is below the ground");
                // The first frame in which a point touches may be that in which it comes down.
                *anchor = match *anchor {
                    Some((at, frames)) if point.y < 1e-5 => {
                        assert!(frames < 2 || (point - at).length() < 2e-4, "{point} was {at}");
                        longest = longest.max(frames);
                        Some((if frames < 2 { point } else { at }, frames + 1))
                    }
                    _ => (point.y < 1e-5).then_some((point, 0)),
                };
            }
        }
    }
    assert!(longest > 40, "the last stand was to be long: {longest} frames");
    assert!(app.world().get::<Walker>(walker).expect("a walker").is_standing());
}

#[test]
fn axes_are_those_of_bevy() {
    let mut app = app();
    let walker = app.world_mut().spawn((ann(), Skeleton)).id();
    walk(&mut app, 0.1);
    // At first it faces −z; its right is x. A bone has the axes of the link: x left, z forward.
    let root = bone(&mut app, walker, "pelvis");
    is_near(root.rotation() * Vec3::Z, Vec3::NEG_Z, 0.1);
    is_near(root.rotation() * Vec3::X, Vec3::NEG_X, 0.1);
    let [left, right] = ["left_foot", "right_foot"].map(|name| bone(&mut app, walker, name).translation());
    assert!(right.x > 0.03 && left.x < -0.03, "{left} {right}");

    // Ahead, to the right, and to a point behind.
    let steer = |app: &mut App, to: Steering, seconds| {
        *app.world_mut().get_mut::<Steering>(walker).expect("steering") = to;
        walk(app, seconds);
        app.world().get::<Walker>(walker).expect("a walker").place()
    };
    let ahead = steer(&mut app, Steering::velocity(Vec3::new(0.0, 0.0, -1.2)), 4.0);
    assert!(ahead.translation.z < -3.0 && ahead.translation.x.abs() < 0.05, "{ahead:?}");
    is_near(*ahead.forward(), Vec3::NEG_Z, 0.02);
    let right = steer(&mut app, Steering::velocity(Vec3::new(1.2, 0.0, 0.0)), 5.0);
    assert!(right.translation.x > 3.0, "{right:?}");
    is_near(*right.forward(), Vec3::X, 0.02);
    let velocity = app.world().get::<Walker>(walker).expect("a walker").velocity();
    is_near(velocity, Vec3::new(1.2, 0.0, 0.0), 0.05);
    let point = Vec3::new(1.0, 0.0, 2.0);
    let there = steer(&mut app, Steering::to_point(point, 1.2), 12.0);
    is_near(there.translation, point, 0.05);
    let turned = steer(&mut app, Steering::stop().facing(Dir3::NEG_X), 6.0);
    is_near(*turned.forward(), Vec3::NEG_X, 0.02);
    // The body is where it is said to be, and looks there.
    let root = bone(&mut app, walker, "pelvis");
    is_near(root.rotation() * Vec3::Z, Vec3::NEG_X, 0.1);
    is_near(root.translation().with_y(0.0), point, 0.1);
    let turned = steer(&mut app, Steering::stop().facing_point(Vec3::new(1.0, 0.0, -9.0)), 6.0);
    is_near(*turned.forward(), Vec3::NEG_Z, 0.02);
    let strafed = steer(&mut app, Steering::own_velocity(Vec3::new(0.3, 0.0, 0.0)), 5.0);
    assert!(strafed.translation.x > 1.5, "{strafed:?}");
    is_near(*strafed.forward(), Vec3::NEG_Z, 0.1);
}

#[test]
fn the_transform_of_the_entity_places_its_world() {
    let mut app = app();
    let placed = Transform::from_xyz(5.0, 1.0, 0.0).with_rotation(Quat::from_rotation_y(1.0));
    let go = Steering::velocity(Vec3::new(0.0, 0.0, -1.2));
    let one = app.world_mut().spawn((ann(), Skeleton, go)).id();
    let other = app.world_mut().spawn((ann(), Skeleton, go, placed)).id();
    walk(&mut app, 3.0);
    for name in ["pelvis", "left_foot", "right_hand"] {
        let (one, other) = (bone(&mut app, one, name), bone(&mut app, other, name));
        is_near(other.translation(), placed.transform_point(one.translation()), 1e-4);
    }
    assert_eq!(*app.world().get::<Transform>(other).expect("its place"), placed);
}

#[test]
fn nodes_of_a_scene_that_have_the_names_of_links_are_bones() {
    let mut app = app();
    let walker = app.world_mut().spawn((ann(), Steering::velocity(Vec3::NEG_Z))).id();
    walk(&mut app, 0.5);
    // A scene comes later, with a node of its own above and one that is nobody's link below.
    let scene = app.world_mut().spawn((Name::new("scene"), Transform::default(), ChildOf(walker))).id();
    let figure = app.world().get::<Walker>(walker).expect("a walker").figure().clone();
    let mut nodes: Vec<Entity> = Vec::new();
    for link in figure.links() {
        let parent = link.parent().map_or(scene, |parent| nodes[parent]);
        let node = (Name::new(link.name().to_owned()), Transform::default(), ChildOf(parent));
        nodes.push(app.world_mut().spawn(node).id());
    }
    let hat = app.world_mut().spawn((Name::new("hat"), Transform::default(), ChildOf(nodes[0]))).id();
    walk(&mut app, 2.0);
    assert!(!app.world().entity(hat).contains::<Bone>() && !app.world().entity(scene).contains::<Bone>());
    // They are where the figure's own forward kinematics has them, turned by half about y.
    let q = app.world().get::<Walker>(walker).expect("a walker").inner().configuration().to_vec();
    for (node, place) in nodes.into_iter().zip(figure.places(&q)) {
        let found = app.world().get::<GlobalTransform>(node).expect("a place").translation();
        let [x, y, z] = place.translation.vector.map(|x| x as f32).into();
        is_near(found, Vec3::new(-x, y, -z), 1e-5);
    }
}

#[test]
fn what_cannot_be_walked_is_said_and_long_frames_are_gone_through() {
    static SAID: std::sync::Mutex<String> = std::sync::Mutex::new(String::new());
    let mut app = app();
    app.set_error_handler(|error, _| *SAID.lock().expect("a text") = error.to_string());
    let bad = app.world_mut().spawn((ann(), Steering::velocity(Vec3::NAN))).id();
    let good = app.world_mut().spawn((ann(), Steering::velocity(Vec3::NEG_Z))).id();
    walk(&mut app, 2.0);
    let said = SAID.lock().expect("a text").clone();
    assert!(said.contains(&format!("{bad}")) && said.contains("velocity"), "{said}");
    let place = |app: &App, it| app.world().get::<Walker>(it).expect("a walker").place().translation;
    assert!(place(&app, bad).length() < 1e-6 && place(&app, good).z < -1.0);
    // A frame of more than a quarter of a second is gone through in parts.
    let before = place(&app, good).z;
    app.world_mut()
        .resource_mut::<bevy_time::Time<bevy_time::Virtual>>()
        .set_max_delta(Duration::from_secs(5));
    app.insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_secs(2)));
    app.update();
    assert!(place(&app, good).z < before - 1.0);
}
