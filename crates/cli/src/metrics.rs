//! `solaris metrics`: numbers of any motion.

mod evidence;
mod report;

use crate::error::CliError;
use crate::given::{Given, GivenReport};
use crate::ground::needs_times;
use crate::input::{self, Body};
use crate::output::{Formats, Outputs};
use crate::print::print;
use crate::progress::Progress;
use crate::walk::person;
use clap::ArgMatches;
use evidence::Evidence;
use report::Report;
use solaris::gait::metrics::metrics;
use std::path::{Path, PathBuf};

/// What a file of metrics is.
#[derive(Clone, Copy, Debug)]
enum Format {
    Json,
    Csv,
}

const FILES: Formats<Format> = &[("json", Format::Json), ("csv", Format::Csv)];

pub(crate) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    let files = matches.get_many::<PathBuf>("output").unwrap_or_default();
    let outputs = Outputs::new(files.map(|path| ("-o", path, FILES)))?;
    let from = matches.get_one::<PathBuf>("motion").cloned().unwrap_or_default();
    let others = ["figure", "soles"].map(|name| matches.get_one::<PathBuf>(name).map(PathBuf::as_path));
    outputs.keep_off([from.as_path()].into_iter().chain(others.into_iter().flatten()))?;

    let progress = Progress::new(4);
    progress.stage("reading");
    let (body, of) = match matches.get_one::<PathBuf>("figure") {
        Some(path) => (input::body(path)?, path.clone()),
        None => (Body::own(person(matches)?), PathBuf::from("the human")),
    };
    let is_guess = !matches.contains_id("figure");
    let given = Given::of(matches, body, &of, &from, &progress).map_err(|error| match error {
        CliError::Input { path, why } if is_guess && path.is_file() => {
            let why =
                format!("{why}; without --figure it is taken for the motion of a human of `solaris walk`");
            CliError::Input { path, why }
        }
        other => other,
    })?;
    needs_times(&given)?;
    progress.stage("finding the steps");
    let evidence = Evidence::find(matches, &given)?;
    progress.stage("measuring");
    let prepared = given.prepared()?;
    let all = metrics(&evidence.input(&prepared)).map_err(|error| CliError::input(&from, &error))?;
    let report = Report::new(GivenReport::new(&given), &evidence, &all);
    outputs.write(|format, mut writer| match format {
        Format::Json => report.write_json(writer).map_err(CliError::other),
        Format::Csv => report.write_csv(&mut writer).map_err(CliError::other),
    })?;
    drop(progress);
    print(|out| {
        if matches.get_flag("json") {
            return report.write_json(out);
        }
        report.write(out)?;
        outputs.paths().try_for_each(|path: &Path| writeln!(out, "\nwrote {}", path.display()))
    })
}
