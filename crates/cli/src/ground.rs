//! `solaris ground`: what the ground does to the feet in a given motion.

mod files;
mod moved;
mod predicted;
mod report;
mod soles;
mod summary;

pub(crate) use files::{Content, outputs, write_motion};
pub(crate) use predicted::Predicted;
pub(crate) use report::GroundReport;

use crate::convert::{TABLE, TableFormat};
use crate::error::CliError;
use crate::given::{Given, GivenReport};
use crate::input::extension;
use crate::print::print;
use crate::progress::Progress;
use clap::ArgMatches;
use serde::Serialize;
use solaris::io::record::{ForceHeadings, force_table};
use solaris::io::{csv, sto};
use std::path::{Path, PathBuf};

/// What is printed as JSON.
#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    given: GivenReport,
    ground: GroundReport,
}

pub(crate) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    let outputs = outputs(matches)?;
    let [mut from, mut of] =
        ["motion", "figure"].map(|name| matches.get_one::<PathBuf>(name).cloned().unwrap_or_default());
    // `solaris inverse` has them the other way round, and their names tell them apart.
    if is_table(&of) && !is_table(&from) {
        std::mem::swap(&mut of, &mut from);
    }
    let soles = matches.get_one::<PathBuf>("soles");
    outputs.keep_off([&of, &from].into_iter().chain(soles).map(PathBuf::as_path))?;

    let progress = Progress::new(4);
    progress.stage("reading");
    let mut given = Given::read(matches, &of, &from, &progress)?;
    progress.stage("finding the ground's forces");
    let ground = Predicted::find(matches, &mut given)?;

    progress.stage("writing");
    let table = |headings| {
        let tracks = &ground.forces.contacts;
        force_table(headings, &given.states.time, tracks).map_err(CliError::other)
    };
    outputs.write(|content, mut writer| {
        match content {
            Content::Forces(TableFormat::Csv) => {
                csv::write_table(&table(ForceHeadings::Solaris)?, &mut writer)
            }
            Content::Forces(TableFormat::Sto) => sto::write(&table(ForceHeadings::OpenSim)?, &mut writer),
            Content::Motion(format) => return write_motion(format, writer, &given),
        }
        .map_err(CliError::other)
    })?;
    drop(progress);
    let report = Report { ground: GroundReport::new(ground, &given), given: GivenReport::new(&given) };
    print(|out| {
        if matches.get_flag("json") {
            serde_json::to_writer_pretty(&mut *out, &report).map_err(std::io::Error::from)?;
            return writeln!(out);
        }
        report.given.write(out)?;
        report.given.write_doubts(out)?;
        report.ground.write(out)?;
        outputs.paths().try_for_each(|path| writeln!(out, "\nwrote {}", path.display()))
    })
}

fn is_table(path: &Path) -> bool {
    TABLE.iter().any(|(known, _)| *known == extension(path))
}
