//! The oldest versions that the manifests allow: of what we name ourselves, in a copy of the workspace.

use super::Done;
use super::packages::built_in;
use super::state::{State, listened, outside, starts};
use crate::workspace::{cargo, root};
use std::fs;
use std::path::Path;
use std::process::Command;

/// Resolves downwards by a nightly cargo, checks by ours.
pub(super) fn check(state: &State) -> Result<Done, String> {
    if !starts(outside(root()).args(["+nightly", "--version"])) {
        return Ok(Done::Skipped("there is no nightly cargo (rustup toolchain install nightly)".to_owned()));
    }
    let folder = state.fresh("minimal")?;
    copy(&folder)?;
    listened(outside(&folder).args(["+nightly", "update", "--quiet", "-Z", "direct-minimal-versions"]))?;
    let mut command = cargo();
    command.current_dir(&folder).env("CARGO_TARGET_DIR", built_in(state));
    command.args(["check", "--workspace", "--quiet", "--locked", "--keep-going"]);
    // What only measures or runs chores is not published.
    listened(command.args(["--exclude", "solaris-lab", "--exclude", "xtask"]))?;
    Ok(Done::Holds("all compiles with the oldest versions that its manifests allow".to_owned()))
}

/// What git knows or would add, without what is no part of the workspace.
fn copy(folder: &Path) -> Result<(), String> {
    let files = listened(Command::new("git").current_dir(root()).args([
        "ls-files",
        "-z",
        "--cached",
        "--others",
        "--exclude-standard",
        "--",
        "Cargo.toml",
        "Cargo.lock",
        "README.md",
        "rust-toolchain.toml",
        "crates",
        "lab",
        "xtask",
        "docs",
        "studio/dist",
    ]))?;
    let files = String::from_utf8(files.stdout).map_err(|error| error.to_string())?;
    for file in files.split('\0').filter(|file| !file.is_empty()) {
        let (from, to) = (root().join(file), folder.join(file));
        // Deleted, and not committed yet.
        if !from.is_file() {
            continue;
        }
        let inside = to.parent().unwrap_or(folder);
        let copied = fs::create_dir_all(inside).and_then(|()| fs::copy(&from, &to));
        copied.map_err(|error| format!("{file}: {error}"))?;
    }
    Ok(())
}
