//! What is said of plates and angles that do not fit, on the command line.

use crate::inverse::{
    PLATES, data, failed, json, number, read, solaris, solaris_with, subject, succeeded, write,
};
use serde_json::Value;

/// The kinds of findings of `inverse` with these options, and all that was printed.
fn kinds(report: &Value) -> Vec<String> {
    let findings = report["plausibility"]["findings"].as_array().expect("findings");
    findings.iter().map(|finding| finding["kind"].as_str().expect("a word").to_owned()).collect()
}

const FILTER: &str = "--filter 6Hz --filter-order 3";

#[test]
fn right_plates_are_said_to_fit() {
    let folder = subject();
    for soles in ["", "--soles soles.ron"] {
        let line = format!("inverse subject.osim walk.mot {PLATES} {FILTER} {soles}");
        let printed = succeeded(&solaris(folder.path(), &line));
        assert!(printed.contains("plates            bear 100.") && !printed.contains("Look at"), "{printed}");
        assert!(printed.contains("published thresholds (Hicks and others 2015)"), "{printed}");
        let report = json(&succeeded(&solaris(folder.path(), &format!("{line} --json"))));
        assert_eq!(kinds(&report), [""; 0]);
        let residual = |what: &str| number(&report, &format!("/plausibility/residual/{what}"));
        assert!((residual("force_threshold_n") - 0.05 * residual("greatest_external_n")).abs() < 1e-9);
        let height = residual("com_height_m");
        assert!((0.85..1.1).contains(&height), "{height}");
        let moment = 0.01 * height * residual("greatest_external_n");
        assert!((residual("moment_threshold_nm") - moment).abs() < 1e-9);
    }
}

#[test]
fn swapped_feet_are_said_by_all_commands() {
    let folder = subject();
    let line = format!(
        "inverse subject.osim walk.mot --external grf.mot --plate calcn_l= --plate calcn_r=1 {FILTER}"
    );
    let printed = succeeded(&solaris(folder.path(), &line));
    assert_eq!(printed.matches("the feet are swapped").count(), 2, "{printed}");
    assert_eq!(kinds(&json(&succeeded(&solaris(folder.path(), &format!("{line} --json"))))), ["far"; 2]);
    let ground = "ground subject.osim walk.mot --soles soles.ron --filter 6Hz --against grf.mot";
    let printed = succeeded(&solaris(folder.path(), &format!("{ground} --plate left= --plate right=1_")));
    assert_eq!(printed.matches("the feet are swapped").count(), 2, "{printed}");
    let printed = succeeded(&solaris(folder.path(), &format!("{ground} --plate right= --plate left=1_")));
    assert!(!printed.contains("swapped") && printed.contains("plates            bear"), "{printed}");
}

#[test]
fn loads_of_opensim_are_held_against_the_ground() {
    let folder = subject();
    let line = "ground subject.osim walk.mot --soles soles.ron --filter 6Hz --json";
    let plates = format!("{line} --against grf.mot --plate right= --plate left=1_");
    let [described, one_by_one] = [format!("{line} --external-loads loads.xml"), plates]
        .map(|line| json(&succeeded(&solaris(folder.path(), &line))));
    assert_eq!(described["ground"]["beside_plates"], one_by_one["ground"]["beside_plates"]);
    assert_eq!(described["ground"]["plausibility"], one_by_one["ground"]["plausibility"]);
    let elsewhere = read(&folder.path().join("loads.xml")).replace(">calcn_l</applied", ">tibia_l</applied");
    write(folder.path(), "loads.xml", &elsewhere);
    let said = failed(&solaris(folder.path(), &format!("{line} --external-loads loads.xml")), 1);
    assert!(said.contains("no sole is on 'tibia_l', but on calcn_r, calcn_l"), "{said}");
}

#[test]
fn soles_without_forces_are_refused() {
    let folder = subject();
    let said = failed(&solaris(folder.path(), "inverse subject.osim walk.mot --soles soles.ron"), 2);
    assert!(said.contains("--ground") && said.contains("--external"), "{said}");
}

#[test]
fn degrees_that_are_radians_are_suspect() {
    let folder = subject();
    let walk = read(&folder.path().join("walk.mot"));
    write(folder.path(), "radians.mot", &walk.replace("inDegrees=yes", "inDegrees=no"));
    let line = format!("inverse subject.osim radians.mot {FILTER}");
    let printed = succeeded(&solaris(folder.path(), &line));
    assert!(printed.contains("suspect") && printed.contains("the numbers are degrees"), "{printed}");
    let report = json(&succeeded(&solaris(folder.path(), &format!("{line} --json"))));
    assert_eq!(report["suspect_angles"]["kind"], "degrees_as_radians");
    // Without a version it is one of SIMM's, which are in degrees.
    let old =
        walk.replace("version=1\n", "").replace("inDegrees=yes\n", "").replace("nRows=286", "nRows=400");
    write(folder.path(), "old.mot", &old);
    let printed = succeeded(&solaris(folder.path(), "inverse subject.osim old.mot"));
    assert!(printed.contains("angles in degrees, as in SIMM") && !printed.contains("suspect"), "{printed}");
    assert!(printed.contains("the header says 400 rows, there are 286; what is there is read"), "{printed}");
}

/// A measured trial, if it is at hand: right, swapped, and its plates half a second late.
#[test]
fn a_measured_trial_is_judged_rightly() {
    let files =
        ["gait10dof18musc_subject01.osim", "subject01_walk_ik_planar10.mot", "subject01_walk_grf.mot"];
    let [Some(model), Some(motion), Some(forces)] = files.map(|name| data(&format!("subject01_walk/{name}")))
    else {
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    // Each time with the forces of 0.4 s later.
    let text = read(&forces);
    let rows: Vec<(&str, &str)> = text
        .lines()
        .filter_map(|line| line.trim_start().split_once('\t'))
        .filter(|(time, _)| time.trim().parse::<f64>().is_ok())
        .collect();
    let header: Vec<&str> = text.lines().take(text.lines().count() - rows.len()).collect();
    let shift = rows.len() * 4 / 25;
    let late = rows
        .iter()
        .zip(rows.iter().cycle().skip(shift))
        .map(|((time, _), (_, rest))| format!("{time}\t{rest}\n"));
    let late = header.join("\n") + "\n" + &late.collect::<Vec<String>>().concat();
    write(folder.path(), "late.mot", &late);
    let [model, motion, forces] = [&model, &motion, &forces].map(|path| path.to_str().expect("UTF-8"));
    let found = |forces: &str, right: &str, left: &str| {
        let plates = [format!("calcn_r={right}"), format!("calcn_l={left}")];
        let mut args = vec!["inverse", model, motion, "--external", forces, "--json"];
        args.extend(["--plate", &plates[0], "--plate", &plates[1], "--filter", "6Hz"]);
        json(&succeeded(&solaris_with(folder.path(), &args)))
    };
    assert_eq!(kinds(&found(forces, "", "1_")), [""; 0]);
    let swapped = found(forces, "1_", "");
    assert_eq!(kinds(&swapped), ["far"; 2]);
    assert!(swapped.to_string().matches("the feet are swapped").count() == 2, "{swapped}");
    let late = found("late.mot", "", "1_");
    assert!(!kinds(&late).is_empty() && late.to_string().contains("another trial"), "{late}");
}
