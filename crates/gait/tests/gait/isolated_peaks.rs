//! Forces that only one sample has: where phases of a walk through key postures change, and nowhere else.

use solaris_gait::determinants::Determinants;
use solaris_gait::{
    InBetween, IsolatedPeak, StyledPlan, StyledRequest, ThesisRequest, WalkRequest, isolated_peaks,
};
use solaris_model::human;

const RATE: f64 = 120.0;

/// Plans a walk and measures it.
fn isolated(request: &StyledRequest) -> (StyledPlan, Vec<IsolatedPeak>) {
    let figure = human(1.75, 73.0).expect("a person");
    let plan = StyledPlan::of(&figure, request).expect("it can be walked");
    let (motion, _) = plan.loaded(&figure, RATE).expect("its forces");
    let isolated = isolated_peaks(&motion).expect("it has forces");
    (plan, isolated)
}

#[test]
fn single_samples_lie_where_postures_change() {
    for determinants in Determinants::ALL {
        for in_between in [InBetween::Rest, InBetween::Linear] {
            for step_frequency in [60.0, 95.0, 110.0] {
                let case = format!("{determinants:?}, {in_between:?}, {step_frequency} steps/min");
                let step_frequency = Some(step_frequency);
                let request =
                    ThesisRequest { determinants, in_between, step_frequency, ..ThesisRequest::default() };
                let (plan, isolated) = isolated(&StyledRequest::Thesis(request));
                let StyledPlan::Thesis(plan) = plan else { panic!("{case}: another style") };
                // It begins to move a quarter of a step after it was told to.
                let changes: Vec<f64> =
                    plan.walk.keys().map(|(time, _)| time).chain([0.25 * plan.walk.step_time()]).collect();
                assert!(!isolated.is_empty(), "{case}: no single sample");
                for IsolatedPeak { direction, peak, neighbour } in isolated {
                    let off = changes.iter().map(|t| (t - peak.time).abs()).fold(f64::INFINITY, f64::min);
                    assert!(
                        off < 1.0 / RATE,
                        "{case}: {direction} at {} s, {off} s from a change",
                        peak.time
                    );
                    assert!(neighbour < 0.5 * peak.value, "{case}: {direction} {peak:?} {neighbour}");
                }
            }
        }
    }
}

#[test]
fn a_smooth_walk_has_no_single_sample() {
    let (_, isolated) = isolated(&StyledRequest::Smooth(WalkRequest::default()));
    assert!(isolated.is_empty(), "{isolated:?}");
}
