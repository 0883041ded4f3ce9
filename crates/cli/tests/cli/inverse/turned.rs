//! Recordings of markers of which another way is up than is thought: the figure that fits them lies, and that is said.

use crate::inverse::{FIXTURES, read, solaris, succeeded};
use serde_json::Value;
use std::path::Path;

fn leg() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["leg.osim", "swing.trc", "swing_z_up.trc"] {
        let from = Path::new(FIXTURES).join("markers").join(name);
        std::fs::copy(from, folder.path().join(name)).expect("a fixture");
    }
    folder
}

#[test]
fn a_figure_that_lies_is_named_with_axes_that_would_do() {
    let folder = leg();
    let run = |line: &str| succeeded(&solaris(folder.path(), line));
    let said = run("ik leg.osim swing_z_up.trc --axes y,x");
    assert!(said.contains("look at") && said.contains("y up, as --axes says"), "{said}");
    assert!(said.contains("give --axes z,x"), "{said}");
    let said = run("ik leg.osim swing_z_up.trc --axes -z,x");
    assert!(said.contains("-z up, as --axes says") && said.contains("give --axes z,x"), "{said}");
    let found: Value =
        serde_json::from_str(&run("ik leg.osim swing_z_up.trc --axes y,x --json")).expect("JSON");
    let turned = &found["turned"];
    assert_eq!((turned["kind"].as_str(), turned["unit"].as_str()), (Some("turned"), Some("°")));
    assert!(turned["value"].as_f64().is_some_and(|angle| (angle - 90.0).abs() < 15.0), "{turned}");
    // On the page, and of several motions.
    run("inverse leg.osim swing_z_up.trc --axes y,x -o page.html");
    assert!(read(&folder.path().join("page.html")).contains("give --axes z,x"));
    let said = run("inverse leg.osim swing_z_up.trc swing.trc --axes y,x -o all.csv");
    assert!(said.contains("in 1 motion: the figure is turned by"), "{said}");
}

#[test]
fn an_upright_figure_and_one_without_gravity_are_not() {
    let folder = leg();
    // The pelvis says which way is up where nobody else does.
    for line in ["swing.trc", "swing_z_up.trc", "swing_z_up.trc --axes z,x", "swing_z_up.trc --gravity 0,0,0"]
    {
        let said = succeeded(&solaris(folder.path(), &format!("ik leg.osim {line}")));
        assert!(!said.contains("look at"), "{said}");
    }
}
