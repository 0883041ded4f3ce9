//! Reports of walks as JSON: the keys carry the units, the values are the fields'.

use serde_json::{Value, json};
use solaris_analysis::PreparedMotion;
use solaris_gait::determinants::Determinants;
use solaris_gait::metrics::{MetricsInput, metrics};
use solaris_gait::{
    Extent, StyledPlan, StyledRequest, ThesisRequest, WalkForces, WalkRequest, band_reports, measure,
};
use solaris_model::human;

/// The keys of an object, sorted.
fn keys(value: &Value) -> Vec<&str> {
    let mut keys: Vec<&str> = value.as_object().expect("an object").keys().map(String::as_str).collect();
    keys.sort_unstable();
    keys
}

const FORCES: [&str; 5] = [
    "cop_from_prescribed_m",
    "double_support_split",
    "from_prescribed_n",
    "root_residual_n",
    "root_residual_n_m",
];

#[test]
fn a_smooth_walk_is_written_with_units_in_its_keys() {
    let figure = human(1.75, 73.0).expect("a person");
    let request = WalkRequest { extent: Extent::Steps(8), ..WalkRequest::default() };
    let plan = StyledPlan::of(&figure, &StyledRequest::Smooth(request)).expect("a plan");
    let (motion, forces) = plan.loaded(&figure, 120.0).expect("forces");
    let written = serde_json::to_value(&forces).expect("written");
    assert_eq!(keys(&written), FORCES);
    let WalkForces::Prescribed(report) = &forces else { panic!("{forces:?}") };
    assert_eq!(written, serde_json::to_value(report).expect("written"), "the same keys in either case");
    let off = report.from_prescribed.expect("prescribed");
    assert_eq!(written["from_prescribed_n"], json!({"value": off.value, "at_s": off.time}));

    let measures = measure(&figure, &motion).expect("measures");
    let written = serde_json::to_value(&measures).expect("written");
    assert_eq!(
        keys(&written),
        [
            "braking_percent_bw",
            "cop_outside_m",
            "distance_m",
            "double_supports_percent",
            "duration_s",
            "foot_friction",
            "friction",
            "joints",
            "least_knee_deg",
            "pushing_percent_bw",
            "sink_m",
            "slide_m",
            "steady_stride",
            "steps",
            "toe_clearance_m",
            "vertical_percent_bw"
        ]
    );
    let knee = measures.extremes.least_knee;
    assert_eq!(written["least_knee_deg"], json!({"value": knee.value.to_degrees(), "at_s": knee.time}));
    let knee = &measures.joints[1];
    assert_eq!(keys(&written["joints"][1]), ["absorbed", "extension", "flexion", "generated", "joint"]);
    assert_eq!(written["joints"][1]["absorbed"]["value"], json!(knee.absorbed.value));

    let stride = measures.steady.expect("eight steps have one");
    // Plates see a foot later and lose it sooner than it touches and lifts.
    assert!(stride.plate_stance > stride.stance - 5.0 && stride.plate_stance < stride.stance);
    let lost = stride.double_support - stride.plate_double_support;
    assert!((0.5..4.0).contains(&lost), "{lost}");
    // Both legs' stances together are the stride and both double supports.
    assert!((2.0 * stride.plate_stance - 100.0 - 2.0 * stride.plate_double_support).abs() < 0.05);
    assert_eq!(
        written["steady_stride"],
        json!({
            "span_s": [stride.span.0, stride.span.1],
            "step_length_m": stride.step_length,
            "speed_m_s": stride.speed,
            "cadence_per_min": stride.cadence,
            "double_support_percent": stride.double_support,
            "stance_percent": stride.stance,
            "plate_double_support_percent": stride.plate_double_support,
            "plate_stance_percent": stride.plate_stance,
            "walk_ratio_m_min": stride.step_length / stride.cadence,
        })
    );
    let recipe = &band_reports(&stride)[0];
    let written = serde_json::to_value(recipe).expect("written");
    assert_eq!((&written["name"], &written["of"]), (&json!("recipe"), &json!(22)));
    assert_eq!(written["inside"], json!(recipe.checks.iter().filter(|check| check.inside).count()));
    let expected = json!({
        "name": "mean vertical force", "unit": "%BW", "value": stride.mean_vertical, "lower": 99.5, "upper": 100.5,
        "inside": recipe.checks[0].inside,
    });
    assert_eq!(written["checks"][0], expected);
}

#[test]
fn a_walk_of_the_thesis_is_written_with_where_the_ground_would_have_to_pull() {
    let figure = human(1.75, 73.0).expect("a person");
    let request = StyledRequest::Thesis(ThesisRequest::default());
    let plan = StyledPlan::of(&figure, &request).expect("a plan");
    let (_, forces) = plan.loaded(&figure, 120.0).expect("forces");
    let written = serde_json::to_value(&forces).expect("written");
    let pull = forces.pull().expect("the body stops at every posture");
    assert!(pull.percent < 0.0 && (0.0..=1.0).contains(&pull.share));
    assert_eq!(keys(&written)[..5], [&FORCES[..3], &["pulls", "root_residual_n"]].concat());
    assert_eq!(written["from_prescribed_n"], Value::Null);
    let expected =
        json!({"least_percent_bw": pull.percent, "at_s": pull.time, "share_of_stance": pull.share});
    assert_eq!(written["pulls"], expected);
}

#[test]
fn postures_are_written_by_how_far_off_they_are_in_degrees() {
    let figure = human(1.75, 73.0).expect("a person");
    let plan = solaris_gait::walk(&figure, &WalkRequest::default()).expect("a plan");
    let postures = plan.compare_postures(Determinants::Five).expect("postures");
    let written = serde_json::to_value(&postures[0]).expect("written");
    let off = postures[0].deviations().map(f64::to_degrees);
    let expected = json!({
        "posture": "heel strike", "at_s": postures[0].time, "stance_deg": off[..3], "swing_deg": off[3..],
    });
    assert_eq!(written, expected);
}

#[test]
fn a_metric_is_written_with_its_value_or_why_there_is_none() {
    let figure = human(1.75, 73.0).expect("a person");
    let plan = solaris_gait::walk(&figure, &WalkRequest::default()).expect("a plan");
    let motion = plan.motion(&figure, 60.0).expect("frames");
    let prepared = PreparedMotion::new(&figure, &motion).expect("ready");
    let given = MetricsInput { motion: &prepared, feet: None, stances: None, contacts: None };
    let all = metrics(&given).expect("measured");
    let of = |key: &str| {
        let metric = all.iter().find(|metric| metric.key == key).expect(key);
        (metric, serde_json::to_value(metric).expect("written"))
    };
    let (metric, written) = of("bob_cm");
    let expected = json!({
        "metric": "bob_cm", "name": metric.name, "value": metric.value.ok(), "unit": "cm", "at_s": metric.at, "why": null,
    });
    assert!(metric.value.is_ok());
    assert_eq!(written, expected);
    let (_, written) = of("step_length_m");
    assert_eq!((&written["value"], &written["why"]), (&Value::Null, &json!("the figure has no feet")));
}
