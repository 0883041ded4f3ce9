//! Walks by the dozen, planned and judged on all cores.

use crate::criteria::judge;
use crate::worst::Worst;
use rayon::prelude::*;
use solaris::gait::{FEET, GaitError, WalkPlan};
use solaris::model::Human;
use solaris::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Frames a second.
pub(crate) const RATE: f64 = 120.0;

/// A walk that is asked for.
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) figure: Figure,
    pub(crate) request: WalkRequest,
}

/// What came of it.
pub(crate) enum Outcome {
    /// A motion, with the worst of each criterion.
    Walked(Worst),
    /// The planner said why not.
    Refused(GaitError),
    /// Something went wrong that is no refusal: a panic, or a motion without forces.
    Failed(String),
}

/// A human of this height with the mass 23.8 kg/m² · h².
pub(crate) fn person(height: f64) -> Figure {
    human(height, 23.8 * height * height).expect("a usual height")
}

/// The same, with some segments' own lengths.
pub(crate) fn shaped(height: f64, lengths: &[(&str, f64)]) -> Figure {
    let person = Human::new(height, 23.8 * height * height);
    let shaped = lengths.iter().fold(person, |human, (name, length)| human.segment_length(*name, *length));
    shaped.build().expect("lengths that people have")
}

/// So many steps at a step frequency.
pub(crate) fn steps(step_frequency: f64, steps: usize) -> WalkRequest {
    let step_frequency = Some(step_frequency);
    WalkRequest { step_frequency, extent: Extent::Steps(steps), ..WalkRequest::default() }
}

/// The plan, and its motion with the ground's forces.
pub(crate) fn walked(figure: &Figure, request: &WalkRequest, rate: f64) -> (WalkPlan, Motion) {
    let plan = walk(figure, request).expect("a walk that is not refused");
    let motion = loaded(figure, &plan, rate).expect("a walk with forces");
    (plan, motion)
}

fn loaded(figure: &Figure, plan: &WalkPlan, rate: f64) -> Result<Motion, String> {
    let mut motion = plan.motion(figure, rate).map_err(|error| error.to_string())?;
    ground_reactions(figure, &mut motion, FEET, plan).map_err(|error| error.to_string())?;
    Ok(motion)
}

impl Case {
    fn outcome(&self) -> Outcome {
        let run = || match walk(&self.figure, &self.request) {
            Err(error) => Outcome::Refused(error),
            Ok(plan) => match loaded(&self.figure, &plan, RATE) {
                Err(error) => Outcome::Failed(error),
                Ok(motion) => Outcome::Walked(judge(&self.figure, &plan, &motion)),
            },
        };
        catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|_| Outcome::Failed("panics".to_owned()))
    }
}

/// Runs all cases; outcomes are in their order.
pub(crate) fn run(cases: &[Case]) -> Vec<Outcome> {
    cases.par_iter().map(Case::outcome).collect()
}

/// Runs all cases, none of which may be refused, and asserts that the criteria hold.
pub(crate) fn assert_all_walk(title: &str, cases: &[Case]) {
    let mut worst = Worst::default();
    let mut failed = Vec::new();
    for (case, outcome) in cases.iter().zip(run(cases)) {
        match outcome {
            Outcome::Walked(found) => worst.merge(&case.name, &found),
            Outcome::Refused(error) => failed.push(format!("{}: refused: {error}", case.name)),
            Outcome::Failed(what) => failed.push(format!("{}: {what}", case.name)),
        }
    }
    worst.show(title);
    assert!(
        failed.is_empty() && worst.broken().is_empty(),
        "{title}\n{}\n{}",
        failed.join("\n"),
        worst.broken()
    );
}
