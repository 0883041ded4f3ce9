//! `solaris metrics` from outside: a walk of ours, the subject, the measured walk.

use crate::inverse::{
    data, folder_with, json, names, number, read, refused, solaris, solaris_with, subject, succeeded,
};
use serde_json::Value;
use solaris::io::csv::read_rows;

/// A metric by its key.
fn metric(report: &Value, key: &str) -> Value {
    let all = report["metrics"].as_array().expect("a list");
    all.iter().find(|metric| metric["metric"] == key).expect(key).clone()
}

fn value(report: &Value, key: &str) -> f64 {
    let metric = metric(report, key);
    metric["value"].as_f64().unwrap_or_else(|| panic!("{metric}"))
}

#[test]
fn a_walk_in_a_file_has_the_numbers_of_its_report() {
    let folder = folder_with(&[]);
    let own = json(&succeeded(&solaris(folder.path(), "walk --steps 10 -o walk.csv --json")));
    let found = json(&succeeded(&solaris(folder.path(), "metrics walk.csv --json")));
    for (key, pointer, factor, within) in [
        ("slide_greatest_mm", "/whole_walk/slide_m/value", 1e3, 0.1),
        ("sink_mm", "/whole_walk/sink_m/value", 1e3, 1e-9),
        // Mid-swing begins a frame earlier where contacts are found in frames, and the tip rises there.
        ("clearance_mm", "/whole_walk/toe_clearance_m/value", 1e3, 0.8),
        ("step_length_m", "/steady_stride/step_length_m", 1.0, 5e-3),
        ("speed_m_s", "/steady_stride/speed_m_s", 1.0, 5e-3),
        ("double_support_percent", "/steady_stride/double_support_percent", 1.0, 1.6),
        ("stance_percent", "/steady_stride/stance_percent", 1.0, 1.6),
    ] {
        let wanted = factor * number(&own, pointer);
        let found = value(&found, key);
        assert!((found - wanted).abs() <= within, "{key}: {found} is not {wanted}");
    }
    assert_eq!(found["forces_from"], "of the motion's file");
    // From positions alone, without the forces of the file.
    let alone = json(&succeeded(&solaris(folder.path(), "metrics walk.csv --stances feet --ground --json")));
    assert!((value(&alone, "step_length_m") - value(&found, "step_length_m")).abs() < 0.02);
    let off = value(&alone, "vertical_first_percent_bw") - value(&found, "vertical_first_percent_bw");
    assert!(off.abs() < 10.0, "{off} %BW");
}

#[test]
fn files_hold_what_is_printed() {
    let folder = folder_with(&[]);
    succeeded(&solaris(folder.path(), "walk --steps 3 -o walk.csv"));
    let printed = succeeded(&solaris(folder.path(), "metrics walk.csv --json -o m.json -o m.csv"));
    assert_eq!(printed, read(&folder.path().join("m.json")));
    let (report, table) = (json(&printed), read_rows(&read(&folder.path().join("m.csv"))).expect("a table"));
    assert_eq!(table.columns, ["metric", "value", "unit", "at_s", "why"]);
    let all = report["metrics"].as_array().expect("a list");
    assert_eq!(all.len(), table.rows.len());
    for (one, row) in all.iter().zip(&table.rows) {
        assert_eq!(one["metric"], row.fields[0]);
        assert_eq!(one["value"].as_f64(), row.fields[1].parse().ok(), "{one}");
        // A number or a reason, never both, never neither.
        assert!(one["value"].is_null() != one["why"].is_null(), "{one}");
    }
}

#[test]
fn what_is_asked_in_vain_is_refused() {
    let folder = subject();
    for (line, why) in [
        (
            "metrics walk.mot --figure subject.osim --soles soles.ron --stances contacts",
            "no forces on its soles (right.fx",
        ),
        ("metrics walk.mot --figure subject.osim --ground", "has no soles"),
        ("metrics walk.mot --figure subject.osim --soles soles.ron --stance-height 0", "--stance-height 0"),
        ("metrics walk.mot", "walk.mot"),
        ("metrics none.csv", "there is no such file"),
        ("metrics walk.mot --figure subject.osim -o soles.ron", ".json or .csv"),
    ] {
        let said = refused(&solaris(folder.path(), line));
        assert!(said.contains(why), "{line}: {said}");
    }
    assert_eq!(names(folder.path()), ["grf.mot", "loads.xml", "soles.ron", "subject.osim", "walk.mot"]);
}

#[test]
fn a_measured_walk_has_metrics() {
    let files = ["gait10dof18musc_subject01.osim", "subject01_walk_ik_planar10.mot"];
    let [Some(model), Some(motion)] = files.map(|name| data(&format!("subject01_walk/{name}"))) else {
        return;
    };
    let folder = folder_with(&[]);
    let [model, motion] = [&model, &motion].map(|path| path.to_str().expect("UTF-8"));
    let args = ["metrics", motion, "--figure", model, "--filter", "6Hz", "--ground", "--json"];
    let report = json(&succeeded(&solaris_with(folder.path(), &args)));
    // On a treadmill, at a speed that is found.
    assert!((1.0..2.0).contains(&value(&report, "speed_m_s")), "{}", report["metrics"]);
    assert!((80.0..130.0).contains(&value(&report, "step_frequency_per_min")));
    assert!((55.0..75.0).contains(&value(&report, "stance_percent")));
    assert!((2.0..8.0).contains(&value(&report, "bob_cm")));
    assert!((90.0..150.0).contains(&value(&report, "vertical_first_percent_bw")));
    assert!(value(&report, "spectral_arc_length") < -1.0);
}
