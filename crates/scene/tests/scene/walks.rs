//! Walks on the ground of a scene: the plan's own ground, contact of what hangs loose, and the balance of all forces.

use crate::faults::{faults, person};
use crate::fixtures::fixture;
use nalgebra::Vector3;
use solaris_dynamics::{Frame, Tree, Workspace, accelerations, forward_kinematics};
use std::fmt::Write;

#[test]
fn a_walk_up_a_slope_stands_on_it_and_a_stick_touches_it() {
    let scene = fixture("walk_slope.ron");
    let simulated = scene.simulate(&mut ()).expect("runs");
    let (figure, motion) = (scene.figure(), &simulated.motion);
    let slope = 6_f64.to_radians();
    assert_eq!(motion.info.ground.expect("a ground").friction, Some(0.7));
    let relief = motion.relief.as_ref().expect("a relief");
    assert!((relief.height(2.0) - 2.0 * slope.tan()).abs() < 1e-12 && relief.height(0.0).abs() < 1e-12);
    // What is planted is on the plane.
    let tree = Tree::<f64>::new(figure, Vector3::zeros()).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    let mut planted = 0;
    for frame in (0..motion.len()).step_by(5) {
        let time = motion.time()[frame];
        forward_kinematics(&tree, &mut workspace, motion.q(frame)).expect("finite");
        for interval in motion.planted.iter().filter(|x| x.start <= time && time <= x.end) {
            let at = workspace.pose(interval.link).transform(&interval.point);
            assert!(
                (at.y - at.z * slope.tan()).abs() < 2e-3,
                "{} at {time}: {at}",
                figure.links()[interval.link].name()
            );
            planted += 1;
        }
    }
    assert!(planted > 200, "{planted}");
    // The stick bears something where it is in the ground, with its damper up to three times its spring, and friction is within its cone.
    let stick = motion.contacts.iter().find(|track| track.link == "right_hand").expect("the stick touches");
    let up = Vector3::new(0.0, slope.cos(), -slope.sin());
    let hand = figure.link_index("right_hand").expect("a hand");
    let mut most = 0.0_f64;
    for (frame, contact) in stick.samples.iter().enumerate() {
        let normal = contact.force.dot(&up);
        most = most.max(normal);
        assert!((contact.force - up * normal).norm() <= 0.7 * normal + 1e-9);
        if normal > 1.0 {
            forward_kinematics(&tree, &mut workspace, motion.q(frame)).expect("finite");
            let depth = 0.02 - workspace.pose(hand).transform(&Vector3::new(0.0, -0.86, 0.0)).dot(&up);
            assert!(depth > 0.0 && normal < 3.0 * 4000.0 * depth, "{normal} N at {depth} m");
        }
    }
    assert!(most > 2.0, "{most}");
    assert!(
        motion
            .contacts
            .iter()
            .all(|track| ["left_foot", "right_foot", "right_hand"].contains(&track.link.as_str()))
    );
    // Feet and stick together are the weight and what accelerates the links, one by one.
    let mut worst = 0.0_f64;
    for frame in 0..motion.len() {
        let total: Vector3<f64> = motion.contacts.iter().map(|track| track.samples[frame].force).sum();
        let (q, v, a) = (motion.q(frame), motion.v(frame), motion.a(frame));
        accelerations(&tree, &mut workspace, q, v, a).expect("finite");
        let links = figure.links().iter().enumerate();
        let expected: Vector3<f64> = links
            .map(|(i, link)| {
                let moved = Frame::at(i, *link.com()).acceleration(&workspace).linear;
                (moved + Vector3::y() * 9.806_65) * link.mass()
            })
            .sum();
        worst = worst.max((total - expected).norm());
    }
    assert!(worst < 1e-8, "{worst} N");
    let reactions = simulated.reactions.expect("reactions");
    assert!(reactions.root_force < 1e-9 && reactions.root_moment < 1e-9);
}

#[test]
fn a_cane_bears_its_part_in_a_scene_too() {
    let text = "Scene(version: 1, figures: {\"ann\": Figure(body: Human(height: 1.65, mass: 58, cane: \"right\"))}, \
                walk: Walk(steps: 6, step_frequency: 85))";
    let scene = solaris_scene::read(text, &mut solaris_scene::NoFiles).expect("a scene");
    let simulated = scene.simulate(&mut ()).expect("runs");
    let motion = &simulated.motion;
    let weight = scene.figure().mass() * 9.80665;
    let track = |link: &str| motion.contacts.iter().find(|track| track.link == link).expect("a track");
    let [cane, left, right] = ["cane", "left_foot", "right_foot"].map(track);
    let part = |frame: usize| {
        let [cane, left, right] = [cane, left, right].map(|track| track.samples[frame].force.y);
        cane / (cane + left + right)
    };
    let most = (0..motion.len()).map(part).fold(0.0, f64::max);
    assert!((most - 0.15).abs() < 2e-3, "{most}");
    let beside = simulated.reactions.expect("reactions").from_prescribed.expect("prescribed");
    assert!(beside.value < 0.02 * weight, "{beside:?}");
    // The left foot, which it helps, goes first.
    let lifts = motion.events.iter().find_map(|event| match &event.kind {
        solaris_model::EventKind::LiftOff { link } => Some(link.as_str()),
        _ => None,
    });
    assert_eq!(lifts, Some("left_foot"));
}

#[test]
fn a_walk_up_stairs_is_that_of_the_walker() {
    let scene = fixture("walk_stairs.ron");
    let simulated = scene.simulate(&mut ()).expect("runs");
    let relief = simulated.motion.relief.as_ref().expect("a relief");
    assert!((relief.range().1 - 0.85).abs() < 1e-12);
    assert_eq!(scene.notes(), &[] as &[String]);
    let end = simulated.motion.len() - 1;
    let height = scene.figure().layout().dof_index("root.ty").expect("a root");
    let climbed = simulated.motion.q(end)[height] - simulated.motion.q(0)[height];
    assert!((climbed - 0.85).abs() < 1e-3, "{climbed}");
}

#[test]
fn faults_of_grounds_under_walks() {
    let mut said = String::new();
    for case in [
        "walk: Walk(steps: 3), ground: Flat(friction: 0.8)",
        "walk: Walk(steps: 3), ground: Flat(friction: 0.8, height: 1, up: (0, 1, 0.1), stand: true)",
        "walk: Walk(steps: 3), ground: Slope(friction: 0.8)",
        "walk: Walk(steps: 3), ground: Slop(friction: 0.8)",
        "walk: Walk(steps: 3), ground: Slope(friction: 0.8, rise: deg(35))",
        "walk: Walk(steps: 3), ground: Slope(friction: 0.8, rise: deg(95))",
        "walk: Walk(steps: 3, turn: deg(5)), ground: Slope(friction: 0.8, rise: deg(5))",
        "walk: [Walk(steps: 3), Stand(time: 1)], ground: Slope(friction: 0.8, rise: deg(5))",
        "walk: Walk(), ground: Stairs(friction: 0.8, rise: 0.5)",
        "walk: Walk(), ground: Stairs(friction: 0.8, count: 3.5, rise: 0.5, thread: 2)",
        "walk: Walk(), ground: Stairs(friction: 0.8, count: 3, rise: 0.5)",
        "walk: Walk(), ground: Relief(friction: 0.8, points: [(0, 0), (1, 0, 1)])",
        "walk: Walk(), ground: Relief(friction: 0.8, points: [(0, 0), (1, 0.1), (0.5, 0.2)])",
        "walk: Walk(), ground: Relief(friction: 0.8, points: [])",
        "duration: 1, ground: Stairs(friction: 0.8, count: 3)",
        "duration: 1, gravity: (0, 0, -9.81), ground: Slope(friction: 0.8, rise: deg(5))",
    ] {
        let _ = write!(said, "{case}\n{}\n\n", faults(&person(case)));
    }
    insta::assert_snapshot!(said);
}

#[test]
fn what_hangs_loose_over_stairs_is_said_to_go_through_them() {
    let text =
        person("walk: Walk(), ground: Stairs(friction: 0.8, count: 3), drives: {\"right_elbow.rx\": Free}");
    let scene = solaris_scene::read(&text, &mut solaris_scene::NoFiles).expect("a scene");
    assert_eq!(
        scene.notes(),
        ["'right_forearm', and what else dynamics move, touches planes alone, and goes through stairs"]
    );
}
