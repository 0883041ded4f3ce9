//! Falls of many people, too long for every `cargo test`: the ignored tests of `crates/modes/tests/modes/contact/people.rs`.

use crate::workspace::cargo;

/// Runs them, and prints what they measured.
pub(crate) fn run() -> Result<(), String> {
    let test = ["test", "--release", "--package", "solaris-modes", "--tests", "people::"];
    // One after the other: each takes all cores.
    cargo(&[&test[..], &["--", "--ignored", "--nocapture", "--test-threads", "1"]].concat())
}
