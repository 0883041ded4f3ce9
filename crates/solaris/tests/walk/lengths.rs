//! Step lengths and distances other than people's.

use crate::body::frames_at;
use crate::cases::{Case, Outcome, RATE, assert_all_walk, person, run, steps, walked};
use crate::worst::Worst;
use solaris::gait::{GaitError, PlanError, RequestError};
use solaris::model::SolePart;
use solaris::prelude::*;

const HEIGHT: f64 = 1.75;

/// Ten steps, `factor` times as long as people's, which is 0.0037·height·frequency.
fn longer(frequency: f64, factor: f64) -> WalkRequest {
    WalkRequest { step_length: Some(factor * 0.0037 * HEIGHT * frequency), ..steps(frequency, 10) }
}

/// The greatest factor that is allowed.
fn most(frequency: f64) -> f64 {
    // 12 % up to 115 steps/min, from there to 2 % at 130.
    1.12 - 0.10 * ((frequency - 115.0) / 15.0).max(0.0)
}

const FREQUENCIES: [f64; 8] = [60.0, 70.0, 80.0, 95.0, 110.0, 115.0, 120.0, 130.0];

#[test]
fn shorter_and_longer_steps_obey_the_laws() {
    let mut cases = Vec::new();
    for frequency in FREQUENCIES {
        for factor in [0.88, most(frequency)] {
            let name = format!("{frequency}/min, {factor} of people's step");
            cases.push(Case { name, figure: person(HEIGHT), request: longer(frequency, factor) });
        }
    }
    assert_all_walk("step lengths", &cases);
}

/// At the limits friction decides; what is not refused for it must hold on the samples, where knees are all but straight.
#[test]
fn the_longest_steps_of_tall_people_hold_or_are_refused() {
    let mut cases = Vec::new();
    for (frequency, factor) in [(114.0, 1.12), (115.0, 1.08), (115.0, 1.10), (115.0, 1.12), (118.0, 1.06)] {
        let step_length = Some(factor * 0.0037 * 2.0 * frequency);
        let request = WalkRequest { step_length, ..steps(frequency, 10) };
        let name = format!("2 m, {frequency}/min, {factor} of people's step");
        cases.push(Case { name, figure: person(2.0), request });
    }
    let mut worst = Worst::default();
    for (case, outcome) in cases.iter().zip(run(&cases)) {
        match outcome {
            Outcome::Walked(found) => worst.merge(&case.name, &found),
            Outcome::Refused(GaitError::Plan(PlanError::Friction { .. } | PlanError::NotWalkable { .. })) => {
            }
            Outcome::Refused(error) => panic!("{}: {error}", case.name),
            Outcome::Failed(what) => panic!("{}: {what}", case.name),
        }
    }
    worst.assert_all("longest steps");
}

#[test]
fn steps_beyond_are_refused_with_the_interval() {
    for frequency in FREQUENCIES {
        for factor in [0.87, most(frequency) + 0.01] {
            let request = longer(frequency, factor);
            let error = walk(&person(HEIGHT), &request).err().expect("too short or too long");
            let GaitError::Request(RequestError::StepLength { value, lower, upper, .. }) = &error else {
                panic!("{error}")
            };
            let default = 0.0037 * HEIGHT * frequency;
            assert!((value - factor * default).abs() < 1e-12);
            assert!(
                (lower - 0.88 * default).abs() < 1e-9 && (upper - most(frequency) * default).abs() < 1e-9
            );
            assert!(error.to_string().contains(&format!("{lower:.3} to {upper:.3} m")), "{error}");
        }
    }
}

const DISTANCES: [f64; 5] = [0.1, 0.5, 1.0, 3.0, 10.0];

fn far(frequency: f64, distance: f64) -> WalkRequest {
    WalkRequest { extent: Extent::Distance(distance), ..steps(frequency, 1) }
}

#[test]
fn distances_are_met_exactly() {
    for (frequency, distance) in [(95.0, 0.1), (95.0, 3.0), (110.0, 0.5), (110.0, 10.0)] {
        let figure = person(HEIGHT);
        let (_, motion) = walked(&figure, &far(frequency, distance), RATE);
        let link = figure.link_index("left_foot").expect("a foot");
        let heel = figure.links()[link].sole_point(SolePart::Heel).expect("a heel");
        let at = |sample: usize| frames_at(&figure, &motion, sample)[link].point(heel)[0];
        let went = at(motion.len() - 1) - at(0);
        assert!((went.z - distance).abs() < 1e-9, "{distance} m: {went}");
    }
}

#[test]
fn walks_to_a_distance_obey_the_laws() {
    let mut cases = Vec::new();
    for frequency in [95.0, 110.0] {
        for distance in DISTANCES {
            let name = format!("{frequency}/min, {distance} m");
            cases.push(Case { name, figure: person(HEIGHT), request: far(frequency, distance) });
        }
    }
    assert_all_walk("distances", &cases);
}
