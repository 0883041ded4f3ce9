//! People whose legs and arms have lengths of their own.

use crate::cases::{Case, Outcome, run, shaped, steps};
use crate::worst::Worst;
use solaris::gait::{BodyError, GaitError, PlanError};
use solaris::prelude::walk;

/// Lengths at a height of 1.75 m, where thigh, shank, foot and toes are 0.424, 0.436, 0.201 and 0.070 m.
const SHAPES: [&[(&str, f64)]; 10] = [
    &[("thigh", 0.46), ("shank", 0.40)],
    &[("thigh", 0.39), ("shank", 0.47)],
    &[("thigh", 0.46)],
    &[("shank", 0.48)],
    &[("thigh", 0.38), ("shank", 0.39)],
    &[("foot", 0.23)],
    &[("foot", 0.17), ("toes", 0.06)],
    &[("toes", 0.085)],
    &[("pelvis", 0.17), ("upper_arm", 0.25), ("forearm", 0.31)],
    &[("abdomen", 0.25), ("head", 0.24)],
];

/// People of all shapes who walk so many steps.
fn walk_or_are_told_why_not(n: usize) {
    let mut cases = Vec::new();
    for lengths in SHAPES {
        for frequency in [95.0, 110.0] {
            let name = format!("{lengths:?}, {frequency}/min");
            cases.push(Case { name, figure: shaped(1.75, lengths), request: steps(frequency, n) });
        }
    }
    let (mut worst, mut wrong, mut refused) = (Worst::default(), Vec::new(), 0);
    for (case, outcome) in cases.iter().zip(run(&cases)) {
        match outcome {
            Outcome::Walked(found) => worst.merge(&case.name, &found),
            Outcome::Refused(GaitError::Plan(PlanError::Friction { .. } | PlanError::NotWalkable { .. })) => {
                refused += 1;
            }
            Outcome::Refused(error) => wrong.push(format!("{}: {error}", case.name)),
            Outcome::Failed(what) => wrong.push(format!("{}: {what}", case.name)),
        }
    }
    worst.show("proportions");
    assert!(wrong.is_empty() && worst.broken().is_empty(), "{}\n{}", wrong.join("\n"), worst.broken());
    assert!(4 * refused <= cases.len(), "{refused} of {} are refused", cases.len());
}

#[test]
fn people_of_other_proportions_walk_or_are_told_why_not() {
    walk_or_are_told_why_not(3);
}

#[test]
#[ignore = "ten steps each, some seconds: cargo xtask nightly"]
fn people_of_other_proportions_walk_far_or_are_told_why_not() {
    walk_or_are_told_why_not(10);
}

#[test]
fn legs_that_differ_too_much_are_refused_by_name() {
    let error =
        walk(&shaped(1.75, &[("left_thigh", 0.46)]), &steps(95.0, 4)).err().expect("legs that differ");
    assert!(matches!(error, GaitError::Body(BodyError::LegsTooUnequal { .. })), "{error}");
    assert!(error.to_string().starts_with("the right leg is "), "{error}");
}
