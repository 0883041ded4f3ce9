//! How near the parts of a figure come to each other.
use nalgebra::Vector3;
use solaris_analysis::{Clearance, Nearness, NearnessError, nearness};
use solaris_model::{
    Figure, FigureBuilder, Joint, LinkSpec, Motion, MotionInfo, Placement, Shape, ShapeKind, human,
};
use std::time::Instant;

/// Where two capsules stand beside a ball, 1 m apart, and lean towards each other.
fn two_arms(has_shapes: bool) -> Figure {
    let shape = |kind, y| Shape { kind, placement: Placement::translation(0.0, y, 0.0) };
    let arm = |name: &str, x: f64| {
        let joint = Joint::new(format!("{name}_shoulder")).at(Vector3::new(x, 0.0, 0.0)).rz();
        let link = LinkSpec::child(name, "ball", joint).mass(1.0);
        if has_shapes {
            link.shape(shape(ShapeKind::Capsule { radius: 0.04, length: 0.6 }, 0.3))
        } else {
            link
        }
    };
    let ball = LinkSpec::root("ball", Joint::new("root").tx()).mass(1.0);
    FigureBuilder::new("two arms")
        .link(ball.shape(shape(ShapeKind::Sphere { radius: 0.05 }, 0.0)))
        .link(arm("left", -0.5))
        .link(arm("right", 0.5))
        .build()
        .expect("valid")
}

fn motion(figure: &Figure, frames: &[Vec<f64>], rate: f64) -> Motion {
    let time = (0..frames.len()).map(|frame| frame as f64 / rate).collect();
    let still = vec![0.0; frames.len() * figure.layout().nv()];
    let columns = [frames.concat(), still.clone(), still];
    Motion::new(figure, MotionInfo::on_earth(figure, rate), time, columns).expect("valid")
}

fn neutral(figure: &Figure) -> Vec<f64> {
    let mut q = vec![0.0; figure.layout().nq()];
    figure.neutral(&mut q).expect("of that length");
    q
}

fn measured(figure: &Figure, motion: &Motion) -> Nearness {
    let found = nearness(figure, motion).expect("measured").expect("pairs");
    assert_eq!(found.frames.len(), motion.len());
    assert!(found.frames.iter().all(|near| near.distance.is_finite() && near.links[0] < near.links[1]));
    found
}

#[test]
fn arms_that_lean_towards_each_other_are_as_near_as_their_tips() {
    let figure = two_arms(true);
    let frames: Vec<Vec<f64>> =
        (0..=120).map(|k| 0.01 * f64::from(k)).map(|lean| vec![0.3, -lean, lean]).collect();
    let found = measured(&figure, &motion(&figure, &frames, 100.0));
    assert_eq!((&*found.pairs, found.left_out.len()), (&[[1, 2]][..], 0));
    for (q, near) in frames.iter().zip(&found.frames) {
        // Once the tips have met, the axes cross.
        let tips = (1.0 - 2.0 * 0.6 * q[2].sin()).max(0.0);
        assert!((near.distance - (tips - 0.08)).abs() < 1e-14, "{}: {}", q[2], near.distance);
    }
    // The first of those that are as deep.
    let nearest = &found.nearest;
    assert!((nearest.distance + 0.08).abs() < 1e-15, "{nearest:?}");
    assert!(nearest.time >= (5.0_f64 / 6.0).asin(), "{nearest:?}");
    assert_eq!(nearest.links, ["left", "right"]);
    // One pair for all the time.
    let time: Vec<f64> = (0..=120).map(|k| 0.01 * f64::from(k)).collect();
    let [spell] = &found.limbs(&figure, &time).spells[..] else { panic!("of one pair") };
    assert_eq!((&spell.links, spell.from, spell.to), (&nearest.links, 0.0, time[120]));
    assert_eq!((spell.distance, spell.time), (nearest.distance, nearest.time));
}

#[test]
fn nothing_is_measured_without_shapes_and_another_figures_motion_is_refused() {
    let (with, without) = (two_arms(true), two_arms(false));
    assert_eq!(nearness(&without, &motion(&without, &[vec![0.0; 3]], 1.0)), Ok(None));
    assert_eq!(nearness(&with, &motion(&with, &[], 1.0)), Ok(None));
    let person = human(1.75, 73.0).expect("within range");
    let other = nearness(&with, &motion(&person, &[neutral(&person)], 1.0));
    assert!(matches!(other, Err(NearnessError::Motion(_))), "{other:?}");
}

#[test]
fn a_neutral_person_touches_itself_nowhere_that_is_measured() {
    for (height, mass) in [(1.2, 25.0), (1.75, 73.0), (2.0, 95.0)] {
        let figure = human(height, mass).expect("within range");
        let found = measured(&figure, &motion(&figure, &[neutral(&figure)], 1.0));
        let names = |pairs: &[[usize; 2]]| {
            let name = |link: usize| figure.links()[link].name();
            pairs.iter().map(|[a, b]| format!("{} {}", name(*a), name(*b))).collect::<Vec<_>>()
        };
        eprintln!("{height} m: {:?}, left out {:?}", found.nearest, names(&found.left_out));
        assert!(found.nearest.distance >= 0.0);
        for pair in ["left_hand left_thigh", "left_thigh right_thigh", "left_foot right_foot"] {
            assert!(names(&found.pairs).contains(&pair.to_owned()), "{pair}");
        }
        // Shoulders stand in the trunk; the hip's neighbour is the pelvis.
        for pair in ["thorax left_upper_arm", "pelvis left_thigh"] {
            assert!(!names(&found.pairs).contains(&pair.to_owned()), "{pair}");
        }
    }
}

/// Turns about the mirror's normal keep their sign, the others change it.
#[test]
fn a_mirrored_person_is_as_near_to_itself_on_the_other_side() {
    let figure = human(1.75, 73.0).expect("within range");
    let dof = |name: &str| figure.layout().dof_index(name).expect("a dof of the human");
    let posed = |side: &str, sign: f64, lift: f64| {
        let mut q = neutral(&figure);
        for (name, value) in [
            ("shoulder.rx", -lift),
            ("shoulder.rz", sign * 0.2),
            ("elbow.rx", -1.1),
            ("wrist.ry", sign * 0.1),
            ("hip.rx", -0.5 * lift),
            ("hip.ry", sign * 0.2),
        ] {
            q[dof(&format!("{side}_{name}"))] = value;
        }
        q
    };
    let lifts = || (0..240).map(|k| 1.5 * (f64::from(k) / 40.0).sin().abs());
    let left: Vec<Vec<f64>> = lifts().map(|lift| posed("left", 1.0, lift)).collect();
    let right: Vec<Vec<f64>> = lifts().map(|lift| posed("right", -1.0, lift)).collect();
    let (left, right) = (motion(&figure, &left, 60.0), motion(&figure, &right, 60.0));
    let begin = Instant::now();
    let (left, right) = (measured(&figure, &left), measured(&figure, &right));
    eprintln!("240 frames of a person in {:?}; {:?}", begin.elapsed() / 2, left.nearest);
    let mirrored = |name: &str| match name.split_once('_') {
        Some(("left", part)) => format!("right_{part}"),
        Some(("right", part)) => format!("left_{part}"),
        _ => name.to_owned(),
    };
    let sides = |links: [usize; 2]| {
        let mut names = links.map(|link| figure.links()[link].name().to_owned());
        names.sort();
        names
    };
    let mut pairs_that_differ = 0;
    for (one, other) in left.frames.iter().zip(&right.frames) {
        assert!((one.distance - other.distance).abs() < 1e-12, "{one:?} {other:?}");
        let mut expected = sides(one.links).map(|name| mirrored(&name));
        expected.sort();
        pairs_that_differ += usize::from(expected != sides(other.links));
    }
    // Only where both sides are as near, as of a body that stands still.
    assert!(pairs_that_differ < 240 / 2, "{pairs_that_differ}");
    assert!((left.nearest.distance - right.nearest.distance).abs() < 1e-12);
}

/// Balls that fly by themselves, and one that hangs: every pair is measured, whatever overlaps with every joint at zero, but for what
/// is joined.
#[test]
fn what_flies_apart_is_measured_from_figure_to_figure() {
    let ball = |radius| Shape { kind: ShapeKind::Sphere { radius }, placement: Placement::identity() };
    let mut builder = FigureBuilder::new("balls").link(LinkSpec::root("sky", Joint::new("sky")));
    let hangs = LinkSpec::child("bob", "sky", Joint::new("bob").rz()).mass(1.0);
    let placement = Placement::translation(0.0, -1.0, 0.0);
    builder = builder.link(hangs.shape(Shape { placement, ..ball(0.05) }));
    for k in 0..12 {
        let joint = Joint::new(format!("air{k}")).tx().ty().tz();
        let link = LinkSpec::child(format!("ball{k}"), "sky", joint).mass(1.0);
        builder = builder.link(link.shape(ball(0.02 + 0.01 * f64::from(k))));
    }
    let figure = builder.build().expect("valid");
    // Places by a rule without a pattern.
    let place = |frame: i32, k: i32, i: i32| f64::from((frame * 7 + k * 31 + i * 17 + k * k * i) % 23) / 8.0;
    let frames: Vec<Vec<f64>> = (0..40)
        .map(|frame| {
            let balls = (0..12).flat_map(|k| (0..3).map(move |i| place(frame, k, i)));
            std::iter::once(f64::from(frame) * 0.1).chain(balls).collect()
        })
        .collect();
    let motion = motion(&figure, &frames, 10.0);
    let joined = [[3, 2], [1, 5]];
    let found = solaris_analysis::nearness_but(&figure, &motion, &joined).expect("measured").expect("pairs");
    assert_eq!((found.pairs.len(), found.of_others), (0, 13 * 12 / 2 - 2));
    assert!(found.left_out.is_empty());
    for (q, near) in frames.iter().zip(&found.frames) {
        let at = |link: usize| match link {
            1 => (Vector3::new(q[0].sin(), -q[0].cos(), 0.0), 0.05),
            link => (Vector3::from_column_slice(&q[3 * link - 5..3 * link - 2]), 0.01 * link as f64),
        };
        let apart = |[a, b]: [usize; 2]| {
            let ((one, r), (other, s)) = (at(a), at(b));
            (one - other).norm() - r - s
        };
        let pairs = (1..14).flat_map(|a| (a + 1..14).map(move |b| [a, b]));
        let measured = pairs.filter(|pair| ![[2, 3], [1, 5]].contains(pair));
        let least = measured.min_by(|a, b| apart(*a).total_cmp(&apart(*b))).expect("some");
        assert!((near.distance - apart(near.links)).abs() < 1e-12, "{near:?}");
        assert!((near.distance - apart(least)).abs() < 1e-12, "{near:?}, {least:?}");
    }
}

/// Two arms whose tips are `1 − 2·0.6·sin(lean)` apart: how that changes, and which coordinates move what.
#[test]
fn slopes_of_clearance_are_derivatives_of_distances() {
    let figure = two_arms(true);
    let mut clearance = Clearance::new(&figure, &[0, 1, 2], &[]).expect("a figure");
    assert_eq!(clearance.pairs().collect::<Vec<_>>(), [[1, 2]]);
    // The slide carries both.
    assert_eq!(clearance.moved_by(0), [1, 2]);
    let q = [0.3, -0.4, 0.4];
    let apart = 1.0 - 2.0 * 0.6 * 0.4_f64.sin() - 0.08;
    assert!((clearance.distance(&q, 0).expect("measured") - apart).abs() < 1e-14);
    let [(first, left), (second, right)] = clearance.slopes(&q, 0).expect("measured")[..] else { panic!() };
    let slope = 0.6 * 0.4_f64.cos();
    assert!((first, second) == (1, 2) && (left - slope).abs() < 1e-9 && (right + slope).abs() < 1e-9);
    assert!(clearance.nearer(&q, apart - 1e-9).expect("measured").is_empty());
    assert_eq!(clearance.nearer(&q, apart + 1e-9).expect("measured").len(), 1);
    // What is no configuration is refused, and the next one is measured as before.
    assert!(clearance.slopes(&[f64::NAN; 3], 0).is_err() && clearance.slopes(&q[..2], 0).is_err());
    assert_eq!(clearance.slopes(&q, 0).expect("measured").len(), 2);
    clearance.retain(|links, between| links == [1, 2] && between == [1, 2]);
    assert_eq!(clearance.pairs().len(), 1);
    clearance.retain(|_, _| false);
    assert_eq!(clearance.pairs().len(), 0);
    // What nothing moves, or is left out, is not measured.
    for (dofs, but) in [(&[0][..], &[][..]), (&[1, 2], &[[2, 1]])] {
        assert_eq!(Clearance::new(&figure, dofs, but).expect("a figure").pairs().len(), 0);
    }
}
