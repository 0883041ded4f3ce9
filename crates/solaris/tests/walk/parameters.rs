//! The parameters of the style at the ends of their ranges.

use crate::cases::{Case, Outcome, person, run, steps};
use crate::worst::Worst;
use solaris::gait::{GaitError, PARAMETERS, PlanError, RequestError};
use solaris::prelude::*;

/// Both ends of every parameter at three speeds.
fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for parameter in PARAMETERS {
        for value in [parameter.range.0, parameter.range.1] {
            for frequency in [80.0, 95.0, 110.0] {
                let name = format!("{} {value} at {frequency}/min", parameter.name);
                let request =
                    WalkRequest { parameters: vec![(parameter.name, value)], ..steps(frequency, 4) };
                cases.push(Case { name, figure: person(1.75), request });
            }
        }
    }
    cases
}

#[expect(clippy::print_stdout, reason = "captured unless somebody asks for it")]
fn walk_or_are_told_why_not(cases: &[Case]) {
    let (mut worst, mut wrong) = (Worst::default(), Vec::new());
    for (case, outcome) in cases.iter().zip(run(cases)) {
        match outcome {
            Outcome::Walked(found) => {
                if !found.broken().is_empty() {
                    wrong.push(format!("{}:\n{}", case.name, found.broken()));
                }
                worst.merge(&case.name, &found);
            }
            Outcome::Refused(
                error @ GaitError::Plan(
                    PlanError::Friction { .. } | PlanError::NotWalkable { .. } | PlanError::Options { .. },
                ),
            ) => {
                println!("{}: refused: {error}", case.name);
            }
            Outcome::Refused(error) => wrong.push(format!("{}: {error}", case.name)),
            Outcome::Failed(what) => wrong.push(format!("{}: {what}", case.name)),
        }
    }
    worst.show("ends of the parameters' ranges");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Every fourth: each parameter comes up at one end at least, each speed with both ends of some.
#[test]
fn some_ends_of_all_ranges_walk_or_are_told_why_not() {
    let cases: Vec<Case> = cases().into_iter().step_by(4).collect();
    walk_or_are_told_why_not(&cases);
}

#[test]
#[ignore = "all ends at all speeds, half a minute: cargo xtask nightly"]
fn the_ends_of_all_ranges_walk_or_are_told_why_not() {
    walk_or_are_told_why_not(&cases());
}

#[test]
fn beyond_its_range_a_parameter_is_refused_by_name() {
    for parameter in PARAMETERS {
        let (lower, upper) = parameter.range;
        for value in [lower - 0.01, upper + 0.01, f64::NAN] {
            let request = WalkRequest { parameters: vec![(parameter.name, value)], ..steps(95.0, 2) };
            let error = walk(&person(1.75), &request).err().expect("out of range");
            assert!(matches!(error, GaitError::Request(RequestError::Range { .. })), "{error}");
            assert!(error.to_string().contains(parameter.name), "{error}");
        }
    }
}
