//! Instructions that the kernel takes, counted by valgrind: what no noise bends, compared with what they were.
//!
//! A program that calls a kernel twice as often executes so many more instructions; what it does besides falls out.

use crate::workspace::{self, cargo};
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// How far a count may be from what it was.
const TOLERANCE: f64 = 0.02;
/// How often a kernel is called, and then twice as often.
const CALLS: u64 = 50;
/// The counts, by kernel.
const FILE: &str = "fixtures/instructions.ron";

type Counts = BTreeMap<String, u64>;

/// What `cargo xtask instructions` was asked.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Options {
    bless: bool,
}

impl Options {
    pub(crate) fn parse(args: &[&str]) -> Result<Self, String> {
        match args {
            [] => Ok(Self { bless: false }),
            ["--bless"] => Ok(Self { bless: true }),
            [other, ..] => Err(format!("instructions: unknown option '{other}'; there is --bless")),
        }
    }
}

/// Counts and compares, or rewrites what is expected; skipped aloud where nothing can be counted.
pub(crate) fn run(options: &Options) -> Result<(), String> {
    let path = workspace::root().join(FILE);
    if !cfg!(all(target_arch = "x86_64", target_os = "linux")) {
        println!("skipped: instructions are counted on x86-64 under linux");
        return Ok(());
    }
    if Command::new("valgrind").arg("--version").stdout(Stdio::null()).status().is_err() {
        println!("skipped: instructions are counted by valgrind, and there is none");
        return Ok(());
    }
    let text = fs::read_to_string(&path).map_err(|error| format!("{FILE}: {error}"))?;
    let expected: Counts = ron::from_str(&text).map_err(|error| format!("{FILE}:{error}"))?;
    let program = build()?;
    let mut counts = Counts::new();
    for kernel in expected.keys() {
        let [once, twice] = [CALLS, 2 * CALLS].map(|calls| count(&program, kernel, calls));
        counts.insert(kernel.clone(), (twice? - once?) / CALLS);
    }
    if options.bless {
        let lines = counts.iter().map(|(kernel, count)| format!("    {kernel:?}: {count},\n"));
        let text = format!(
            "// Instructions of one call: `cargo xtask instructions --bless`.\n{{\n{}}}\n",
            lines.collect::<String>()
        );
        println!("writing {FILE}");
        return fs::write(&path, text).map_err(|error| format!("{FILE}: {error}"));
    }
    let (lines, faults) = compare(&expected, &counts);
    println!("{}", lines.join("\n"));
    if faults == 0 {
        return Ok(());
    }
    Err(format!(
        "{faults} of {} kernels take other counts of instructions than {FILE} says, by more than {} %; where that is meant, \
         `cargo xtask instructions --bless`",
        expected.len(),
        100.0 * TOLERANCE
    ))
}

/// A line for each kernel, and how many are beyond the tolerance.
fn compare(expected: &Counts, found: &Counts) -> (Vec<String>, usize) {
    let mut faults = 0;
    let line = |(kernel, expected): (&String, &u64)| {
        let found = found.get(kernel).copied().unwrap_or_default();
        let change = found as f64 / *expected as f64 - 1.0;
        let is_beyond = change.abs() > TOLERANCE;
        faults += usize::from(is_beyond);
        let mark = if is_beyond { "  <-- beyond" } else { "" };
        format!("{kernel:<34} {found:>9} instructions, {:+.2} %{mark}", 100.0 * change)
    };
    let lines = expected.iter().map(line).collect();
    (lines, faults)
}

/// Compiles the program that calls kernels; where it is.
fn build() -> Result<PathBuf, String> {
    // In the instructions that every machine has, but for batches, which are told what to take: the same counts everywhere.
    let args = "bench --package solaris-dynamics --no-default-features --features batch --bench calls --no-run --message-format json";
    let output = cargo()
        .args(args.split(' '))
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| format!("cargo does not start: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout);
    let executable = |line: &str| {
        let message: serde_json::Value = serde_json::from_str(line).ok()?;
        let is_it = message["target"]["name"] == "calls";
        message["executable"].as_str().filter(|_| is_it).map(PathBuf::from)
    };
    let found = text.lines().find_map(executable).filter(|_| output.status.success());
    found.ok_or_else(|| "the benchmark 'calls' of solaris-dynamics does not compile".to_owned())
}

/// The instructions of a run with so many calls.
fn count(program: &PathBuf, kernel: &str, calls: u64) -> Result<u64, String> {
    let output = Command::new("valgrind")
        .args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"])
        .arg(program)
        .args([kernel, &calls.to_string()])
        .output()
        .map_err(|error| format!("valgrind: {error}"))?;
    let text = String::from_utf8_lossy(&output.stderr);
    let number = |line: &str| {
        let (_, number) = line.split_once("refs:")?;
        number.trim().replace(',', "").parse().ok()
    };
    let counted = text.lines().filter(|line| line.contains(" I ")).find_map(number);
    counted
        .filter(|_| output.status.success())
        .ok_or_else(|| format!("{kernel}: valgrind counts nothing:\n{text}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_percent_are_let_pass() {
        let counts = |numbers: [u64; 3]| -> Counts {
            ["a", "b", "c"].iter().map(|name| (*name).to_owned()).zip(numbers).collect()
        };
        let (lines, faults) = compare(&counts([1000, 1000, 1000]), &counts([1019, 979, 1000]));
        assert_eq!(faults, 1);
        assert!(lines[1].ends_with("979 instructions, -2.10 %  <-- beyond"), "{}", lines[1]);
        let (_, faults) = compare(&counts([1000, 1000, 1000]), &Counts::new());
        assert_eq!(faults, 3);
    }

    #[test]
    fn options_are_read() {
        assert_eq!(Options::parse(&["--bless"]), Ok(Options { bless: true }));
        assert!(Options::parse(&["--fast"]).is_err_and(|error| error.contains("--bless")));
    }
}
