//! Random walks that change on the way: what is not refused obeys the laws.

use crate::random::Random;
use solaris_analysis::ground_reactions;
use solaris_gait::{
    Extent, FEET, FRICTION, GaitError, PlanError, WALK_RATIO, WalkPart, WalkRequest, measure, walk,
};
use solaris_model::human;

/// Some steps of any pace, now and then short ones, now and then round a corner.
fn request(random: &mut Random, height: f64) -> WalkRequest {
    let first = random.within(60.0, 118.0);
    let (mut step_frequency, mut turned) = (first, 0.0_f64);
    let mut then = Vec::new();
    for _ in 0..random.within(1.0, 4.0) as usize {
        step_frequency = (step_frequency + random.within(-40.0, 40.0)).clamp(60.0, 130.0);
        let short = if random.often(0.3) { random.within(0.5, 1.0) } else { 1.0 };
        let steps = random.within(1.0, 5.0) as usize;
        let turn = if random.often(0.5) { random.within(-30.0, 30.0).to_radians() } else { 0.0 };
        let turn = if (turned + turn * steps as f64).abs() > 1.30 { 0.0 } else { turn };
        turned += turn * steps as f64;
        let step_length = Some(short * WALK_RATIO * height * step_frequency);
        then.push(WalkPart {
            steps,
            step_frequency: Some(step_frequency),
            step_length,
            turn,
            ..WalkPart::default()
        });
    }
    WalkRequest {
        step_frequency: Some(first),
        extent: Extent::Steps(random.within(1.0, 6.0) as usize),
        left_first: random.often(0.5),
        then,
        ..WalkRequest::default()
    }
}

#[test]
fn random_changes_obey_the_laws() {
    let mut random = Random(2026);
    let mut refused = 0;
    for number in 0..40 {
        let height = random.within(1.4, 2.0);
        let figure = human(height, 23.8 * height * height).expect("a person");
        let request = request(&mut random, height);
        let of = format!("{number}, {height} m: {request:?}");
        let plan = match walk(&figure, &request) {
            Ok(plan) => plan,
            Err(GaitError::Plan(PlanError::AbruptChange { .. })) => {
                refused += 1;
                continue;
            }
            Err(error) => panic!("{error}; {of}"),
        };
        let mut motion = plan.motion(&figure, 120.0).expect("sampled");
        let report = ground_reactions(&figure, &mut motion, FEET, &plan)
            .unwrap_or_else(|error| panic!("{error}; {of}"));
        let prescribed = report.from_prescribed.expect("prescribed").value / plan.weight();
        let walk = measure(&figure, &motion).expect("measured");
        assert!(prescribed < 0.15, "{prescribed}; {of}");
        assert!(
            walk.extremes.friction.value <= FRICTION.0 && walk.extremes.foot_friction.value <= FRICTION.1,
            "{of}"
        );
        assert!(walk.extremes.slide.value < 1e-9 && walk.extremes.sink.value < 1e-4, "{of}");
        assert!(walk.extremes.cop_outside.value < 1e-3, "{} m; {of}", walk.extremes.cop_outside.value);
        assert!(walk.extremes.clearance.value > 0.005 && walk.extremes.least_knee.value > -0.0175, "{of}");
        let all: usize = request.then.iter().map(|leg| leg.steps).sum();
        assert_eq!(walk.steps, plan.steps(), "{of}");
        assert!(plan.steps() > all, "{of}");
    }
    println!("{refused} of 40 were refused");
    assert!(refused < 8, "{refused}");
}
