//! The table of docs/chair.md is what the program measures.

use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

/// What a row is called, and the options that make it.
const ROWS: [(&str, &[&str]); 8] = [
    ("as usual", &[]),
    ("in 1.4 s", &["--duration", "1.4"]),
    ("in 4 s", &["--duration", "4"]),
    ("from 0.36 m", &["--seat-height", "0.36"]),
    ("from 0.54 m", &["--seat-height", "0.54"]),
    ("from 0.62 m", &["--seat-height", "0.62"]),
    ("shanks at 8°", &["--shank", "8"]),
    ("shanks at 25°", &["--shank", "25"]),
];

/// Rest before the seat is left (s).
const STILL: f64 = 0.4;

fn row(name: &str, options: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_solaris"))
        .args(["chair", "--height", "1.75", "--mass", "73", "--json"])
        .args(options)
        .output()
        .expect("it runs");
    let report: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let number = |value: &Value| value.as_f64().expect("a number");
    let peak = |key: &str| number(&report[key]["value"]);
    let of = |list: &str, joint: &str, key: &str| {
        let all = report[list].as_array().expect("a list");
        let one = all.iter().find(|one| one["joint"].as_str().expect("a name").starts_with(joint));
        one.expect("the joint")[key].clone()
    };
    let [hip, knee, ankle] =
        ["hip", "knee", "ankle"].map(|joint| number(&of("angles", joint, "greatest_deg")));
    let moments = ["hip", "knee", "ankle"]
        .map(|joint| format!("{:.2}", number(&of("joints", joint, "extension")["value"])));
    format!(
        "| {name} | {:.0} % | {:.0}° | {:.0} % | {:.2}, {:.2} m/s | {hip:.0}, {knee:.0}, {ankle:.0}° | {} N m/kg | {:.2} |",
        100.0 * (number(&report["left_s"][0]) - STILL) / number(&report["one_way_s"]),
        number(&report["lean_deg"]),
        peak("feet_percent_bw"),
        peak("along_m_s"),
        peak("vertical_m_s"),
        moments.join(", "),
        peak("contact_friction"),
    )
}

#[test]
fn the_table_of_the_page_is_measured() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/chair.md");
    let page = fs::read_to_string(page).expect("the page");
    for (name, options) in ROWS {
        let row = row(name, options);
        assert!(page.contains(&row), "docs/chair.md has no row\n{row}");
    }
}
