//! A million random walks in the thesis's style, too long for every `cargo test`: the ignored test of
//! `crates/gait/tests/gait/thesis_random.rs`.

use crate::workspace::{self, cargo};

/// Runs it.
pub(crate) fn run() -> Result<(), String> {
    let test = ["test", "--release", "--package", "solaris-gait", "--test", "gait", "--", "thesis_random::"];
    workspace::run(cargo().args(test).args(["--ignored", "--nocapture"]))
}
