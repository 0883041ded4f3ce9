//! A cane in a hand: its tip stands, it is as long as it is, it bears what it is asked to along itself, and the laws hold with it, judged by the
//! motion's own inverse dynamics.

use super::load::walked;
use super::random::Random;
use solaris_gait::{
    CANE, CANE_LOADS, ChairRequest, Extent, FEET, FRICTION, RunRequest, WalkGround, WalkRequest, Walker,
    chair, helped_side, measure, run, walk,
};
use solaris_model::{Figure, Human, Motion, RootOrder, Trajectory, Vector3};

fn walker(height: f64, hand: &str) -> Figure {
    let human = Human::new(height, 23.8 * height * height).root(RootOrder::Yzx);
    human.cane(hand).build().expect("a person with a cane")
}

fn request(figure: &Figure, step_frequency: f64) -> WalkRequest {
    WalkRequest {
        step_frequency: Some(step_frequency),
        left_first: helped_side(figure) == Some(0),
        ..WalkRequest::default()
    }
}

/// Fist and tip of the cane in a frame.
fn cane(figure: &Figure, motion: &Motion, frame: usize) -> [Vector3<f64>; 2] {
    let link = figure.link_index(CANE).expect("a cane");
    let place = figure.places(motion.q(frame))[link];
    let tip = figure.links()[link].tip().expect("a tip");
    [place.translation.vector, (place * nalgebra::Point3::from(*tip)).coords]
}

/// What the ground does in a frame, of feet and cane together.
fn force(motion: &Motion, frame: usize) -> Vector3<f64> {
    motion.contacts.iter().map(|track| track.samples[frame].force).sum()
}

#[test]
fn whoever_walks_with_a_cane_obeys_the_laws() {
    for (height, hand, step_frequency, turn, load) in [
        (1.75, "right", 85.0, 0.0, None),
        (1.6, "left", 70.0, 0.2, Some(0.25)),
        (1.9, "right", 100.0, -0.3, Some(0.1)),
        (1.2, "left", 110.0, 0.0, Some(0.2)),
    ] {
        let figure = walker(height, hand);
        let asked = WalkRequest { turn, cane_load: load, ..request(&figure, step_frequency) };
        let (plan, motion) = walked(&figure, &asked);
        let found = measure(&figure, &motion).expect("measured").extremes;
        let who = format!("{height} m, {hand}, {step_frequency}: {found:?}");
        assert!(found.slide.value < 1e-4 && found.sink.value < 1e-3, "{who}");
        assert!(found.cop_outside.value < 5e-3 && found.least_knee.value > 0.0, "{who}");
        assert!(found.friction.value < FRICTION.0 && found.foot_friction.value < FRICTION.1, "{who}");

        let length = figure.link(CANE).and_then(|link| link.tip()).expect("a tip").norm();
        let track = motion.contacts.iter().find(|track| track.link == CANE).expect("a track");
        let mut most = 0.0_f64;
        for (frame, contact) in track.samples.iter().enumerate() {
            let [fist, tip] = cane(&figure, &motion, frame);
            assert!((fist - tip).norm() - length < 1e-9 && tip.y > -1e-9, "{who}");
            if contact.force == Vector3::zeros() {
                continue;
            }
            // Along the cane, at its tip on the ground.
            assert!((contact.cop - tip).norm() < 1e-9 && tip.y < 1e-9, "{who}: {tip}");
            assert!(contact.force.cross(&(fist - tip)).norm() < 1e-7 * contact.force.norm(), "{who}");
            most = most.max(contact.force.y / force(&motion, frame).y);
        }
        assert!((most - load.unwrap_or(0.15)).abs() < 5e-3, "{who}: {most}");
        // The tip stays where it is planted, and the others' share of the weight is the feet's.
        let link = figure.link_index(CANE).expect("a cane");
        let planted: Vec<_> = motion.planted.iter().filter(|planted| planted.link == link).collect();
        assert!(planted.len() >= plan.steps() / 2, "{who}: {planted:?}");
        for planted in planted {
            let frames = |time: &f64| (planted.start..=planted.end).contains(time);
            let tips: Vec<_> = (0..motion.len())
                .filter(|frame| frames(&motion.time()[*frame]))
                .map(|frame| cane(&figure, &motion, frame)[1])
                .collect();
            assert!(tips.iter().all(|tip| (tip - tips[0]).norm() < 1e-9), "{who}");
        }
    }
}

#[test]
fn the_ground_carries_the_body_with_its_cane() {
    let figure = walker(1.75, "left");
    let plan = walk(&figure, &request(&figure, 90.0)).expect("a walk");
    // At the nodes' own distance, at which the plan is differenced.
    let mut motion = plan.motion(&figure, 1.0 / plan.resolution()).expect("sampled");
    solaris_analysis::ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
    // By the body's own momentum, of all its links: m c̈ = F + m g.
    let com = |frame: usize| {
        let places = figure.places(motion.q(frame));
        let of = |(link, place): (&solaris_model::Link, &solaris_model::Isometry3<f64>)| {
            (place * nalgebra::Point3::from(*link.com())).coords * link.mass()
        };
        figure.links().iter().zip(&places).map(of).sum::<Vector3<f64>>()
    };
    let rate = motion.info.rate;
    let weight = figure.mass() * motion.info.gravity;
    for frame in (3..motion.len() - 3).step_by(7) {
        let seven = [2.0, -27.0, 270.0, -490.0, 270.0, -27.0, 2.0];
        let sum: Vector3<f64> = seven.iter().zip(frame - 3..).map(|(w, at)| com(at) * *w).sum();
        let beside = (sum * (rate * rate / 180.0) - weight - force(&motion, frame)).norm();
        assert!(beside < 1e-6 * weight.norm(), "{beside} N at {frame}");
    }
}

#[test]
fn a_cane_helps_the_hip_of_the_other_side() {
    let figure = walker(1.75, "right");
    let alone = Human::new(1.75, 23.8 * 1.75 * 1.75).root(RootOrder::Yzx).build().expect("a person");
    let peak = |figure: &Figure, load: Option<f64>| {
        let asked = WalkRequest { cane_load: load, ..request(&walker(1.75, "right"), 80.0) };
        let (_, motion) = walked(figure, &asked);
        let at =
            |name: &str| figure.layout().v_names().iter().position(|known| known == name).expect("a joint");
        let middle = motion.len() / 3..2 * motion.len() / 3;
        let most = |dof: usize| {
            middle.clone().map(|frame| motion.tau(frame).expect("forces")[dof].abs()).fold(0.0, f64::max)
        };
        [most(at("left_hip.rz")), most(at("right_hip.rz"))]
    };
    let [left, right] = peak(&alone, None);
    let mut before = peak(&figure, Some(0.0));
    assert!((before[0] / left - 1.0).abs() < 0.03 && (before[1] / right - 1.0).abs() < 0.05, "{before:?}");
    // Peak moments about the hip fall with what the cane bears (docs/manners.md).
    for load in [0.10, 0.15, 0.20] {
        let now = peak(&figure, Some(load));
        assert!(now[0] < before[0] - 0.02 * left, "{load}: {now:?} after {before:?}");
        assert!((now[1] / right - 1.0).abs() < 0.08, "{load}: {now:?}");
        before = now;
    }
    assert!((0.5..0.7).contains(&(before[0] / left)), "{before:?} of {left}");
}

#[test]
fn the_other_hand_is_the_mirror_image() {
    let [left, right] = ["left", "right"].map(|hand| {
        let figure = walker(1.75, hand);
        let (_, motion) = walked(&figure, &request(&figure, 95.0));
        (figure, motion)
    });
    let column = |figure: &Figure, name: &str| {
        figure.layout().v_names().iter().position(|known| known == name).expect("a coordinate")
    };
    for (name, other, sign) in [
        ("left_elbow.rx", "right_elbow.rx", 1.0),
        ("cane.rx", "cane.rx", 1.0),
        ("cane.rz", "cane.rz", -1.0),
        ("root.tx", "root.tx", -1.0),
        ("left_knee.rx", "right_knee.rx", 1.0),
    ] {
        let (a, b) = (column(&left.0, name), column(&right.0, other));
        for frame in (0..left.1.len()).step_by(11) {
            let [a, b] = [left.1.q(frame)[a], sign * right.1.q(frame)[b]];
            assert!((a - b).abs() < 1e-9, "{name} at {frame}: {a} {b}");
        }
    }
}

#[test]
fn what_a_cane_cannot_do_is_refused() {
    let figure = walker(1.75, "right");
    let refused = |asked: WalkRequest| walk(&figure, &asked).err().expect("refused").to_string();
    let usual = || request(&figure, 90.0);
    for load in [-0.01, 0.26, f64::NAN] {
        let error = refused(WalkRequest { cane_load: Some(load), ..usual() });
        assert!(error.contains("cane load") && error.contains("0 to 0.25"), "{error}");
    }
    for load in [CANE_LOADS.0, CANE_LOADS.1] {
        assert!(walk(&figure, &WalkRequest { cane_load: Some(load), ..usual() }).is_ok());
    }
    let error = refused(WalkRequest { ground: WalkGround::Slope(0.1), ..usual() });
    assert!(error.contains("holds a cane") && error.contains("level"), "{error}");
    let error = refused(WalkRequest { step_frequency: Some(130.0), ..usual() });
    assert!(error.contains("reach its cane"), "{error}");
    let alone = Human::new(1.75, 73.0).build().expect("a person");
    let error = walk(&alone, &WalkRequest { cane_load: Some(0.1), ..usual() }).err().expect("refused");
    assert!(error.to_string().contains("holds no cane"), "{error}");
    for error in [
        run(&figure, &RunRequest::default()).err().map(|error| error.to_string()),
        chair(&figure, &ChairRequest::default()).err().map(|error| error.to_string()),
        Walker::new(&figure).err().map(|error| error.to_string()),
    ] {
        let error = error.expect("refused");
        assert!(error.contains("holds a cane"), "{error}");
    }
}

#[test]
fn many_with_a_cane_obey_the_laws() {
    let mut random = Random(7);
    let (mut held, all) = (0, 40);
    for i in 0..all {
        let hand = if random.often(0.5) { "left" } else { "right" };
        let figure = walker(random.within(1.3, 1.95), hand);
        let turn = if random.often(0.5) { 0.0 } else { random.within(-0.3, 0.3) };
        let asked = WalkRequest {
            turn,
            extent: Extent::Steps(1 + random.pick(12)),
            cane_load: Some(random.within(0.0, 0.25)),
            ..request(&figure, random.within(62.0, 112.0))
        };
        let Ok(plan) = walk(&figure, &asked) else { continue };
        held += 1;
        let mut motion = plan.motion(&figure, 480.0).expect("sampled");
        solaris_analysis::ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
        let found = measure(&figure, &motion).expect("measured").extremes;
        assert!(found.cop_outside.value < 5.5e-3 && found.slide.value < 1e-4, "{i}, {asked:?}: {found:?}");
    }
    assert!(held >= 34, "{held} of {all}");
}
