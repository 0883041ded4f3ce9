//! What cannot be walked in the thesis's style, and what is said of it.

use solaris_gait::determinants::Determinants;
use solaris_gait::{Extent, GaitError, LegGeometry, ThesisRequest, thesis_walk};
use solaris_model::human;

#[test]
fn what_cannot_be_walked_is_refused_with_what_could_be() {
    let figure = human(1.75, 73.0).expect("a person");
    let refused = |request: ThesisRequest| match thesis_walk(&figure, &request) {
        Err(error) => error,
        Ok(_) => panic!("it was walked: {request:?}"),
    };
    let with = |name, value| ThesisRequest { parameters: vec![(name, value)], ..ThesisRequest::default() };
    let GaitError::Infeasible { why, .. } = refused(with("heel-strike-angle", 32.0)) else {
        panic!("another error")
    };
    let nearest = why.nearest.iter().find(|n| n.parameter.name == "heel-strike-angle").expect("its own");
    let better = nearest.feasible.expect("a feasible angle");
    assert!(thesis_walk(&figure, &with("heel-strike-angle", better)).is_ok());
    assert!(thesis_walk(&figure, &with("heel-strike-angle", better + 0.01)).is_err());
    for (request, says) in [
        (with("flexion", 12.0), "flexion"),
        (with("heel-strike-angle", f64::NAN), "heel-strike-angle"),
        (ThesisRequest { step_frequency: Some(500.0), ..ThesisRequest::default() }, "step frequency"),
        (ThesisRequest { step_length: Some(1.6), ..ThesisRequest::default() }, "step"),
        (ThesisRequest { extent: Extent::Steps(0), ..ThesisRequest::default() }, "steps"),
        (ThesisRequest { extent: Extent::Distance(f64::NAN), ..ThesisRequest::default() }, "distance"),
        (ThesisRequest { sway: f64::NAN, ..ThesisRequest::default() }, "sway"),
        (ThesisRequest { step_width: Some(-1.0), ..ThesisRequest::default() }, "step width"),
        (
            ThesisRequest { sway: 0.5, ..ThesisRequest::default() },
            "sway 0.5 m: it must be 0 to 0.215 m; farther",
        ),
        (
            ThesisRequest { step_width: Some(3.0), ..ThesisRequest::default() },
            "step width 3 m: it must be 0 to",
        ),
    ] {
        let error = refused(request).to_string();
        assert!(error.contains(says), "{error}");
    }
}

/// A straight leg of length l carries a body over it as long as v²/l is no more than g.
#[test]
fn nobody_walks_faster_than_a_straight_leg_carries() {
    for height in [1.2, 1.75, 2.0] {
        let figure = human(height, 23.8 * height * height).expect("a person");
        let at = |step_frequency: f64| {
            let request = ThesisRequest {
                determinants: Determinants::Three,
                step_frequency: Some(step_frequency),
                extent: Extent::Steps(2),
                ..ThesisRequest::default()
            };
            thesis_walk(&figure, &request)
        };
        let leg = LegGeometry::of(&figure).expect("a leg").length();
        // v = 0.004·H·sf²/60.
        let fastest = (60.0 * (9.806_65 * leg).sqrt() / (0.004 * height)).sqrt();
        assert!(at(fastest - 0.01).is_ok());
        let Err(GaitError::Range { parameter: "speed", value, upper, .. }) = at(fastest + 0.01) else {
            panic!("{height} m: {fastest} steps/min is too fast")
        };
        assert!(value > upper && (value * value / (9.806_65 * leg) - 1.0).abs() < 1e-3);
    }
}
