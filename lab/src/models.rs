//! The chore `models`: how many of the model files that other engines open are read, and why the rest is not.
//!
//! The files are other people's and not part of the project. A folder holds them, and for each set of them a list
//! `SET.opened` of what the reference engine opens, which `lab/models/opened.py` writes.

use crate::table::{Cell, Table, replace};
use crate::workspace;
use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const PAGE: &str = "docs/bodies.md";

/// What is asked on the command line.
pub(crate) struct Options {
    folder: PathBuf,
    /// Whether the page is written.
    write: bool,
}

impl Options {
    pub(crate) fn parse(arguments: &[&str]) -> Result<Self, String> {
        match arguments {
            [folder] => Ok(Self { folder: folder.into(), write: false }),
            [folder, "--write"] => Ok(Self { folder: folder.into(), write: true }),
            _ => Err("models FOLDER [--write]: a folder with model files and lists SET.opened".to_owned()),
        }
    }
}

/// One set of files.
struct Set {
    name: String,
    /// Files of it, and those that the reference engine opens.
    files: usize,
    opened: Vec<PathBuf>,
    /// Of these: what is not read, with its reason.
    refused: Vec<(PathBuf, String)>,
}

/// Reads all sets of a folder and prints what came of them.
pub(crate) fn run(options: &Options) -> Result<(), String> {
    let program = built()?;
    let mut sets = sets(&options.folder)?;
    for set in &mut sets {
        let answers = set.opened.par_iter().map(|path| (path, refusal(&program, &options.folder.join(path))));
        let answers: Vec<_> = answers.collect();
        let refused = answers.into_iter().filter_map(|(path, why)| Some((path.clone(), why?)));
        set.refused = refused.collect();
        eprintln!(
            "models: {}: {} of {} read",
            set.name,
            set.opened.len() - set.refused.len(),
            set.opened.len()
        );
        for (path, why) in &set.refused {
            println!("{}\t{}\t{why}", set.name, path.display());
        }
    }
    let table = table(&sets).markdown();
    println!("{table}");
    if options.write {
        let page = workspace::read(PAGE)?;
        workspace::write(PAGE, &replace(&page, "models", &table)?)?;
    }
    Ok(())
}

/// The program, built for release.
fn built() -> Result<PathBuf, String> {
    workspace::cargo(&["build", "--quiet", "--release", "--package", "solaris-cli"])?;
    Ok(workspace::root().join("target/release/solaris"))
}

/// The sets that the lists of a folder name.
fn sets(folder: &Path) -> Result<Vec<Set>, String> {
    let refuse = |error: &dyn ToString| format!("{}: {}", folder.display(), error.to_string());
    let mut lists: Vec<PathBuf> = fs::read_dir(folder)
        .map_err(|error| refuse(&error))?
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "opened"))
        .collect();
    lists.sort();
    if lists.is_empty() {
        return Err(refuse(&"there is no list SET.opened; lab/models/opened.py writes them"));
    }
    lists
        .iter()
        .map(|list| {
            let text = fs::read_to_string(list).map_err(|error| refuse(&error))?;
            let opened = |line: &str| {
                let mut fields = line.split('\t');
                (fields.next() == Some("ok")).then(|| fields.next().map(PathBuf::from)).flatten()
            };
            let name = list.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
            Ok(Set {
                name,
                files: text.lines().count(),
                opened: text.lines().filter_map(opened).collect(),
                refused: Vec::new(),
            })
        })
        .collect()
}

/// Why the program does not read a file, in its own words; nothing where it reads it.
fn refusal(program: &Path, path: &Path) -> Option<String> {
    let answer = Command::new(program).arg("check").arg(path).output();
    let answer = match answer {
        Ok(answer) if answer.status.success() => return None,
        Ok(answer) => answer,
        Err(error) => return Some(error.to_string()),
    };
    let said = String::from_utf8_lossy(&answer.stderr).into_owned();
    // The first fault stands behind the line that names the file; without one the program did not end as it should.
    let mut lines = said.lines().map(str::trim).filter(|line| !line.is_empty());
    let first = lines.next().unwrap_or("it said nothing").to_owned();
    Some(if first.ends_with("cannot be used") { lines.next().unwrap_or(&first).to_owned() } else { first })
}

fn table(sets: &[Set]) -> Table {
    let row = |set: &Set| {
        let read = set.opened.len() - set.refused.len();
        let share = 100.0 * read as f64 / set.opened.len().max(1) as f64;
        [
            set.name.clone(),
            set.files.to_string(),
            set.opened.len().to_string(),
            format!("{read} ({share:.0} %)"),
        ]
        .map(Cell::text)
        .to_vec()
    };
    Table {
        header: vec!["set", "files", "the reference opens", "of these are read"],
        rows: sets.iter().map(row).collect(),
    }
}
