//! A load in one hand: the body is heavier on one side, and the laws hold all the same, judged by the motion's own inverse dynamics.

use solaris_analysis::{ground_reactions, nearness};
use solaris_gait::{Extent, FEET, FRICTION, Population, WalkPlan, WalkRequest, measure, walk};
use solaris_model::{Figure, Human, Motion, Trajectory};

fn porter(height: f64, loads: &[(&str, f64)]) -> Figure {
    let human = Human::new(height, 23.8 * height * height);
    loads.iter().fold(human, |human, (hand, load)| human.load(*hand, *load)).build().expect("a person")
}

pub(crate) fn walked(figure: &Figure, request: &WalkRequest) -> (WalkPlan, Motion) {
    let plan = walk(figure, request).unwrap_or_else(|error| panic!("{error}: {request:?}"));
    let mut motion = plan.motion(figure, 240.0).expect("sampled");
    let report = ground_reactions(figure, &mut motion, FEET, &plan).expect("forces");
    let beside = report.from_prescribed.expect("prescribed").value / plan.weight();
    assert!(beside < 0.05, "{beside} weights beside the plan: {request:?}");
    (plan, motion)
}

/// Mean and half of the range of a coordinate in the middle of a walk (rad).
pub(crate) fn course(figure: &Figure, motion: &Motion, name: &str) -> (f64, f64) {
    let at = figure.layout().v_names().iter().position(|known| known == name).expect("a coordinate");
    let middle = motion.len() / 3..2 * motion.len() / 3;
    let (least, most) = middle
        .map(|sample| motion.q(sample)[at])
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)));
    (0.5 * (least + most), 0.5 * (most - least))
}

#[test]
fn whoever_carries_something_in_one_hand_obeys_the_laws() {
    for (height, hand, load, step_frequency) in [
        (1.75, "right", 5.0, 110.0),
        (1.75, "left", 10.0, 100.0),
        (1.6, "right", 8.0, 95.0),
        (1.9, "left", 12.0, 90.0),
        (1.75, "right", 15.0, 80.0),
    ] {
        let figure = porter(height, &[(hand, load)]);
        for left_first in [false, true] {
            let request =
                WalkRequest { step_frequency: Some(step_frequency), left_first, ..WalkRequest::default() };
            let (_, motion) = walked(&figure, &request);
            let found = measure(&figure, &motion).expect("measured").extremes;
            let who = format!("{height} m, {load} kg {hand}, {step_frequency}, {left_first}: {found:?}");
            assert!(found.slide.value < 1e-4 && found.sink.value < 1e-3, "{who}");
            assert!(found.cop_outside.value < 5e-3 && found.least_knee.value > 0.0, "{who}");
            assert!(found.friction.value < FRICTION.0 && found.foot_friction.value < FRICTION.1, "{who}");
        }
    }
}

#[test]
fn the_trunk_leans_away_and_the_arm_swings_less() {
    // The middle third is steady: first and last steps bend the trunk otherwise.
    let request =
        WalkRequest { step_frequency: Some(100.0), extent: Extent::Steps(20), ..WalkRequest::default() };
    let empty = porter(1.75, &[]);
    let (_, motion) = walked(&empty, &request);
    let lean = |figure: &Figure, motion: &Motion| {
        ["lumbar.rz", "thorax.rz"].map(|name| course(figure, motion, name).0).iter().sum::<f64>()
    };
    let upright = lean(&empty, &motion);
    let swings = ["left_shoulder.rx", "right_shoulder.rx"].map(|name| course(&empty, &motion, name).1);
    assert!(upright.abs() < 0.02 && (swings[0] - swings[1]).abs() < 1e-3, "{upright} {swings:?}");
    let figure = porter(1.75, &[("right", 8.0)]);
    let (plan, motion) = walked(&figure, &request);
    // A turn about z, which points forward, to the left is negative: the lumbar joint and the one above it share it.
    let leans = lean(&figure, &motion);
    assert!((-0.2..-0.05).contains(&leans), "{leans}");
    let loaded = ["left_shoulder.rx", "right_shoulder.rx"].map(|name| course(&figure, &motion, name).1);
    assert!((loaded[0] - swings[0]).abs() < 0.02 && loaded[1] < 0.4 * swings[1], "{loaded:?} {swings:?}");
    // Standing, half of what the load is off is made good: 8 kg that hang 0.3 m aside.
    let mut q = vec![0.0; 66];
    plan.configuration(0.0, &mut q);
    let places = figure.places(&q);
    let moment: f64 = figure
        .links()
        .iter()
        .zip(&places)
        .map(|(link, place)| link.mass() * (place * nalgebra::Point3::from(*link.com())).x)
        .sum();
    assert!((0.3..0.7).contains(&(moment.abs() / (8.0 * 0.3))), "{moment}");
    // Nothing goes into anything by what would be told.
    let near = nearness(&figure, &motion).expect("shapes").expect("limbs").limbs(&figure, motion.time());
    assert!(near.overlaps.is_empty(), "{:?}", near.overlaps);
}

#[test]
fn a_load_on_the_other_side_is_the_mirror_image() {
    let request = |left_first| WalkRequest {
        step_frequency: Some(100.0),
        extent: Extent::Steps(5),
        population: Population::Older,
        left_first,
        ..WalkRequest::default()
    };
    let plans = [("right", false), ("left", true)].map(|(hand, left_first)| {
        let figure = porter(1.75, &[(hand, 6.0)]);
        walked(&figure, &request(left_first)).0
    });
    assert_mirrored(&porter(1.75, &[]), &plans);
}

/// That one walk is the other one's mirror image, of figures with the coordinates of `figure`.
pub(crate) fn assert_mirrored(figure: &Figure, plans: &[WalkPlan; 2]) {
    let names: Vec<String> = figure.layout().v_names().to_vec();
    let [mut one, mut other] = [vec![0.0; 66], vec![0.0; 66]];
    for k in 0..100 {
        let t = plans[0].duration() * f64::from(k) / 99.0;
        plans[0].configuration(t, &mut one);
        plans[1].configuration(t, &mut other);
        for (i, name) in names.iter().enumerate() {
            let swapped = match name.split_once('_') {
                Some(("left", rest)) => format!("right_{rest}"),
                Some(("right", rest)) => format!("left_{rest}"),
                _ => name.clone(),
            };
            let there = names.iter().position(|known| *known == swapped).expect("the other side");
            // Sideways, and turns about y and z, go the other way.
            let sign = if name == "root.tx"
                || ["ry", "rz"].iter().any(|axis| name.rsplit('.').next() == Some(*axis))
            {
                -1.0
            } else {
                1.0
            };
            assert!(
                (one[i] - sign * other[there]).abs() < 1e-9,
                "{name} at {t}: {} {}",
                one[i],
                other[there]
            );
        }
    }
}

#[test]
fn the_same_in_both_hands_is_carried_upright() {
    let figure = porter(1.75, &[("left", 7.0), ("right", 7.0)]);
    let request =
        WalkRequest { step_frequency: Some(95.0), extent: Extent::Steps(20), ..WalkRequest::default() };
    let (_, motion) = walked(&figure, &request);
    let lean = ["lumbar.rz", "thorax.rz"].map(|name| course(&figure, &motion, name).0);
    assert!(lean.iter().all(|lean| lean.abs() < 0.01), "{lean:?}");
}
