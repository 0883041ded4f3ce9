//! `solaris inverse`: joint torques of a given motion.

mod forces;
mod report;
mod summary;
mod tables;

use crate::args::{InverseArgs, Switch};
use crate::convert::TableFormat;
use crate::error::CliError;
use crate::given::{Given, in_order};
use crate::ground::{Content, Ground, GroundReport, outputs, write_motion};
use crate::print::print;
use crate::progress::Progress;
use forces::External;
use report::{Asked, Report};
use solaris::analysis::{InverseOptions, Loads, inverse_motion};
use solaris::io::{csv, sto};
use std::path::PathBuf;

pub(crate) fn run(args: &InverseArgs) -> Result<(), CliError> {
    let (predicted, external) = (&args.predicted, &args.external);
    let outputs = outputs(&args.outputs, &predicted.consistent.motions)?;
    let (of, from) = (args.figure.as_path(), args.motion.as_path());
    in_order("inverse", of, from)?;

    let files = [&external.forces, &external.loads, &predicted.how.soles];
    outputs.keep_off([of, from].into_iter().chain(files.into_iter().flatten().map(PathBuf::as_path)))?;

    let progress = Progress::new(5);
    progress.stage("reading");
    let mut given = Given::read(of, from, &args.record, &args.frame, &progress)?;
    let external = External::read(external)?;
    let measured = external.records(&given.body.figure)?;

    progress.stage("finding the forces");
    let asked = || Ground::new(&predicted.how, &args.frame, &given);
    let ground = predicted.ground.then(asked).transpose()?;
    let moved = match &ground {
        Some(ground) => ground.make_consistent(&predicted.consistent, &mut given)?,
        None => None,
    };
    let prepared = given.prepared()?;
    let ground = ground.map(|ground| ground.predict(&given, &prepared, moved)).transpose()?;
    let figure = &given.body.figure;
    let mut loads = Loads::at_times(figure, &measured, given.motion().time())
        .map_err(|error| CliError::input(from, &error))?;
    if let Some(ground) = &ground {
        loads = loads.and(ground.forces.loads());
    }
    let passive = args.passive == Switch::On;
    let rows = progress.rows(given.motion().len());
    let mut count = |done: usize| rows.at(done);
    let options = InverseOptions { passive, progress: Some(&mut count) };
    let forces = inverse_motion(&prepared, &loads, options).map_err(|error| CliError::input(from, &error))?;

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
    let report = Report::new(&given, asked, forces);
    print(|out| {
        if args.json {
            return report.write_json(out);
        }
        report.write(out)?;
        outputs.written().try_for_each(|line| writeln!(out, "\n{line}"))
    })
}
