//! `solaris crowd`: people in, a motion of each out.

mod person;
mod table;

use crate::animation::{self, Bones};
use crate::args::{CrowdArgs, MOST_IN_ONE};
use crate::error::{CliError, UsageError};
use crate::input::extension;
use crate::output::{Formats, Outputs, make_folder};
use crate::pool::pool;
use crate::print::{print, write_json};
use crate::progress::Rows as Bar;
use crate::words::{row, short};
use person::{Crowd, Walked};
use rayon::ThreadPool;
use rayon::prelude::*;
use serde::Serialize;
use solaris::io::csv::write_row;
use std::time::Instant;
use table::{People, read};

const MOTION: Formats<()> = &[("bvh", ()), ("csv", ()), ("glb", ())];
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

/// What no folder is called.
const FILES: [&str; 7] = ["bvh", "csv", "html", "json", "parquet", "svg", "usda"];

pub(crate) fn run(args: &CrowdArgs) -> Result<(), CliError> {
    let start = Instant::now();
    let people = match &args.people {
        Some(path) => read(path)?,
        None => People::drawn(args.count.unwrap_or_default()),
    };
    let is_one = extension(&args.output) == "glb" && !args.output.is_dir();
    let file = extension(&args.output);
    if !is_one && !args.output.is_dir() && FILES.contains(&file.as_str()) {
        let why =
            "this names a file, and a crowd is a folder with a file for each, or one .glb; see --format";
        return Err(CliError::option("output", args.output.display().to_string(), why));
    }
    let format = if is_one { "glb" } else { args.format.unwrap_or_default().extension() };
    animation::check_bones(&args.bones, &[format])?;
    let bones = animation::asked(&args.bones)?;
    let pool = pool(args.threads.map_or(0, usize::from))?;
    let crowd = Crowd::new(&people, args, &bones);
    let mut summary = Summary {
        people: people.rows.len(),
        walked: 0,
        in_part: 0,
        refused: 0,
        threads: pool.current_num_threads(),
        seconds: 0.0,
        folder: args.output.display().to_string(),
        refusals: Vec::new(),
    };
    if is_one {
        together(args, &crowd, &bones, &pool, &mut summary)?;
    } else {
        apart(args, &crowd, &pool, &mut summary)?;
    }
    summary.seconds = start.elapsed().as_secs_f64();
    print(|out| if args.json { write_json(out, &summary) } else { summary.write(out, is_one) })
}

/// A file for each.
fn apart(args: &CrowdArgs, crowd: &Crowd, pool: &ThreadPool, summary: &mut Summary) -> Result<(), CliError> {
    make_folder("-o", &args.output)?;
    let index_path = args.output.join(INDEX);
    let index = Outputs::new([("-o", &index_path, &[("csv", ())] as Formats<()>)])?;
    index.keep_off(args.people.as_deref())?;
    index.write(|(), mut writer| {
        write_row(Walked::HEADINGS, &mut writer).map_err(CliError::other)?;
        let bar = Bar::shown(summary.people);
        // In the order of the table, a few at a time: nobody keeps all motions.
        let numbers: Vec<usize> = (0..summary.people).collect();
        for some in numbers.chunks(AT_A_TIME * summary.threads) {
            let whole = |number: usize| -> Result<(Walked, Vec<u8>), String> {
                let (walked, person) = crowd.walk(number)?;
                let bytes = crowd.bytes(&person).map_err(|error| error.to_string())?;
                Ok((walked, bytes))
            };
            let walked: Vec<_> =
                pool.install(|| some.par_iter().with_max_len(1).map(|&number| whole(number)).collect());
            for (&number, found) in some.iter().zip(walked) {
                let fields = match found {
                    Ok((walked, bytes)) => {
                        summary.add(&walked);
                        let path = args.output.join(&walked.file);
                        let file = Outputs::new([("-o", &path, MOTION)])?;
                        file.keep_off(args.people.as_deref())?;
                        file.write(|(), writer| writer.write_all(&bytes).map_err(CliError::other))?;
                        walked.fields()
                    }
                    Err(why) => {
                        summary.refuse(&why);
                        Walked::refused(crowd.name(number), why)
                    }
                };
                write_row(fields, &mut writer).map_err(CliError::other)?;
            }
            bar.add(some.len());
        }
        Ok(())
    })
}

/// All in one file.
fn together(
    args: &CrowdArgs,
    crowd: &Crowd,
    bones: &Bones,
    pool: &ThreadPool,
    summary: &mut Summary,
) -> Result<(), CliError> {
    if args.format.is_some() {
        return Err(UsageError::FormatOfOne { path: args.output.clone() }.into());
    }
    if summary.people > MOST_IN_ONE {
        let why = format!(
            "{} people in one file; it takes {MOST_IN_ONE} at most: name a folder, and --format glb writes a file for each",
            summary.people
        );
        return Err(CliError::Output { option: "-o", path: args.output.clone(), why });
    }
    let file = Outputs::new([("-o", &args.output, &[("glb", ())] as Formats<()>)])?;
    file.keep_off(args.people.as_deref())?;
    let numbers: Vec<usize> = (0..summary.people).collect();
    let found: Vec<_> =
        pool.install(|| numbers.par_iter().with_max_len(1).map(|&number| crowd.walk(number)).collect());
    let mut people = Vec::new();
    for found in found {
        match found {
            Ok((walked, person)) => {
                summary.add(&walked);
                people.push(person);
            }
            Err(why) => summary.refuse(&why),
        }
    }
    pool.install(|| file.write(|(), writer| animation::crowd(&people, bones, writer)))
}

impl Summary {
    fn add(&mut self, walked: &Walked) {
        self.walked += 1;
        self.in_part += usize::from(walked.part < 1.0);
    }

    fn refuse(&mut self, why: &str) {
        self.refused += 1;
        if self.refusals.len() < SHOWN {
            self.refusals.push(why.to_owned());
        }
    }

    fn write(&self, out: &mut dyn std::io::Write, is_one: bool) -> std::io::Result<()> {
        let Self { people, walked, in_part, refused, threads, .. } = self;
        row(out, "people", &format!("{people}: {walked} walk, {refused} refused"))?;
        if *in_part > 0 {
            row(out, "", &format!("{in_part} of them in their manner in part, as far as it holds"))?;
        }
        for (i, why) in self.refusals.iter().enumerate() {
            row(out, if i == 0 { "refused" } else { "" }, why)?;
        }
        if *refused > self.refusals.len() {
            let others = if is_one {
                "… and others; into a folder, all of them are told"
            } else {
                "… the others stand in crowd.csv"
            };
            row(out, "", others)?;
        }
        let plural = if *threads == 1 { "" } else { "s" };
        row(out, "run time", &format!("{} s on {threads} thread{plural}", short(self.seconds)))?;
        if is_one {
            return writeln!(out, "\nwrote {}", self.folder);
        }
        writeln!(out, "\nwrote {} and a motion for each into {}", INDEX, self.folder)
    }
}
