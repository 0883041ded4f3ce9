//! A million random walks in the thesis's style, too long for every `cargo test`: the ignored test of
//! `crates/gait/tests/gait/thesis_random.rs`.

use crate::workspace::cargo;

/// Runs it.
pub(crate) fn run() -> Result<(), String> {
    let test = ["test", "--release", "--package", "solaris-gait", "--tests", "a_million_requests"];
    cargo(&[&test[..], &["--", "--ignored", "--nocapture"]].concat())
}
