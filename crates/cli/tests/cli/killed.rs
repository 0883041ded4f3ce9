//! Somebody who pulls the plug: whatever moment a run is killed at, a file is what it was or what it becomes, and what was reported is
//! there.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// What a run that nobody disturbs writes.
const NAMES: [&str; 3] = ["walk.csv", "walk.bvh", "walk.glb"];

fn walk(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_solaris"));
    command.args(["walk", "--steps", "4"]).args(NAMES.iter().flat_map(|name| ["-o", name]));
    command.current_dir(folder).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
    command
}

fn killed(moments: u32) {
    let folder = tempfile::tempdir().expect("a folder");
    let place = |name: &str| folder.path().join(name);
    let begun = Instant::now();
    assert!(walk(folder.path()).output().expect("it runs").status.success());
    // From early on towards where files are written, and then to and fro about it, however busy the machine is.
    let mut moment = 0.3 * begun.elapsed().as_secs_f64();
    let whole = NAMES.map(|name| fs::read(place(name)).expect("written"));
    let old = b"what was there before";
    let (mut kept, mut there) = (0, 0);
    for _ in 0..moments {
        for name in NAMES {
            fs::write(place(name), old).expect("written");
        }
        let mut run = walk(folder.path()).spawn().expect("it runs");
        std::thread::sleep(Duration::from_secs_f64(moment));
        run.kill().expect("killed, or done already");
        let told = run.wait_with_output().expect("its output").stdout;
        let told = String::from_utf8_lossy(&told);
        let before = there;
        for (name, whole) in NAMES.iter().zip(&whole) {
            let found = fs::read(place(name)).expect("a file is in its place at every moment");
            let is_new = found == *whole;
            assert!(is_new || found == old, "{name} is half a file after {moment} s");
            assert!(
                is_new || !told.contains(&format!("wrote {name}")),
                "{name} was reported after {moment} s"
            );
            if is_new { there += 1 } else { kept += 1 }
        }
        moment *= if there == before { 1.15 } else { 0.93 };
    }
    assert!(kept > 0 && there > 0, "{kept} files were as before, {there} new: no moment was within a run");
    // What is left under other names does not keep the next run from its work.
    assert!(walk(folder.path()).output().expect("it runs").status.success());
    NAMES
        .iter()
        .zip(&whole)
        .for_each(|(name, whole)| assert!(fs::read(place(name)).expect("there") == *whole));
}

#[test]
fn a_run_that_is_killed_leaves_no_half_file() {
    killed(20);
}

#[test]
#[ignore = "two minutes: cargo xtask nightly"]
fn a_run_that_is_killed_at_two_hundred_moments_leaves_no_half_file() {
    killed(200);
}
