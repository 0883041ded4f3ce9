//! Bands around the moments of a motion, as files and words.

use crate::inverse::{column, read, solaris, subject, succeeded, table};

/// The project's leg with markers, in a folder of its own.
fn leg() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let fixtures = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/markers");
    for name in ["leg.osim", "swing.trc"] {
        std::fs::copy(format!("{fixtures}/{name}"), folder.path().join(name)).expect("a fixture");
    }
    folder
}

const LEG: &str = "inverse leg.osim --markers swing.trc --filter 6Hz";

#[test]
fn moments_of_markers_have_standard_errors() {
    let folder = leg();
    let line = format!("{LEG} --json -o tau.csv -o page.html -o tau.svg");
    let json: serde_json::Value =
        serde_json::from_str(&succeeded(&solaris(folder.path(), &line))).expect("JSON");
    let sources: Vec<&str> = json["bands"]["sources"]
        .as_array()
        .expect("some")
        .iter()
        .filter_map(|s| s["source"].as_str())
        .collect();
    // Nothing was measured outside, so that what is left over is no error.
    assert_eq!(sources, ["markers", "filter"]);
    let moments = table(folder.path(), "tau.csv");
    let (knee, error) = (column(&moments, "knee_angle.tau"), column(&moments, "knee_angle.tau_se"));
    assert_eq!(knee.len(), error.len());
    assert!(error.iter().all(|error| (1e-6..20.0).contains(error)), "{error:?}");
    let rms = (error.iter().map(|x| x * x).sum::<f64>() / error.len() as f64).sqrt();
    let joints = json["bands"]["joints"].as_array().expect("some");
    let told = joints.iter().find(|joint| joint["dof"] == "knee_angle").expect("a knee");
    let told = told["force_se_rms"].as_f64().expect("a number");
    assert!((told - rms).abs() < 1e-9 * rms, "{told} {rms}");
    assert!(read(&folder.path().join("page.html")).contains("\"bands\":\"two standard errors\""));
    assert!(read(&folder.path().join("tau.svg")).contains("areas: two standard errors"));

    let without = succeeded(&solaris(folder.path(), &format!("{LEG} --bands off -o plain.csv")));
    assert!(!without.contains("band"), "{without}");
    let plain = table(folder.path(), "plain.csv");
    assert!(!plain.columns.iter().any(|column| column.ends_with("_se")));
    assert_eq!(column(&plain, "knee_angle.tau"), knee);
}

/// Angles that somebody else found: no markers, but a filter and plates.
#[test]
fn bands_of_a_table_come_of_filter_and_residual() {
    let folder = subject();
    let line = "inverse subject.osim walk.mot --external-loads loads.xml --filter 6Hz --bands on";
    let printed = succeeded(&solaris(folder.path(), line));
    let bands = printed.lines().find(|line| line.trim_start().starts_with("bands")).expect("bands");
    assert!(
        bands.contains("cut-off") && bands.contains("the residual") && !bands.contains("markers"),
        "{bands}"
    );
    let nothing = succeeded(&solaris(folder.path(), "inverse subject.osim walk.mot --bands on"));
    assert!(nothing.contains("nothing is known of errors"), "{nothing}");
}

#[test]
fn a_root_that_is_moved_has_no_bands() {
    let folder = subject();
    let line = "inverse subject.osim walk.mot --ground --consistent --bands on";
    let refused = solaris(folder.path(), line);
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(
        !refused.status.success() && said.contains("--bands") && said.contains("leave out one"),
        "{said}"
    );
}
