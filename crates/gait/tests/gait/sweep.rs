//! One walk as a row of numbers.

use solaris_analysis::ground_reactions;
use solaris_gait::sweep::{COLUMNS, Walked, metrics_of};
use solaris_gait::{Extent, FEET, GaitError, RequestError, StyledRequest, WalkRequest, measure, walk};
use solaris_model::human;
use std::collections::BTreeSet;

fn steps(steps: usize) -> WalkRequest {
    WalkRequest { extent: Extent::Steps(steps), ..WalkRequest::default() }
}

fn smooth(request: WalkRequest) -> StyledRequest {
    StyledRequest::Smooth(request)
}

fn value(row: &[Option<f64>], heading: &str) -> Option<f64> {
    row[COLUMNS.iter().position(|column| column.heading == heading).expect(heading)]
}

#[test]
fn a_row_has_the_numbers_of_the_walk() {
    let ann = human(1.65, 58.0).expect("a person");
    let plan = walk(&ann, &steps(8)).expect("a walk");
    let mut motion = plan.motion(&ann, 120.0).expect("frames");
    ground_reactions(&ann, &mut motion, FEET, &plan).expect("forces");
    let measures = measure(&ann, &motion).expect("measures");
    let row = metrics_of(&ann, &smooth(steps(8)), 120.0).expect("a row");
    let bits = |value: Option<f64>| value.map(f64::to_bits);
    for (heading, wanted) in [
        ("walked_steps", 8.0),
        ("distance_m", measures.distance),
        ("vertical_peak_percent_bw", measures.extremes.vertical.value),
        ("friction", measures.extremes.friction.value),
        ("sink_mm", 1e3 * measures.extremes.sink.value),
        ("com_rise_cm", measures.steady.as_ref().expect("steady").com_vertical),
        ("ankle_plantarflexor_n_m_kg", measures.joints[2].extension.value),
    ] {
        assert_eq!(bits(value(&row, heading)), bits(Some(wanted)), "{heading}");
    }
    let sum = |of: fn(&Walked) -> f64| of(&Walked::of(&ann, &smooth(steps(8)), 120.0).expect("walked"));
    // docs/walking.md has 15 N m in a steady stride and 30 at the end for a larger person.
    let free = sum(|walked| walked.free_moment.value);
    assert!((10.0..40.0).contains(&free), "{free} N m");
}

#[test]
fn short_walks_have_no_steady_stride() {
    let ann = human(1.65, 58.0).expect("a person");
    for count in [1, 2, 3, 8] {
        let row = metrics_of(&ann, &smooth(steps(count)), 60.0).expect("a row");
        let empty: Vec<&str> = COLUMNS
            .iter()
            .zip(&row)
            .filter(|(_, value)| value.is_none())
            .map(|(column, _)| column.heading)
            .collect();
        assert_eq!(empty.is_empty(), count == 8, "{count} steps: {empty:?}");
        assert!(value(&row, "double_support_percent").is_some(), "{count} steps");
    }
}

#[test]
fn headings_are_different_and_explained() {
    let headings: BTreeSet<&str> = COLUMNS.iter().map(|column| column.heading).collect();
    assert_eq!(headings.len(), COLUMNS.len());
    assert!(COLUMNS.iter().all(|column| !column.help.is_empty()));
}

#[test]
fn what_cannot_be_done_says_why() {
    let ann = human(1.65, 58.0).expect("a person");
    let fast = WalkRequest { speed: Some(2.9), ..steps(3) };
    assert!(matches!(
        metrics_of(&ann, &smooth(fast), 60.0),
        Err(GaitError::Request(RequestError::Range { .. } | RequestError::StepLength { .. }))
    ));
    assert!(matches!(metrics_of(&ann, &smooth(steps(3)), 0.0), Err(GaitError::Reaction(_))));
    let said = metrics_of(&ann, &smooth(steps(300)), 1000.0).expect_err("too long").to_string();
    assert!(said.contains("more than 150000"), "{said}");
}
