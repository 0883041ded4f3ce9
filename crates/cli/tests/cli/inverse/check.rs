//! What a figure is, and what looks wrong with it.

use crate::inverse::{failed, folder_with, json, number, read, refused, solaris, subject, succeeded, write};
use std::path::Path;
use tempfile::TempDir;

/// Every figure of the project: its file, links, degrees of freedom, mass (kg), chains.
const FIGURES: [(&str, f64, f64, f64, f64); 3] = [
    ("arm.urdf", 3.0, 2.0, 3.2, 1.0),
    ("subject.osim", 8.0, 14.0, 73.0, 3.0),
    ("human.ron", 21.0, 66.0, 73.0, 5.0),
];

/// A fault in the text of a figure, the place where it is reported (line, column), and a word of what is said.
const FAULTS: [(&str, &str, (usize, usize), &str); 4] = [
    (
        "f.ron",
        "Figure(\n    version: 1,\n    name: \"a\",\n    links: [\n        Link(name: \"b\", mas: 1.0),\n    ],\n)\n",
        (5, 25),
        "mass",
    ),
    (
        "f.urdf",
        "<robot name=\"a\">\n  <link name=\"b\">\n    <inertial>\n      <mass value=\"one\"/>\n    </inertial>\n  </link>\n</robot>\n",
        (4, 20),
        "one",
    ),
    (
        "f.xml",
        "<mujoco>\n  <worldbody>\n    <body pos=\"0 0\">\n      <geom size=\"1\"/>\n    </body>\n  </worldbody>\n</mujoco>\n",
        (3, 16),
        "pos",
    ),
    (
        "f.osim",
        "<OpenSimDocument Version=\"40000\">\n  <Model name=\"a\">\n  </Modell>\n</OpenSimDocument>\n",
        (3, 3),
        "Model",
    ),
];

fn figures() -> TempDir {
    let folder = subject();
    std::fs::copy(
        Path::new(crate::inverse::FIXTURES).join("figures/arm.urdf"),
        folder.path().join("arm.urdf"),
    )
    .expect("copied");
    succeeded(&solaris(folder.path(), "figure human --mass 73 -o human.ron"));
    folder
}

#[test]
fn every_figure_is_told_in_numbers() {
    let folder = figures();
    for (file, links, dofs, mass, chains) in FIGURES {
        let facts = json(&succeeded(&solaris(folder.path(), &format!("check {file} --json"))));
        let expected = [("/links", links), ("/dofs", dofs), ("/mass_kg", mass), ("/chains", chains)];
        for (pointer, value) in expected {
            assert!((number(&facts, pointer) - value).abs() < 1e-9, "{file} {pointer}: {facts}");
        }
        let shown = succeeded(&solaris(folder.path(), &format!("check {file}")));
        for row in [format!("{links}"), format!("{dofs}"), format!("{mass} kg")] {
            assert!(shown.lines().any(|line| line.ends_with(&format!(" {row}"))), "{row}: {shown}");
        }
        assert!(shown.contains(facts["name"].as_str().expect("a name")), "{shown}");
        // Nothing of the project looks wrong.
        succeeded(&solaris(folder.path(), &format!("check {file} --strict")));
    }
}

#[test]
fn what_follows_and_what_is_not_read_is_listed() {
    let folder = figures();
    let facts = |file: &str| json(&succeeded(&solaris(folder.path(), &format!("check {file} --json"))));
    let subject = facts("subject.osim");
    let followers = subject["followers"].as_array().expect("a list");
    assert_eq!(followers.len(), 4, "two slides a knee: {subject}");
    assert_eq!(subject["gravity_is_given"], true);
    let arm = facts("arm.urdf");
    let effort = arm["findings"].as_array().expect("a list").iter().find(|finding| {
        finding["kind"] == "unsupported"
            && finding["message"].as_str().is_some_and(|message| message.contains("'effort'"))
    });
    let text = read(&folder.path().join("arm.urdf"));
    let line = number(effort.expect("efforts are not read"), "/line");
    assert!(text.lines().nth(line as usize - 1).expect("a line").contains("effort="));
}

#[test]
fn rationalised_links_come_as_a_table() {
    let folder = figures();
    for (file, dofs) in [("arm.urdf", 2), ("human.ron", 66), ("subject.osim", 14)] {
        let shown = succeeded(&solaris(folder.path(), &format!("check {file} --dh")));
        let rows = shown.lines().skip_while(|line| !line.starts_with("dof ")).skip(1);
        let rows = rows.take_while(|line| {
            line.split_whitespace().next().is_some_and(|word| word.parse::<u32>().is_ok())
        });
        assert_eq!(rows.count(), dofs, "{shown}");
        let plain = succeeded(&solaris(folder.path(), &format!("check {file}")));
        assert!(!plain.contains("θ⁰"), "{plain}");
    }
    // Upper arm to forearm: 0.3 m along the common normal.
    let arm = succeeded(&solaris(folder.path(), "check arm.urdf --dh"));
    assert!(arm.contains("-0.3000") || arm.contains("0.3000"), "{arm}");
}

/// The arm with an elbow that cannot stretch.
fn crooked(folder: &Path) {
    let text = read(&folder.join("arm.urdf"));
    write(folder, "crooked.urdf", &text.replace("upper=\"0.1\"", "upper=\"-0.1\""));
}

#[test]
fn strict_fails_where_something_looks_wrong() {
    let folder = folder_with(&["figures/arm.urdf"]);
    crooked(folder.path());
    let shown = succeeded(&solaris(folder.path(), "check crooked.urdf"));
    let finding = "elbow: its limits -2.6 to -0.1 exclude 0";
    assert!(shown.contains("Looks wrong") && shown.contains(finding), "{shown}");
    for format in ["", "--json"] {
        let output = solaris(folder.path(), &format!("check crooked.urdf --strict {format}"));
        assert_eq!(output.status.code(), Some(1));
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(said.starts_with("error: crooked.urdf: ") && said.contains("--strict"), "{said}");
        // What looks wrong stands where it does otherwise.
        assert!(String::from_utf8_lossy(&output.stdout).contains("exclude 0"));
    }
    let facts = json(&succeeded(&solaris(folder.path(), "check crooked.urdf --json")));
    let suspects = facts["findings"].as_array().expect("a list").iter().filter(|f| f["kind"] == "suspect");
    assert_eq!(suspects.count(), 1, "{facts}");
}

#[test]
fn faults_stand_with_their_places_on_standard_error() {
    let folder = tempfile::tempdir().expect("a folder");
    for (file, text, (line, column), word) in FAULTS {
        write(folder.path(), file, text);
        for options in ["", "--json", "--strict", "--dh"] {
            let said = refused(&solaris(folder.path(), &format!("check {file} {options}")));
            assert!(said.starts_with(&format!("error: {file} cannot be used\n")), "{said}");
            let place = format!(" {file}:{line}:{column}\n");
            assert!(said.contains(&place) && said.contains(word), "{place}: {said}");
        }
    }
}

#[test]
fn the_line_of_a_fault_is_shown_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    for (file, text, (line, _), _) in FAULTS {
        write(folder.path(), file, text);
        let said = refused(&solaris(folder.path(), &format!("check {file}")));
        let source = text.lines().nth(line - 1).expect("a line");
        assert!(said.contains(source), "{said}");
    }
}

#[test]
fn all_faults_are_told_at_once() {
    let folder = folder_with(&["figures/arm.urdf"]);
    let text = read(&folder.path().join("arm.urdf"));
    let text = text
        .replace("<mass value=\"2.0\"/>", "<mass value=\"heavy\"/>")
        .replace("<parent link=\"upper_arm\"/>", "<parent link=\"uper_arm\"/>")
        .replace("<limit lower=\"-3.1\"", "<limit lower=\"1e999\"");
    write(folder.path(), "bad.urdf", &text);
    let said = refused(&solaris(folder.path(), "check bad.urdf"));
    for word in ["heavy", "uper_arm", "'upper_arm'", "1e999", "3 faults"] {
        assert!(said.contains(word), "{word}: {said}");
    }
    // Wherever a figure is read, it is the same.
    for line in ["inverse bad.urdf x.csv", "convert bad.urdf x.ron", "walk --figure bad.urdf"] {
        assert_eq!(refused(&solaris(folder.path(), line)), said, "{line}");
    }
}

#[test]
fn options_that_there_are_not() {
    let folder = folder_with(&["figures/arm.urdf"]);
    for line in [
        "check",
        "check arm.urdf arm.urdf",
        "check arm.urdf --stirct",
        "check --json",
        "figure",
        "figure dog",
    ] {
        failed(&solaris(folder.path(), line), 2);
    }
}
