//! Many motions in one command, and means over strides.

use super::{FIXTURES, failed, solaris, succeeded};
use serde_json::Value;
use solaris::io::csv;
use std::fs;
use std::path::Path;

/// A folder with the subject, its trials `a`, `b` and `c` with their plates, and one that is no motion.
fn trials() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let copy = |from: &str, to: &str| {
        fs::copy(Path::new(FIXTURES).join("subject").join(from), at(to)).expect("copied");
    };
    for name in ["trials", "grf"] {
        fs::create_dir(at(name)).expect("made");
    }
    copy("subject.osim", "subject.osim");
    copy("soles.ron", "soles.ron");
    for name in ["a", "b", "c"] {
        copy("walk.mot", &format!("trials/{name}.mot"));
        copy("grf.mot", &format!("grf/{name}.mot"));
    }
    fs::write(at("trials/no.mot"), "x y\n").expect("written");
    folder
}

const ALL: &str = "trials/a.mot trials/b.mot trials/no.mot trials/c.mot";
const PLATES: &str = "--external grf/{}.mot --plate calcn_r= --plate calcn_l=1_ --filter 6Hz";

#[test]
fn each_of_many_motions_is_a_row_and_has_its_files() {
    let folder = trials();
    let line = format!("inverse subject.osim {ALL} {PLATES} -o out/ -o out/{{}}.svg -o all.csv");
    let output = solaris(folder.path(), &line);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert_eq!(said, "error: 1 of 4 motions failed; the summary says why\n");
    let printed = String::from_utf8_lossy(&output.stdout);
    assert!(printed.contains("4: 3 done, 1 failed") && printed.contains("endheader"), "{printed}");

    let mut names: Vec<String> = fs::read_dir(folder.path().join("out"))
        .expect("made")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    assert_eq!(names, ["a.sto", "a.svg", "b.sto", "b.svg", "c.sto", "c.svg"]);

    let text = fs::read_to_string(folder.path().join("all.csv")).expect("written");
    let table = csv::read_rows(&text).expect("a table");
    let motions: Vec<&str> = table.rows.iter().map(|row| row.fields[0].as_str()).collect();
    assert_eq!(motions, ["trials/a.mot", "trials/b.mot", "trials/no.mot", "trials/c.mot"]);
    let refusal = table.columns.len() - 1;
    assert_eq!(table.columns[refusal], "refusal");
    assert!(table.rows[2].fields[refusal].contains("endheader"), "{text}");
    assert_eq!(table.rows[0].fields[1..], table.rows[3].fields[1..]);
}

#[test]
fn what_is_found_of_one_of_many_is_what_is_found_of_it_alone() {
    let folder = trials();
    solaris(folder.path(), &format!("inverse subject.osim {ALL} {PLATES} -o out/"));
    let alone = PLATES.replace("{}", "a");
    succeeded(&solaris(folder.path(), &format!("inverse subject.osim trials/a.mot {alone} -o a.sto")));
    let read = |name: &str| fs::read(folder.path().join(name)).expect("written");
    assert_eq!(read("out/a.sto"), read("a.sto"));
}

#[test]
fn many_motions_are_an_array_of_reports() {
    let folder = trials();
    let output = solaris(folder.path(), &format!("inverse subject.osim {ALL} {PLATES} --json"));
    let all: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let all = all.as_array().expect("an array");
    assert_eq!(all.len(), 4);
    assert_eq!(all[1]["motion"], "trials/b.mot");
    assert!(all[1]["residual"]["force_rms_n"].as_f64().is_some_and(|force| force > 1.0), "{}", all[1]);
    assert!(all[2]["refusal"].is_string() && all[2]["residual"].is_null() && all[1]["refusal"].is_null());
}

#[test]
fn one_file_does_not_serve_many_motions() {
    let folder = trials();
    let refused =
        |more: &str| failed(&solaris(folder.path(), &format!("inverse subject.osim {ALL} {more}")), 1);
    let said = refused("--external grf/a.mot --plate calcn_r=");
    assert!(
        said.contains("--external grf/a.mot: there are 4 motions") && said.contains("grf/{}.mot"),
        "{said}"
    );
    let said = refused("-o page.html");
    assert!(said.contains("-o page.html") && said.contains("out/{}.html"), "{said}");
    let said = refused("-o nowhere/out/");
    assert!(said.contains("make it first"), "{said}");
    let said = refused("--soles soles.ron --cycles right --cycles-out stride.csv");
    assert!(said.contains("--cycles-out stride.csv"), "{said}");
    fs::copy(folder.path().join("trials/a.mot"), folder.path().join("a.mot")).expect("copied");
    let said = refused("a.mot");
    assert!(said.contains("trials/a.mot has the same name"), "{said}");
    assert!(!folder.path().join("out").exists());
}

#[test]
fn strides_are_cut_at_touch_downs() {
    let folder = trials();
    let line = "inverse subject.osim trials/a.mot --ground --soles soles.ron --filter 6Hz --cycles right \
                --cycles-out stride.csv --cycles-out stride.svg -o all.csv";
    let printed = succeeded(&solaris(folder.path(), line));
    assert!(printed.contains("2 strides of 1.105 to 1.126 s"), "{printed}");
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).expect("written");
    let (stride, whole) = (read("stride.csv"), read("all.csv"));
    let [stride, whole] = [&stride, &whole].map(|text| csv::read_table(text).expect("a table"));
    assert_eq!((stride.len(), stride.row(0)[0], stride.row(100)[0]), (101, 0.0, 100.0));
    // A mean is between the least and the greatest.
    let column = |table: &solaris::io::Table, name: &str| -> Vec<f64> {
        table.values_of(table.column(name).expect("a column")).collect()
    };
    let (mean, all) = (column(&stride, "knee_angle_r.tau.mean"), column(&whole, "knee_angle_r.tau"));
    let most = |values: &[f64]| values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    assert!(most(&mean) > 0.3 * most(&all) && most(&mean) <= most(&all), "{} {}", most(&mean), most(&all));
    assert!(column(&stride, "knee_angle_r.tau.sd").iter().all(|sd| *sd >= 0.0));
    assert!(read("stride.svg").contains("2 strides of right"));

    let one =
        "ground subject.osim trials/a.mot --soles soles.ron --filter 6Hz --cycles left --cycles-out left.csv";
    succeeded(&solaris(folder.path(), one));
    let left = csv::read_table(&read("left.csv")).expect("a table");
    let up = column(&left, "left.fy.mean");
    // It stands at first, and swings before the stride ends.
    assert!(up[20] > 300.0 && up[80].abs() < 1.0, "{} {}", up[20], up[80]);
    let said = failed(&solaris(folder.path(), &one.replace("--cycles left", "--cycles toe")), 1);
    assert!(said.contains("--cycles toe: it must be a sole: right, left"), "{said}");
}

#[test]
fn pages_hold_the_figure_its_forces_and_what_was_found() {
    let folder = trials();
    let line = "inverse subject.osim trials/a.mot --ground --soles soles.ron --filter 6Hz -o a.html";
    succeeded(&solaris(folder.path(), line));
    succeeded(&solaris(
        folder.path(),
        "ground subject.osim trials/a.mot --soles soles.ron --filter 6Hz -o g.html",
    ));
    succeeded(&solaris(folder.path(), "convert trials/a.mot m.html --figure subject.osim"));
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).expect("written");
    let data = |page: &str| -> Value {
        let (_, rest) = page.split_once("id=\"data\">").expect("data");
        serde_json::from_str(rest.split_once("</script>").expect("its end").0).expect("JSON")
    };
    let page = read("a.html");
    for text in ["Residual force", "hip_flexion_r", "Look at", "outside of its sole"] {
        assert!(page.contains(text), "{text}");
    }
    let (inverse, ground, motion) = (data(&page), data(&read("g.html")), data(&read("m.html")));
    let labels = |data: &Value, of: &str| -> Vec<String> {
        let all = data[of].as_array().expect("an array").iter();
        all.map(|one| one["label"].as_str().expect("a label").to_owned()).collect()
    };
    assert_eq!(labels(&inverse, "joints")[..3], ["Hip flexion", "Knee angle", "Ankle angle"]);
    assert_eq!(labels(&inverse, "forces")[3..], ["Residual force", "Residual moment"]);
    assert_eq!((labels(&ground, "forces").len(), labels(&motion, "forces").len()), (3, 0));
    let knee = &inverse["joints"][1];
    assert_eq!((&knee["effort"]["unit"], &knee["power"]["unit"]), (&"N m/kg".into(), &"W/kg".into()));
    assert!(ground["joints"][1]["effort"].is_null() && motion["ground"]["solid"] == false);
    assert_eq!(ground["ground"]["solid"], true);
    // The soles are drawn, a line for each edge.
    let foot = inverse["links"].as_array().expect("links").iter().find(|link| link["name"] == "calcn_r");
    assert_eq!(foot.expect("a foot")["parts"].as_array().expect("parts").len(), 4);
}
