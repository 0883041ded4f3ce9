//! Files that hold no figure, no motion, no forces: each is refused by its name, with exit code 1 and no panic.

use crate::inverse::{names, refused, solaris, subject, write};
use std::fs;
use std::path::Path;

/// Files that are not what their names say, and a word of why.
fn bad_files(folder: &Path) -> Vec<(String, &'static str)> {
    let mut files = Vec::new();
    for extension in ["ron", "urdf", "xml", "osim", "csv", "mot", "sto"] {
        // Models of other programs may be written in other letters.
        let letters = if ["urdf", "xml", "osim"].contains(&extension) { "" } else { "UTF-8" };
        let contents: [(&str, &[u8], &'static str); 5] = [
            ("empty", b"", ""),
            ("blank", b" \n\t\r\n\n", ""),
            ("binary", b"\x7fELF\x02\x01\x01\x00\x00\xff\xfe\x00", "UTF-8"),
            ("latin", b"name,caf\xe9\n1,2\n", letters),
            ("nul", b"\x00\x00\x00\x00", ""),
        ];
        for (name, bytes, why) in contents {
            let name = format!("{name}.{extension}");
            fs::write(folder.join(&name), bytes).expect("written");
            files.push((name, why));
        }
        let directory = format!("folder.{extension}");
        fs::create_dir(folder.join(&directory)).expect("made");
        files.push((directory, "it is a folder"));
        files.push((format!("missing.{extension}"), "there is no such file"));
    }
    files
}

fn extension(name: &str) -> &str {
    name.rsplit_once('.').expect("an extension").1
}

fn is_table(name: &str) -> bool {
    ["csv", "mot", "sto"].contains(&extension(name))
}

#[test]
fn no_figure() {
    let folder = subject();
    for (name, why) in bad_files(folder.path()) {
        let lines = ["check {}", "inverse {} walk.mot -o x.csv", "walk --figure {} -o x.csv"];
        for line in lines.map(|line| line.replace("{}", &name)) {
            let said = refused(&solaris(folder.path(), &line));
            // A motion that is a readable text is told that it is a motion; the others why they are no text.
            assert!(said.starts_with(&format!("error: {name}")) && said.contains(why), "{line}: {said}");
        }
    }
    assert!(!folder.path().join("x.csv").exists());
}

#[test]
fn no_table() {
    let folder = subject();
    let files = bad_files(folder.path());
    for (name, why) in files.iter().filter(|(name, _)| is_table(name)) {
        let lines = [
            "inverse subject.osim {} -o x.csv",
            "inverse subject.osim walk.mot --external {} --plate calcn_r= -o x.csv",
        ];
        for line in lines.map(|line| line.replace("{}", name)) {
            let said = refused(&solaris(folder.path(), &line));
            assert!(said.starts_with(&format!("error: {name}: ")) && said.contains(why), "{line}: {said}");
        }
    }
    assert!(!folder.path().join("x.csv").exists());
}

#[test]
fn no_motion_to_convert() {
    let folder = subject();
    let files = bad_files(folder.path());
    for (name, why) in files.iter().filter(|(name, _)| is_table(name)) {
        for to in ["x.csv", "x.mot"] {
            let said = refused(&solaris(folder.path(), &format!("convert {name} {to}")));
            assert!(said.starts_with(&format!("error: {name}: ")) && said.contains(why), "{name}: {said}");
            assert!(!folder.path().join(to).exists());
        }
    }
}

#[test]
fn no_loads() {
    let folder = subject();
    let files = bad_files(folder.path());
    for (name, why) in files.iter().filter(|(name, _)| extension(name) == "xml") {
        let line = format!("inverse subject.osim walk.mot --external-loads {name} -o x.csv");
        let said = refused(&solaris(folder.path(), &line));
        assert!(said.starts_with(&format!("error: {name}")) && said.contains(why), "{line}: {said}");
    }
    assert!(!folder.path().join("x.csv").exists());
}

#[test]
fn a_text_of_the_wrong_kind_is_told_what_it_is() {
    let folder = subject();
    let good = names(folder.path());
    for (name, text, why) in [
        ("note.xml", "<note>milk</note>", "neither a MuJoCo model (<mujoco>) nor a URDF (<robot>)"),
        ("note.urdf", "<note>milk</note>", "robot"),
        ("note.mjcf", "<note>milk</note>", "mujoco"),
        ("note.osim", "<note>milk</note>", "OpenSimDocument"),
        ("note.ron", "<note>milk</note>", "not '<'"),
        ("note.txt", "Figure(version: 1)", "its extension says nothing; a figure is .ron, .urdf"),
        ("note", "Figure(version: 1)", "its extension says nothing"),
        ("page.xml", "<html><body/></html>", "neither"),
    ] {
        write(folder.path(), name, text);
        let said = refused(&solaris(folder.path(), &format!("check {name}")));
        assert!(said.contains(name) && said.contains(why), "{name}: {said}");
    }
    for (line, why) in [
        ("check walk.mot", "it is a motion, and a figure is needed"),
        ("check loads.xml", "loads.xml"),
        ("inverse walk.mot walk.mot", "it is a motion, and a figure is needed"),
        ("inverse subject.osim subject.osim", "a table is .csv, .mot or .sto"),
        ("inverse subject.osim note.txt", "a table is .csv, .mot or .sto"),
        ("inverse subject.osim walk.mot --external-loads walk.mot", "walk.mot"),
        ("inverse subject.osim walk.mot --external-loads subject.osim", "subject.osim"),
    ] {
        let said = refused(&solaris(folder.path(), line));
        assert!(said.contains(why), "{line}: {said}");
    }
    assert_eq!(names(folder.path()).len(), good.len() + 8, "nothing but these notes");
}

#[test]
fn a_motion_of_another_figure_is_not_converted_to_nothing() {
    let folder = subject();
    fs::copy(Path::new(crate::inverse::FIXTURES).join("figures/arm.urdf"), folder.path().join("arm.urdf"))
        .expect("copied");
    let said = refused(&solaris(folder.path(), "convert walk.mot x.csv --figure arm.urdf"));
    assert!(said.starts_with("error: walk.mot: ") && said.contains("'arm'"), "{said}");
    assert!(!folder.path().join("x.csv").exists());
}

/// A ball that falls, and a comment before it.
const BALL: &str = "<mujoco model=\"ball\"><worldbody><body name=\"b\"><freejoint/><geom size=\"0.1\"/></body></worldbody></mujoco>";

#[test]
fn an_xml_file_is_what_its_root_says() {
    let folder = subject();
    let model = crate::inverse::read(&folder.path().join("subject.osim"));
    write(folder.path(), "subject.xml", &model);
    write(folder.path(), "ball.xml", BALL);
    write(folder.path(), "comment.xml", &format!("<?xml version=\"1.0\"?>\n<!-- not a <robot> -->\n{BALL}"));
    let ball = "MuJoCo model 'ball'";
    for (file, kind) in
        [("subject.xml", "OpenSim model 'subject'"), ("ball.xml", ball), ("comment.xml", ball)]
    {
        let shown = crate::inverse::succeeded(&solaris(folder.path(), &format!("check {file}")));
        assert!(shown.starts_with(kind), "{file}: {shown}");
    }
}
