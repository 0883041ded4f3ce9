//! The program without any library of a system: one file, which runs where nothing else is.

use super::Done;
use super::packages::built_in;
use super::state::{State, listened, starts};
use crate::workspace::{cargo, root};
use std::fs;
use std::process::Command;

const TARGET: &str = "x86_64-unknown-linux-musl";

/// Compiles the program for Linux with its own C library, looks whether it names a loader, and runs it without an environment.
pub(super) fn check(state: &State) -> Result<Done, String> {
    if !cfg!(all(target_os = "linux", target_arch = "x86_64")) {
        return Ok(Done::Skipped("it would not run here: this is not Linux on x86-64".to_owned()));
    }
    let mut add = Command::new("rustup");
    if !starts(add.current_dir(root()).args(["target", "add", TARGET])) {
        return Ok(Done::Skipped(format!("rustup cannot add the target {TARGET}")));
    }
    let mut build = cargo();
    build.env("CARGO_TARGET_DIR", built_in(state));
    build.args(["build", "--release", "--quiet", "--locked", "--package", "solaris-cli", "--target", TARGET]);
    listened(&mut build)?;
    let program = built_in(state).join(TARGET).join("release/solaris");
    let bytes = fs::read(&program).map_err(|error| format!("{}: {error}", program.display()))?;
    if names_a_loader(&bytes)? {
        return Err(format!("{} asks for a loader, and so for libraries of the system", program.display()));
    }
    let told = listened(Command::new(&program).env_clear().current_dir(state.fresh("alone")?).arg("doctor"))?;
    let told = String::from_utf8_lossy(&told.stdout);
    if !told.contains(TARGET) {
        return Err(format!(
            "{} doctor does not say that it is built for {TARGET}:\n{told}",
            program.display()
        ));
    }
    Ok(Done::Holds(format!("one file of {} MB without a loader runs", bytes.len() / 1_000_000)))
}

/// Whether a program of 64 bits for Linux has the segment that names who loads its libraries (ELF-64: `PT_INTERP` is 3).
fn names_a_loader(bytes: &[u8]) -> Result<bool, String> {
    let number = |at: usize, length: usize| {
        let part = bytes.get(at..at + length).ok_or("the program is shorter than its own headers")?;
        Ok::<_, String>(part.iter().rev().fold(0, |sum, byte| sum << 8 | usize::from(*byte)))
    };
    if bytes.get(..5) != Some(b"\x7fELF\x02") {
        return Err("what was built is no program of 64 bits for Linux".to_owned());
    }
    let (first, size, count) = (number(0x20, 8)?, number(0x36, 2)?, number(0x38, 2)?);
    for i in 0..count {
        if number(first + i * size, 4)? == 3 {
            return Ok(true);
        }
    }
    Ok(false)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn this_test_s_own_program_has_a_loader_and_a_text_is_no_program() {
        if cfg!(all(target_os = "linux", target_env = "gnu", target_pointer_width = "64")) {
            let own = fs::read(std::env::current_exe().expect("its path")).expect("its bytes");
            assert_eq!(names_a_loader(&own), Ok(true));
            assert!(names_a_loader(&own[..0x40]).is_err());
        }
        assert!(names_a_loader(b"#!/bin/sh").is_err());
    }
}
