//! Options of the style never break physics: what is accepted obeys the laws, what does not is refused with the nearest that does.

use solaris_analysis::ground_reactions;
use solaris_gait::{
    Extent, FEET, FRICTION, GaitError, PARAMETERS, Parameter, PlanError, WalkPlan, WalkRequest, measure, walk,
};
use solaris_model::{Figure, human};

/// The smallest of generators (Knuth's multiplier): the cases are the same everywhere.
struct Random(u64);

impl Random {
    fn within(&mut self, lower: f64, upper: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        lower + (upper - lower) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

fn request(step_frequency: f64, parameters: Vec<(&'static str, f64)>) -> WalkRequest {
    WalkRequest {
        step_frequency: Some(step_frequency),
        extent: Extent::Steps(6),
        parameters,
        ..WalkRequest::default()
    }
}

fn obeys(figure: &Figure, plan: &WalkPlan, of: &str) {
    let mut motion = plan.motion(figure, 120.0).expect("sampled");
    ground_reactions(figure, &mut motion, FEET, plan).unwrap_or_else(|error| panic!("{of}: {error}"));
    let found = measure(figure, &motion).expect("measured").extremes;
    assert!(found.cop_outside.value <= 5e-3, "{of}: pressed {:?} outside", found.cop_outside);
    assert!(found.friction.value <= FRICTION.0 && found.foot_friction.value <= FRICTION.1, "{of}");
    assert!(found.least_knee.value > -0.0175, "{of}: {:?}", found.least_knee);
    // A leg may be a tenth of a millimetre too short.
    assert!(found.slide.value < 1e-4 && found.sink.value <= 1e-3, "{of}: {:?}", found.slide);
}

/// The values after "the nearest that holds is".
fn nearest(said: &str) -> Vec<(&'static str, f64)> {
    let one = |option: &str| {
        let (name, value) = option.split_once(' ').expect("a name and a value");
        let number = value.trim_end_matches(['°', 'm', ' ']);
        (Parameter::named(name).expect("a parameter").name, number.parse().expect("a number"))
    };
    said.split(", ").map(one).collect()
}

fn try_some(seed: u64, count: usize) {
    let mut random = Random(seed);
    let (mut refused, mut advised) = (0, 0);
    for number in 0..count {
        let height = random.within(1.5, 1.95);
        let figure = human(height, 23.8 * height * height).expect("a person");
        let step_frequency = random.within(65.0, 125.0);
        let mut options = Vec::new();
        for parameter in PARAMETERS {
            if random.within(0.0, 1.0) < 0.2 {
                options.push((parameter.name, random.within(parameter.range.0, parameter.range.1)));
            }
        }
        let of = format!("{number}: {height} m, {step_frequency} steps/min, {options:?}");
        match walk(&figure, &request(step_frequency, options.clone())) {
            Ok(plan) => obeys(&figure, &plan, &of),
            Err(GaitError::Plan(PlanError::Options { nearest: said, .. })) => {
                refused += 1;
                // What is said to hold does.
                for (name, value) in nearest(&said) {
                    let (_, asked) = options.iter_mut().find(|(asked, _)| *asked == name).expect("asked");
                    *asked = value;
                }
                let plan = walk(&figure, &request(step_frequency, options))
                    .unwrap_or_else(|error| panic!("{of}: {said} does not hold: {error}"));
                obeys(&figure, &plan, &of);
                advised += 1;
            }
            Err(error) => panic!("{of}: {error}"),
        }
    }
    println!("{refused} of {count} were refused, {advised} with what holds");
}

#[test]
fn random_options_obey_the_laws_or_are_refused_with_the_nearest_that_do() {
    try_some(1, 30);
}

#[test]
#[ignore = "some hundred random sets of options, minutes: cargo xtask nightly"]
fn many_random_options_obey_the_laws() {
    try_some(2, 300);
}

#[test]
fn a_heel_strike_that_presses_beside_the_sole_is_refused_with_the_nearest() {
    let figure = human(1.75, 73.0).expect("a person");
    for step_frequency in [95.0, 110.0, 120.0] {
        match walk(&figure, &request(step_frequency, vec![("heel-strike-angle", 8.2)])) {
            Ok(plan) => obeys(&figure, &plan, "8.2°"),
            Err(error @ GaitError::Plan(PlanError::Options { .. })) => {
                let said = error.to_string();
                assert!(said.starts_with("heel-strike-angle 8.2° with steps of"), "{said}");
                assert!(said.contains("; the nearest that holds is heel-strike-angle "), "{said}");
            }
            Err(error) => panic!("{error}"),
        }
    }
}
