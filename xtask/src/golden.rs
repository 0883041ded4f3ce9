//! Golden runs: whole motions from the command line, compared with what they were, column by column.
//!
//! Each folder of `fixtures/golden` is a case: `case.ron` says what to run and how exactly to compare (see
//! [`case::Case`]), `expected.csv` holds the numbers. `--bless` writes them anew; read the difference before committing it.

mod case;
mod compare;
mod table;

use crate::workspace::{self, cargo, metadata, run as run_command};
use case::Case;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use table::Table;

/// What `cargo xtask golden` was asked.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Options {
    bless: bool,
    case: Option<String>,
}

impl Options {
    pub(crate) fn parse(args: &[&str]) -> Result<Self, String> {
        let mut options = Self::default();
        let mut args = args.iter();
        while let Some(arg) = args.next() {
            match *arg {
                "--bless" => options.bless = true,
                "--case" => {
                    let name = args.next().ok_or("--case needs the name of a folder in fixtures/golden")?;
                    options.case = Some((*name).to_owned());
                }
                other => {
                    return Err(format!(
                        "golden: unknown option '{other}'; there are --bless and --case NAME"
                    ));
                }
            }
        }
        Ok(options)
    }
}

/// Runs the cases and compares them, or rewrites what is expected.
pub(crate) fn run(options: &Options) -> Result<(), String> {
    let names = case_names(&workspace::root().join("fixtures/golden"), options.case.as_deref())?;
    if names.is_empty() {
        println!("golden: no cases in fixtures/golden");
        return Ok(());
    }
    run_command(cargo().args(["build", "--quiet", "--release", "--package", "solaris-cli"]))?;
    let target = metadata()?.target_directory;
    let program = target.join("release").join(format!("solaris{}", std::env::consts::EXE_SUFFIX));
    let mut failed = Vec::new();
    for name in &names {
        match run_case(name, options.bless, &program, &target.join("golden").join(name)) {
            Ok(line) => println!("{name}: {line}"),
            Err(error) => {
                eprintln!("{name}: FAILED\n  {}", error.replace('\n', "\n  "));
                failed.push(name.as_str());
            }
        }
    }
    match failed.len() {
        0 => Ok(()),
        count => Err(format!(
            "{count} of {} golden cases failed: {}; if the change is meant, `cargo xtask golden --bless`",
            names.len(),
            failed.join(", ")
        )),
    }
}

/// Runs one case; the answer is the line to print.
fn run_case(name: &str, bless: bool, program: &Path, scratch: &Path) -> Result<String, String> {
    let folder = workspace::root().join("fixtures/golden").join(name);
    let case = Case::parse(&read(&folder.join("case.ron"))?).map_err(|error| format!("case.ron: {error}"))?;
    fs::create_dir_all(scratch).map_err(|error| format!("{}: {error}", scratch.display()))?;
    let output = scratch.join("actual.csv");
    // A file of an earlier run must not stand in for one that was not written.
    if output.exists() {
        fs::remove_file(&output).map_err(|error| format!("{}: {error}", output.display()))?;
    }
    let mut command = Command::new(program);
    let ran = command.current_dir(workspace::root()).args(&case.args).arg("-o").arg(&output).output();
    let ran = ran.map_err(|error| format!("{} does not start: {error}", program.display()))?;
    if !ran.status.success() {
        let said = String::from_utf8_lossy(&ran.stderr);
        return Err(format!(
            "`solaris {}` failed ({}):\n{}",
            case.args.join(" "),
            ran.status,
            said.trim_end()
        ));
    }
    let actual = Table::parse(&read(&output)?).map_err(|error| format!("actual.csv: {error}"))?;
    let actual = actual.reduced(case.every, &case.columns)?;
    let expected = folder.join("expected.csv");
    if bless {
        // Compared with itself: a number that is none, or a column without a tolerance, is not blessed.
        compare::compare(&actual, &actual, &case.tolerances)?;
        let text = actual.to_text();
        fs::write(&expected, &text).map_err(|error| format!("{}: {error}", expected.display()))?;
        return Ok(format!("blessed, {} rows, {} bytes", actual.rows.len(), text.len()));
    }
    let expected = Table::parse(&read(&expected)?).map_err(|error| format!("expected.csv: {error}"))?;
    compare::compare(&expected, &actual, &case.tolerances).map(|worst| worst.to_string())
}

/// Names of the cases, sorted; the wanted one alone if there is one.
fn case_names(folder: &Path, wanted: Option<&str>) -> Result<Vec<String>, String> {
    let entries: Vec<PathBuf> = fs::read_dir(folder)
        .map_or_else(|_| Vec::new(), |found| found.flatten().map(|entry| entry.path()).collect());
    let mut names: Vec<String> = entries
        .iter()
        .filter(|path| path.join("case.ron").is_file())
        .filter_map(|path| Some(path.file_name()?.to_str()?.to_owned()))
        .collect();
    names.sort();
    match wanted {
        None => Ok(names),
        Some(wanted) if names.iter().any(|name| name == wanted) => Ok(vec![wanted.to_owned()]),
        Some(wanted) => Err(format!("there is no golden case '{wanted}'; there are: {}", names.join(", "))),
    }
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_understood_or_refused() {
        assert_eq!(Options::parse(&[]), Ok(Options::default()));
        let both = Options { bless: true, case: Some("walk".to_owned()) };
        assert_eq!(Options::parse(&["--case", "walk", "--bless"]), Ok(both));
        assert!(Options::parse(&["--case"]).is_err());
        assert!(Options::parse(&["--blss"]).is_err());
    }

    #[test]
    fn an_unknown_case_is_an_error() {
        let empty = Path::new("no such folder");
        assert_eq!(case_names(empty, None), Ok(vec![]));
        assert!(case_names(empty, Some("walk")).is_err());
    }
}
