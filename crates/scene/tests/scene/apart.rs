//! What reaches, and clips, keep links apart: by the nearness of the motion that comes out.

use nalgebra::Vector3;
use solaris_analysis::nearness;
use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_model::{Figure, Motion};
use solaris_scene::{Loader, NoFiles, Scene, read};

/// Somebody who stands and brings the right hand to a place.
fn reach(to: [f64; 3], clearance: f64) -> Scene {
    let [x, y, z] = to;
    let text = format!(
        "Scene(version: 1, figures: {{\"ann\": Human(height: 1.75, mass: 73.0)}}, duration: 1.5, rate: 240.0,
            start: {{\"root.ty\": 0.95, \"right_elbow.rx\": deg(-30), \"left_elbow.rx\": deg(-30), \"right_shoulder.rz\": deg(-10), \"left_shoulder.rz\": deg(10)}},
            drives: {{\"*\": Frozen}},
            reaches: [Reach(tip: \"right_hand\", at: (0.0, -0.1, 0.0), by: [\"right_shoulder\", \"right_elbow.rx\"], to: ({x}, {y}, {z}), over: 0.8,
                clearance: {clearance})])"
    );
    read(&text, &mut NoFiles).unwrap_or_else(|error| panic!("{error}"))
}

fn run(scene: &Scene) -> Motion {
    scene.simulate(&mut ()).unwrap_or_else(|error| panic!("{error}")).motion
}

fn nearest(figure: &Figure, motion: &Motion) -> f64 {
    nearness(figure, motion).expect("measured").expect("limbs").nearest.distance
}

fn hand(figure: &Figure, q: &[f64]) -> Vector3<f64> {
    let tree = Tree::<f64>::new(figure, Vector3::zeros()).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    forward_kinematics(&tree, &mut workspace, q).expect("finite");
    workspace.pose(figure.link_index("right_hand").expect("a hand")).transform(&Vector3::new(0.0, -0.1, 0.0))
}

/// The greatest difference of accelerations between frames (rad/s²).
fn leap(motion: &Motion) -> f64 {
    let pairs = (1..motion.len()).flat_map(|k| motion.a(k).iter().zip(motion.a(k - 1)));
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Places that an arm comes to through the trunk and the thigh where nothing is kept apart: the elbow goes another way, or the hand does, and
/// is where it should be in the end.
#[test]
fn an_arm_goes_round_the_trunk() {
    for (to, cuts, clear) in [
        ([0.15, 0.95, 0.2], 0.14, 0.005),
        ([0.1, 1.2, 0.15], 0.12, 0.005),
        ([0.15, 1.3, 0.25], 0.12, 0.005),
        ([-0.05, 0.9, -0.2], 0.02, 0.0),
        ([-0.1, 1.45, 0.25], 0.03, 0.005),
    ] {
        let (plain, kept) = (reach(to, 0.0), reach(to, 0.005));
        let (through, round) = (run(&plain), run(&kept));
        let figure = kept.figure();
        let (near, apart) = (nearest(figure, &through), nearest(figure, &round));
        assert!(near < -cuts, "{to:?}: {near}");
        // What is out of reach is not taken farther off for the last millimetre.
        assert!(apart > clear, "{to:?}: {apart}");
        assert_eq!(
            clear > 0.0,
            !kept.notes().iter().any(|note| note.contains("apart")),
            "{:?}",
            kept.notes()
        );
        let last = round.len() - 1;
        let off = |motion: &Motion| (hand(figure, motion.q(last)) - Vector3::from(to)).norm();
        assert!(off(&round) < off(&through) + 1e-8, "{to:?}: {} {}", off(&round), off(&through));
        // What is added comes and goes without a jump.
        let (plain, kept) = (leap(&through), leap(&round));
        // A joint that comes to its limit ends there with 0.2 rad/s.
        assert!(kept < 3.0 * plain + 60.0, "{to:?}: {kept} beside {plain}");
    }
}

#[test]
fn what_is_far_apart_is_not_touched() {
    let (plain, kept) = (reach([-0.25, 1.35, 0.4], 0.0), reach([-0.25, 1.35, 0.4], 0.005));
    let (plain, kept) = (run(&plain), run(&kept));
    assert!((0..plain.len()).all(|k| plain.q(k) == kept.q(k) && plain.v(k) == kept.v(k)));
}

/// The other arm follows a curve, into where the hand is brought: what else moves is where it will be, and what cuts it there is said.
#[test]
fn what_else_moves_is_where_it_will_be() {
    let scene = |clearance: f64| {
        let text = format!(
            "Scene(version: 1, figures: {{\"ann\": Human(height: 1.75, mass: 73.0)}}, duration: 2.0, rate: 120.0,
                start: {{\"root.ty\": 0.95, \"right_elbow.rx\": deg(-70), \"right_shoulder.rx\": deg(-40), \"left_elbow.rx\": deg(-90), \"left_shoulder.rz\": deg(20)}},
                drives: {{\"*\": Frozen, \"left_shoulder.rx\": MinimumJerk(from: 0, to: deg(-45), duration: 1.0), \"left_shoulder.ry\": MinimumJerk(from: 0, to: deg(-50), duration: 1.0)}},
                reaches: [Reach(tip: \"right_hand\", at: (0.0, -0.1, 0.0), by: [\"right_shoulder\", \"right_elbow\"], to: (0.0, 1.25, 0.3), over: 0.8,
                    clearance: {clearance})])"
        );
        read(&text, &mut NoFiles).unwrap_or_else(|error| panic!("{error}"))
    };
    let (plain, kept) = (scene(0.0), scene(0.005));
    let (through, round) = (run(&plain), run(&kept));
    let (near, apart) = (nearest(plain.figure(), &through), nearest(kept.figure(), &round));
    assert!(near < -0.03 && apart > near, "{near} {apart}");
    let said = kept.notes().join("\n");
    assert!(said.contains("'left_forearm' and 'right_forearm' go into each other by"), "{said}");
}

#[test]
fn what_cannot_be_kept_apart_is_said() {
    let scene = reach([0.0, 1.1, 0.05], 0.005);
    let notes = scene.notes().join("\n");
    assert!(notes.contains("'abdomen' and 'right_hand' go into each other by"), "{notes}");
    assert!(notes.contains("and could not be kept apart"), "{notes}");
    // Nearer to apart than if nothing were done.
    let plain = reach([0.0, 1.1, 0.05], 0.0);
    assert!(plain.notes().is_empty());
    assert!(nearest(scene.figure(), &run(&scene)) > nearest(plain.figure(), &run(&plain)) + 0.01);
    let error = read(
        "Scene(version: 1, figures: {\"ann\": Human(height: 1.7, mass: 60)}, duration: 1, reaches: [Reach(tip: \"right_hand\", by: [\"right_shoulder\"], to: (0, 1, 0.4), over: 1, clearance: 0.3)])",
        &mut NoFiles,
    );
    assert!(error.expect_err("too far").to_string().contains("the clearance is 0.3 m; it must be from 0"));
}

/// A motion in place of a file.
struct Recorded(Motion);

impl Loader for Recorded {
    fn figure(&mut self, _: &str) -> Result<Figure, String> {
        Err("there is none".to_owned())
    }

    fn motion(&mut self, _: &str, _: &Figure, _: &Vector3<f64>, _: &[usize]) -> Result<Motion, String> {
        Ok(self.0.clone())
    }
}

#[test]
fn a_clip_keeps_links_apart_where_it_is_asked_to() {
    let scene = reach([0.15, 1.3, 0.25], 0.0);
    let (figure, recorded) = (scene.figure().clone(), run(&scene));
    let clip = |clearance: &str| {
        let text = format!(
            "Scene(version: 1, figures: {{\"ann\": Human(height: 1.75, mass: 73.0)}}, duration: 1.5, rate: 240.0, start: {{\"root.ty\": 0.95}},
                clip: Clip(file: \"it\"{clearance}), drives: {{\"root.*\": Frozen}})"
        );
        read(&text, &mut Recorded(recorded.clone())).unwrap_or_else(|error| panic!("{error}"))
    };
    let (plain, kept) = (clip(""), clip(", clearance: 0.005"));
    assert!(plain.notes().is_empty() && kept.notes().is_empty(), "{:?}", kept.notes());
    let (through, round) = (run(&plain), run(&kept));
    assert!(nearest(&figure, &through) < -0.12);
    assert!(nearest(&figure, &round) > 0.005, "{}", nearest(&figure, &round));
    // What the clip's velocities say is how its positions change, and joints stay within their limits; legs hardly give way.
    let h = 1.0 / 240.0;
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        for (i, axis) in link.joint().kind().axes().iter().enumerate() {
            let Some(x) = figure.layout().coordinate(at.v + i) else { continue };
            for k in 1..round.len() - 1 {
                let slope = (round.q(k + 1)[x] - round.q(k - 1)[x]) / (2.0 * h);
                assert!((slope - round.v(k)[at.v + i]).abs() < 0.02, "{} {i}", link.name());
                let given = through.q(k)[x];
                if let Some(limits) = axis.limits {
                    let (least, most) = (limits.lower.min(given), limits.upper.max(given));
                    assert!((least - 1e-9..=most + 1e-9).contains(&round.q(k)[x]), "{} {i}", link.name());
                }
                if ["left_thigh", "right_thigh", "left_foot"].contains(&link.name()) {
                    assert!((round.q(k)[x] - given).abs() < 1e-9);
                }
            }
        }
    }
}
