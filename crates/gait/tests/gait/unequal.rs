//! Legs of unequal length: the laws hold all the same, judged by the motion's own inverse dynamics, and the pelvis hangs to the shorter one.

use crate::load::{assert_mirrored, course, walked};
use solaris_gait::{
    BodyError, Extent, GaitError, RunRequest, Stairs, WalkGround, WalkRequest, Walker, measure, run, walk,
};
use solaris_model::{Figure, Human, RootOrder, Trajectory};

fn uneven(height: f64, leg: &str, by: f64) -> Figure {
    let human = Human::new(height, 23.8 * height * height).root(RootOrder::Yzx);
    human.shorter_leg(leg, by).build().expect("a person")
}

/// Random people, legs, paces, turns, slopes and stairs: what is walked obeys the laws, and on level ground all up to 118 steps/min is.
fn try_random(walks: usize) {
    let mut seed = 12345_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut walked_on = [0; 4];
    for k in 0..walks {
        let height = 1.5 + 0.45 * random();
        let figure = uneven(height, ["left", "right"][k % 2], 0.032 * random() * height / 1.75);
        let step_frequency = 65.0 + 60.0 * random();
        let left_first = random() < 0.5;
        let request =
            WalkRequest { step_frequency: Some(step_frequency), left_first, ..WalkRequest::default() };
        let kind = k / 2 % 4;
        let request = match kind {
            0 => request,
            1 => WalkRequest { turn: 0.4 * (random() - 0.5), ..request },
            2 => WalkRequest { ground: WalkGround::Slope(0.24 * (random() - 0.5)), ..request },
            _ => {
                let rise = if random() < 0.5 { 0.17 } else { -0.17 };
                let stairs = Stairs { count: 4, rise, ..Stairs::default() };
                WalkRequest { ground: WalkGround::Stairs(stairs), step_frequency: None, ..request }
            }
        };
        let who = format!("walk {k}: {height} m, {request:?}");
        if let Err(error) = walk(&figure, &request) {
            assert!(kind > 1 || step_frequency > 118.0, "{who}: {error}");
            continue;
        }
        walked_on[kind] += 1;
        let (_, motion) = walked(&figure, &request);
        let found = measure(&figure, &motion).expect("measured").extremes;
        let who = format!("{who}: {found:?}");
        assert!(found.slide.value < 1e-4 && found.sink.value.abs() < 1e-3, "{who}");
        // A degree of hyperextension is what any walk may have.
        let knee = found.least_knee.value.to_degrees();
        assert!(found.cop_outside.value < 5e-3 && knee > -1.0, "{who}");
        // On ground that leans friction is judged by its normals, as the plan has them.
        assert!(kind > 1 || found.friction.value < 0.5 && found.foot_friction.value < 0.5, "{who}");
    }
    assert!(walked_on.iter().all(|count| 3 * count >= walks / 4), "{walked_on:?} of {walks}");
}

#[test]
fn whoever_has_a_shorter_leg_obeys_the_laws() {
    try_random(32);
}

#[test]
#[ignore = "160 walks: cargo xtask nightly"]
fn many_with_a_shorter_leg_obey_the_laws() {
    try_random(160);
}

#[test]
fn the_pelvis_hangs_to_the_shorter_leg_and_the_knees_bend_alike() {
    let request =
        WalkRequest { step_frequency: Some(100.0), extent: Extent::Steps(20), ..WalkRequest::default() };
    let figure = uneven(1.75, "right", 0.02);
    let (_, motion) = walked(&figure, &request);
    let hip = figure.link("left_thigh").expect("a thigh").joint().placement().translation.x;
    // A turn about z, which points forward, lifts the left hip.
    let hangs = course(&figure, &motion, "root.rz").0;
    assert!((hangs - (0.01 / hip).asin()).abs() < 0.01, "{hangs}");
    // The thorax stays upright over it.
    let bends = ["lumbar.rz", "thorax.rz"].map(|name| course(&figure, &motion, name).0);
    assert!((hangs + bends.iter().sum::<f64>()).abs() < 0.01, "{hangs} {bends:?}");
    let knees = ["left_knee.rx", "right_knee.rx"].map(|name| course(&figure, &motion, name));
    assert!((knees[0].0 - knees[1].0).abs() < 0.02 && (knees[0].1 - knees[1].1).abs() < 0.03, "{knees:?}");
}

/// One thigh is longer and its shank shorter: legs are as long, and knees stand elsewhere.
#[test]
fn legs_as_long_as_each_other_with_other_thighs_walk_with_either_foot_first() {
    let figure = |side: &str| {
        let human = Human::new(1.75, 73.0).root(RootOrder::Yzx);
        let plain = human.build().expect("a person");
        let below = |link: &str| -plain.link(link).expect("a link").joint().placement().translation.y;
        let [thigh, shank] = ["left_shank", "left_foot"].map(below);
        let length = |name: &str| plain.segment_length(name).expect("a length");
        let longer = |name: &str, own: f64, by: f64| length(name) * (own + by) / own;
        let human = human.segment_length(format!("{side}_thigh"), longer("left_thigh", thigh, 0.012));
        let human = human.segment_length(format!("{side}_shank"), longer("left_shank", shank, -0.012));
        human.build().expect("a person")
    };
    let plans = [("right", false), ("left", true)].map(|(side, left_first)| {
        let extent = Extent::Steps(5);
        let request =
            WalkRequest { step_frequency: Some(105.0), extent, left_first, ..WalkRequest::default() };
        let (plan, motion) = walked(&figure(side), &request);
        let found = measure(&figure(side), &motion).expect("measured").extremes;
        assert!(found.slide.value < 1e-4 && found.sink.value.abs() < 1e-3, "{found:?}");
        plan
    });
    assert_mirrored(&figure("left"), &plans);
}

#[test]
fn a_leg_that_is_shorter_on_the_other_side_is_the_mirror_image() {
    let plans = [("right", false), ("left", true)].map(|(leg, left_first)| {
        let extent = Extent::Steps(5);
        let request =
            WalkRequest { step_frequency: Some(100.0), extent, left_first, ..WalkRequest::default() };
        walked(&uneven(1.75, leg, 0.015), &request).0
    });
    assert_mirrored(&uneven(1.75, "left", 0.0), &plans);
}

#[test]
fn a_leg_that_is_no_shorter_changes_nothing() {
    let q = [
        uneven(1.75, "left", 0.0),
        Human::new(1.75, 23.8 * 1.75 * 1.75).root(RootOrder::Yzx).build().expect("a person"),
    ]
    .map(|figure| {
        let mut q = vec![0.0; 66];
        walk(&figure, &WalkRequest::default()).expect("a walk").configuration(2.3, &mut q);
        q
    });
    assert_eq!(q[0], q[1]);
}

#[test]
fn what_cannot_be_walked_on_unequal_legs_is_refused_by_name() {
    let far = uneven(1.75, "left", 0.05);
    let error = walk(&far, &WalkRequest::default()).err().expect("too far").to_string();
    assert!(
        error.starts_with("the left leg is 5.0 cm shorter than the other one; the walker can do with 3."),
        "{error}"
    );
    // What plans one leg and mirrors it.
    let figure = uneven(1.75, "left", 0.01);
    let refused = [Walker::new(&figure).err(), run(&figure, &RunRequest::default()).err()];
    for error in refused.map(|error| error.expect("it plans one leg and mirrors it")) {
        assert!(matches!(error, GaitError::Body(BodyError::LegsDiffer { .. })), "{error}");
    }
}
