//! People smaller and taller than those whom the laws were tried with: their walks hold, or are refused with a pace that does.

use solaris_gait::{Extent, GaitError, PlanError, StyledPlan, WalkRequest, manner, measure, walk};
use solaris_model::{Figure, human};

fn asked(step_frequency: f64) -> WalkRequest {
    WalkRequest { step_frequency: Some(step_frequency), extent: Extent::Steps(10), ..WalkRequest::default() }
}

fn holds(figure: &Figure, step_frequency: f64) -> Result<(), GaitError> {
    let plan = walk(figure, &asked(step_frequency))?;
    let (motion, _) = StyledPlan::Smooth(Box::new(plan)).loaded(figure, 240.0)?;
    let found = measure(figure, &motion)?.extremes;
    let who = format!("{:?} m at {step_frequency}: {found:?}", figure.stature());
    assert!(found.cop_outside.value < 5.5e-3, "{who}");
    assert!(found.slide.value < 1e-3 && found.sink.value < 1e-3, "{who}");
    assert!(found.foot_friction.value < 0.6 && found.least_knee.value > -1_f64.to_radians(), "{who}");
    Ok(())
}

#[test]
fn they_walk_or_are_told_at_which_pace() {
    let (mut walked, mut refused) = (0, Vec::new());
    for height in [0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 2.05, 2.15, 2.3] {
        let figure = human(height, 23.0 * height * height).expect("a person");
        for step_frequency in [61.0, 67.0, 72.0, 78.0, 90.0, 104.0, 114.0, 118.0, 124.0, 130.0] {
            match holds(&figure, step_frequency) {
                Ok(()) => walked += 1,
                Err(GaitError::Plan(PlanError::Options { nearest, what, .. })) => {
                    refused.push(format!("{height} m at {step_frequency}: {what}; {nearest}"));
                    let pace = nearest.split_whitespace().find_map(|word| word.parse().ok());
                    let pace: f64 =
                        pace.unwrap_or_else(|| panic!("{height} m at {step_frequency}: {what}; {nearest}"));
                    holds(&figure, pace).unwrap_or_else(|why| panic!("{height} m at {pace}: {why}"));
                    // None that is nearer does.
                    let nearer = pace + (step_frequency - pace).signum();
                    assert!((nearer - step_frequency).abs() < 0.5 || walk(&figure, &asked(nearer)).is_err());
                }
                Err(why) => panic!("{height} m at {step_frequency}: {why}"),
            }
        }
        // People's own pace is walked by all, as far as it is one of the walker's.
        let own = 110.0 * (1.75 / height).sqrt();
        holds(&figure, own.min(130.0)).unwrap_or_else(|why| panic!("{height} m: {why}"));
    }
    println!("{walked} walked; refused: {refused:#?}");
    assert!(walked >= 80, "{walked}");
}

#[test]
fn who_walks_in_a_manner_or_at_a_speed_is_told_too() {
    let figure = human(0.9, 19.0).expect("a person");
    let refused =
        |request: WalkRequest| walk(&figure, &request).map(|_| ()).expect_err("no walk").to_string();
    let sad = WalkRequest { sheet: manner("sad").expect("a manner"), ..asked(61.0) };
    let why = refused(sad);
    println!("{why}");
    assert!(why.contains("a height of 0.9 m") && why.contains("the nearest that holds is"), "{why}");
    let slow = WalkRequest { step_frequency: None, speed: Some(0.2), ..asked(61.0) };
    let why = refused(slow);
    println!("{why}");
    assert!(why.contains("the nearest that holds is") && why.ends_with(" steps/min"), "{why}");
}
