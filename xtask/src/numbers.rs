//! The chore that holds the numbers of pages against what they are: `docs/numbers.md` is a table of them, each with the command that
//! makes it, how far it may be off, and when it was made.

mod pattern;
mod prose;
mod row;

use crate::workspace::{self, cargo, root};
use pattern::found;
use row::{Row, Source, rows};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// The table.
const PAGE: &str = "docs/numbers.md";
/// The pages of which every number must be in the table.
const WHOLE: &[&str] = &[
    "README.md",
    "crates/collision/README.md",
    "crates/dynamics/README.md",
    "crates/ffi/README.md",
    "crates/gait/README.md",
    "crates/io/README.md",
    "crates/model/README.md",
    "crates/profiles/README.md",
    "crates/retarget/README.md",
    "crates/scalar/README.md",
    "crates/scene/README.md",
    "crates/skin/README.md",
    "crates/solaris/README.md",
    "crates/text/README.md",
    "docs/chair.md",
    "docs/drives.md",
    "docs/engines.md",
    "docs/installing.md",
    "docs/learn/animator.md",
    "docs/learn/biomechanics.md",
    "docs/learn/game.md",
];
/// How often a time is taken; the shortest counts.
const RUNS: usize = 5;

/// What the chore was asked.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Options {
    /// Whether commands that take minutes are run too.
    all: bool,
    /// The day to write into the rows that hold, such as 2026-11-27.
    bless: Option<String>,
}

impl Options {
    /// Of the words after `numbers`.
    pub(crate) fn parse(words: &[&str]) -> Result<Self, String> {
        let mut options = Self::default();
        let mut words = words.iter();
        while let Some(word) = words.next() {
            match *word {
                "--all" => options.all = true,
                "--bless" => {
                    let day = words.next().copied().unwrap_or_default();
                    if !row::is_day(day) {
                        return Err(format!(
                            "numbers --bless '{day}': give the day, as in --bless 2026-11-27"
                        ));
                    }
                    options.bless = Some(day.to_owned());
                }
                _ => return Err(format!("numbers has no option '{word}'; it has --all and --bless DAY")),
            }
        }
        Ok(options)
    }
}

/// Makes every number of the table, and says which pages state another one.
pub(crate) fn run(options: &Options) -> Result<(), String> {
    let mut text = read(PAGE)?;
    let rows = rows(&text).map_err(|error| format!("{PAGE}: {error}"))?;
    let mut faults = unsaid(&rows)?;
    let mut said = BTreeMap::new();
    let mut program = None;
    for row in &rows {
        if row.source.is_long() && !options.all {
            println!("skipped: {}: '{}': takes minutes; --all runs it", row.page, row.says);
            continue;
        }
        let shown = match said.get(&row.source) {
            Some(shown) => Ok(String::clone(shown)),
            None => show(&row.source, &mut program),
        };
        let held = shown.and_then(|shown| {
            said.insert(row.source.clone(), shown.clone());
            check(row, &shown)
        });
        match held {
            Ok(number) => {
                println!("{}: '{}': {number}", row.page, row.says);
                if let Some(day) = &options.bless {
                    text = text.replace(&row.line, &row.line.replace(&row.day, day));
                }
            }
            Err(why) => faults.push(format!("{}: '{}': {why}", row.page, row.says)),
        }
    }
    if options.bless.is_some() {
        fs::write(root().join(PAGE), text).map_err(|error| format!("{PAGE}: {error}"))?;
    }
    if faults.is_empty() {
        println!("{} numbers are as the pages say", rows.len());
        return Ok(());
    }
    Err(format!("{} numbers are stale:\n{}", faults.len(), faults.join("\n")))
}

/// Pages that do not say what the table says they do, and numbers that no row is about.
fn unsaid(rows: &[Row]) -> Result<Vec<String>, String> {
    let mut faults = Vec::new();
    for row in rows {
        if !prose::flat(&read(&row.page)?).contains(&prose::flat(&row.says)) {
            faults.push(format!("{} does not say '{}'; correct {PAGE}, or the page", row.page, row.says));
        }
    }
    for page in WHOLE {
        let known: Vec<&str> =
            rows.iter().filter(|row| row.page == *page).map(|row| row.says.as_str()).collect();
        let missing = prose::uncovered(&read(page)?, &known);
        faults.extend(missing.iter().map(|number| format!("{page}: {PAGE} has no row for {number}")));
    }
    Ok(faults)
}

/// Holds what a command showed against what it should be.
fn check(row: &Row, shown: &str) -> Result<f64, String> {
    let number =
        found(&row.shows, shown).ok_or_else(|| format!("{} does not show '{}'", row.source, row.shows))?;
    if (number - row.is).abs() <= row.within {
        return Ok(number);
    }
    Err(format!(
        "it is {number} now, and was {} (within {}) on {}: {}",
        row.is, row.within, row.day, row.source
    ))
}

/// What a source shows.
fn show(source: &Source, program: &mut Option<PathBuf>) -> Result<String, String> {
    match source {
        Source::Text(path) => read(path),
        Source::Bytes(path) => {
            let size = fs::metadata(root().join(path)).map_err(|error| format!("{path}: {error}"))?.len();
            Ok(format!("{size} bytes"))
        }
        Source::Solaris(words) => output(&mut solaris(program, words)?),
        Source::Seconds(words) => {
            let mut best = f64::INFINITY;
            for _ in 0..RUNS {
                let mut command = solaris(program, words)?;
                let begun = Instant::now();
                output(&mut command)?;
                best = best.min(begun.elapsed().as_secs_f64());
            }
            Ok(format!("{best:.3} s"))
        }
        Source::Cargo(words) => {
            // What is compiled into a folder of its own is compiled anew: that is what is timed.
            if let Some(folder) = words.iter().skip_while(|word| *word != "--target-dir").nth(1) {
                let _ = fs::remove_dir_all(root().join(folder));
            }
            output(cargo().args(words))
        }
    }
}

/// The program, in a folder where it may write.
fn solaris(program: &mut Option<PathBuf>, words: &[String]) -> Result<Command, String> {
    let target = workspace::metadata()?.target_directory;
    if program.is_none() {
        workspace::run(cargo().args(["build", "--release", "--quiet", "--package", "solaris-cli"]))?;
        *program = Some(target.join("release").join(format!("solaris{}", std::env::consts::EXE_SUFFIX)));
    }
    let folder = target.join("numbers");
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut command = Command::new(program.as_deref().unwrap_or(Path::new("solaris")));
    command.current_dir(folder).args(words);
    Ok(command)
}

/// What a command says, to either stream. That it refuses may be what shows the number.
fn output(command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|error| format!("{command:?} does not start: {error}"))?;
    Ok(format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr)))
}

fn read(path: &str) -> Result<String, String> {
    fs::read_to_string(root().join(path)).map_err(|error| format!("{path}: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_understood_and_its_pages_say_what_it_says() {
        let rows = rows(&read(PAGE).expect("the page")).expect("rows");
        assert!(rows.len() > 10, "{} rows", rows.len());
        assert_eq!(unsaid(&rows).expect("pages"), Vec::<String>::new());
    }

    #[test]
    fn a_number_that_moved_is_stale() {
        let line = "| `README.md` | `1 cm` | `text x` | `TOLD = #;` | 0.01 | 0.001 | 2026-11-27 |";
        let row = &rows(&format!("{line}\n")).expect("a row")[0];
        assert_eq!(check(row, "const TOLD = 0.0105;"), Ok(0.0105));
        let why = check(row, "const TOLD = 0.02;").expect_err("moved");
        assert!(why.contains("0.02 now, and was 0.01") && why.contains("text x"), "{why}");
        assert!(check(row, "nothing").expect_err("nothing").contains("does not show"));
    }

    #[test]
    fn a_day_is_asked_for_with_a_blessing() {
        assert!(Options::parse(&["--bless"]).is_err() && Options::parse(&["--bless", "today"]).is_err());
        let asked = Options::parse(&["--all", "--bless", "2026-11-27"]).expect("known");
        assert_eq!(asked, Options { all: true, bless: Some("2026-11-27".to_owned()) });
    }
}
