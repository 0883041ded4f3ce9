//! The chore that counts which lines the tests run, by crate: compiled with the compiler's own counters, read by its own tools.
//!
//! Optimised, as counters keep what is called for every number from being inlined where it is not: tests take twenty times as long then.

use crate::workspace::{self, cargo};
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Kept beside the target folder's other builds: counters are compiled into everything.
const FOLDER: &str = "coverage";
/// So many files take the counts of one program, however often it is started.
const POOL: &str = "%4m.profraw";

/// What a file or a crate has, and what of it was run.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
struct Count {
    count: u64,
    covered: u64,
}

impl Count {
    fn add(&mut self, other: Self) {
        self.count += other.count;
        self.covered += other.covered;
    }

    fn percent(self) -> f64 {
        if self.count == 0 { 100.0 } else { 100.0 * self.covered as f64 / self.count as f64 }
    }
}

/// What `llvm-cov export` says, as far as it is read.
#[derive(Debug, Deserialize)]
struct Export {
    data: Vec<Data>,
}

#[derive(Debug, Deserialize)]
struct Data {
    files: Vec<File>,
}

#[derive(Debug, Deserialize)]
struct File {
    filename: PathBuf,
    summary: Summary,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
struct Summary {
    lines: Count,
    functions: Count,
}

/// A line of cargo's messages: what was compiled to be run.
#[derive(Debug, Deserialize)]
struct Artifact {
    executable: Option<PathBuf>,
}

/// Runs the tests of the packages that these arguments of `cargo test` choose, or of all, with counters, and prints a table by crate.
pub(crate) fn run(chosen: &[&str]) -> Result<(), String> {
    let tools = Tools::find()?;
    let folder = workspace::metadata()?.target_directory.join(FOLDER);
    let profiles = folder.join("profiles");
    // Counts of another build would be refused, or mixed in.
    if profiles.exists() {
        fs::remove_dir_all(&profiles).map_err(|error| format!("{}: {error}", profiles.display()))?;
    }
    let mut tests = counted(chosen, &folder, &profiles);
    tests.args(["--no-run", "--message-format", "json-render-diagnostics"]).stderr(Stdio::inherit());
    let compiled = tests.output().map_err(|error| format!("cargo test does not start: {error}"))?;
    if !compiled.status.success() {
        return Err(format!("the tests do not compile with counters ({})", compiled.status));
    }
    let programs = programs(&String::from_utf8_lossy(&compiled.stdout));
    // What failed has run all the same.
    let tested = workspace::run(counted(chosen, &folder, &profiles).arg("--no-fail-fast"));
    let export = tools.export(&profiles, &programs)?;
    print!("{}", table(&by_crate(&export, workspace::root())));
    tested
}

/// `cargo test` of what is chosen or of everything, compiled with counters.
fn counted(chosen: &[&str], folder: &Path, profiles: &Path) -> Command {
    let mut tests = cargo();
    tests.args(["test", "--release", "--tests", "--target-dir"]).arg(folder);
    tests.args(if chosen.is_empty() { &["--workspace"] } else { chosen });
    tests.env("RUSTFLAGS", "-C instrument-coverage").env("LLVM_PROFILE_FILE", profiles.join(POOL));
    tests
}

/// The programs among cargo's messages.
fn programs(messages: &str) -> BTreeSet<PathBuf> {
    let artifacts = messages.lines().filter_map(|line| serde_json::from_str::<Artifact>(line).ok());
    artifacts.filter_map(|artifact| artifact.executable).collect()
}

/// The toolchain's own programs that read counters.
struct Tools {
    folder: PathBuf,
}

impl Tools {
    fn find() -> Result<Self, String> {
        let said = |arguments: &[&str]| {
            let output = Command::new("rustc").current_dir(workspace::root()).args(arguments).output();
            let output = output.map_err(|error| format!("rustc does not start: {error}"))?;
            Ok::<_, String>(String::from_utf8_lossy(&output.stdout).into_owned())
        };
        let version = said(&["-vV"])?;
        let host = version.lines().find_map(|line| line.strip_prefix("host: "));
        let host = host.ok_or("rustc does not say its host")?;
        let folder =
            Path::new(said(&["--print", "sysroot"])?.trim()).join("lib/rustlib").join(host).join("bin");
        if folder.join("llvm-cov").exists() {
            Ok(Self { folder })
        } else {
            Err("coverage needs the compiler's tools: `rustup component add llvm-tools`".to_owned())
        }
    }

    /// All counts together, file by file.
    fn export(&self, profiles: &Path, programs: &BTreeSet<PathBuf>) -> Result<Export, String> {
        let merged = profiles.join("all.profdata");
        let mut merge = Command::new(self.folder.join("llvm-profdata"));
        merge.args(["merge", "--sparse", "--output"]).arg(&merged).arg(profiles);
        workspace::run(&mut merge)?;
        let mut export = Command::new(self.folder.join("llvm-cov"));
        export.args(["export", "--summary-only", "--instr-profile"]).arg(&merged);
        for program in programs {
            export.arg("--object").arg(program);
        }
        let output = export.output().map_err(|error| format!("llvm-cov does not start: {error}"))?;
        if !output.status.success() {
            return Err(format!("llvm-cov: {}", String::from_utf8_lossy(&output.stderr)));
        }
        serde_json::from_slice(&output.stdout).map_err(|error| format!("llvm-cov is not understood: {error}"))
    }
}

/// Sums of the sources of each crate; tests count nothing themselves.
fn by_crate(export: &Export, root: &Path) -> BTreeMap<String, Summary> {
    let mut crates = BTreeMap::<String, Summary>::new();
    for file in export.data.iter().flat_map(|data| &data.files) {
        let Some(name) = crate_of(&file.filename, root) else { continue };
        let sum = crates.entry(name).or_default();
        sum.lines.add(file.summary.lines);
        sum.functions.add(file.summary.functions);
    }
    crates
}

/// The crate whose source this is: `crates/NAME/src/…`, `lab/src/…`.
fn crate_of(file: &Path, root: &Path) -> Option<String> {
    let below = file.strip_prefix(root).ok()?;
    let (name, _) = below.to_str()?.split_once("/src/")?;
    Some(name.to_owned())
}

fn table(crates: &BTreeMap<String, Summary>) -> String {
    let row = |name: &str, sum: &Summary| {
        let [lines, functions] = [sum.lines, sum.functions].map(Count::percent);
        format!("| {name} | {} | {lines:.1} | {functions:.1} |\n", sum.lines.count)
    };
    let mut all = Summary::default();
    let mut text = "| crate | lines | run, % | functions, % |\n|---|--:|--:|--:|\n".to_owned();
    for (name, sum) in crates {
        text += &row(name, sum);
        all.lines.add(sum.lines);
        all.functions.add(sum.functions);
    }
    text + &row("all", &all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_are_summed_by_crate_and_tests_are_not() {
        let file = |name: &str, count, covered| File {
            filename: PathBuf::from(name),
            summary: Summary { lines: Count { count, covered }, functions: Count { count: 2, covered: 1 } },
        };
        let files = vec![
            file("/home/crates/gait/src/lib.rs", 10, 5),
            file("/home/crates/gait/src/smooth/style.rs", 30, 30),
            file("/home/crates/gait/tests/gait/main.rs", 100, 0),
            file("/home/lab/src/fit.rs", 4, 0),
            file("/elsewhere/serde/src/lib.rs", 50, 1),
        ];
        let crates = by_crate(&Export { data: vec![Data { files }] }, Path::new("/home"));
        assert_eq!(
            table(&crates),
            "| crate | lines | run, % | functions, % |\n|---|--:|--:|--:|\n\
             | crates/gait | 40 | 87.5 | 50.0 |\n| lab | 4 | 0.0 | 50.0 |\n| all | 44 | 79.5 | 50.0 |\n"
        );
    }

    #[test]
    fn programs_are_those_that_cargo_can_run() {
        let messages = r#"{"reason":"compiler-artifact","executable":null}
{"reason":"compiler-artifact","executable":"/target/debug/solaris"}
{"reason":"build-finished","success":true}"#;
        assert_eq!(programs(messages), BTreeSet::from([PathBuf::from("/target/debug/solaris")]));
    }
}
