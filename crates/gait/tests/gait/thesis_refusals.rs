//! What cannot be walked in the thesis's style, and what is said of it.

use solaris_gait::determinants::{Determinants, Proportions};
use solaris_gait::{
    Extent, GaitError, KeyChoice, LegGeometry, PostureError, RequestError, ThesisRequest, thesis_walk,
};
use solaris_model::human;

#[test]
fn what_cannot_be_walked_is_refused_with_what_could_be() {
    let figure = human(1.75, 73.0).expect("a person");
    let refused = |request: ThesisRequest| match thesis_walk(&figure, &request) {
        Err(error) => error,
        Ok(_) => panic!("it was walked: {request:?}"),
    };
    let with = |name, value| ThesisRequest { parameters: vec![(name, value)], ..ThesisRequest::default() };
    let GaitError::Posture(PostureError::Infeasible { why, .. }) = refused(with("heel-strike-angle", 32.0))
    else {
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
        let Err(GaitError::Request(RequestError::Range { parameter: "speed", value, upper, .. })) =
            at(fastest + 0.01)
        else {
            panic!("{height} m: {fastest} steps/min is too fast")
        };
        assert!(value > upper && (value * value / (9.806_65 * leg) - 1.0).abs() < 1e-3);
    }
}

/// A speed is looked at or not by its Froude number, whoever walks and whatever lengths are in.
#[test]
fn speeds_of_one_froude_number_are_answered_alike() {
    // 0.00175 to 5.25 m/s at 1.75 m.
    let limits = [1.75e-3, 5.25].map(|speed| speed / (9.806_65_f64 * 1.75).sqrt());
    let refused = |p: &Proportions, part: f64| {
        let speed = part * (9.806_65 * p.height * p.unit).sqrt() / p.unit;
        let request = ThesisRequest { speed: Some(speed), ..ThesisRequest::default() };
        matches!(
            KeyChoice::of(p, &request),
            Err(GaitError::Request(RequestError::Range { parameter: "speed", .. }))
        )
    };
    let people = [1.2, 1.75, 2.0].map(Proportions::drillis_contini);
    for p in people.iter().chain([&Proportions::FIT]) {
        let [lower, upper] = limits;
        for (part, outside) in [
            (0.999 * lower, true),
            (1.001 * lower, false),
            (0.3, false),
            (0.999 * upper, false),
            (1.001 * upper, true),
            (f64::NAN, true),
        ] {
            assert_eq!(
                refused(p, part),
                outside,
                "{part} √(g·H) at a height of {} times {} m",
                p.height,
                p.unit
            );
        }
    }
    // The range is said in few digits.
    let at = |speed| {
        let request = ThesisRequest { speed: Some(speed), ..ThesisRequest::default() };
        KeyChoice::of(&Proportions::drillis_contini(1.2), &request).expect_err("too fast").to_string()
    };
    assert_eq!(at(5.0), "speed 5 m/s: it must be 0.0014 to 4.3474 m/s");
}
