//! The stance leg's flexion as an input of a smooth walk, as it is one of three determinants.

use solaris_analysis::ground_reactions;
use solaris_gait::determinants::Determinants;
use solaris_gait::{FEET, WalkPlan, WalkRequest, measure, walk};
use solaris_model::{Figure, human};

fn planned(figure: &Figure, step_frequency: f64, parameters: &[(&'static str, f64)]) -> WalkPlan {
    let parameters = parameters.to_vec();
    let request = WalkRequest { step_frequency: Some(step_frequency), parameters, ..WalkRequest::default() };
    walk(figure, &request).expect("it can be walked")
}

/// Pitch of the standing shank in mid-walk when the hip is above its ankle (°): the posture that three determinants call lift-off.
fn shank(plan: &WalkPlan) -> f64 {
    let beside = plan.compare_postures(Determinants::Three).expect("postures of this step");
    let passing = beside.iter().find(|beside| beside.name == "lift-off").expect("a lift-off");
    passing.walk[0].shank.to_degrees()
}

#[test]
fn the_shank_passes_with_the_pitch_that_is_asked() {
    for (height, mass) in [(1.75, 73.0), (1.5, 50.0)] {
        let figure = human(height, mass).expect("a person");
        for step_frequency in [80.0, 95.0, 110.0, 118.0] {
            for flexion in [9.0, 12.0] {
                let plan = planned(&figure, step_frequency, &[("flexion", flexion)]);
                let off = (shank(&plan) - flexion).abs();
                assert!(off < 0.02, "{height} m, {step_frequency}/min, {flexion}°: off by {off}°");
            }
        }
    }
}

#[test]
fn less_than_the_walk_has_anyway_changes_little() {
    let figure = human(1.75, 73.0).expect("a person");
    let (plain, asked) = (planned(&figure, 110.0, &[]), planned(&figure, 110.0, &[("flexion", 2.0)]));
    let [plain, asked] = [shank(&plain), shank(&asked)];
    assert!(plain > 4.0 && (asked - plain).abs() < 0.3, "{plain}° and {asked}°");
}

#[test]
fn a_flexed_walk_obeys_the_laws() {
    let figure = human(1.75, 73.0).expect("a person");
    for step_frequency in [80.0, 110.0] {
        // Three determinants: no pelvic rotation, a tilt and a flexion of one's own. At 80 steps/min 11.2° are the most.
        let plan = planned(&figure, step_frequency, &[("flexion", 11.0), ("rotation", 0.0), ("tilt", 5.0)]);
        let mut motion = plan.motion(&figure, 120.0).expect("sampled");
        let report = ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
        assert!(report.from_prescribed.expect("prescribed").value < 0.05 * plan.weight());
        let walked = measure(&figure, &motion).expect("measured");
        assert!(walked.extremes.slide.value < 1e-9 && walked.extremes.sink.value < 1e-4);
        // The last landing, on a leg that is still bent.
        let outside = walked.extremes.cop_outside;
        assert!(
            outside.value <= 5e-3,
            "{step_frequency}/min: {outside:?}, clock {}",
            plan.clock_at(outside.time)
        );
        assert!(walked.extremes.clearance.value > 0.01);
        assert!(walked.extremes.friction.value < 0.4 && walked.extremes.least_knee.value > 0.0);
        // The stance knee bends by more than twice the shank's pitch, for the thigh leans the other way.
        let steady = walked.steady.expect("a steady stride");
        assert!(steady.knee_loading > 24.0, "{}", steady.knee_loading);
    }
}
