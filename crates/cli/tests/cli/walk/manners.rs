//! Standard output and standard error.

use crate::walk::{command, names, read, refused, solaris, succeeded};
use serde_json::Value;
use std::fs::{self, OpenOptions};
use std::io::Read;
use std::process::Stdio;

#[test]
fn json_is_the_report() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = solaris(folder.path(), &["walk", "--steps", "10", "--json", "--report", "walk.json"]);
    let printed = succeeded(&output);
    assert_eq!(printed, read(&folder.path().join("walk.json")));
    let value: Value = serde_json::from_str(&printed).expect("JSON");
    let number = |pointer: &str| value.pointer(pointer).and_then(Value::as_f64).expect(pointer);
    assert!((number("/walk/steps") - 10.0).abs() < 1e-9);
    assert!((number("/steady_stride/cadence_per_min") - 110.0).abs() < 0.5);
    assert!((number("/bands/0/of") - 22.0).abs() < 1e-9 && (number("/bands/1/of") - 21.0).abs() < 1e-9);
    let mass = number("/person/mass_kg");
    assert!((mass - 23.8 * 1.75 * 1.75).abs() < 1e-9, "{mass} kg");
}

#[test]
fn what_hands_carry_is_not_the_persons_mass() {
    let folder = tempfile::tempdir().expect("a folder");
    let loaded = ["walk", "--mass", "73", "--load", "right=6", "--load", "left=1.5", "--steps", "3"];
    let printed = succeeded(&solaris(folder.path(), &loaded));
    assert!(
        printed.starts_with("A person of 1.75 m and 73 kg with 7.5 kg in hand walks 3 steps"),
        "{printed}"
    );
    let json = succeeded(&solaris(folder.path(), &[&loaded[..], &["--json"]].concat()));
    let value: Value = serde_json::from_str(&json).expect("JSON");
    let number = |pointer: &str| value.pointer(pointer).and_then(Value::as_f64).expect(pointer);
    assert!(
        (number("/person/mass_kg") - 73.0).abs() < 1e-9 && (number("/person/carried_kg") - 7.5).abs() < 1e-9
    );
}

#[test]
fn whose_figure_is_given_has_no_load_and_no_age_beside_it() {
    let folder = tempfile::tempdir().expect("a folder");
    for option in [["--load", "left=3"], ["--age", "9"]] {
        let output = solaris(folder.path(), &[&["walk", "--figure", "ann.ron"][..], &option].concat());
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && said.contains("cannot be used with"), "{said}");
    }
}

/// Less than a foot needs to clear the ground is not walked in silence.
#[test]
fn a_knee_that_bends_more_than_asked_for_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let notes = |knee: &str, cadence: &str| {
        let words = ["walk", "--steps", "8", "--swing-knee", knee, "--step-frequency", cadence];
        let printed = succeeded(&solaris(folder.path(), &words));
        let said = printed.lines().find_map(|line| line.strip_prefix("note: the swinging knee bends to "));
        said.map(str::to_owned)
    };
    for cadence in ["70", "110", "125"] {
        let said = notes("55", cadence).expect("a note");
        assert!(said.starts_with('6') && said.contains("°, not to the 55° asked for"), "{said}");
        assert_eq!(notes("70", cadence), None);
    }
}

/// A block that is shorter than a sole stands where the last foot would.
#[test]
fn a_walk_that_ends_elsewhere_says_so() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("block.csv"), "z,height\n3.9,0\n3.9,0.1\n4.12,0.1\n4.12,0\n")
        .expect("written");
    let printed = |distance: &str| {
        succeeded(&solaris(folder.path(), &["walk", "--ground", "block.csv", "--distance", distance]))
    };
    let beside = printed("3.9");
    assert!(beside.contains("note: it goes 3.56 m, not the 3.9 m asked for"), "{beside}");
    let there = printed("3.5");
    assert!(!there.contains("asked for"), "{there}");
}

#[test]
fn no_number_of_the_report_is_missing() {
    // JSON has no infinity and no NaN: they would stand there as null.
    let folder = tempfile::tempdir().expect("a folder");
    for steps in ["1", "2", "3", "10"] {
        let printed = succeeded(&solaris(folder.path(), &["walk", "--steps", steps, "--json"]));
        let value: Value = serde_json::from_str(&printed).expect("JSON");
        let whole = value.get("whole_walk").expect("there").to_string();
        assert!(!whole.contains("null"), "{steps} steps: {whole}");
    }
}

#[test]
fn what_is_printed_agrees_with_the_report() {
    let folder = tempfile::tempdir().expect("a folder");
    let table = succeeded(&solaris(folder.path(), &["walk", "--report", "walk.json"]));
    let value: Value = serde_json::from_str(&read(&folder.path().join("walk.json"))).expect("JSON");
    let line = |label: &str| {
        let line = table.lines().find(|line| line.trim_start().starts_with(label)).expect(label);
        line.trim_start()[label.len()..].split_whitespace().next().expect("a value").to_owned()
    };
    let number = |pointer: &str| value.pointer(pointer).and_then(Value::as_f64).expect(pointer);
    assert_eq!(line("step length"), format!("{:.3}", number("/walk/step_length_m")));
    assert_eq!(
        line("vertical force, peak"),
        format!("{:.1}", number("/whole_walk/vertical_percent_bw/value"))
    );
    for list in value["bands"].as_array().expect("lists") {
        let inside = format!(
            "{} of {} inside ({})",
            list["inside"],
            list["of"],
            list["source"].as_str().expect("text")
        );
        assert!(table.contains(&inside), "{inside}");
    }
    // Every name of both lists stands in the table.
    for check in value["bands"]
        .as_array()
        .expect("lists")
        .iter()
        .filter_map(|list| list["checks"].as_array())
        .flatten()
    {
        assert!(table.contains(check["name"].as_str().expect("a name")), "{check}");
    }
    assert!(table.lines().all(|line| line.chars().count() <= 110), "{table}");
}

#[test]
fn every_example_of_the_help_runs() {
    let folder = tempfile::tempdir().expect("a folder");
    let help =
        [&["--help"] as &[&str], &["walk", "--help"]].map(|args| succeeded(&solaris(folder.path(), args)));
    let examples: Vec<&str> = help
        .iter()
        .flat_map(|help| help.lines())
        .filter_map(|line| line.strip_prefix("  solaris "))
        // The others need files of their own.
        .filter(|example| example.starts_with("walk "))
        .collect();
    assert!(examples.len() >= 4, "{examples:?}");
    fs::write(folder.path().join("way.csv"), "x,z\n0,3\n2,3\n").expect("written");
    for example in examples {
        succeeded(&solaris(folder.path(), &example.split(' ').collect::<Vec<_>>()));
    }
    let written = [
        "about.html",
        "back.html",
        "child.csv",
        "child.html",
        "corner.html",
        "loop.glb",
        "run.html",
        "sad.html",
        "start.html",
        "stiff.bvh",
        "stiff.json",
        "strip.svg",
        "thesis.html",
        "walk.html",
        "way.csv",
        "way.html",
    ];
    assert_eq!(names(folder.path()), written);
}

#[test]
fn every_example_of_gaits_help_runs() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut run = 0;
    for command in ["table", "map", "explain"] {
        let [all, own] = [&["gait", "--help"] as &[&str], &["gait", command, "--help"]]
            .map(|args| succeeded(&solaris(folder.path(), args)));
        let example = format!("  solaris gait {command}");
        let lines = all.lines().chain(own.lines()).filter(|line| line.starts_with(&example));
        for line in lines.map(|line| line.trim_start_matches("  solaris ")) {
            let output = solaris(folder.path(), &line.split(' ').collect::<Vec<_>>());
            // One of them shows a refusal.
            if line.ends_with("--heel-strike-angle 32") {
                refused(&output);
            } else {
                succeeded(&output);
            }
            run += 1;
        }
    }
    assert_eq!(run, 9);
    assert_eq!(names(folder.path()), ["map.html", "map.svg", "postures.svg"]);
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let folder = tempfile::tempdir().expect("a folder");
    for args in [&["walk"] as &[&str], &["walk", "--json"], &["walk", "--help"]] {
        let mut child = command(folder.path(), args)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        // Closed before anything is printed: the walk takes longer than this.
        drop(child.stdout.take());
        let mut said = String::new();
        child.stderr.take().expect("piped").read_to_string(&mut said).expect("UTF-8");
        let status = child.wait().expect("it ends");
        assert_eq!((status.code(), said.as_str()), (Some(0), ""), "{args:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn an_output_that_is_full_is_an_error_and_no_panic() {
    let full = || Stdio::from(OpenOptions::new().write(true).open("/dev/full").expect("Linux has it"));
    let folder = tempfile::tempdir().expect("a folder");
    let run = |args: &[&str]| command(folder.path(), args);
    let printed =
        run(&["walk", "--steps", "1"]).stdout(full()).stderr(Stdio::piped()).output().expect("starts");
    let said = refused(&printed);
    assert!(said.starts_with("error: standard output: "), "{said}");
    let silent = run(&["walk", "--height", "17"]).stderr(full()).output().expect("starts");
    assert_eq!(silent.status.code(), Some(1), "the message is lost, the exit code is not");
}

#[test]
fn more_frames_than_memory_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let args = ["walk", "--steps", "2800", "--rate", "1000", "-o", "long.csv"];
    let said = refused(&solaris(folder.path(), &args));
    assert!(said.contains("lower --rate") && said.contains("1500000"), "{said}");
    assert!(names(folder.path()).is_empty());
}
