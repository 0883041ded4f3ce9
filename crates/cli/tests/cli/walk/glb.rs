//! `-o x.glb` from outside: what the file says of itself.

use crate::walk::{names, refused, solaris, succeeded};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// The JSON part of a file, whose header must be right.
fn json(path: &Path) -> Value {
    let bytes = fs::read(path).expect("a file");
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes")) as usize;
    assert_eq!((&bytes[..4], word(4), word(8)), (&b"glTF"[..], 2, bytes.len()));
    assert_eq!(&bytes[16..20], b"JSON");
    serde_json::from_slice(&bytes[20..20 + word(12)]).expect("JSON")
}

/// The greatest time of an animation's keys (s).
fn end(json: &Value, animation: usize) -> f64 {
    let samplers = json["animations"][animation]["samplers"].as_array().expect("samplers");
    let input = |sampler: &Value| sampler["input"].as_u64().expect("an index") as usize;
    let ends =
        samplers.iter().map(|sampler| json["accessors"][input(sampler)]["max"][0].as_f64().expect("a time"));
    ends.fold(0.0, f64::max)
}

fn count(json: &Value, key: &str) -> usize {
    json[key].as_array().map_or(0, Vec::len)
}

#[test]
fn a_walk_is_a_body_and_an_animation() {
    let folder = tempfile::tempdir().expect("a folder");
    succeeded(&solaris(folder.path(), &["walk", "--steps", "2", "-o", "walk.glb"]));
    let json = json(&folder.path().join("walk.glb"));
    assert_eq!([count(&json, "skins"), count(&json, "meshes"), count(&json, "animations")], [1; 3]);
    // 21 links, the figure, the skin.
    assert_eq!(count(&json, "nodes"), 23);
    assert_eq!(json["animations"][0]["name"], "walk");
    let events = json["animations"][0]["extras"]["events"].as_array().expect("events");
    assert!(events.iter().any(|event| event["kind"] == "touch-down" && event["link"] == "left_foot"));
}

#[test]
fn a_loop_ends_where_its_first_frame_comes_again() {
    let folder = tempfile::tempdir().expect("a folder");
    succeeded(&solaris(
        folder.path(),
        &["walk", "--loop", "in-place", "--rate", "30", "-o", "a.glb", "-o", "a.bvh"],
    ));
    let frames = fs::read_to_string(folder.path().join("a.bvh")).expect("a file");
    let frames: f64 = frames
        .lines()
        .find_map(|line| line.strip_prefix("Frames: "))
        .expect("frames")
        .parse()
        .expect("a number");
    let end = end(&json(&folder.path().join("a.glb")), 0);
    assert!((end - frames / 30.0).abs() < 1e-6, "{end} s and {frames} frames");
}

#[test]
fn a_crowd_is_one_file_or_one_each() {
    let folder = tempfile::tempdir().expect("a folder");
    let crowd =
        |more: &[&str]| solaris(folder.path(), &[&["crowd", "--count", "3", "--rate", "24"], more].concat());
    succeeded(&crowd(&["-o", "all.glb"]));
    let all = json(&folder.path().join("all.glb"));
    assert_eq!([count(&all, "skins"), count(&all, "animations")], [3, 1]);
    succeeded(&crowd(&["-o", "each", "--format", "glb"]));
    assert_eq!(
        names(&folder.path().join("each")),
        ["crowd.csv", "person-0001.glb", "person-0002.glb", "person-0003.glb"]
    );
    let odd = crowd(&["-o", "all.glb", "--format", "csv"]);
    let error = String::from_utf8_lossy(&odd.stderr).into_owned();
    assert_eq!(odd.status.code(), Some(2), "{error}");
    assert!(
        error.contains("--format says what the files of a folder are; -o all.glb is one file"),
        "{error}"
    );
    let many = solaris(folder.path(), &["crowd", "--count", "501", "-o", "many.glb"]);
    assert!(refused(&many).contains("501 people in one file; it takes 500 at most"));
}

#[test]
fn any_motion_of_any_figure_becomes_one() {
    let folder = tempfile::tempdir().expect("a folder");
    succeeded(&solaris(folder.path(), &["walk", "--steps", "2", "--rate", "30", "-o", "walk.bvh"]));
    succeeded(&solaris(folder.path(), &["convert", "walk.bvh", "again.glb"]));
    let again = json(&folder.path().join("again.glb"));
    assert_eq!((count(&again, "skins"), &again["animations"][0]["name"]), (1, &Value::from("walk")));
}

#[test]
fn bones_are_those_of_the_rig_that_is_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let walk = |more: &[&str]| solaris(folder.path(), &[&["walk", "--steps", "2"], more].concat());
    succeeded(&walk(&["--rig", "mixamo", "-o", "a.glb", "-o", "a.bvh"]));
    let file = json(&folder.path().join("a.glb"));
    let nodes = file["nodes"].as_array().expect("nodes");
    assert!(nodes.iter().any(|node| node["name"] == "mixamorig:LeftUpLeg"));
    assert!(!nodes.iter().any(|node| node["name"] == "left_thigh"));
    let text = fs::read_to_string(folder.path().join("a.bvh")).expect("a file");
    assert!(text.starts_with("HIERARCHY\nROOT mixamorig:Hips\n"));
    for (more, why) in [
        (["--rig", "vrm", "-o", "a.csv"], "add -o x.glb or -o x.bvh"),
        (
            ["--rig", "biped", "-o", "b.glb"],
            "it must be mixamo, vrm, unreal, unity, smpl, cmu or a .ron file",
        ),
    ] {
        let odd = walk(&more);
        let error = String::from_utf8_lossy(&odd.stderr).into_owned();
        assert_eq!(odd.status.code(), Some(2), "{error}");
        assert!(error.contains(why), "{error}");
    }
}

#[test]
fn bones_of_a_map_are_in_all_files_and_those_of_vrm_are_said() {
    let folder = tempfile::tempdir().expect("a folder");
    let walk = |more: &[&str]| solaris(folder.path(), &[&["walk", "--steps", "2"], more].concat());
    let map = |text: &str| fs::write(folder.path().join("map.ron"), text).expect("written");
    map("Rig(rest: T, bones: {\"pelvis\": \"Root_M\", \"left_thigh\": \"Hip_L\"})");
    succeeded(&walk(&["--rig", "map.ron", "-o", "a.glb", "-o", "a.bvh", "-o", "a.usda"]));
    let file = json(&folder.path().join("a.glb"));
    assert!(file["nodes"].as_array().expect("nodes").iter().any(|node| node["name"] == "Hip_L"));
    assert!(file.get("extensions").is_none());
    for (name, bone) in [("a.bvh", "JOINT Hip_L"), ("a.usda", "\"Root_M/Hip_L\"")] {
        assert!(fs::read_to_string(folder.path().join(name)).expect("a file").contains(bone), "{name}");
    }
    map("Rig(rest: T,\n    bones: {\"pelvs\": \"Root_M\"})");
    let odd = walk(&["--rig", "map.ron", "-o", "b.glb"]);
    let error = String::from_utf8_lossy(&odd.stderr).into_owned();
    assert_eq!(odd.status.code(), Some(1), "{error}");
    assert!(error.contains("map.ron") && error.contains("did you mean 'pelvis'?"), "{error}");
    succeeded(&walk(&["--rig", "vrm", "-o", "c.glb"]));
    let vrm = &json(&folder.path().join("c.glb"))["extensions"]["VRMC_vrm"];
    assert!(vrm["humanoid"]["humanBones"]["upperChest"]["node"].is_number());
}
