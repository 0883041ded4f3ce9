//! Limbs that go into each other are told.

use super::{solaris, succeeded};
use serde_json::Value;
use std::path::Path;

/// The numbers of a walk.
fn report(args: &[&str]) -> Value {
    let all: Vec<&str> = ["walk", "--rate", "30", "--json"].iter().chain(args).copied().collect();
    serde_json::from_str(&succeeded(&solaris(Path::new("."), &all))).expect("JSON")
}

fn told(report: &Value) -> Vec<&str> {
    let notes = report["notes"].as_array().expect("a list").iter().filter_map(Value::as_str);
    notes.filter(|note| note.starts_with("limbs go into each other")).collect()
}

#[test]
fn a_walk_whose_limbs_overlap_says_which_how_deep_when_and_how_long() {
    let sharp = report(&["--turn", "30", "--first", "right", "--step-width", "0.06", "--steps", "3"]);
    let overlap = &sharp["whole_walk"]["nearest_limbs"]["overlaps"][0];
    assert_eq!(overlap["links"], serde_json::json!(["left_thigh", "right_thigh"]));
    let number = |key: &str| overlap[key].as_f64().expect(key);
    let (depth, at, lasts) = (number("depth_m"), number("at_s"), number("lasts_s"));
    assert!(depth > 0.01 && lasts > 0.0, "{overlap}");
    let [note] = told(&sharp)[..] else { panic!("{}", sharp["notes"]) };
    let says =
        format!("left_thigh and right_thigh by {:.0} mm at {at:.2} s, {lasts:.2} s in all", 1e3 * depth);
    assert!(note.contains(&says), "{note}: {says}");

    let straight = report(&["--steps", "3"]);
    assert_eq!(straight["whole_walk"]["nearest_limbs"]["overlaps"], serde_json::json!([]));
    assert!(told(&straight).is_empty());
}
