//! The chore that holds the plug-in for Bevy: a workspace of its own, built beside the others.

use crate::workspace::{cargo, metadata, root, run as run_command};
use std::process::{Command, Stdio};

/// Formatting, lints, tests with examples, and documentation; skipped aloud where the engine's crates cannot be had.
pub(crate) fn run() -> Result<(), String> {
    let target = metadata()?.target_directory.join("bevy");
    let step = |words: &[&str]| {
        let mut command = cargo();
        command.current_dir(root().join("bevy")).env("CARGO_TARGET_DIR", &target).args(words);
        command
    };
    let mut fetch: Command = step(&["fetch", "--locked"]);
    if !fetch.stderr(Stdio::null()).status().is_ok_and(|status| status.success()) {
        println!("skipped: the crates of the engine Bevy cannot be had, or bevy/Cargo.lock is old");
        return Ok(());
    }
    run_command(&mut step(&["fmt", "--check"]))?;
    run_command(&mut step(&["clippy", "--all-targets", "--", "-D", "warnings"]))?;
    run_command(&mut step(&["test"]))?;
    run_command(step(&["doc", "--no-deps"]).env("RUSTDOCFLAGS", "-Dwarnings"))
}
