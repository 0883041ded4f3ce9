//! Files as people have them.

use solaris_files::{FileError, Language, body, body_in, language, motion, scene};
use std::fs;
use std::path::Path;

fn repository(path: &str) -> std::path::PathBuf {
    Path::new("../..").join(path)
}

#[test]
fn xml_is_told_by_its_first_element() {
    let folder = tempfile::tempdir().expect("a folder");
    let urdf = fs::read_to_string(repository("fixtures/figures/arm.urdf")).expect("read");
    let path = folder.path().join("arm.xml");
    fs::write(
        &path,
        format!("\u{feff}<!-- <mujoco> -->\n{}", urdf.trim_start_matches("<?xml version=\"1.0\"?>")),
    )
    .expect("written");
    assert_eq!(language(&path), Some(Language::Urdf));
    assert_eq!(body(&path).expect("a robot").language, Language::Urdf);
    fs::write(&path, "<svg/>").expect("written");
    let why = body(&path).expect_err("a picture").to_string();
    assert!(why.contains("neither a MuJoCo model"), "{why}");
}

#[test]
fn a_fault_comes_with_its_text_and_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("bad.ron");
    fs::write(&path, "Figure(\n  version: 1,\n  nam: \"x\",\n)").expect("written");
    let FileError::Text { text, faults, .. } = body(&path).expect_err("a fault") else { panic!("no text") };
    assert!(text.contains("nam"));
    assert!(
        faults.faults.iter().any(|fault| fault.place.line == 3 && fault.message.contains("nam")),
        "{faults}"
    );
}

#[test]
fn a_scene_tells_what_it_was_read_from() {
    let folder = tempfile::tempdir().expect("a folder");
    let arm = fs::read(repository("fixtures/figures/arm.urdf")).expect("read");
    fs::write(folder.path().join("arm.urdf"), arm).expect("written");
    let path = folder.path().join("s.ron");
    fs::write(&path, "Scene(version: 1, figures: {\"it\": File(\"arm.urdf\")}, duration: 1.0)")
        .expect("written");
    let loaded = scene(&path).expect("a scene");
    assert_eq!(loaded.reads, [path.clone(), folder.path().join("arm.urdf")]);
    let why = scene(&folder.path().join("arm.urdf")).expect_err("a figure").to_string();
    assert!(why.contains("it is a figure (URDF)"), "{why}");
}

#[test]
fn what_is_not_there_or_elsewhere_is_refused_by_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let missing = body(&folder.path().join("none.urdf")).expect_err("nothing").to_string();
    assert!(missing.ends_with("none.urdf: there is no such file"), "{missing}");
    let inside = body(folder.path()).expect_err("a folder").to_string();
    assert!(inside.contains("it is a folder; name a file"), "{inside}");
    let arm = repository("fixtures/figures/arm.urdf");
    let figure = body(&arm).expect("a robot").figure;
    let why = motion(&arm, &figure).expect_err("no motion").to_string();
    assert!(why.contains("a table is .csv, .mot or .sto"), "{why}");
    let mjcf = folder.path().join("m.xml");
    fs::write(&mjcf, "<mujoco><worldbody/></mujoco>").expect("written");
    let elsewhere = body_in(&mjcf, Some(&repository("fixtures"))).expect_err("another folder");
    assert!(matches!(elsewhere, FileError::Folder { .. }), "{elsewhere}");
}

#[test]
fn a_clip_needs_tell_of_what_follows_it_alone() {
    let folder = std::env::temp_dir().join(format!("solaris-clip-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    fs::write(folder.join("nod.csv"), "time,neck.rx.q\n0,0\n0.5,0.2\n1,0\n").expect("a motion");
    let text = |dofs: &str| {
        format!(
            "Scene(version: 1, figures: {{\"ann\": Human(height: 1.7, mass: 60)}}, duration: 1.0, \
             clip: Clip(file: \"nod.csv\"{dofs}))"
        )
    };
    let path = folder.join("nod.ron");
    fs::write(&path, text(", dofs: [\"neck.rx\"]")).expect("a scene");
    let nods = scene(&path).expect("a scene whose person nods").scene;
    let motion = nods.simulation().run(&nods.settings().clone()).expect("a run").motion;
    let layout = nods.figure().layout();
    let neck = layout.dof_index("neck.rx").and_then(|dof| layout.coordinate(dof)).expect("a neck");
    let middle = motion.q(motion.len() / 2)[neck];
    assert!((middle - 0.2).abs() < 1e-12, "{middle}");
    // Nothing is left out of what does follow it.
    fs::write(&path, text(", dofs: [\"neck.*\"]")).expect("a scene");
    let refused = scene(&path).expect_err("no 'neck.ry'").to_string();
    let has = |word: &str| refused.contains(word);
    assert!(
        has("neck.ry.q") && has("neck.rz.q") && !has("thorax") && has("or name what it moves"),
        "{refused}"
    );
    fs::remove_dir_all(&folder).expect("it was made above");
}
