//! The same command again: the same bytes in every format, on one thread as on several, and the same motion whatever else is written beside it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

fn fixture(name: &str) -> String {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures")).join(name).display().to_string()
}

/// All that a command writes, by name. What it prints has its run time.
fn all(arguments: &[&str], threads: &str) -> BTreeMap<PathBuf, Vec<u8>> {
    let folder = tempfile::tempdir().expect("a folder");
    let mut command = Command::new(env!("CARGO_BIN_EXE_solaris"));
    command.args(arguments).current_dir(folder.path()).env("RAYON_NUM_THREADS", threads).stdin(Stdio::null());
    let output = command.output().expect("it runs");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    let mut files = BTreeMap::new();
    gather(folder.path(), folder.path(), &mut files);
    files
}

fn gather(root: &Path, folder: &Path, files: &mut BTreeMap<PathBuf, Vec<u8>>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            gather(root, &path, files);
        } else {
            let name = path.strip_prefix(root).expect("below it").to_owned();
            files.insert(name, fs::read(&path).expect("a file"));
        }
    }
}

#[test]
fn runs_on_one_thread_and_on_several_write_the_same_bytes() {
    let [subject, walk, loads] =
        ["subject/subject.osim", "subject/walk.mot", "subject/loads.xml"].map(fixture);
    let scenes = ["pendulum", "jump", "walk_loose_arm"].map(|name| fixture(&format!("scenes/{name}.ron")));
    let out = ["-o", "m.csv", "-o", "m.html", "-o", "m.glb", "-o", "m.bvh"];
    let mut commands: Vec<Vec<&str>> = vec![
        [&["walk", "--steps", "4", "--variability", "1", "--seed", "5", "--json"][..], &out].concat(),
        [&["walk", "--gait", "run", "--steps", "6"][..], &out].concat(),
        [&["walk", "--stairs", "4"][..], &out].concat(),
        ["crowd", "--count", "3", "-o", "crowd"].to_vec(),
        [
            "inverse",
            &subject,
            &walk,
            "--external-loads",
            &loads,
            "--filter",
            "6Hz",
            "-o",
            "m.sto",
            "-o",
            "m.html",
        ]
        .to_vec(),
        ["gait", "set", "-o", "set.glb"].to_vec(),
    ];
    commands.extend(scenes.iter().map(|scene| ["run", scene, "-o", "m.csv", "-o", "m.html"].to_vec()));
    for arguments in commands {
        let [one, several] = ["1", "4"].map(|threads| all(&arguments, threads));
        assert!(!one.is_empty(), "{arguments:?} writes nothing");
        assert_eq!(one.keys().collect::<Vec<_>>(), several.keys().collect::<Vec<_>>());
        for (name, bytes) in one {
            assert!(bytes == several[&name], "{arguments:?}: {} differs", name.display());
        }
    }
}

#[test]
fn a_file_does_not_depend_on_what_is_written_beside_it() {
    let walk = ["walk", "--steps", "4"];
    let formats = ["m.csv", "m.html", "m.glb", "m.bvh", "m.usda"];
    let together: Vec<&str> = walk.into_iter().chain(formats.iter().flat_map(|name| ["-o", name])).collect();
    let together = all(&together, "2");
    for name in formats {
        let alone = all(&[&walk[..], &["-o", name]].concat(), "2");
        assert!(alone[Path::new(name)] == together[Path::new(name)], "{name}");
    }
}
