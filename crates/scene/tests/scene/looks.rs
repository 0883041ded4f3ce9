//! What looks, is held, follows and gives up, by direct kinematics and by differences of the motion that comes out.

use crate::fixtures::fixture;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use solaris_dynamics::{Pose, Tree, Workspace, forward_kinematics};
use solaris_model::{Figure, Motion};
use solaris_scene::{NoFiles, Scene, read};

/// Poses of links in frames of a motion.
struct Poses {
    figure: Figure,
    tree: Tree<f64>,
    workspace: Workspace<f64>,
}

impl Poses {
    fn of(figure: &Figure) -> Self {
        let tree = Tree::new(figure, Vector3::zeros()).expect("a tree");
        Self { figure: figure.clone(), workspace: Workspace::new(&tree), tree }
    }

    fn at(&mut self, q: &[f64], link: &str) -> Pose<f64> {
        forward_kinematics(&self.tree, &mut self.workspace, q).expect("finite");
        *self.workspace.pose(self.figure.link_index(link).expect("a link"))
    }
}

fn scene(text: &str) -> Scene {
    read(text, &mut NoFiles).unwrap_or_else(|error| panic!("{error}"))
}

fn run(scene: &Scene) -> Motion {
    scene.simulate(&mut ()).unwrap_or_else(|error| panic!("{error}")).motion
}

/// Angle between where the eyes of a head look and the way from them to a place.
fn off_sight(head: &Pose<f64>, place: Vector3<f64>) -> f64 {
    let way = place - head.transform(&Vector3::new(0.0, 0.1, 0.08));
    (head.rotation * Vector3::z()).angle(&way)
}

fn angle(a: &Matrix3<f64>, b: &Matrix3<f64>) -> f64 {
    UnitQuaternion::from_matrix(&(a.transpose() * b)).angle()
}

/// By how much positions, velocities and accelerations disagree from frame to frame, of all that have a coordinate: a jump of velocity
/// shows as one of the first, a jump of acceleration does not.
fn jumps(figure: &Figure, motion: &Motion) -> f64 {
    let rate = motion.info.rate;
    let mut worst = 0.0_f64;
    for dof in 0..figure.layout().nv() {
        let Some(x) = figure.layout().coordinate(dof) else { continue };
        for k in 1..motion.len() - 1 {
            let q = |k: usize| motion.q(k)[x];
            let (left, right) = ((q(k) - q(k - 1)) * rate, (q(k + 1) - q(k)) * rate);
            worst = worst.max((0.5 * (left + right) - motion.v(k)[dof]).abs());
        }
    }
    worst
}

fn within_limits(figure: &Figure, motion: &Motion, names: &[&str]) {
    for link in figure.links() {
        let joint = link.joint();
        if !names.contains(&joint.name()) {
            continue;
        }
        let at = figure.layout().joints()[figure.link_index(link.name()).expect("a link")];
        for (i, limits) in joint.kind().axes().iter().enumerate().filter_map(|(i, x)| Some((i, x.limits?))) {
            for k in 0..motion.len() {
                let x = motion.q(k)[at.q + i];
                assert!(x >= limits.lower - 1e-6 && x <= limits.upper + 1e-6, "{} {i}: {x}", joint.name());
            }
        }
    }
}

#[test]
fn eyes_follow_a_hand_that_another_figure_moves() {
    let scene = fixture("look.ron");
    assert_eq!(scene.notes(), &[] as &[String]);
    let (figure, motion) = (scene.figure().clone(), run(&scene));
    let mut poses = Poses::of(&figure);
    let mut farthest = 0.0_f64;
    for frame in 60..motion.len() {
        let q = motion.q(frame);
        let hand = poses.at(q, "bob.right_hand").transform(&Vector3::new(0.0, -0.1, 0.0));
        let head = poses.at(q, "ann.head");
        farthest = farthest.max(off_sight(&head, hand));
    }
    assert!(farthest < 1e-6, "{farthest}");
    within_limits(&figure, &motion, &["ann.neck", "ann.head", "ann.right_wrist", "ann.left_elbow"]);
    // The cup stays as it was while the trunk leans by 6°.
    let first = poses.at(motion.q(0), "ann.right_hand").rotation;
    let (mut turned, mut leant) = (0.0_f64, 0.0_f64);
    for frame in 0..motion.len() {
        turned = turned.max(angle(&first, &poses.at(motion.q(frame), "ann.right_hand").rotation));
        leant = leant.max(angle(&first, &poses.at(motion.q(frame), "ann.right_forearm").rotation));
    }
    assert!(turned < 1e-6 && leant > 0.1, "{turned} {leant}");
    // Bob's way through places begins with an acceleration, 8 rad/s² of his elbow, that shows in half a frame.
    assert!(jumps(&figure, &motion) < 0.05, "{}", jumps(&figure, &motion));
}

#[test]
fn a_walker_looks_at_a_lamp_for_a_while() {
    let scene = fixture("walk_look.ron");
    assert_eq!(scene.notes(), &[] as &[String]);
    let (figure, motion) = (scene.figure().clone(), run(&scene));
    let plain = {
        let text = r#"Scene(version: 1, figures: {"ann": Human(height: 1.75, mass: 73.0)}, walk: Walk(steps: 6, step_frequency: 108.0), rate: 120.0)"#;
        run(&self::scene(text))
    };
    let mut poses = Poses::of(&figure);
    let lamp = Vector3::new(-1.2, 2.4, 3.2);
    let held = UnitQuaternion::from_scaled_axis(Vector3::x() * (-10_f64).to_radians());
    let held = *held.to_rotation_matrix().matrix();
    for frame in 0..motion.len() {
        let (time, q) = (motion.time()[frame], motion.q(frame));
        let head = poses.at(q, "head");
        let otherwise = poses.at(plain.q(frame), "head");
        if (1.1..=2.4).contains(&time) {
            assert!(off_sight(&head, lamp) < 1e-5, "{time}: {}", off_sight(&head, lamp));
        } else if !(0.6..=3.1).contains(&time) {
            assert!(angle(&head.rotation, &otherwise.rotation) < 1e-7, "{time}");
        }
        if time >= 0.4 {
            let turned = angle(&poses.at(q, "right_hand").rotation, &held);
            assert!(turned < 1e-5, "{time}: {turned}");
        }
        // All else walks on as it did.
        let knee = figure.layout().dof_index("left_knee.rx").expect("a knee");
        assert!((q[knee] - plain.q(frame)[knee]).abs() < 1e-12);
    }
    within_limits(&figure, &motion, &["neck", "head", "right_wrist"]);
    assert!(jumps(&figure, &motion) < jumps(&figure, &plain) + 0.02);
    // Nine degrees of freedom do something else than the walk.
    assert_eq!(scene.walked() + 9, figure.layout().nv());
}

/// A head on a carriage that slides to and fro past a place, on a neck that turns about the vertical: the angle is that of the way.
#[test]
fn a_head_that_slides_past_turns_by_the_angle_of_the_way() {
    let text = |weight: f64| {
        format!(
            r#"Scene(version: 1, duration: 4, rate: 100, gravity: (0, 0, 0), figures: {{"f": Figure(name: "f", links: [
    Link(name: "carriage", joint: Joint(name: "rail", axes: [tx(name: "rail")]), mass: 1),
    Link(name: "head", parent: "carriage", joint: Joint(name: "neck", axes: [ry(name: "neck", limits: (deg(-150), deg(150)))]), mass: 1),
])}}, drives: {{"rail": Sine(amplitude: 0.8, period: 2.5), "neck": Frozen}},
    reaches: [Look(tip: "head", by: ["neck"], to: (0.3, 0.0, 1.0), from: 0.5, over: 0.7, until: 2.6, back: 0.9, weight: {weight})])"#
        )
    };
    for weight in [1.0, 0.35] {
        let motion = run(&scene(&text(weight)));
        for frame in 0..motion.len() {
            let t = motion.time()[frame];
            let ease = |u: f64| {
                let u = u.clamp(0.0, 1.0);
                u * u * u * (10.0 - 15.0 * u + 6.0 * u * u)
            };
            let x = 0.8 * (std::f64::consts::TAU * t / 2.5).sin();
            let wanted = f64::atan2(0.3 - x, 1.0);
            let expected = weight * ease((t - 0.5) / 0.7) * (1.0 - ease((t - 2.6) / 0.9)) * wanted;
            let found = motion.q(frame)[1];
            assert!((found - expected).abs() < 1e-6, "{t}: {found} {expected}");
        }
        assert!(jumps(scene(&text(weight)).figure(), &motion) < 0.01);
    }
}

/// A hand that goes along with a wagon, by the law of cosines, and a limb that comes before it in the chain.
#[test]
fn what_carries_a_hand_is_found_before_it_whatever_the_order_in_the_text() {
    let text = r#"Scene(version: 1, duration: 3, rate: 100, gravity: (0, 0, 0), figures: {"f": Figure(name: "f", links: [
    Link(name: "floor", joint: Joint(name: "ground")),
    Link(name: "wagon", parent: "floor", joint: Joint(name: "rail", at: (0, -0.9, 0), axes: [tx(name: "rail")]), mass: 1),
    Link(name: "trunk", parent: "floor", joint: Joint(name: "hips", axes: [rz(name: "hips")]), mass: 1),
    Link(name: "upper", parent: "trunk", joint: Joint(name: "shoulder", at: (0, 0.1, 0), axes: [rz(name: "shoulder")]), mass: 1),
    Link(name: "lower", parent: "upper", joint: Joint(name: "elbow", at: (0, -0.6, 0), axes: [rz(name: "elbow")]), mass: 1),
])}, start: {"elbow": 0.5}, drives: {"*": Frozen, "rail": Sine(amplitude: 0.2, period: 2)},
    reaches: [
        Reach(tip: "lower", at: (0, -0.6, 0), by: ["shoulder", "elbow"], to: Follow(link: "wagon", at: (0, 0.1, 0)), over: 0.5),
        Look(tip: "trunk", axis: (0, 1, 0), by: ["hips"], to: (0.6, 3.0, 0), from: 0.2, over: 1.0),
    ])"#;
    let scene = scene(text);
    let (figure, motion) = (scene.figure().clone(), run(&scene));
    let mut poses = Poses::of(&figure);
    for frame in 50..motion.len() {
        let q = motion.q(frame);
        let hand = poses.at(q, "lower").transform(&Vector3::new(0.0, -0.6, 0.0));
        let wagon = poses.at(q, "wagon").transform(&Vector3::new(0.0, 0.1, 0.0));
        assert!((hand - wagon).norm() < 1e-6, "{}", (hand - wagon).norm());
        let shoulder = poses.at(q, "upper").translation;
        let square = (wagon - shoulder).norm_squared();
        let elbow = figure.layout().dof_index("elbow").expect("an elbow");
        assert!((q[elbow].cos() - (square - 0.72) / 0.72).abs() < 1e-6);
    }
    let hips = figure.layout().dof_index("hips").expect("hips");
    assert!((motion.q(300)[hips] + f64::atan2(0.6, 3.0)).abs() < 1e-9);
}

#[test]
fn what_cannot_be_looked_at_is_said_with_the_angle() {
    let text = r#"Scene(version: 1, duration: 1, figures: {"ann": Human(height: 1.75, mass: 73.0)}, drives: {"*": Frozen},
        reaches: [Look(tip: "head", by: ["head"], to: (0.1, 1.5, -3.0), over: 0.5), Hold(tip: "left_foot", by: ["left_ankle"], turned: About(axis: (1, 0, 0), angle: deg(170)), over: 0.5)])"#;
    let scene = scene(text);
    let [look, hold] = scene.notes() else { panic!("{:?}", scene.notes()) };
    assert!(look.starts_with("'head' cannot look where it should all of the time: at 0.5"), "{look}");
    assert!(hold.starts_with("'left_foot' cannot be held as it should all of the time: at 0.5"), "{hold}");
    assert!(look.contains('°') && look.ends_with("° away, as near as its joints come"), "{look}");
}

/// A look that begins at 1e300 s was to be sampled until then, which no memory holds.
#[test]
fn what_begins_long_after_the_run_is_refused_instead_of_found() {
    let text = |end: f64| {
        format!(
            r#"Scene(version: 1, duration: 1, figures: {{"ann": Human(height: 1.75, mass: 73.0)}}, drives: {{"*": Frozen}},
            reaches: [Look(tip: "head", by: ["head"], to: (0.0, 1.5, 3.0), from: 0, over: 0.5),
            Look(tip: "head", by: ["head"], to: (0.1, 1.5, 3.0), from: {}, over: 1)])"#,
            end - 1.0
        )
    };
    assert!(read(&text(1800.0), &mut NoFiles).is_ok());
    for end in [1801.0, 1e9, 1e300] {
        let error = read(&text(end), &mut NoFiles).expect_err("refused").to_string();
        assert!(error.contains("of the run; that may be 1800 s at most"), "{error}");
    }
}
