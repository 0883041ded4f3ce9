//! The chore that fuzzes every reader: the targets of `fuzz/`, one after the other, on what earlier runs found and on the seeds
//! that the project's own texts are.

mod literals;
mod seeds;

use crate::workspace::{root, run as run_command};
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// What is a hang (s), too much memory (MB), and the longest input (bytes).
const LIMITS: [&str; 3] = ["-timeout=10", "-rss_limit_mb=1024", "-max_len=65536"];

/// What the chore was asked.
pub(crate) struct Options {
    /// How long in all (minutes).
    minutes: f64,
    /// One target, instead of all.
    target: Option<String>,
}

impl Default for Options {
    fn default() -> Self {
        Self { minutes: 12.0, target: None }
    }
}

impl Options {
    /// Of the words after `fuzz`.
    pub(crate) fn parse(words: &[&str]) -> Result<Self, String> {
        let mut options = Self::default();
        let mut words = words.iter();
        while let Some(word) = words.next() {
            let value = words.next().ok_or_else(|| format!("{word} needs a value"))?;
            match *word {
                "--minutes" => {
                    let minutes = value.parse().ok().filter(|minutes| *minutes > 0.0);
                    options.minutes = minutes.ok_or_else(|| format!("--minutes {value} is no time"))?;
                }
                "--target" => options.target = Some((*value).to_owned()),
                _ => return Err(format!("fuzz has no option {word}; it has --minutes and --target")),
            }
        }
        Ok(options)
    }
}

/// Runs all targets, or the one that is asked; an error names those that found something. Where there is no nightly compiler
/// or no cargo-fuzz, it says so and does nothing.
pub(crate) fn run(options: &Options) -> Result<(), String> {
    if let Some(lacking) = lacking() {
        println!("fuzzing is skipped: {lacking}");
        return Ok(());
    }
    let all = targets()?;
    let chosen: Vec<String> = match &options.target {
        None => all,
        Some(target) if all.contains(target) => vec![target.clone()],
        Some(target) => return Err(format!("there is no target {target}; there are {}", all.join(", "))),
    };
    seeds::write(&folder())?;
    run_command(&mut fuzz("build"))?;
    let seconds = (60.0 * options.minutes / chosen.len() as f64).ceil();
    let mut failed = Vec::new();
    for target in &chosen {
        println!("fuzzing {target} for {seconds} s");
        let mut command = fuzz("run");
        // The seeds come second: what is new is kept in the first folder.
        command.args([
            target,
            &format!("fuzz/corpus/{target}"),
            &format!("fuzz/corpus/seeds/{target}"),
            "--",
        ]);
        command.args(LIMITS).arg(format!("-max_total_time={seconds}"));
        command.args([format!("-dict=fuzz/dictionaries/{target}"), "-print_final_stats=1".to_owned()]);
        if let Err(error) = run_command(&mut command) {
            failed.push(format!("{target}: {error}; the input is in fuzz/artifacts/{target}"));
        }
    }
    if failed.is_empty() { Ok(()) } else { Err(failed.join("\n")) }
}

/// What is missing, and how to get it.
fn lacking() -> Option<&'static str> {
    let starts = |words: &[&str]| {
        let mut command = Command::new("cargo");
        outside(&mut command).args(words).stdout(Stdio::null()).stderr(Stdio::null());
        command.status().is_ok_and(|status| status.success())
    };
    if !starts(&["+nightly", "--version"]) {
        Some("there is no nightly compiler (rustup toolchain install nightly)")
    } else if !starts(&["+nightly", "fuzz", "--version"]) {
        Some("there is no cargo-fuzz (cargo install cargo-fuzz)")
    } else {
        None
    }
}

/// A command of cargo-fuzz. The crates have no unsafe code, so that nothing is to be found by sanitizers.
fn fuzz(what: &str) -> Command {
    let mut command = Command::new("cargo");
    outside(&mut command).args(["+nightly", "fuzz", what, "--sanitizer", "none"]);
    command
}

/// What cargo says of itself to a chore would choose its own toolchain for the commands that it starts.
fn outside(command: &mut Command) -> &mut Command {
    command.current_dir(root()).env_remove("RUSTUP_TOOLCHAIN").env_remove("CARGO").env_remove("RUSTC")
}

fn folder() -> PathBuf {
    root().join("fuzz")
}

/// The targets: the files of their folder.
fn targets() -> Result<Vec<String>, String> {
    let files = std::fs::read_dir(folder().join("fuzz_targets")).map_err(|error| error.to_string())?;
    let stem = |file: std::fs::DirEntry| Some(file.path().file_stem()?.to_str()?.to_owned());
    let mut targets: Vec<String> = files.filter_map(|file| stem(file.ok()?)).collect();
    targets.sort();
    Ok(targets)
}
