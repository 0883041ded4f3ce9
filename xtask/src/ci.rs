//! Everything beside the tests that must pass before a change goes in, one step after another.

use crate::golden;
use crate::layers::{self, ROWS};
use crate::workspace::{self, cargo, metadata};
use std::time::Instant;

type Step = (String, Box<dyn FnOnce() -> Result<(), String>>);

/// Runs all steps with their names and times; the first that fails ends it.
pub(crate) fn run() -> Result<(), String> {
    let steps = steps()?;
    let count = steps.len();
    let start = Instant::now();
    for (i, (name, step)) in steps.into_iter().enumerate() {
        println!("[{}/{count}] {name}", i + 1);
        let begun = Instant::now();
        step().map_err(|error| format!("step '{name}': {error}"))?;
        println!("[{}/{count}] {name}: {:.1} s", i + 1, begun.elapsed().as_secs_f64());
    }
    println!("all {count} steps passed in {:.1} s", start.elapsed().as_secs_f64());
    Ok(())
}

fn steps() -> Result<Vec<Step>, String> {
    let mut steps = vec![
        cargo_step("formatting", &["fmt", "--all", "--", "--check"], &[]),
        // With the feature that `cargo test` leaves to `cargo xtask nightly`, so that what it adds compiles at least.
        cargo_step(
            "lints",
            &["clippy", "--workspace", "--all-targets", "--features", "stiff", "--", "-D", "warnings"],
            &[],
        ),
        ("layers".to_owned(), Box::new(layers::run) as Box<_>),
        ("golden runs".to_owned(), Box::new(|| golden::run(&golden::Options::default()))),
        cargo_step("documentation", &["doc", "--workspace", "--no-deps"], &[("RUSTDOCFLAGS", "-Dwarnings")]),
    ];
    let packages = metadata()?.packages;
    // From the innermost outwards, so that a break shows where it is. With several packages in one build cargo would
    // unite their features; alone, a crate must name all that it needs.
    for (name, _) in
        ROWS.iter().rev().filter(|(name, _)| packages.iter().any(|package| package.name == *name))
    {
        steps.push(cargo_step(&format!("{name} alone"), &["check", "--package", name], &[]));
    }
    // The curves serve where there is no standard library; their functions come from elsewhere there.
    let bare = ["--package", "solaris-profiles", "--no-default-features"];
    steps.push(cargo_step("solaris-profiles without std", &[&["check"][..], &bare].concat(), &[]));
    let reference = [&["test", "--test", "reference"][..], &bare].concat();
    steps.push(cargo_step("reference numbers without std", &reference, &[]));
    Ok(steps)
}

fn cargo_step(name: &str, args: &[&str], environment: &[(&str, &str)]) -> Step {
    let mut command = cargo();
    command.args(args).envs(environment.iter().copied());
    (name.to_owned(), Box::new(move || workspace::run(&mut command)))
}
