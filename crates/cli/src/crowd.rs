//! `solaris crowd`: people in, a motion of each out.

mod person;
mod table;

use crate::args::CrowdArgs;
use crate::error::CliError;
use crate::output::{Formats, Outputs, make_folder};
use crate::pool::pool;
use crate::print::{print, write_json};
use crate::progress::Rows as Bar;
use crate::words::{row, short};
use person::{Crowd, Walked};
use rayon::prelude::*;
use serde::Serialize;
use solaris::io::csv::write_row;
use std::time::Instant;
use table::{People, read};

const MOTION: Formats<()> = &[("bvh", ()), ("csv", ())];
/// The table of who walks where.
const INDEX: &str = "crowd.csv";
/// People that a thread takes on before they are written.
const AT_A_TIME: usize = 16;
/// Refusals that a person reads.
const SHOWN: usize = 3;

/// What is printed.
#[derive(Serialize)]
struct Summary {
    people: usize,
    walked: usize,
    in_part: usize,
    refused: usize,
    threads: usize,
    seconds: f64,
    folder: String,
    /// The first refusals, each with its line and column.
    refusals: Vec<String>,
}

pub(crate) fn run(args: &CrowdArgs) -> Result<(), CliError> {
    let start = Instant::now();
    let people = match &args.people {
        Some(path) => read(path)?,
        None => People::drawn(args.count.unwrap_or_default()),
    };
    make_folder("-o", &args.output)?;
    let index_path = args.output.join(INDEX);
    let index = Outputs::new([("-o", &index_path, &[("csv", ())] as Formats<()>)])?;
    index.keep_off(args.people.as_deref())?;
    let pool = pool(args.threads.map_or(0, usize::from))?;
    let threads = pool.current_num_threads();
    let crowd = Crowd::new(&people, args);
    let mut summary = Summary {
        people: people.rows.len(),
        walked: 0,
        in_part: 0,
        refused: 0,
        threads,
        seconds: 0.0,
        folder: args.output.display().to_string(),
        refusals: Vec::new(),
    };
    index.write(|(), mut writer| {
        write_row(Walked::HEADINGS, &mut writer).map_err(CliError::other)?;
        let bar = Bar::shown(people.rows.len());
        // In the order of the table, a few at a time: nobody keeps all motions.
        let numbers: Vec<usize> = (0..people.rows.len()).collect();
        for some in numbers.chunks(AT_A_TIME * threads) {
            let walked: Vec<_> =
                pool.install(|| some.par_iter().with_max_len(1).map(|&number| crowd.walk(number)).collect());
            for (&number, found) in some.iter().zip(walked) {
                let fields = match found {
                    Ok((walked, bytes)) => {
                        summary.walked += 1;
                        summary.in_part += usize::from(walked.part < 1.0);
                        let path = args.output.join(&walked.file);
                        let file = Outputs::new([("-o", &path, MOTION)])?;
                        file.keep_off(args.people.as_deref())?;
                        file.write(|(), writer| writer.write_all(&bytes).map_err(CliError::other))?;
                        walked.fields()
                    }
                    Err(why) => {
                        summary.refused += 1;
                        if summary.refusals.len() < SHOWN {
                            summary.refusals.push(why.clone());
                        }
                        Walked::refused(crowd.name(number), why)
                    }
                };
                write_row(fields, &mut writer).map_err(CliError::other)?;
            }
            bar.add(some.len());
        }
        Ok(())
    })?;
    summary.seconds = start.elapsed().as_secs_f64();
    print(|out| if args.json { write_json(out, &summary) } else { summary.write(out) })
}

impl Summary {
    fn write(&self, out: &mut dyn std::io::Write) -> std::io::Result<()> {
        let Self { people, walked, in_part, refused, threads, .. } = self;
        row(out, "people", &format!("{people}: {walked} walk, {refused} refused"))?;
        if *in_part > 0 {
            row(out, "", &format!("{in_part} of them in their manner in part, as far as it holds"))?;
        }
        for (i, why) in self.refusals.iter().enumerate() {
            row(out, if i == 0 { "refused" } else { "" }, why)?;
        }
        if *refused > self.refusals.len() {
            row(out, "", &format!("… the others stand in {INDEX}"))?;
        }
        let plural = if *threads == 1 { "" } else { "s" };
        row(out, "run time", &format!("{} s on {threads} thread{plural}", short(self.seconds)))?;
        writeln!(out, "\nwrote {} and a motion for each into {}", INDEX, self.folder)
    }
}
