//! Populations, manners and variability as options of a walk.

use crate::walk::{refused, solaris, succeeded};
use serde_json::Value;
use std::fs;
use std::path::Path;

fn walked(folder: &Path, options: &[&str]) -> Value {
    let all = [&["walk", "--steps", "3", "--json"], options].concat();
    serde_json::from_str(&succeeded(&solaris(folder, &all))).expect("JSON")
}

#[test]
fn manners_add_up_and_files_are_manners() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path();
    let plain = walked(path, &[]);
    let sad = walked(path, &["--manner", "sad"]);
    let pace = |walk: &Value| walk["walk"]["step_frequency_per_min"].as_f64().expect("a number");
    assert!((pace(&plain) - 110.0).abs() < 1e-9 && (pace(&sad) - 110.0 * 0.86).abs() < 1e-9);
    fs::write(path.join("my.ron"), "Manner(cadence: Times(0.86))").expect("written");
    assert!((pace(&walked(path, &["--style-file", "my.ron"])) - 110.0 * 0.86).abs() < 1e-9);
    let both = walked(path, &["--manner", "sad:0.5", "--manner", "sad:0.25,sad:0.25"]);
    assert!((pace(&both) - pace(&sad)).abs() < 1e-9);
    // A pace that is asked for stays, and what does not hold is walked in part.
    let asked = walked(path, &["--manner", "sad", "--cadence", "100"]);
    assert!((pace(&asked) - 100.0).abs() < 1e-12);
    fs::write(path.join("wild.ron"), "Manner(arm_swing: Times(3))").expect("written");
    let wild = walked(path, &["--style-file", "wild.ron"])["notes"].to_string();
    assert!(wild.contains("% of the manner and of the variability are walked"), "{wild}");
}

#[test]
fn a_seed_is_a_walk_and_a_limp_is_no_other_speed() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path();
    let [a, b, c] =
        ["3", "3", "4"].map(|seed| walked(path, &["--variability", "--seed", seed])["whole_walk"].clone());
    assert!(a == b && a != c);
    let speed = |walk: &Value| walk["walk"]["speed_m_s"].as_f64().expect("a number");
    let (even, limp) = (walked(path, &[]), walked(path, &["--left", "limp"]));
    assert!((speed(&even) - speed(&limp)).abs() < 1e-12 && even["whole_walk"] != limp["whole_walk"]);
}

#[test]
fn what_is_wrong_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path();
    let said = |options: &[&str]| refused(&solaris(path, &[&["walk"], options].concat()));
    for (options, why) in [
        (&["--manner", "hapy"][..], "did you mean 'happy'?"),
        (&["--manner", "sad:7"], "it must be a number from 0 to 2"),
        (&["--right", "lmp"], "did you mean 'limp'?"),
        (&["--seed", "3"], "add it"),
        (&["--variability", "5"], "it must be 0 to 2"),
        (&["--variability", "--loop", "in-place"], "leave out --loop"),
        (&["--manner", "sad", "--gait", "run"], "a run has no such option"),
        (&["--manner", "sad", "--style", "thesis"], "only --style smooth has this"),
    ] {
        let text = said(options);
        assert!(text.contains(why), "{options:?}: {text}");
    }
    fs::write(path.join("my.ron"), "Manner(\n    arm_swng: Times(0.5),\n)\n").expect("written");
    let text = said(&["--style-file", "my.ron"]);
    assert!(text.contains("did you mean 'arm_swing'?") && text.contains("my.ron:2:5"), "{text}");
}
