//! Chores of the workspace, run as `cargo xtask CHORE`: what must pass. Measurements stand in `lab`.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a chore talks to the person who runs it")]

mod bevy;
mod ci;
mod coverage;
mod fuzz;
mod golden;
mod instructions;
mod layers;
mod nightly;
mod numbers;
mod release;
mod studio;
mod workspace;

use std::process::ExitCode;

const HELP: &str = "\
cargo xtask CHORE

  bench [--peers] [FIGURE…]         times the kernel, a minute; --peers: beside other engines (`cargo lab bench`)
  bevy                              formatting, lints and tests of the plug-in for Bevy, a workspace of its own; skipped where the
                                    engine's crates cannot be had
  ci                                formatting, lints, layers, golden runs, documentation, every crate alone
  coverage [ARGUMENT…]              counts which lines the tests run, by crate, in an optimised build of its own; arguments of cargo test
                                    choose packages (-p solaris-model); needs the component llvm-tools
  fuzz [--minutes N] [--target T]   fuzzes every reader, 12 minutes in all, or one; needs a nightly compiler and cargo-fuzz
  golden [--bless] [--case NAME]    runs fixtures/golden/*/case.ron and compares, or rewrites what is expected
  instructions [--bless]            counts the instructions of the kernel's operations, and compares with fixtures/instructions.ron;
                                    skipped where there is no valgrind
  layers                            checks that crates use lower rows only and leave files, clocks and output alone
  nightly                           tests and sweeps too long for every `cargo test`, with the feature stiff, and fuzz: about an hour
  numbers [--all] [--bless DAY]     makes the numbers that pages state again, by docs/numbers.md, and fails where one is stale; --all: those that
                                    take minutes, too; --bless: writes the day into the rows that hold
  release [--only STEP] [--final]   a dry run of everything that a release is, step by step: versions, changelog, compiler,
                                    manifests, packages, licences, advisories, bill of materials, interface, the packages built, oldest
                                    versions, features; --final: asks what only the release itself must have
  studio [--quick]                  builds the studio, one page with the engine in it, which programs hold that are compiled afterwards;
                                    needs Node.js; --quick: not made small
  help                              this list

Measurements and what writes pages is `cargo lab`.
";

/// Chores that `cargo lab` has.
const MOVED: [&str; 6] = ["falls", "fit", "gaits", "peers", "report", "subject"];

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    let done = match args[..] {
        ["bevy"] => bevy::run(),
        ["ci"] => ci::run(),
        ["coverage", ref chosen @ ..] => coverage::run(chosen),
        ["fuzz", ref options @ ..] => fuzz::Options::parse(options).and_then(|options| fuzz::run(&options)),
        ["golden", ref options @ ..] => {
            golden::Options::parse(options).and_then(|options| golden::run(&options))
        }
        ["bench", ref options @ ..] => {
            workspace::run(workspace::cargo().args(["lab", "bench"]).args(options))
        }
        ["instructions", ref options @ ..] => {
            instructions::Options::parse(options).and_then(|options| instructions::run(&options))
        }
        ["layers"] => layers::run(),
        ["nightly"] => nightly::run(),
        ["numbers", ref options @ ..] => {
            numbers::Options::parse(options).and_then(|options| numbers::run(&options))
        }
        ["release", ref options @ ..] => {
            release::Options::parse(options).and_then(|options| release::run(&options))
        }
        ["studio", ref options @ ..] => studio::run(options),
        ["help" | "--help" | "-h"] => {
            print!("{HELP}");
            Ok(())
        }
        [chore, ..] if MOVED.contains(&chore) => {
            eprintln!("cargo xtask {0}: this is `cargo lab {0}` now", args.join(" "));
            return ExitCode::from(2);
        }
        _ => {
            eprint!("cargo xtask: no such chore: {}\n\n{HELP}", args.join(" "));
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
