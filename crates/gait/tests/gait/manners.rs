//! What a walker does besides what decides the walk: joints within their ranges, toes, head, arms.

use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_gait::{Extent, WalkPlan, WalkRequest, walk};
use solaris_model::{EventKind, Figure, Trajectory, Vector3, human};

/// Samples of a second.
const RATE: f64 = 200.0;

fn planned(figure: &Figure, step_frequency: f64) -> WalkPlan {
    let request = WalkRequest {
        step_frequency: Some(step_frequency),
        extent: Extent::Steps(8),
        ..WalkRequest::default()
    };
    walk(figure, &request).expect("it can be walked")
}

/// All configurations of a walk, with their times.
fn samples(figure: &Figure, plan: &WalkPlan) -> Vec<(f64, Vec<f64>)> {
    let count = (plan.duration() * RATE).ceil() as usize;
    (0..=count)
        .map(|i| {
            let (t, mut q) = (i as f64 / RATE, vec![0.0; figure.layout().nq()]);
            plan.configuration(t, &mut q);
            (t, q)
        })
        .collect()
}

fn coordinate(figure: &Figure, name: &str) -> usize {
    figure.layout().q_names().iter().position(|q| q == name).expect("a coordinate of a person")
}

/// Least and greatest angle (°) between two times.
fn range(samples: &[(f64, Vec<f64>)], k: usize, from: f64, to: f64) -> (f64, f64) {
    let inside = samples.iter().filter(|(t, _)| (from..=to).contains(t)).map(|(_, q)| q[k].to_degrees());
    inside.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)))
}

#[test]
fn no_joint_leaves_its_range() {
    for (height, mass) in [(1.5, 50.0), (1.75, 73.0), (1.95, 92.0)] {
        let figure = human(height, mass).expect("a person");
        for step_frequency in [60.0, 70.0, 80.0, 95.0, 110.0, 120.0, 130.0] {
            for (t, q) in samples(&figure, &planned(&figure, step_frequency)) {
                let names = figure.layout().v_names();
                let beyond: Vec<_> =
                    figure.limit_excess(&q).iter().map(|excess| (&names[excess.dof], excess.by)).collect();
                assert!(beyond.is_empty(), "{height} m, {step_frequency}/min at {t} s: {beyond:?}");
            }
        }
    }
}

/// They are bent up in the push-off and come back to the foot without clawing; in mid-swing they are a little extended.
#[test]
fn toes_do_not_claw() {
    let figure = human(1.75, 73.0).expect("a person");
    for step_frequency in [60.0, 80.0, 95.0, 110.0, 120.0, 130.0] {
        let plan = planned(&figure, step_frequency);
        let samples = samples(&figure, &plan);
        for side in ["left", "right"] {
            let toes = coordinate(&figure, &format!("{side}_toes.rx"));
            let (up, down) = range(&samples, toes, 0.0, plan.duration());
            assert!((-60.0..=-25.0).contains(&up), "{step_frequency}: {up}° at most in the push-off");
            assert!(down < 3.0, "{step_frequency}: bent down by {down}°");
        }
    }
}

/// The head keeps nearly still in the world, but not quite: it pitches and turns a little.
#[test]
fn the_head_is_steady_and_not_rigid() {
    let figure = human(1.75, 73.0).expect("a person");
    let plan = planned(&figure, 110.0);
    let head = figure.links().iter().position(|link| link.name() == "head").expect("a head");
    let tree = Tree::<f64>::new(&figure, Vector3::zeros()).expect("finite constants");
    let mut workspace = Workspace::new(&tree);
    let mut angles = Vec::new();
    for (_, q) in samples(&figure, &plan) {
        forward_kinematics(&tree, &mut workspace, &q).expect("valid");
        // Where the face points: z forward, y up, x left.
        let face = workspace.pose(head).rotation * Vector3::z();
        angles.push((face.y.asin().to_degrees(), face.x.atan2(face.z).to_degrees()));
    }
    let spread = |of: fn(&(f64, f64)) -> f64| {
        let (least, most) =
            angles.iter().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        most - least
    };
    let (pitch, yaw) = (spread(|a| a.0), spread(|a| a.1));
    assert!((1.0..5.0).contains(&pitch) && (1.0..5.0).contains(&yaw), "{pitch}° and {yaw}°");
}

/// Elbows bend and swing more the faster the walk is, and arms swing before the first foot lands.
#[test]
fn arms_follow_the_pace() {
    let figure = human(1.75, 73.0).expect("a person");
    let (elbow, shoulder) = (coordinate(&figure, "left_elbow.rx"), coordinate(&figure, "left_shoulder.rx"));
    let mut before = (0.0, 0.0);
    for step_frequency in [60.0, 80.0, 95.0, 110.0, 120.0, 130.0] {
        let plan = planned(&figure, step_frequency);
        let samples = samples(&figure, &plan);
        let middle = 0.45 * plan.duration();
        let (bent, straight) = range(&samples, elbow, middle, middle + 120.0 / step_frequency);
        assert!(
            (-70.0..-10.0).contains(&bent) && straight < -10.0,
            "{step_frequency}: {bent}° to {straight}°"
        );
        let (mean, swing) = (-0.5 * (bent + straight), straight - bent);
        assert!(mean > before.0 && swing > before.1, "{step_frequency}: {mean}° ± {swing}° after {before:?}");
        before = (mean, swing);
        if (95.0..=110.0).contains(&step_frequency) {
            let landed = plan.events().into_iter().find(|e| matches!(e.kind, EventKind::TouchDown { .. }));
            let first = landed.expect("a first contact").time;
            let (least, most) = range(&samples, shoulder, 0.0, first);
            assert!(most - least > 8.0, "{step_frequency}: {least}° to {most}° before the first contact");
        }
    }
}
