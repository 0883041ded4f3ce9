//! `solaris crowd` from outside.

use crate::walk::{names, read, refused, solaris, succeeded};
use serde_json::Value;
use solaris::io::csv::{Rows, read_rows};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

const PEOPLE: &str = "name,height,mass,age,cadence,manner,seed,x,z,heading,steps
Ann,1.65,58,34,,happy:0.8,,0,0,170,2
Bo,,,71,,older,5,1.5,0,,2
,,,9,,,,3,-1,,2
Cy,1.8,110,,200,,,1,1,,2
Di,1.8,80,,,sadd,,1,1,,2
Ed,1.8,80,,,sad,,abc,1,,2
Ann,1.72,,,,,,,,400,2
ann,1.72,,,,,,,,,2
Gus,1.72
";

fn walked(folder: &Path, options: &str) -> Rows {
    let line = format!("crowd --people people.csv --rate 30 {options}");
    succeeded(&solaris(folder, &line.split_whitespace().collect::<Vec<_>>()));
    read_rows(&read(&folder.join("out/crowd.csv"))).expect("a table")
}

fn field<'a>(table: &'a Rows, row: usize, heading: &str) -> &'a str {
    &table.rows[row].fields[table.columns.iter().position(|name| name == heading).expect(heading)]
}

#[test]
fn bad_rows_are_told_with_line_and_column_and_the_others_walk() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("people.csv"), PEOPLE).expect("written");
    let table = walked(folder.path(), "-o out");
    for (row, why) in [
        (3, "line 5, column 5: --step-frequency 200: it must be 60 to 130 steps/min"),
        (4, "line 6, column 6: --manner sadd: there is no manner 'sadd'; did you mean 'sad'?"),
        (5, "line 7, column 8: x abc: it must be a number"),
        (6, "line 8, column 10: heading 400: it must be -360 to 360"),
        (8, "line 10: it has 2 fields, the header has 11"),
    ] {
        assert_eq!((field(&table, row, "refusal"), field(&table, row, "file")), (why, ""));
    }
    for (row, file) in [(0, "Ann.bvh"), (1, "Bo.bvh"), (2, "person-0003.bvh"), (7, "ann-3.bvh")] {
        assert_eq!((field(&table, row, "refusal"), field(&table, row, "file")), ("", file));
        assert!(read(&folder.path().join("out").join(file)).starts_with("HIERARCHY"));
    }
    let files = names(&folder.path().join("out"));
    assert_eq!(files, ["Ann.bvh", "Bo.bvh", "ann-3.bvh", "crowd.csv", "person-0003.bvh"]);
    // What is given is so, what is not is drawn: a child of nine is small.
    assert_eq!((field(&table, 0, "height_m"), field(&table, 0, "mass_kg")), ("1.65", "58"));
    let height: f64 = field(&table, 2, "height_m").parse().expect("a number");
    assert!((1.1..1.6).contains(&height), "{height}");
}

#[test]
fn a_crowd_does_not_depend_on_threads_and_nobody_is_like_another() {
    let folder = tempfile::tempdir().expect("a folder");
    let crowd = |threads: &str, out: &str| {
        let line = format!("crowd --count 8 --seed 3 --rate 30 --format csv --threads {threads} -o {out}");
        succeeded(&solaris(folder.path(), &line.split_whitespace().collect::<Vec<_>>()));
        let out = folder.path().join(out);
        names(&out).iter().map(|name| (name.clone(), read(&out.join(name)))).collect::<Vec<_>>()
    };
    let (one, four) = (crowd("1", "one"), crowd("4", "four"));
    assert_eq!(one.len(), 9);
    assert!(one == four);
    let bodies: BTreeSet<&String> = one.iter().map(|(_, text)| text).collect();
    assert_eq!(bodies.len(), 9);
}

#[test]
fn faults_of_the_table_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let crowd = |text: &str| {
        fs::write(folder.path().join("people.csv"), text).expect("written");
        refused(&solaris(folder.path(), &["crowd", "--people", "people.csv", "-o", "out"]))
    };
    let unknown = crowd("name,hieght\nAnn,1.6\n");
    assert!(
        unknown.contains("line 1, column 2: there is no column 'hieght'; did you mean 'height'?"),
        "{unknown}"
    );
    assert!(crowd("").contains("it is empty"));
    let json = solaris(folder.path(), &["crowd", "--count", "2", "--rate", "30", "-o", "out", "--json"]);
    let json: Value = serde_json::from_str(&succeeded(&json)).expect("JSON");
    assert_eq!((json["people"].as_u64(), json["walked"].as_u64()), (Some(2), Some(2)));
}

#[test]
fn a_folder_that_is_called_as_a_file_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let message = refused(&solaris(folder.path(), &["crowd", "--count", "2", "-o", "people.usda"]));
    assert!(
        message.contains("--output people.usda: this names a file, and a crowd is a folder"),
        "{message}"
    );
    assert!(!folder.path().join("people.usda").exists());
}
