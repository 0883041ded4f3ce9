//! Inverse kinematics of markers, against poses that are known, and against the objective itself.

mod fit;
mod spread;
mod unseen;

use proptest::prelude::*;
use solaris_analysis::markers::{
    CoordinateTask, IkError, IkOptions, MarkerMotion, inverse_kinematics, measured_factor, place_markers,
    places,
};
use solaris_dynamics::{Frame, Tree, Workspace, forward_kinematics};
use solaris_model::{Base, Figure, FigureBuilder, Joint, LinkSpec, Marker, MarkerTrial, Vector3, human};

/// Four markers on every link, none in a plane with all others.
fn markers(figure: &Figure, per_link: usize) -> Vec<Marker> {
    let corners = [[0.1, 0.02, 0.0], [-0.05, 0.08, 0.03], [0.02, -0.06, 0.09], [-0.03, -0.04, -0.07]];
    let on = |link: usize| {
        corners.iter().take(per_link).enumerate().map(move |(i, corner)| Marker {
            name: format!("m{link}_{i}"),
            link,
            position: Vector3::from(*corner),
            is_fixed: false,
        })
    };
    (0..figure.links().len()).flat_map(on).collect()
}

/// Where the markers are in each of these configurations.
fn seen(figure: &Figure, markers: &[Marker], poses: &[Vec<f64>]) -> MarkerTrial {
    let tree = Tree::<f64>::new(figure, Vector3::zeros()).expect("finite");
    let mut workspace = Workspace::new(&tree);
    let mut points = Vec::new();
    for q in poses {
        forward_kinematics(&tree, &mut workspace, q).expect("valid");
        let place = |marker: &Marker| Frame::at(marker.link, marker.position).pose(&workspace).translation;
        points.extend(markers.iter().map(place));
    }
    let names = markers.iter().map(|marker| marker.name.clone()).collect();
    let time = (0..poses.len()).map(|frame| frame as f64 * 0.01).collect();
    MarkerTrial::new(names, time, points).expect("valid")
}

/// The trial with every point moved by a function of frame and marker.
fn changed(trial: &MarkerTrial, change: impl Fn(usize, usize, Vector3<f64>) -> Vector3<f64>) -> MarkerTrial {
    let points = (0..trial.len()).flat_map(|frame| {
        let row = trial.frame(frame).iter().enumerate();
        row.map(|(marker, point)| change(frame, marker, *point)).collect::<Vec<_>>()
    });
    MarkerTrial::new(trial.names().to_vec(), trial.time().to_vec(), points.collect()).expect("valid")
}

fn noise(frame: usize, marker: usize) -> Vector3<f64> {
    let at = |k: f64| ((frame * 131 + marker * 17) as f64 * k).sin();
    Vector3::new(at(12.9898), at(78.233), at(37.719)) * 0.01
}

/// A person who sways: smooth angles of all joints, anywhere in the room.
fn swaying(figure: &Figure, frames: usize, turn: f64) -> Vec<Vec<f64>> {
    let pose = |frame: usize| {
        let mut q: Vec<f64> =
            (0..figure.layout().nq()).map(|k| 0.25 * (0.05 * frame as f64 + 1.7 * k as f64).sin()).collect();
        q[0] += 3.0;
        q[4] += turn;
        q
    };
    (0..frames).map(pose).collect()
}

fn solve(figure: &Figure, markers: &[Marker], trial: &MarkerTrial, options: &IkOptions) -> MarkerMotion {
    inverse_kinematics(figure, markers, trial, options).expect("markers in common")
}

/// The objective of a frame, written out.
fn objective(figure: &Figure, markers: &[Marker], trial: &MarkerTrial, frame: usize, q: &[f64]) -> f64 {
    let places = seen(figure, markers, &[q.to_vec()]);
    let pairs = places.frame(0).iter().zip(trial.frame(frame)).filter(|(_, seen)| !seen.x.is_nan());
    let (sum, count) = pairs.fold((0.0, 0), |(sum, n), (x, m)| (sum + (x - m).norm_squared(), n + 1));
    0.5 * sum / f64::from(count)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    /// From whatever side a person is seen, with a third of the markers hidden now and then, the pose comes out.
    #[test]
    fn a_pose_is_found_from_any_side(turn in -3.1..3.1_f64, hidden in 0_usize..3) {
        let figure = human(1.75, 73.0).expect("a person");
        let markers = markers(&figure, 4);
        let poses = swaying(&figure, 40, turn);
        let trial = seen(&figure, &markers, &poses);
        let trial = changed(&trial, |frame, marker, point| {
            if frame > 3 && (frame + marker) % 3 < hidden && marker % 4 != 0 { Vector3::repeat(f64::NAN) } else { point }
        });
        let found = solve(&figure, &markers, &trial, &IkOptions::default());
        prop_assert!(found.frames.iter().all(|frame| frame.converged));
        prop_assert!(found.rms() < 1e-9, "{:e}", found.rms());
        prop_assert!(found.swaps.is_empty());
    }
}

#[test]
fn no_small_step_lowers_the_objective() {
    let figure = human(1.75, 73.0).expect("a person");
    let markers = markers(&figure, 3);
    let trial = changed(&seen(&figure, &markers, &swaying(&figure, 3, 0.4)), |f, m, p| p + noise(f, m));
    let found = solve(&figure, &markers, &trial, &IkOptions::default());
    let nq = figure.layout().nq();
    for frame in 0..3 {
        let q = &found.q[frame * nq..][..nq];
        let best = objective(&figure, &markers, &trial, frame, q);
        assert!((best - found.frames[frame].cost).abs() < 1e-12);
        for k in 0..nq {
            for step in [1e-4, -1e-4] {
                let mut q = q.to_vec();
                q[k] += step;
                let other = objective(&figure, &markers, &trial, frame, &q);
                assert!(other > best, "dof {k}: {other:e} < {best:e}");
            }
        }
    }
}

/// A free joint and ball joints are found as well: their steps are turns, not differences.
#[test]
fn balls_and_free_joints_are_found() {
    let figure = FigureBuilder::new("f")
        .link(LinkSpec::root("a", Joint::new("ground")).mass(1.0))
        .link(LinkSpec::child("b", "a", Joint::ball("hip").at(Vector3::new(0.0, -0.2, 0.0))).mass(1.0))
        .link(LinkSpec::child("c", "b", Joint::new("knee").rx().at(Vector3::new(0.0, -0.4, 0.0))).mass(1.0))
        .build()
        .expect("valid");
    let figure = figure.on_base(Base::Free).expect("a base");
    let markers = markers(&figure, 4);
    let mut q = vec![0.3, 1.1, -2.0, 0.1, 0.7, -0.2, 0.6, 0.5, -0.4, 0.2, 0.7, -0.9];
    figure.normalize(&mut q).expect("valid");
    let found =
        solve(&figure, &markers, &seen(&figure, &markers, std::slice::from_ref(&q)), &IkOptions::default());
    let off = figure.distance(&q, &found.q).expect("valid");
    assert!(off < 1e-8, "{off:e}");
}

/// The bound is kept, and the other coordinates are the best that there are with it.
#[test]
fn bounds_hold_and_what_is_held_stays() {
    let figure = FigureBuilder::new("f")
        .link(LinkSpec::root("a", Joint::new("one").rz()).mass(1.0))
        .link(LinkSpec::child("b", "a", Joint::new("two").rz().at(Vector3::new(1.0, 0.0, 0.0))).mass(1.0))
        .build()
        .expect("valid");
    let tip = Marker { name: "tip".into(), link: 1, position: Vector3::x(), is_fixed: false };
    let trial =
        MarkerTrial::new(vec!["tip".into()], vec![0.0], vec![Vector3::new(1.0, 1.0, 0.0)]).expect("valid");
    let options = IkOptions { bounds: vec![(1, -0.1, 0.5)], ..IkOptions::default() };
    let found = solve(&figure, std::slice::from_ref(&tip), &trial, &options);
    // The second joint would bend by a right angle; at its bound the first turns the tip towards the point.
    assert!((found.q[1] - 0.5).abs() < 1e-12);
    assert!((found.q[0] - (std::f64::consts::FRAC_PI_4 - 0.25)).abs() < 1e-9);
    let held = IkOptions { held: vec![(0, 0.0)], ..IkOptions::default() };
    let found = solve(&figure, std::slice::from_ref(&tip), &trial, &held);
    assert!(found.q[0].abs() < 1e-15 && (found.q[1] - std::f64::consts::FRAC_PI_2).abs() < 1e-9);
    // Drawn as strongly to 0 as the mean square draws away from it: ½(x−1)² of an angle x near a small pull.
    let task = CoordinateTask { dof: 1, value: 0.0, weight: 1e6 };
    let drawn = solve(&figure, &[tip], &trial, &IkOptions { tasks: vec![task], ..held });
    assert!(drawn.q[1].abs() < 1e-5);
}

#[test]
fn exchanged_labels_are_found_and_told() {
    let figure = human(1.75, 73.0).expect("a person");
    let markers = markers(&figure, 3);
    let trial =
        changed(&seen(&figure, &markers, &swaying(&figure, 90, 0.4)), |f, m, p| p + noise(f, m) * 0.3);
    let (a, b) = (10, 31);
    let swapped = changed(&trial, |frame, marker, point| {
        let exchanged = (25..70).contains(&frame);
        match marker {
            m if exchanged && m == a => trial.frame(frame)[b],
            m if exchanged && m == b => trial.frame(frame)[a],
            _ => point,
        }
    });
    let right = solve(&figure, &markers, &trial, &IkOptions::default());
    let found = solve(&figure, &markers, &swapped, &IkOptions::default());
    assert_eq!(right.swaps, []);
    let [swap] = &found.swaps[..] else { panic!("{:?}", found.swaps) };
    assert_eq!((swap.first, swap.last), (25, 69));
    assert_eq!(swap.names, [a, b].map(|m| markers[m].name.clone()));
    let off = found.q.iter().zip(&right.q).map(|(x, y)| (x - y).abs()).enumerate();
    let off = off.max_by(|a, b| a.1.total_cmp(&b.1)).expect("some");
    assert!(off.1 < 1e-7, "{off:?}");
    let kept = solve(&figure, &markers, &swapped, &IkOptions { keep_labels: true, ..IkOptions::default() });
    assert!(kept.swaps.is_empty() && kept.rms() > 2.0 * found.rms());
}

/// A forearm with its markers on its own axis: nothing tells how it turns, so it stays at rest and is named.
#[test]
fn what_no_marker_tells_of_stays_at_rest() {
    let figure = FigureBuilder::new("f")
        .link(LinkSpec::root("arm", Joint::new("shoulder").rz()).mass(1.0))
        .link(
            LinkSpec::child("forearm", "arm", Joint::new("turn").rx().at(Vector3::new(0.3, 0.0, 0.0)))
                .mass(1.0),
        )
        .build()
        .expect("valid");
    let on = |name: &str, x: f64| Marker {
        name: name.into(),
        link: 1,
        position: Vector3::x() * x,
        is_fixed: false,
    };
    let markers = [on("a", 0.1), on("b", 0.2)];
    let poses: Vec<Vec<f64>> = (0..5).map(|frame| vec![0.1 * f64::from(frame), 0.0]).collect();
    let trial = seen(&figure, &markers, &poses);
    let options = IkOptions { rest: Some(vec![0.0, 0.4]), ..IkOptions::default() };
    let found = solve(&figure, &markers, &trial, &options);
    assert_eq!((found.dofs[0].blind, found.dofs[1].blind), (0, 5));
    assert!(found.dofs[1].spread.is_infinite() && found.dofs[0].spread < 1e-6);
    assert!(found.q.chunks(2).all(|q| (q[1] - 0.4).abs() < 1e-6));
}

/// Frames without any marker keep the pose before them; the frames after them are as if there had been no gap.
#[test]
fn a_gap_of_everything_is_crossed() {
    let figure = human(1.75, 73.0).expect("a person");
    let markers = markers(&figure, 3);
    let trial = seen(&figure, &markers, &swaying(&figure, 80, -2.0));
    let hidden = changed(&trial, |f, _, p| if (20..45).contains(&f) { Vector3::repeat(f64::NAN) } else { p });
    let found = solve(&figure, &markers, &hidden, &IkOptions::default());
    for (frame, fit) in found.frames.iter().enumerate() {
        let hidden = (20..45).contains(&frame);
        assert_eq!((fit.seen == 0, fit.rms.is_nan(), fit.worst.is_none()), (hidden, hidden, hidden));
        assert!(hidden || fit.rms < 1e-9, "{frame}: {}", fit.rms);
    }
    assert!(found.q.iter().all(|x| x.is_finite()));
}

#[test]
fn what_cannot_be_asked_is_refused_by_name() {
    let figure = human(1.75, 73.0).expect("a person");
    let markers = markers(&figure, 3);
    let trial = seen(&figure, &markers, &swaying(&figure, 2, 0.0));
    let said = |markers: &[Marker], trial: &MarkerTrial, options: IkOptions| {
        inverse_kinematics(&figure, markers, trial, &options).expect_err("refused").to_string()
    };
    let none = || IkOptions::default();
    let strangers = MarkerTrial::new(vec!["C7".into()], vec![0.0], vec![Vector3::zeros()]).expect("valid");
    let message = said(&markers, &strangers, none());
    assert!(
        message.contains("m0_0, m0_1") && message.ends_with("the trial C7; rename one or the other"),
        "{message}"
    );
    let empty = MarkerTrial::new(vec!["m0_0".into()], vec![], vec![]).expect("valid");
    assert!(said(&markers, &empty, none()).contains("no frame"));
    let weights = |weight| IkOptions { weights: Some(vec![("m0_0".into(), weight)]), ..none() };
    assert!(said(&markers, &trial, weights(-1.0)).contains("the weight of 'm0_0' is -1"));
    assert!(said(&markers, &trial, weights(0.0)).contains("with a weight above 0"));
    let bounds = IkOptions { bounds: vec![(7, 1.0, 0.0)], ..none() };
    assert!(said(&markers, &trial, bounds).contains("between 1 and 0; give the smaller bound first"));
    let held = IkOptions { held: vec![(1000, 0.0)], ..none() };
    assert!(said(&markers, &trial, held).contains("'dof 1000' cannot be held at 0"));
    let mut lost = markers.clone();
    lost[3].position.x = f64::NAN;
    assert!(said(&lost, &trial, none()).contains("'m1_0' sits at (NaN"));
    let error = inverse_kinematics(&figure, &markers, &trial, &IkOptions { rest: Some(vec![0.0]), ..none() });
    assert!(matches!(error, Err(IkError::Rest(_))));
}

#[test]
fn a_factor_is_the_mean_of_the_pairs_ratios() {
    let figure = human(1.75, 73.0).expect("a person");
    let markers = markers(&figure, 3);
    let rest = vec![0.0; figure.layout().nq()];
    let own = seen(&figure, &markers, &[rest.clone(), rest.clone()]);
    let longer = own.clone().mapped(|point| point * 1.07);
    let longer = changed(&longer, |f, m, p| if f == 1 && m == 4 { Vector3::repeat(f64::NAN) } else { p });
    let pair = |a: usize, b: usize| [a, b].map(|m| markers[m].name.clone());
    let factor =
        |trial: &MarkerTrial, pairs: &[[String; 2]]| measured_factor(&figure, &markers, &rest, trial, pairs);
    let found = factor(&longer, &[pair(0, 4), pair(3, 11)]).expect("seen");
    assert!((found.factor - 1.07).abs() < 1e-14);
    assert_eq!([found.pairs[0].frames, found.pairs[1].frames], [1, 2]);
    let said = |trial, pairs: &[[String; 2]]| factor(trial, pairs).expect_err("refused").to_string();
    assert!(
        said(&longer, &[["m0_0".into(), "m0_9".into()]])
            .contains("the model has no marker 'm0_9'; did you mean")
    );
    let hidden = changed(&own, |_, m, p| if m == 4 { Vector3::repeat(f64::NAN) } else { p });
    assert!(said(&hidden, &[pair(0, 4)]).starts_with("no frame shows both 'm0_0' and 'm1_1'"));
    assert!(said(&own, &[pair(2, 2)]).contains("are in one place"));
    assert!(said(&own, &[]).contains("no pair"));
}

/// What a static trial saw is where the markers are afterwards, but for those that are fixed.
#[test]
fn markers_are_placed_where_they_were_seen() {
    let figure = human(1.75, 73.0).expect("a person");
    let mut markers = markers(&figure, 3);
    let poses = swaying(&figure, 1, 0.7);
    let trial = seen(&figure, &markers, &poses);
    let (moved, lost) = {
        for marker in &mut markers {
            marker.position += Vector3::new(0.01, -0.02, 0.03);
        }
        markers[5].is_fixed = true;
        markers.push(Marker { name: "stray".into(), ..markers[0].clone() });
        place_markers(&figure, &markers, &poses[0], &trial).expect("a configuration")
    };
    assert_eq!(lost, ["stray"]);
    let now = places(&figure, &moved, &poses[0]).expect("a configuration");
    for (i, (place, seen)) in now.iter().zip(trial.frame(0)).enumerate() {
        let off = (place - seen).norm();
        assert!(if i == 5 { (off - 0.0014_f64.sqrt()).abs() < 1e-12 } else { off < 1e-12 }, "{i} {off:e}");
    }
}

/// Seen from the side two of the root's axes fall together: its angles are then not told apart, and it is in view all the same.
#[test]
fn a_person_whose_axes_fall_together_is_seen() {
    let figure = human(1.75, 73.0).expect("a person");
    let markers = markers(&figure, 4);
    let trial = seen(&figure, &markers, &swaying(&figure, 40, 1.414_035_518_308_298_9));
    let found = solve(&figure, &markers, &trial, &IkOptions::default());
    assert!(found.rms() < 1e-9, "{:e}", found.rms());
    assert!(found.frames.iter().all(|frame| frame.is_placed && frame.blind == 0));
}
