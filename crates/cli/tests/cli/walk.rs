//! The program as a whole: its files, its manners, its exit codes. What it prints stands in the transcripts.

mod agreement;
mod crowd;
mod everyone;
mod glb;
mod hints;
mod loops;
mod manners;
mod overlaps;
mod places;
mod sweep;

use std::path::Path;
use std::process::{Command, Output, Stdio};

/// Runs `solaris` in a folder, its outputs caught.
fn solaris(folder: &Path, args: &[&str]) -> Output {
    command(folder, args).output().expect("the program starts")
}

fn command(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_solaris"));
    command.current_dir(folder).args(args).stdin(Stdio::null());
    command
}

/// Standard error of a run that ended with exit code 1.
fn refused(output: &Output) -> String {
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{text}");
    text
}

fn succeeded(output: &Output) -> String {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!((output.status.code(), said.as_ref()), (Some(0), ""));
    String::from_utf8(output.stdout.clone()).expect("UTF-8")
}

/// Names in a folder, hidden ones too, sorted.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).expect("a file of text")
}
