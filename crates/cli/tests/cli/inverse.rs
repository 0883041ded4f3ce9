//! The commands on figures and recorded motions (`inverse`, `ground`, `check`, `figure`, `convert`, `walk --figure`) from outside:
//! what goes into files and what comes out. What is printed stands in the transcripts.

mod against;
mod bad_files;
mod bands;
mod check;
mod consistent;
mod convert;
mod files;
mod ground;
mod manners;
mod many;
mod masses;
mod metrics;
mod part;
mod plausible;
mod refusals;
mod robots;
mod subject;
mod toes;
mod turned;
mod walk;

use serde_json::Value;
use solaris::io::{Table, csv, sto};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

/// The project's own examples.
const FIXTURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures");

/// What people measured and other programs computed, beside the project where it is there at all.
const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data");

/// Forces on the fixture's feet, plate by plate.
const PLATES: &str = "--external grf.mot --plate calcn_r= --plate calcn_l=1_";

/// Runs `solaris` in a folder with the words of a line, its outputs caught.
fn solaris(folder: &Path, line: &str) -> Output {
    solaris_with(folder, &line.split_whitespace().collect::<Vec<_>>())
}

fn solaris_with(folder: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_solaris"));
    command.current_dir(folder).args(args).stdin(Stdio::null());
    command.output().expect("the program starts")
}

/// Standard output of a run that went well and had nothing to say on standard error.
fn succeeded(output: &Output) -> String {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!((output.status.code(), said.as_ref()), (Some(0), ""));
    String::from_utf8(output.stdout.clone()).expect("UTF-8")
}

/// Standard error of a run that ended with exit code `code` and printed no result.
fn failed(output: &Output, code: i32) -> String {
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(code), "{text}");
    assert!(output.stdout.is_empty(), "{}", String::from_utf8_lossy(&output.stdout));
    text
}

/// What cannot be done.
fn refused(output: &Output) -> String {
    failed(output, 1)
}

/// A folder with copies of fixtures.
fn folder_with(fixtures: &[&str]) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for fixture in fixtures {
        let from = Path::new(FIXTURES).join(fixture);
        let name = from.file_name().expect("a name");
        fs::copy(&from, folder.path().join(name)).expect(fixture);
    }
    folder
}

/// A folder with the subject: model, motion, forces, and their description.
fn subject() -> TempDir {
    folder_with(&[
        "subject/subject.osim",
        "subject/walk.mot",
        "subject/grf.mot",
        "subject/loads.xml",
        "subject/soles.ron",
    ])
}

/// A file of the reference data; where it is absent that is said aloud.
fn data(name: &str) -> Option<PathBuf> {
    let path = Path::new(DATA).join(name);
    if path.is_file() {
        return Some(path);
    }
    // Past the harness, which catches what is printed.
    let _ = writeln!(std::io::stderr(), "SKIPPED: {} is not here", path.display());
    None
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).expect("a file of text")
}

fn write(folder: &Path, name: &str, text: &str) {
    fs::write(folder.join(name), text).expect("written");
}

/// A table, by its extension.
fn table(folder: &Path, name: &str) -> Table {
    let text = read(&folder.join(name));
    let is_csv = Path::new(name).extension().is_some_and(|extension| extension == "csv");
    if is_csv { csv::read_table(&text) } else { sto::read(&text) }.expect(name)
}

fn column(table: &Table, name: &str) -> Vec<f64> {
    table.values_of(table.column(name).expect(name)).collect()
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

fn number(value: &Value, pointer: &str) -> f64 {
    value.pointer(pointer).and_then(Value::as_f64).expect(pointer)
}

/// The size of the largest.
fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, value| value.abs().max(largest))
}

/// The greatest difference of two lists of numbers.
fn difference(one: &[f64], other: &[f64]) -> f64 {
    assert_eq!(one.len(), other.len());
    largest(&one.iter().zip(other).map(|(a, b)| a - b).collect::<Vec<_>>())
}

/// Names in a folder, hidden ones too, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let name = |entry: std::io::Result<fs::DirEntry>| entry.expect("an entry").file_name();
    let mut names: Vec<String> = entries.map(|entry| name(entry).to_string_lossy().into_owned()).collect();
    names.sort();
    names
}
