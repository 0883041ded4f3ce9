//! Within which values of a number walks hold: ends are accepted and what is beyond them is not, by the planner itself.

use solaris_gait::{GaitError, GaitKind, GaitOptions, PARAMETERS, PartOptions, Repeats, StairOptions, TURN};
use solaris_model::{Figure, human};

fn people() -> [Figure; 3] {
    [(1.75, 73.0), (1.55, 80.0), (1.95, 85.0)].map(|(height, mass)| human(height, mass).expect("a person"))
}

/// The same options with another value of a number.
fn with(options: &GaitOptions, field: &str, value: f64) -> GaitOptions {
    let mut options = options.clone();
    match field {
        "step_frequency" => options.step_frequency = Some(value),
        "step_length" => options.step_length = Some(value),
        "speed" => options.speed = Some(value),
        "turn" => options.turn = value,
        "slope" => options.slope = Some(value),
        "variability" => options.variability = Some(value),
        "stairs.rise" => {
            options.stairs = Some(StairOptions { rise: Some(value), ..options.stairs.unwrap_or_default() });
        }
        style => drop(options.style.insert(style.to_owned(), value)),
    }
    options
}

fn is_accepted(figure: &Figure, options: &GaitOptions) -> bool {
    options.make(figure).is_ok()
}

/// Ends are accepted; a 250th of the declared range beyond them, of which `within` are the ends, nothing is.
fn hold(figure: &Figure, options: &GaitOptions, field: &str, within: [f64; 2]) -> Option<[f64; 2]> {
    let began = std::time::Instant::now();
    let found = options.range_of(figure, field).expect("a number of the options");
    let took = began.elapsed();
    println!("{}: {field} {found:.4?}, {took:.0?}", figure.name());
    let [lower, upper] = found?;
    let said = format!("{} {options:?} {field}: {found:?}", figure.name());
    assert!(lower <= upper, "{said}");
    for end in [lower, upper] {
        assert!(is_accepted(figure, &with(options, field, end)), "{end}: {said}");
    }
    let beyond = (within[1] - within[0]) / 250.0;
    for value in [lower - beyond, upper + beyond] {
        if (within[0]..=within[1]).contains(&value) {
            assert!(!is_accepted(figure, &with(options, field, value)), "{value}: {said}");
        }
    }
    found
}

#[test]
fn ends_are_accepted_and_what_is_beyond_them_is_not() {
    let usual = GaitOptions::default();
    for (figure, steps) in people().iter().zip([10, 6, 10]) {
        let walk = GaitOptions { steps: Some(steps), ..usual.clone() };
        let [slow, fast] = hold(figure, &walk, "speed", [0.01, 3.0]).expect("speeds");
        assert!(slow < 1.0 && fast > 1.6, "{slow} {fast}");
        let paced = GaitOptions { step_frequency: Some(100.0), ..walk.clone() };
        let [short, long] = hold(figure, &paced, "step_length", [0.01, 2.0]).expect("lengths");
        let usual = 0.0037 * figure.stature().expect("a height") * 100.0;
        assert!(short < usual && long > usual, "{short} {long}");
        hold(figure, &walk, "step_frequency", [60.0, 130.0]).expect("frequencies");
        let [right, left] = hold(figure, &paced, "turn", [-TURN, TURN]).expect("turns");
        assert!(right < -0.1 && left > 0.1);
    }
    let one = &people()[0];
    hold(one, &usual, "slope", [-0.35, 0.35]).expect("slopes");
    for name in ["heel-strike-angle", "step-width", "arm-swing"] {
        let range = PARAMETERS.iter().find(|parameter| parameter.name == name).expect("there is").range;
        hold(one, &GaitOptions { step_frequency: Some(115.0), ..usual.clone() }, name, range.into());
    }
}

#[test]
fn other_gaits_have_ranges_too() {
    let one = &people()[0];
    let run = GaitOptions { gait: GaitKind::Run, ..GaitOptions::default() };
    let [slow, fast] = hold(one, &run, "speed", [1.0, 6.0]).expect("speeds of runs");
    assert!(slow < 2.5 && fast > 4.0, "{slow} {fast}");
    let thesis = GaitOptions { determinants: Some(5), ..GaitOptions::default() };
    hold(one, &thesis, "step_frequency", [30.0, 180.0]).expect("frequencies of key postures");
    let looped = GaitOptions { repeats: Some(Repeats::InPlace), ..GaitOptions::default() };
    hold(one, &looped, "speed", [0.01, 3.0]).expect("speeds of a loop");
    let stand = PartOptions { stand: Some(1.0), ..PartOptions::default() };
    let on = PartOptions { steps: Some(3), ..PartOptions::default() };
    let sequence = GaitOptions { steps: Some(3), then: vec![stand, on], ..GaitOptions::default() };
    hold(one, &sequence, "step_frequency", [60.0, 130.0]).expect("frequencies of two walks");
}

#[test]
fn a_value_that_is_refused_has_the_nearest_interval_or_none() {
    let one = &people()[0];
    // Nobody walks at 3 m/s: what holds is below.
    let fast = GaitOptions { speed: Some(2.9), steps: Some(6), ..GaitOptions::default() };
    let [_, most] = hold(one, &fast, "speed", [0.01, 3.0]).expect("slower ones");
    assert!(most > 1.6 && most < 2.9, "{most}");
    // With steps of a metre at 60 a minute no arm swing helps.
    let long = GaitOptions { step_length: Some(1.0), step_frequency: Some(60.0), ..GaitOptions::default() };
    assert_eq!(long.range_of(one, "arm_swing").expect("a number"), None);
}

#[test]
fn what_is_no_number_and_what_contradicts_itself_is_refused() {
    let one = &people()[0];
    let error = GaitOptions::default().range_of(one, "arm_swin").expect_err("no such number").to_string();
    assert!(error.contains("did you mean arm-swing?") && error.contains("step-length"), "{error}");
    let all = GaitOptions { speed: Some(1.0), step_length: Some(0.6), ..GaitOptions::default() };
    let error = all.range_of(one, "step_frequency").expect_err("one too many");
    assert!(matches!(error, GaitError::Request(_)), "{error}");
    let run = GaitOptions { gait: GaitKind::Run, ..GaitOptions::default() };
    assert!(run.range_of(one, "slope").is_err());
}
