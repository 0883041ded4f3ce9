//! Several who walk in one scene: each as alone, elsewhere, and what else moves beside them.

use crate::fixtures::fixture;
use nalgebra::{UnitQuaternion, Vector3};
use solaris_dynamics::{Tree, Workspace, momentum};
use solaris_model::{EventKind, Link};
use solaris_scene::{NoFiles, Simulated, read};

const ANN: &str = "Human(height: 1.65, mass: 58.0)";
const BOB: &str = "Human(height: 1.82, mass: 80.0)";
const ANN_WALKS: &str = "Walk(steps: 4, step_frequency: 105)";
const BOB_WALKS: &str = "[Stand(time: 0.5), Walk(steps: 3, step_frequency: 112)]";

fn run(text: &str) -> Simulated {
    let scene = read(text, &mut NoFiles).unwrap_or_else(|error| panic!("{text}\n{error}"));
    scene.simulate(&mut ()).expect("a motion")
}

fn alone(figure: &str, walk: &str) -> Simulated {
    run(&format!(
        "Scene(version: 1, figures: {{\"who\": {figure}}}, walk: {walk}, ground: Flat(friction: 0.6))"
    ))
}

#[test]
fn each_walks_as_alone_where_its_place_is() {
    let both = run(&format!(
        "Scene(version: 1, figures: {{\"ann\": {ANN}, \"bob\": {BOB}}}, walk: {{\"bob\": {BOB_WALKS}, \"ann\": {ANN_WALKS}}},
        places: {{\"bob\": (at: (0.8, 0, 3), facing: deg(150))}}, ground: Flat(friction: 0.6))"
    ));
    let singles = [alone(ANN, ANN_WALKS), alone(BOB, BOB_WALKS)];
    let turn = UnitQuaternion::from_scaled_axis(Vector3::y() * 150_f64.to_radians());
    let places = [(Vector3::zeros(), UnitQuaternion::identity()), (Vector3::new(0.8, 0.0, 3.0), turn)];
    assert!(both.motion.len() == singles[0].motion.len().max(singles[1].motion.len()));
    for (who, (single, (at, turn))) in singles.iter().zip(places).enumerate() {
        let (name, rows) = (["ann", "bob"][who], 66 * who..66 * (who + 1));
        for frame in 0..single.motion.len() {
            for (whole, own) in [
                (both.motion.q(frame), single.motion.q(frame)),
                (both.motion.v(frame), single.motion.v(frame)),
                (both.motion.tau(frame).expect("forces"), single.motion.tau(frame).expect("forces")),
            ] {
                let off = whole[rows.clone()].iter().zip(own).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(off < 1e-7, "{name}, frame {frame}: {off}");
            }
            for foot in ["left_foot", "right_foot"] {
                let of = |simulated: &Simulated, link: &str| {
                    simulated.motion.contact(link).expect("a foot").samples[frame]
                };
                let (whole, own) = (of(&both, &format!("{name}.{foot}")), of(single, foot));
                assert!((whole.force - turn * own.force).norm() < 1e-6, "{name}, {foot}");
                let moment = turn * own.moment + at.cross(&(turn * own.force));
                assert!((whole.moment - moment).norm() < 1e-6, "{name}, {foot}");
                if own.force.y > 20.0 {
                    assert!((whole.cop - (turn * own.cop + at)).norm() < 1e-9, "{name}, {foot}");
                }
            }
        }
        // Who is there first stands.
        let last = both.motion.len() - 1;
        let end = single.motion.q(single.motion.len() - 1);
        let off = both.motion.q(last)[rows].iter().zip(end).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-9, "{name} goes on: {off}");
    }
    // In the frames up to the end of the shorter one, events and planted points are those of both.
    let named = both.motion.events.iter().filter(|event| {
        matches!(&event.kind, EventKind::TouchDown { link } | EventKind::LiftOff { link } if link.starts_with("bob."))
    });
    assert_eq!(named.count(), singles[1].motion.events.len());
    assert_eq!(
        both.motion.planted.len(),
        singles.iter().map(|single| single.motion.planted.len()).sum::<usize>()
    );
    let moved = both.motion.planted.iter().filter(|planted| planted.link > 21).count();
    assert_eq!(moved, singles[1].motion.planted.len());
    let worst = singles.iter().filter_map(|single| single.reactions.as_ref()).map(|own| own.root_force);
    let found = both.reactions.expect("reactions").root_force;
    assert!((found - worst.fold(0.0, f64::max)).abs() < 1e-6);
}

/// `dp/dt = ΣF + m·g` of who walks, with all that touches her: the feet bear what is pushed.
#[test]
fn what_is_met_is_borne_by_the_feet() {
    let scene = fixture("crossing.ron");
    let Simulated { motion, .. } = scene.simulate(&mut ()).expect("a motion");
    let figure = scene.figure();
    let tree = Tree::<f64>::new(figure, Vector3::zeros()).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    // The gate opens and falls shut, and the ball is knocked away.
    let of = |name: &str| figure.layout().dof_index(name).expect("a dof");
    let widest = |name: &str| (0..motion.len()).map(|i| motion.q(i)[of(name)].abs()).fold(0.0, f64::max);
    assert!(widest("gate.hinge.ry") > 0.7 && widest("ball.hook.rx") > 0.5);
    assert!(motion.q(motion.len() - 1)[of("gate.hinge.ry")].abs() < 0.2);
    for who in ["ann.", "bob."] {
        let links: Vec<_> = figure.links().iter().filter(|link| link.name().starts_with(who)).collect();
        let mass: f64 = links.iter().map(|link| link.mass()).sum();
        let mut of_her = |frame: usize| {
            let mut v = motion.v(frame).to_vec();
            for (v, name) in v.iter_mut().zip(figure.layout().v_names()) {
                *v *= f64::from(u8::from(name.starts_with(who)));
            }
            momentum(&tree, &mut workspace, motion.q(frame), &v).expect("finite").linear
        };
        let (mut touched, mut worst, mut sum) = (0, 0.0_f64, 0.0);
        for frame in 2..motion.len() - 2 {
            let step = motion.time()[frame + 1] - motion.time()[frame];
            // The derivative of a polynomial of degree four.
            let [a, b, c, d] = [frame - 2, frame - 1, frame + 1, frame + 2].map(&mut of_her);
            let rate = (a - d + (c - b) * 8.0) / (12.0 * step);
            let (mut force, mut met) = (Vector3::y() * -9.806_65 * mass, 0.0);
            for track in motion.contacts.iter().filter(|track| track.link.starts_with(who)) {
                force += track.samples[frame].force;
                met += if track.link.ends_with("_foot") { 0.0 } else { track.samples[frame].force.norm() };
            }
            if met > 1.0 {
                touched += 1;
                let off = (force - rate).norm() / (9.806_65 * mass);
                (worst, sum) = (worst.max(off), sum + off);
            }
        }
        // What is left are differences over two frames.
        assert!(touched >= 8, "{who} {touched}");
        assert!(worst < 0.05 && sum / f64::from(touched) < 0.01, "{who} {worst} {sum} of {touched}");
    }
}

#[test]
fn a_push_that_comes_too_late_is_noted() {
    let text = "Scene(version: 1, duration: 0.5, figures: {\"ann\": Human(height: 1.7, mass: 60)}, drives: {\"*\": Frozen}, \
                pushes: [Push(link: \"pelvis\", force: (9, 0, 0), from: 3), Push(link: \"head\", force: (9, 0, 0), from: 0.4)])";
    let found = read(text, &mut NoFiles).expect("a scene");
    assert_eq!(
        found.notes(),
        ["the push on 'pelvis' begins at 3 s, and the scene is over at 0.5 s: it does nothing"]
    );
}

/// Pushes and springs on who walks are borne by the feet and the drives: what they press changes by just that, alone and beside somebody else.
#[test]
fn what_pushes_and_pulls_is_borne_by_the_feet() {
    let alone =
        "figures: {\"ann\": Human(height: 1.65, mass: 58)}, walk: Walk(steps: 3, step_frequency: 105)";
    let both = "figures: {\"bob\": Human(height: 1.8, mass: 80), \"ann\": Human(height: 1.65, mass: 58)}, \
                places: {\"ann\": (at: (1, 0, 0.5), facing: deg(40))}, walk: {\"ann\": Walk(steps: 3, step_frequency: 105)}, drives: {\"bob.*\": Frozen}";
    for (scene, who) in [(alone, ""), (both, "ann.")] {
        let run = |fields: &str| {
            let text = format!("Scene(version: 1, rate: 60, {scene}, {fields})");
            read(&text, &mut NoFiles).expect("a scene").simulate(&mut ()).expect("a motion")
        };
        let plain = run("");
        let push = format!(
            "pushes: [Push(link: \"{who}thorax\", at: (0, 0.1, 0), force: (10, -20, 40), from: 1.2, over: 0.6)]"
        );
        let spring = format!(
            "springs: [Spring(between: ((\"{who}pelvis\", (0, 0, 0)), (\"world\", (1, 3, 1))), stiffness: 20)]"
        );
        let feet = |found: &Simulated, frame: usize| -> Vector3<f64> {
            let of = |link: &str| {
                found.motion.contact(&format!("{who}{link}")).expect("a foot").samples[frame].force
            };
            of("left_foot") + of("right_foot")
        };
        let (pushed, pulled) = (run(&push), run(&spring));
        for frame in 0..plain.motion.len() {
            let time = plain.motion.time()[frame];
            let asked = feet(&plain, frame);
            let force =
                Vector3::new(10.0, -20.0, 40.0) * f64::from(u8::from((1.2..1.8 - 1e-9).contains(&time)));
            let off = feet(&pushed, frame) + force - asked;
            assert!(off.norm() < 1e-8, "{who} {time}: {off}");
            let pull = asked - feet(&pulled, frame);
            assert!(pull.norm() > 10.0 && pull.norm() < 100.0, "{who} {time}: {pull}");
        }
        // The root bears nothing but rounding: joints know of it, too.
        for found in [&pushed, &pulled] {
            let reactions = found.reactions.as_ref().expect("reactions");
            assert!(reactions.root_force < 1e-8 && reactions.root_moment < 1e-8, "{reactions:?}");
        }
        let dof = |found: &Simulated, name: &str| {
            let scene = read(&format!("Scene(version: 1, {scene})"), &mut NoFiles).expect("a scene");
            let dof = scene.figure().layout().dof_index(&format!("{who}{name}")).expect("a dof");
            found.motion.tau(84).expect("forces")[dof]
        };
        assert!((dof(&pushed, "lumbar.rx") - dof(&plain, "lumbar.rx")).abs() > 5.0);
        assert!((dof(&pushed, "left_elbow.rx") - dof(&plain, "left_elbow.rx")).abs() < 1e-9);
    }
}

/// A curve of somebody's own, over her walk, beside somebody else's.
#[test]
fn limbs_of_who_walks_do_what_they_are_told() {
    let told = run(&format!(
        "Scene(version: 1, figures: {{\"ann\": {ANN}, \"bob\": {BOB}}}, walk: {{\"bob\": Walk(steps: 3)}}, duration: 1.5,
        places: {{\"bob\": (at: (1, 0, 0))}}, drives: {{\"bob.left_elbow.rx\": [Move(to: deg(-90), over: 1)], \"ann.*\": Frozen}})"
    ));
    let last = told.motion.len() - 1;
    let names = read(
        &format!("Scene(version: 1, duration: 1, figures: {{\"ann\": {ANN}, \"bob\": {BOB}}})"),
        &mut NoFiles,
    );
    let figure = names.expect("a scene").figure().clone();
    let at = |name: &str| told.motion.q(last)[figure.layout().dof_index(name).expect("a dof")];
    assert!((at("bob.left_elbow.rx") + std::f64::consts::FRAC_PI_2).abs() < 1e-9 && at("bob.root.tz") > 0.3);
    assert!(at("ann.root.tz").abs() < 1e-12 && told.motion.contact("ann.left_foot").is_none());
}

/// Each with its part, where its place is: links, contacts and events are those of all.
#[test]
fn each_of_several_has_its_part() {
    let scene = read(
        &format!(
            "Scene(version: 1, figures: {{\"ann\": {ANN}, \"bob\": {BOB}}}, walk: {{\"bob\": Walk(steps: 3)}},
            places: {{\"bob\": (at: (0.8, 0, 3), facing: deg(150))}}, drives: {{\"ann.*\": Frozen}})"
        ),
        &mut NoFiles,
    )
    .expect("a scene");
    let motion = scene.simulate(&mut ()).expect("a motion").motion;
    let all = scene.several(&motion).expect("its own motion");
    assert!(scene.is_of_several() && all.iter().map(|one| one.name.as_str()).eq(["ann", "bob"]));
    for one in &all {
        one.motion.check_figure(&one.figure).expect("its own figure");
        for frame in (0..motion.len()).step_by(50) {
            let (whole, own) =
                (scene.figure().places(motion.q(frame)), one.figure.places(one.motion.q(frame)));
            for (link, place) in one.figure.links().iter().zip(own) {
                let same =
                    scene.figure().link_index(&format!("{}.{}", one.name, link.name())).expect("a link");
                let off = (whole[same].translation.vector - place.translation.vector).norm();
                assert!(off < 1e-12 && whole[same].rotation.angle_to(&place.rotation) < 1e-7);
            }
            for track in &one.motion.contacts {
                let of_all = motion.contact(&format!("{}.{}", one.name, track.link)).expect("a contact");
                assert_eq!(of_all.samples[frame], track.samples[frame]);
            }
        }
    }
    assert!(all[0].motion.contacts.is_empty() && all[1].motion.contacts.len() == 2);
    // What stands of all stands of his, on the same spot of the same foot.
    assert!(all[0].motion.planted.is_empty() && motion.planted.len() > 3);
    assert_eq!(all[1].motion.planted.len(), motion.planted.len());
    for (of_all, own) in motion.planted.iter().zip(&all[1].motion.planted) {
        let names = [&scene.figure().links()[of_all.link], &all[1].figure.links()[own.link]].map(Link::name);
        assert_eq!(names[0], format!("bob.{}", names[1]));
        assert_eq!((of_all.point, of_all.start, of_all.end), (own.point, own.start, own.end));
    }
    assert_eq!(all[1].motion.events.len(), motion.events.len());
    let single =
        read(&format!("Scene(version: 1, figures: {{\"ann\": {ANN}}}, duration: 0.1)"), &mut NoFiles);
    let single = single.expect("a scene");
    let motion = single.simulate(&mut ()).expect("a motion").motion;
    assert!(!single.is_of_several() && single.several(&motion).expect("its own").is_empty());
}

#[test]
fn a_pattern_lets_a_crowd_walk() {
    let told = run(
        "Scene(version: 1, figures: {\"c\": Crowd(count: 3, seed: 2, apart: 1.5)}, walk: {\"c*\": Walk(steps: 2)})",
    );
    for who in ["c1", "c2", "c3"] {
        assert!(told.motion.contact(&format!("{who}.left_foot")).is_some(), "{who}");
    }
    let twice = "Scene(version: 1, figures: {\"c\": Crowd(count: 2)}, walk: {\"c*\": Walk(steps: 2), \"c2\": Walk(steps: 3)})";
    let error = read(twice, &mut NoFiles).expect_err("twice").to_string();
    assert!(error.contains("'c2' has two walks"), "{error}");
}

/// Who walks into somebody who falls would be lifted for a frame: the run is there, and says what is not.
#[test]
fn whom_a_blow_would_lift_is_noted() {
    let told = run("Scene(version: 1, figures: {\"a\": Human(height: 1.7, mass: 60), \"b\": Human(height: 1.5, mass: 110, joints: Limp)},
        walk: {\"a\": Walk(steps: 4)}, duration: 1.8, places: {\"b\": (at: (0.1, 0, 1.2))}, start: {\"b.root\": (at: (0, 0.95, 0))},
        ground: Flat(friction: 0.8, contact: Rigid), collisions: Collisions(friction: 0.5))");
    let notes: Vec<String> = told.report.remarks.iter().map(ToString::to_string).collect();
    assert!(notes.iter().any(|note| note.contains("under the feet of a is not told")), "{notes:?}");
    assert!(told.reactions.is_none());
    assert!(told.motion.len() > 100);
}
