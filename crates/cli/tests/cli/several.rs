//! Several figures of a scene in one animation file: people with a skin of their own, on a rig's bones where that is asked.

use std::fs;
use std::path::Path;
use std::process::Command;

/// The JSON of a binary glTF.
fn document(path: &Path) -> serde_json::Value {
    let bytes = fs::read(path).expect("written");
    let length = u32::from_le_bytes(bytes[12..16].try_into().expect("four bytes")) as usize;
    serde_json::from_slice(&bytes[20..20 + length]).expect("JSON")
}

#[test]
fn people_of_a_scene_have_their_skins() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/scenes/crossing.ron");
    for (rig, hips) in [(None, "pelvis"), (Some("mixamo"), "mixamorig:Hips")] {
        let path = folder.path().join("crossing.glb");
        let mut command = Command::new(env!("CARGO_BIN_EXE_solaris"));
        command.arg("run").arg(&scene).arg("-o").arg(&path).args(rig.iter().flat_map(|rig| ["--rig", rig]));
        let output = command.output().expect("it starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let file = document(&path);
        let list = |key: &str| file[key].as_array().map_or(0, Vec::len);
        assert_eq!((list("skins"), list("animations")), (4, 1), "{rig:?}");
        let names: Vec<&str> = file["nodes"]
            .as_array()
            .expect("nodes")
            .iter()
            .filter_map(|node| node["name"].as_str())
            .collect();
        for name in ["ann", "bob", "gate", "ball", "leaf"] {
            assert!(names.contains(&name), "{name} of {names:?}");
        }
        assert_eq!(names.iter().filter(|name| **name == hips).count(), 2);
        // A person's skin has thousands of vertices, a leaf of a gate hundreds at most.
        let counts = file["meshes"].as_array().expect("meshes").iter().map(|mesh| {
            let position = mesh["primitives"][0]["attributes"]["POSITION"].as_u64().expect("an accessor");
            file["accessors"][position as usize]["count"].as_u64().expect("a count")
        });
        assert_eq!(counts.filter(|count| *count > 3000).count(), 2, "{rig:?}");
    }
}
