//! The chore for what is too long for every `cargo test`: ignored tests, the feature `stiff`, which takes two minutes to build, the C
//! interface under a sanitizer, and fuzzing.

use crate::fuzz;
use crate::workspace::{self, cargo};
use std::time::{Instant, SystemTime, UNIX_EPOCH};

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

/// Tests of the C interface, with its programs in C and C++, under the sanitizer of addresses: the library and they are watched by the same one.
fn addresses() -> Result<(), String> {
    if std::env::consts::OS != "linux" {
        println!("skipped: the sanitizer is tried on Linux only");
        return Ok(());
    }
    // With a target that is named, what runs while building is not watched. The compiler is the one that ships: it has the sanitizer, and hides it.
    let target = format!("{}-unknown-linux-gnu", std::env::consts::ARCH);
    let mut tests = cargo();
    // Programs of engines link the library as it ships, without the watcher.
    tests.args(["test", "--package", "solaris-ffi", "--lib", "--test", "calls", "--test", "c"]);
    tests.args(["--target", &target]);
    tests.args(["--target-dir", "target/watched"]);
    workspace::run(tests.env("RUSTC_BOOTSTRAP", "1").env("RUSTFLAGS", "-Zsanitizer=address"))
}

/// Runs all steps, whatever becomes of each; an error names those that failed.
pub(crate) fn run() -> Result<(), String> {
    let mut failed = Vec::new();
    // Every other run of the property tests draws the cases of the seed in `.cargo/config.toml`.
    let seed = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs()).to_string();
    println!("property tests draw their cases with PROPTEST_RNG_SEED={seed}");
    let mut step = |name: &str, step: &dyn Fn() -> Result<(), String>| {
        let begun = Instant::now();
        if let Err(error) = step() {
            failed.push(format!("{name}: {error}"));
        }
        println!("{name}: {:.0} s", begun.elapsed().as_secs_f64());
    };
    for (name, arguments) in STEPS {
        println!("{name}: cargo {}", arguments.join(" "));
        step(name, &|| workspace::run(cargo().args(arguments).env("PROPTEST_RNG_SEED", &seed)));
    }
    step("the C interface, every address watched", &addresses);
    step("fuzzing", &|| fuzz::run(&fuzz::Options::default()));
    if failed.is_empty() { Ok(()) } else { Err(failed.join("\n")) }
}
