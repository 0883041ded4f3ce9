//! The chore for what is too long for every `cargo test`: ignored tests, the feature `stiff`, which takes two minutes to build, and
//! fuzzing.

use crate::fuzz;
use crate::workspace::{self, cargo};
use std::time::Instant;

/// The steps: their names, the arguments of `cargo`.
const STEPS: [(&str, &[&str]); 3] = [
    (
        "ignored tests",
        // One after the other: the long ones take all cores by themselves.
        &[
            "test",
            "--release",
            "--workspace",
            "--tests",
            "--no-fail-fast",
            "--",
            "--ignored",
            "--nocapture",
            "--test-threads",
            "1",
        ],
    ),
    (
        "steppers that choose their steps",
        &["test", "--release", "--workspace", "--no-fail-fast", "--features", "stiff"],
    ),
    (
        "the tables of those steppers",
        &[
            "test",
            "--release",
            "--package",
            "solaris-lab",
            "--features",
            "stiff",
            "--",
            "--ignored",
            "simulation::",
        ],
    ),
];

/// Runs all steps, whatever becomes of each; an error names those that failed.
pub(crate) fn run() -> Result<(), String> {
    let mut failed = Vec::new();
    let mut step = |name: &str, step: &dyn Fn() -> Result<(), String>| {
        let begun = Instant::now();
        if let Err(error) = step() {
            failed.push(format!("{name}: {error}"));
        }
        println!("{name}: {:.0} s", begun.elapsed().as_secs_f64());
    };
    for (name, arguments) in STEPS {
        println!("{name}: cargo {}", arguments.join(" "));
        step(name, &|| workspace::run(cargo().args(arguments)));
    }
    step("fuzzing", &|| fuzz::run(&fuzz::Options::default()));
    if failed.is_empty() { Ok(()) } else { Err(failed.join("\n")) }
}
