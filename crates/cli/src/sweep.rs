//! `solaris sweep`: many walks, a table in and a table out.

mod rows;

use crate::args::{SweepArgs, columns, walk_options};
use crate::error::CliError;
use crate::input;
use crate::output::{Formats, Outputs};
use crate::print::{print, write_json};
use crate::progress::Rows as Bar;
use crate::words::{row, short, some};
use rows::{Done, Walker};
use serde::Serialize;
use solaris::gait::sweep::COLUMNS;
use solaris::io::csv::{Rows, read_rows, write_row};
use solaris::model::nearest;
use std::path::Path;
use std::time::Instant;

const TABLE: Formats<()> = &[("csv", ())];

/// The last column: why there is no walk.
const REFUSAL: &str = "refusal";

/// What is printed.
#[derive(Serialize)]
struct Summary {
    rows: usize,
    walks: usize,
    refused: usize,
    threads: usize,
    seconds: f64,
    rows_per_second_and_thread: f64,
    /// The first refusals, with the line of the table that each is about.
    refusals: Vec<Refused>,
}

/// A row that is no walk.
#[derive(Serialize)]
struct Refused {
    line: u64,
    why: String,
}

/// Refusals that a person reads.
const SHOWN: usize = 3;

pub(crate) fn run(args: &SweepArgs) -> Result<(), CliError> {
    let outputs = Outputs::new([("-o", &args.output, TABLE)])?;
    outputs.keep_off([args.params.as_path()])?;
    let table = read(&args.params)?;
    let threads = args.threads.map_or(0, usize::from);
    let walker = Walker::new(&table.columns, args.rate, threads)?;

    let mut summary = Summary {
        rows: table.rows.len(),
        walks: 0,
        refused: 0,
        threads: walker.threads(),
        seconds: 0.0,
        rows_per_second_and_thread: 0.0,
        refusals: Vec::new(),
    };
    let start = Instant::now();
    outputs.write(|(), mut writer| {
        let heads = table.columns.iter().map(String::as_str).chain(COLUMNS.iter().map(|c| c.heading));
        write_row(heads.chain([REFUSAL]), &mut writer).map_err(CliError::other)?;
        let bar = Bar::shown(table.rows.len());
        // In the order of the table, a few at a time: nobody keeps a walk, nor all rows.
        for some in table.rows.chunks(walker.at_a_time()) {
            for (row, done) in some.iter().zip(walker.walk(some)) {
                match &done {
                    Done::Walked(_) => summary.walks += 1,
                    Done::Refused(why) => {
                        summary.refused += 1;
                        if summary.refusals.len() < SHOWN {
                            summary.refusals.push(Refused { line: row.line, why: why.clone() });
                        }
                    }
                }
                write_row(done.fields(row, table.columns.len()), &mut writer).map_err(CliError::other)?;
            }
            bar.add(some.len());
        }
        Ok(())
    })?;
    summary.seconds = start.elapsed().as_secs_f64();
    summary.rows_per_second_and_thread = summary.rows as f64 / summary.seconds / summary.threads as f64;
    print(|out| {
        if args.json {
            return write_json(out, &summary);
        }
        summary.write(out)?;
        outputs.written().try_for_each(|line| writeln!(out, "\n{line}"))
    })
}

impl Summary {
    fn write(&self, out: &mut dyn std::io::Write) -> std::io::Result<()> {
        let Self { rows, walks, refused, threads, seconds, .. } = self;
        row(out, "rows", &format!("{rows}: {walks} walked, {refused} refused"))?;
        for (i, Refused { line, why }) in self.refusals.iter().enumerate() {
            row(out, if i == 0 { "refused" } else { "" }, &format!("line {line}: {why}"))?;
        }
        if *refused > self.refusals.len() {
            row(out, "", "… the others stand in the last column")?;
        }
        let plural = if *threads == 1 { "" } else { "s" };
        let speed = short(self.rows_per_second_and_thread);
        row(
            out,
            "run time",
            &format!("{} s on {threads} thread{plural}: {speed} rows/s on each", short(*seconds)),
        )
    }
}

/// Reads the table of what is asked; every column is an option of a walk.
fn read(path: &Path) -> Result<Rows, CliError> {
    let refuse = |why: &dyn ToString| CliError::input(path, why);
    if input::extension(path) != "csv" {
        return Err(refuse(&"its extension says nothing; a table of walks is .csv"));
    }
    let text = input::text(path)?;
    if text.trim_start_matches('\u{feff}').trim().is_empty() {
        return Err(refuse(&"it is empty; its first line must name options of a walk: height,speed …"));
    }
    let table = read_rows(&text).map_err(|error| refuse(&error))?;
    let known = columns(&walk_options());
    let is_known = |name: &&String| known.contains(name) || *name == "cadence";
    let unknown: Vec<&String> = table.columns.iter().filter(|name| !is_known(name)).collect();
    if !unknown.is_empty() {
        let named = |name: &&String| {
            let near = nearest(name, known.iter().map(String::as_str));
            let hint = near.map_or_else(String::new, |near| format!(" (did you mean '{near}'?)"));
            format!("'{name}'{hint}")
        };
        let names: Vec<String> = unknown.iter().map(named).collect();
        let column = if unknown.len() == 1 { "column" } else { "columns" };
        let why =
            format!("line 1: {column} {}: no option of a walk; there are {}", some(&names), known.join(", "));
        return Err(refuse(&why));
    }
    Ok(table)
}
