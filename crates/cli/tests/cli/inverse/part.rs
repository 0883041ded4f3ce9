//! A part of a motion: the times that are asked for, those in which it is known where the figure is, and what of a setup counts.

use crate::inverse::{column, read, solaris, subject, succeeded, table, write};
use std::path::Path;

fn times(folder: &Path, name: &str) -> Vec<f64> {
    column(&table(folder, name), "time")
}

#[test]
fn the_times_that_are_asked_for_are_taken() {
    let folder = subject();
    let folder = folder.path();
    succeeded(&solaris(folder, "inverse subject.osim walk.mot -o all.sto"));
    let all = times(folder, "all.sto");
    let (from, to) = (all[20], all[60]);
    let line = format!("inverse subject.osim walk.mot --time {from}:{to} -o part.sto");
    succeeded(&solaris(folder, &line));
    assert_eq!(times(folder, "part.sto"), all[20..=60]);
    for (asked, why) in [("900:901", "lasts from"), ("3:2", "the earlier one first"), ("1", "two times")] {
        let refused = solaris(folder, &format!("inverse subject.osim walk.mot --time {asked}"));
        let said = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert!(!refused.status.success() && said.contains("--time") && said.contains(why), "{said}");
    }
}

/// A recording that begins before somebody comes into view, and goes on after.
#[test]
fn frames_without_anybody_are_left_out() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let fixtures = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/markers"));
    std::fs::copy(fixtures.join("leg.osim"), folder.join("leg.osim")).expect("a fixture");
    let text = read(&fixtures.join("swing.trc"));
    // A line of numbers has a time after the frame's number.
    let is_row = |line: &str| {
        let mut cells = line.split('\t').map(str::parse::<f64>);
        cells.next().is_some_and(|cell| cell.is_ok())
            && line.split('\t').nth(1).is_some_and(|t| t.contains('.'))
    };
    let rows = text.lines().filter(|line| is_row(line)).count();
    let mut row = 0;
    let emptied = text.lines().map(|line| {
        let mut cells: Vec<&str> = line.split('\t').collect();
        if is_row(line) {
            row += 1;
            if row <= 7 || row > rows - 4 {
                cells.truncate(2);
            }
        }
        cells.join("\t") + "\n"
    });
    write(folder, "swing.trc", &emptied.collect::<String>());
    let printed = succeeded(&solaris(folder, "ik leg.osim swing.trc -o swing.csv"));
    assert!(printed.contains("7 frames at the beginning and 4 frames at the end left out"), "{printed}");
    assert_eq!(times(folder, "swing.csv").len(), rows - 11);
}

/// A task whose values are in a file is left out, and said; the others count.
#[test]
fn tasks_with_values_in_files_are_left_out() {
    let folder = tempfile::tempdir().expect("a folder");
    let fixtures = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/markers"));
    for name in ["leg.osim", "swing.trc"] {
        std::fs::copy(fixtures.join(name), folder.path().join(name)).expect("a fixture");
    }
    let task = "<IKCoordinateTask name=\"knee_angle\"><weight>1</weight><value_type>from_file</value_type></IKCoordinateTask>";
    let setup = read(&fixtures.join("ik.xml")).replace("</objects>", &format!("{task}</objects>"));
    write(folder.path(), "ik.xml", &setup);
    let printed = succeeded(&solaris(folder.path(), "ik leg.osim swing.trc --ik-setup ik.xml"));
    assert!(printed.contains("values from a file are not read"), "{printed}");
}
