//! Falls of many people, too long for every `cargo test`: the ignored tests of `crates/modes/tests/contact/people.rs`.

use crate::workspace::{self, cargo};

/// Runs them, and prints what they measured.
pub(crate) fn run() -> Result<(), String> {
    let test = ["test", "--release", "--package", "solaris-modes", "--test", "contact", "--", "people::"];
    // One after the other: each takes all cores.
    workspace::run(cargo().args(test).args(["--ignored", "--nocapture", "--test-threads", "1"]))
}
