//! A disk that is full: an error that names the file, and nothing new on it.
//!
//! Needs a disk of its own: a `tmpfs` is mounted where that is allowed (Linux, root), else the tests say that they are
//! skipped.
#![cfg(target_os = "linux")]

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A small disk, unmounted when it is dropped.
struct SmallDisk(tempfile::TempDir);

impl SmallDisk {
    fn of(size: &str) -> Option<Self> {
        let folder = tempfile::tempdir().expect("a folder");
        let options = format!("size={size}");
        let mounted = Command::new("mount")
            .args(["-t", "tmpfs", "-o", &options, "tmpfs"])
            .arg(folder.path())
            .output()
            .is_ok_and(|output| output.status.success());
        if mounted {
            return Some(Self(folder));
        }
        // Past the harness, which catches what is printed.
        let _ =
            writeln!(std::io::stderr(), "skipped: disk_full needs a tmpfs, and mounting is not allowed here");
        None
    }

    fn path(&self) -> &Path {
        self.0.path()
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.path()).expect("a folder");
        let mut names: Vec<String> = entries
            .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }
}

impl Drop for SmallDisk {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(self.path()).status();
    }
}

fn walk(paths: &[PathBuf]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_solaris"));
    command.args(["walk", "--steps", "2"]);
    for path in paths {
        let is_report = path.extension().is_some_and(|extension| extension == "json");
        command.arg(if is_report { "--report" } else { "-o" }).arg(path);
    }
    command.output().expect("the program starts")
}

/// Checks that `output` is an error about the file at `path`.
fn is_full(output: &Output, path: &Path) {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    let named = format!(" {}: ", path.display());
    assert!(said.contains(&named) && said.contains("No space left on device"), "{said}");
    assert!(output.stdout.is_empty(), "no table of a walk that is not written");
}

#[test]
fn each_kind_of_file_on_a_full_disk_leaves_nothing() {
    let Some(disk) = SmallDisk::of("256k") else { return };
    for name in ["walk.csv", "walk.html"] {
        let path = disk.path().join(name);
        is_full(&walk(std::slice::from_ref(&path)), &path);
        assert!(disk.names().is_empty(), "{:?}", disk.names());
    }
    // What is small enough to fit a buffer fails when it is flushed.
    fs::write(disk.path().join("filler"), vec![0; 256 * 1024]).expect("it fits");
    for name in ["walk.bvh", "walk.json"] {
        let path = disk.path().join(name);
        is_full(&walk(std::slice::from_ref(&path)), &path);
        assert_eq!(disk.names(), ["filler"]);
    }
}

#[test]
fn what_was_there_stays_as_it_was() {
    let Some(disk) = SmallDisk::of("256k") else { return };
    let old = disk.path().join("walk.csv");
    fs::write(&old, "old").expect("written");
    is_full(&walk(std::slice::from_ref(&old)), &old);
    assert_eq!(
        (disk.names(), fs::read_to_string(&old).expect("there")),
        (vec!["walk.csv".to_owned()], "old".into())
    );
}

#[test]
fn files_on_another_disk_are_not_written_either() {
    let Some(disk) = SmallDisk::of("256k") else { return };
    let roomy = tempfile::tempdir().expect("a folder");
    fs::write(roomy.path().join("walk.bvh"), "old").expect("written");
    let full = disk.path().join("walk.html");
    is_full(&walk(&[roomy.path().join("walk.bvh"), roomy.path().join("walk.csv"), full.clone()]), &full);
    let left: Vec<_> =
        fs::read_dir(roomy.path()).expect("a folder").flatten().map(|e| e.file_name()).collect();
    assert_eq!(left, ["walk.bvh"]);
    assert_eq!(fs::read_to_string(roomy.path().join("walk.bvh")).expect("there"), "old");
    assert!(disk.names().is_empty());
}

#[test]
fn a_disk_with_room_takes_them() {
    // The control: on such a disk the same walk is written when there is room.
    let Some(disk) = SmallDisk::of("16m") else { return };
    let output = walk(&["walk.csv", "walk.html", "walk.bvh", "walk.json"].map(|name| disk.path().join(name)));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(disk.names(), ["walk.bvh", "walk.csv", "walk.html", "walk.json"]);
}
