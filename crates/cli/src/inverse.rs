//! `solaris inverse`: joint torques of a given motion.

mod forces;
mod report;
mod summary;
mod tables;

use crate::args::{BASES, Gravity};
use crate::convert::{TABLE, TableFormat};
use crate::error::CliError;
use crate::input::{self, Body};
use crate::output::Outputs;
use crate::print::print;
use crate::progress::Progress;
use clap::ArgMatches;
use forces::External;
use report::{Asked, Report};
use solaris::io::{csv, record, sto};
use solaris::model::Base;
use solaris::modes::{Filter, InverseOptions, complete, inverse_motion};
use std::path::PathBuf;

/// Order of the filter when none is asked for.
const FILTER_ORDER: u8 = 2;

pub(crate) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    let outputs = matches.get_many::<PathBuf>("output").unwrap_or_default();
    let outputs = Outputs::new(outputs.map(|path| ("-o", path, TABLE)))?;
    let [of, from] =
        ["figure", "motion"].map(|name| matches.get_one::<PathBuf>(name).cloned().unwrap_or_default());

    let files = ["external", "external-loads"].map(|name| matches.get_one::<PathBuf>(name));
    outputs.keep_off([&of, &from].into_iter().chain(files.into_iter().flatten()).map(PathBuf::as_path))?;

    let progress = Progress::new(4);
    progress.stage("reading");
    let mut body = input::body(&of)?;
    if let Some(base) = base(matches) {
        if base == Base::Fixed && body.figure.links()[0].joint().kind().nv() > 0 {
            let why = "its root joint moves, and --base fixed is for figures that stand fixed; leave it out"
                .to_owned();
            return Err(CliError::Option { option: "base".to_owned(), value: "fixed".to_owned(), why });
        }
        body.figure = body.figure.on_base(base).map_err(|error| CliError::input(&of, &error))?;
    }
    if let Some(Gravity(gravity)) = matches.get_one("gravity") {
        body.gravity = *gravity;
    }
    let Body { figure, gravity, .. } = &body;
    let table = input::table(&from)?;
    let recorded = record::read(figure, &table).map_err(|error| CliError::input(&from, &error))?;
    let external = External::read(matches)?;
    let loads = external.records(figure)?;

    progress.stage("finding velocities and accelerations");
    let filter = filter(matches);
    let states =
        complete(figure, &recorded.record, filter).map_err(|error| CliError::input(&from, &error))?;

    progress.stage("finding the forces");
    let passive = matches.get_one::<String>("passive").is_none_or(|on| on == "on");
    let rows = progress.rows(states.time.len());
    let mut count = |done: usize| rows.at(done);
    let options = InverseOptions { passive, progress: Some(&mut count) };
    let forces = inverse_motion(figure, *gravity, &states, &loads, options)
        .map_err(|error| CliError::input(&from, &error))?;

    progress.stage("writing");
    outputs.write(|format, mut writer| {
        match format {
            TableFormat::Csv => csv::write_table(&tables::torques(figure, &states, &forces), &mut writer),
            TableFormat::Sto => sto::write(&tables::moments(figure, &states, &forces), &mut writer),
        }
        .map_err(CliError::other)
    })?;
    drop(progress);
    let asked = Asked {
        filter,
        passive,
        gravity: matches.contains_id("gravity"),
        unused: external.unused(&table),
        external: external.describe(),
    };
    let report = Report::new(&body, &asked, &table, &recorded, (&states, &forces));
    print(|out| {
        if matches.get_flag("json") {
            return report.write_json(out);
        }
        report.write(out)?;
        outputs.paths().try_for_each(|path| writeln!(out, "\nwrote {}", path.display()))
    })
}

fn base(matches: &ArgMatches) -> Option<Base> {
    let asked = matches.get_one::<String>("base")?;
    BASES.iter().find(|(name, _)| name == asked).map(|(_, base)| *base)
}

fn filter(matches: &ArgMatches) -> Option<Filter> {
    let cutoff = *matches.get_one::<f64>("filter")?;
    let order = *matches.get_one::<u8>("filter-order").unwrap_or(&FILTER_ORDER);
    Some(Filter { cutoff, order: order.into() })
}
