//! `solaris inverse`: joint torques of a given motion.

mod forces;
mod report;
mod summary;
mod tables;

use crate::convert::TableFormat;
use crate::error::CliError;
use crate::given::Given;
use crate::ground::{Content, GroundReport, Predicted, outputs, write_motion};
use crate::print::print;
use crate::progress::Progress;
use clap::ArgMatches;
use forces::External;
use report::{Asked, Report};
use solaris::analysis::{InverseOptions, Loads, inverse_motion};
use solaris::io::{csv, sto};
use std::path::PathBuf;

pub(crate) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    let outputs = outputs(matches)?;
    let [of, from] =
        ["figure", "motion"].map(|name| matches.get_one::<PathBuf>(name).cloned().unwrap_or_default());

    let files = ["external", "external-loads", "soles"].map(|name| matches.get_one::<PathBuf>(name));
    outputs.keep_off([&of, &from].into_iter().chain(files.into_iter().flatten()).map(PathBuf::as_path))?;

    let progress = Progress::new(5);
    progress.stage("reading");
    let mut given = Given::read(matches, &of, &from, &progress)?;
    let external = External::read(matches)?;
    let measured = external.records(&given.body.figure)?;

    progress.stage("finding the forces");
    let ground = matches.get_flag("ground").then(|| Predicted::find(matches, &mut given)).transpose()?;
    let figure = &given.body.figure;
    let mut loads = Loads::at_times(figure, &measured, given.motion().time())
        .map_err(|error| CliError::input(&from, &error))?;
    if let Some(ground) = &ground {
        loads = loads.and(ground.forces.loads());
    }
    let passive = matches.get_one::<String>("passive").is_none_or(|on| on == "on");
    let rows = progress.rows(given.motion().len());
    let mut count = |done: usize| rows.at(done);
    let options = InverseOptions { passive, progress: Some(&mut count) };
    let forces = inverse_motion(&given.prepared()?, &loads, options)
        .map_err(|error| CliError::input(&from, &error))?;

    progress.stage("writing");
    outputs.write(|content, mut writer| {
        match content {
            Content::Forces(TableFormat::Csv) => {
                csv::write_table(&tables::torques(figure, given.motion(), &forces), &mut writer)
            }
            Content::Forces(TableFormat::Sto) => {
                sto::write(&tables::moments(figure, given.motion(), &forces), &mut writer)
            }
            Content::Motion(format) => return write_motion(format, writer, &given),
        }
        .map_err(CliError::other)
    })?;
    drop(progress);
    let asked = Asked {
        passive,
        unused: external.unused(&given.table),
        external: match &ground {
            Some(_) => "the ground's, found from the motion".to_owned(),
            None => external.describe(),
        },
        ground: ground.map(|ground| GroundReport::new(ground, &given)),
    };
    let report = Report::new(&given, asked, &forces);
    print(|out| {
        if matches.get_flag("json") {
            return report.write_json(out);
        }
        report.write(out)?;
        outputs.paths().try_for_each(|path| writeln!(out, "\nwrote {}", path.display()))
    })
}
