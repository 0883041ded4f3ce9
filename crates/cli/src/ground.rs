//! `solaris ground`: what the ground does to the feet in a given motion.

mod against;
mod files;
mod moved;
mod predicted;
mod report;
mod soles;
mod summary;

pub(crate) use files::{Content, outputs, write_motion};
pub(crate) use predicted::{Ground, Standing, needs_times, say_medium};
pub(crate) use report::GroundReport;
pub(crate) use soles::{From as SolesFrom, find as find_soles, known as known_soles};

use crate::args::GroundCommandArgs;
use crate::convert::TableFormat;
use crate::error::CliError;
use crate::given::{Given, GivenReport, in_order};
use crate::print::{print, write_json};
use crate::progress::Progress;
use against::Plates;
use files::{Written, outputs_or_picture};
use predicted::Predicted;
use serde::Serialize;
use solaris::io::record::{ForceHeadings, force_table};
use solaris::io::{csv, sto};
use solaris::model::Vector3;
use solaris::view::{FootForces, forces};
use std::path::PathBuf;

/// What is printed as JSON.
#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    given: GivenReport,
    ground: GroundReport,
}

pub(crate) fn run(args: &GroundCommandArgs) -> Result<(), CliError> {
    let outputs = outputs_or_picture(&args.outputs, &args.consistent.motions)?;
    let (of, from) = (args.figure.as_path(), args.motion.as_path());
    in_order("ground", of, from)?;
    let others = [&args.ground.soles, &args.against, &args.loads];
    outputs.keep_off([of, from].into_iter().chain(others.into_iter().flatten().map(PathBuf::as_path)))?;

    let progress = Progress::new(4);
    progress.stage("reading");
    let mut given = Given::read(of, from, &args.record, &args.frame, &progress)?;
    progress.stage("finding the ground's forces");
    say_medium(&mut given);
    let ground = Ground::new(&args.ground, &args.frame, &given)?;
    let moved = ground.make_consistent(&args.consistent, &mut given)?;
    let prepared = given.prepared()?;
    let ground = ground.predict(&given, &prepared, moved)?;
    let plates = Plates::read(args, &given.body.figure, &ground.soles)?;
    let plausible = match &plates {
        Some(plates) => Some(plates.plausibility(&given, &prepared, &ground)?),
        None => None,
    };

    progress.stage("writing");
    let table = |headings| {
        let tracks = &ground.forces.contacts;
        force_table(headings, given.motion().time(), tracks).map_err(CliError::other)
    };
    outputs.write(|content, mut writer| {
        match content {
            Written::Table(Content::Forces(TableFormat::Csv)) => {
                csv::write_table(&table(ForceHeadings::Solaris)?, &mut writer)
            }
            Written::Table(Content::Forces(TableFormat::Sto)) => {
                sto::write(&table(ForceHeadings::OpenSim)?, &mut writer)
            }
            Written::Picture => {
                return writer
                    .write_all(picture(&ground, &given, plates.as_ref()).as_bytes())
                    .map_err(CliError::other);
            }
            Written::Table(Content::Motion(format)) => return write_motion(format, writer, &given),
        }
        .map_err(CliError::other)
    })?;
    drop(progress);
    let beside = plates.map(|plates| {
        plates.beside(given.motion().time(), &ground.forces.contacts, ground.forces.report.weight)
    });
    let mut report = Report { ground: GroundReport::new(ground, &given), given: GivenReport::new(&given) };
    if let (Some((feet, whole)), Some(plausible)) = (beside, plausible) {
        report.ground.hold_against(feet, whole, plausible);
    }
    print(|out| {
        if args.json {
            return write_json(out, &report);
        }
        report.given.write(out)?;
        report.given.write_doubts(out)?;
        report.ground.write(out)?;
        outputs.written().try_for_each(|line| writeln!(out, "\n{line}"))
    })
}

/// Forces of each foot along the world's axes, and what plates measured.
fn picture(ground: &Predicted, given: &Given, plates: Option<&Plates>) -> String {
    let (time, tracks) = (given.motion().time(), &ground.forces.contacts);
    let mut feet: Vec<FootForces<'_>> = Vec::new();
    let [first, last] = [time.first(), time.last()].map(|time| time.copied().unwrap_or_default());
    for (sole, track) in tracks.iter().enumerate() {
        feet.push(FootForces { name: &track.link, time, samples: &track.samples, is_measured: false });
        let measured = plates.iter().flat_map(|plates| plates.feet()).find(|(of, _)| *of == sole);
        if let Some((_, record)) = measured {
            // What was measured before and after the motion is not in the picture.
            let begin = record.time.partition_point(|time| *time < first);
            let end = record.time.partition_point(|time| *time <= last);
            let (time, samples) = (&record.time[begin..end], &record.samples[begin..end]);
            if !time.is_empty() {
                feet.push(FootForces { name: &track.link, time, samples, is_measured: true });
            }
        }
    }
    let axes = [("along x", Vector3::x()), ("along y", Vector3::y()), ("along z", Vector3::z())];
    let title = given.from.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    forces(&feet, &axes, &format!("{title}: forces of the ground"))
}
