//! `solaris sweep` from outside.

use crate::walk::{names, read, refused, solaris, succeeded};
use serde_json::Value;
use solaris::io::csv::{Rows, read_rows};
use std::fs;
use std::path::Path;

const PEOPLE: &str = "height,mass,step-frequency,steps,arm-swing
1.75,73,,3,
1.2,25,100,2,10
2.9,,,3,
1.6,55,abc,3,
1.6,55,,3,90
1.6,55
1.7,65,95,8,
";

fn swept(folder: &Path, options: &str) -> Rows {
    let line = format!("sweep people.csv -o metrics.csv --rate 60 {options}");
    succeeded(&solaris(folder, &line.split_whitespace().collect::<Vec<_>>()));
    read_rows(&read(&folder.join("metrics.csv"))).expect("a table")
}

fn field<'a>(table: &'a Rows, row: usize, heading: &str) -> &'a str {
    &table.rows[row].fields[table.columns.iter().position(|name| name == heading).expect(heading)]
}

#[test]
fn the_file_does_not_depend_on_threads() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("people.csv"), PEOPLE).expect("written");
    let bytes = ["1", "4", "3"].map(|threads| {
        swept(folder.path(), &format!("--threads {threads}"));
        read(&folder.path().join("metrics.csv"))
    });
    assert!(bytes.iter().all(|text| *text == bytes[0]));
}

#[test]
fn a_bad_row_is_a_row_with_its_reason() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("people.csv"), PEOPLE).expect("written");
    let table = swept(folder.path(), "");
    assert_eq!(table.rows.len(), 7);
    assert!(table.rows.iter().all(|row| row.fields.len() == table.columns.len()));
    for (row, why) in [
        (2, "--height 2.9: a human figure is 0.8 to 2.3 m tall"),
        (3, "invalid value 'abc' for '--step-frequency <STEPS/MIN>': it must be a number"),
        (4, "--arm-swing 90: it must be 0 to 45°"),
        (5, "it has 2 fields, the header has 5"),
    ] {
        assert_eq!(field(&table, row, "refusal"), why, "row {row}");
        assert_eq!(field(&table, row, "distance_m"), "");
        assert_eq!(field(&table, row, "mass"), ["", "55", "55", "55"][row - 2]);
    }
    for row in [0, 1, 6] {
        assert_eq!(field(&table, row, "refusal"), "");
        assert_eq!(field(&table, row, "walked_steps"), field(&table, row, "steps"));
    }
    assert_eq!(field(&table, 0, "com_rise_cm"), "");
    assert!(field(&table, 6, "com_rise_cm").parse::<f64>().expect("a number") > 1.0);
}

#[test]
fn a_row_has_the_numbers_of_the_walk_itself() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("people.csv"), "height,speed,steps,tilt\n1.62,1.1,9,5\n").expect("written");
    succeeded(&solaris(folder.path(), &["sweep", "people.csv", "-o", "metrics.csv"]));
    let table = read_rows(&read(&folder.path().join("metrics.csv"))).expect("a table");
    let words = "walk --height 1.62 --speed 1.1 --steps 9 --tilt 5 --json";
    let printed = succeeded(&solaris(folder.path(), &words.split(' ').collect::<Vec<_>>()));
    let value: Value = serde_json::from_str(&printed).expect("JSON");
    for (heading, pointer, factor) in [
        ("distance_m", "/walk/distance_m", 1.0),
        ("speed_m_s", "/walk/speed_m_s", 1.0),
        ("vertical_peak_percent_bw", "/whole_walk/vertical_percent_bw/value", 1.0),
        ("clearance_mm", "/whole_walk/toe_clearance_m/value", 1e3),
        ("stance_percent", "/steady_stride/stance_percent", 1.0),
        ("knee_extensor_n_m_kg", "/whole_walk/joints/1/extension/value", 1.0),
    ] {
        let wanted = factor * value.pointer(pointer).and_then(Value::as_f64).expect(pointer);
        let found: f64 = field(&table, 0, heading).parse().expect("a number");
        assert!((found - wanted).abs() <= 1e-12 * wanted.abs(), "{heading}: {found} is not {wanted}");
    }
}

#[test]
fn a_table_that_cannot_be_swept_leaves_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    for (text, why) in [
        (
            "hight,mass\n1.7,70\n",
            "'hight' (did you mean 'height'?): no option of a walk; there are figure, height, mass,",
        ),
        // Each with what it may have meant; a word of four letters is not near to one that shares two.
        ("time,hight\n1,2\n", "columns 'time', 'hight' (did you mean 'height'?): no option of a walk"),
        ("height,output\n1.7,x.html\n", "'output'"),
        ("", "it is empty"),
        ("height,height\n1,2\n", "height"),
        ("height;mass\n1;2\n", "semicolons"),
    ] {
        fs::write(folder.path().join("people.csv"), text).expect("written");
        let said = refused(&solaris(folder.path(), &["sweep", "people.csv", "-o", "metrics.csv"]));
        assert!(said.contains(why), "{text:?}: {said}");
        assert_eq!(names(folder.path()), ["people.csv"]);
    }
    let said = refused(&solaris(folder.path(), &["sweep", "people.csv", "-o", "people.csv"]));
    assert!(said.contains("it is what is read here"), "{said}");
    let said = refused(&solaris(folder.path(), &["sweep", "people.csv", "-o", "m.csv", "--rate", "5"]));
    assert!(said.contains("10 to 1000"), "{said}");
}

#[test]
fn headings_alone_are_a_table_without_rows() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("people.csv"), "height\n").expect("written");
    assert!(swept(folder.path(), "").rows.is_empty());
}

#[test]
fn every_example_of_the_help_runs() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("people.csv"), "height,mass,speed,steps\n1.60,55,1.2,2\n1.85,,1.4,2\n")
        .expect("written");
    succeeded(&solaris(folder.path(), &["walk", "--steps", "3", "-o", "walk.csv"]));
    let mut run = 0;
    for command in ["sweep", "metrics"] {
        let help = succeeded(&solaris(folder.path(), &[command, "--help"]));
        // The measured walk stands in the transcripts.
        let examples = help.lines().filter_map(|line| line.strip_prefix("  solaris "));
        for example in examples.filter(|example| !example.contains("subject.osim")) {
            succeeded(&solaris(folder.path(), &example.split(' ').collect::<Vec<_>>()));
            run += 1;
        }
    }
    assert!(run >= 4, "{run} examples");
    assert_eq!(names(folder.path()), ["metrics.csv", "metrics.json", "people.csv", "walk.csv"]);
}
