//! `solaris inverse`: joint torques of a given motion.

mod forces;
mod report;
mod summary;
mod tables;

use crate::args::{InverseArgs, Switch};
use crate::convert::TableFormat;
use crate::error::CliError;
use crate::given::{Given, in_order};
use crate::ground::{Content, Ground, GroundReport, known_soles, outputs, say_medium, write_motion};
use crate::plausible::Plausibility;
use crate::print::print;
use crate::progress::Progress;
use crate::words::counted;
pub(crate) use forces::External;
use report::{Asked, Report};
use solaris::analysis::{InverseOptions, Loads, inverse_motion, medium_forces};
use solaris::io::{csv, sto};
use solaris::model::Medium;
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
    if predicted.ground {
        say_medium(&mut given);
    }
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
    let medium = &given.body.medium;
    if passive && !medium.is_empty() {
        let forces = medium_forces(&prepared, medium).map_err(|error| CliError::input(from, &error))?;
        loads = loads.and(forces);
    }
    let rows = progress.rows(given.motion().len());
    let mut count = |done: usize| rows.at(done);
    let options = InverseOptions { passive, progress: Some(&mut count) };
    let forces = inverse_motion(&prepared, &loads, options).map_err(|error| CliError::input(from, &error))?;
    let soles = if measured.is_empty() { None } else { known_soles(predicted.how.soles.as_deref(), &given)? };
    let plausible = Plausibility::of(&given, &prepared, soles.map(|(soles, _)| soles), &measured)?
        .map(|plausible| plausible.with_residual(&given, &prepared, &forces, &measured))
        .transpose()?;

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
        medium: describe(medium),
        unused: external.unused(&given.table),
        notes: external.notes(),
        external: match &ground {
            Some(_) => "the ground's, found from the motion".to_owned(),
            None => external.describe(),
        },
        ground: ground.map(|ground| GroundReport::new(ground, &given)),
        plausible,
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

/// What the medium is, for the summary; none where there is none.
fn describe(medium: &Medium) -> Option<String> {
    let Medium { density, viscosity, wind, immersed, carried } = medium;
    let fluid = (!immersed.is_empty()).then(|| {
        let [x, y, z]: [f64; 3] = (*wind).into();
        let blows = wind.norm_squared() > 0.0;
        let wind = if blows { format!(", wind ({x}, {y}, {z}) m/s") } else { String::new() };
        let bodies = counted(immersed.len(), "body", "bodies");
        format!("a fluid of {density} kg/m³ and {viscosity} Pa s{wind} resists {bodies}")
    });
    let carried = (!carried.is_empty())
        .then(|| format!("{} carried against gravity", counted(carried.len(), "body is", "bodies are")));
    let parts: Vec<String> = fluid.into_iter().chain(carried).collect();
    (!parts.is_empty()).then(|| parts.join("; "))
}
