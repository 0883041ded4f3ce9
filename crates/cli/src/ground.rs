//! `solaris ground`: what the ground does to the feet in a given motion.

mod against;
mod files;
mod moved;
mod predicted;
mod report;
mod soles;
mod summary;

pub(crate) use files::{Content, outputs, write_motion};

use files::{Written, outputs_or_picture};
pub(crate) use predicted::{Predicted, needs_times, refused, standing};
pub(crate) use report::GroundReport;
pub(crate) use soles::{From as SolesFrom, find as find_soles, known as known_soles};

use crate::convert::{TABLE, TableFormat};
use crate::error::CliError;
use crate::given::{Given, GivenReport};
use crate::input::extension;
use crate::print::{print, write_json};
use crate::progress::Progress;
use against::Plates;
use clap::ArgMatches;
use serde::Serialize;
use solaris::io::record::{ForceHeadings, force_table};
use solaris::io::{csv, sto};
use solaris::model::Vector3;
use solaris::view::{FootForces, forces};
use std::path::{Path, PathBuf};

/// What is printed as JSON.
#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    given: GivenReport,
    ground: GroundReport,
}

pub(crate) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    let outputs = outputs_or_picture(matches)?;
    let [mut from, mut of] =
        ["motion", "figure"].map(|name| matches.get_one::<PathBuf>(name).cloned().unwrap_or_default());
    // `solaris inverse` has them the other way round, and their names tell them apart.
    if is_table(&of) && !is_table(&from) {
        std::mem::swap(&mut of, &mut from);
    }
    let others = ["soles", "against"].map(|name| matches.get_one::<PathBuf>(name));
    outputs.keep_off([&of, &from].into_iter().chain(others.into_iter().flatten()).map(PathBuf::as_path))?;

    let progress = Progress::new(4);
    progress.stage("reading");
    let mut given = Given::read(matches, &of, &from, &progress)?;
    progress.stage("finding the ground's forces");
    let ground = Predicted::find(matches, &mut given)?;
    let plates = Plates::read(matches, &ground.soles)?;

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
    if let Some((feet, whole)) = beside {
        report.ground.hold_against(feet, whole);
    }
    print(|out| {
        if matches.get_flag("json") {
            return write_json(out, &report);
        }
        report.given.write(out)?;
        report.given.write_doubts(out)?;
        report.ground.write(out)?;
        outputs.paths().try_for_each(|path| writeln!(out, "\nwrote {}", path.display()))
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

fn is_table(path: &Path) -> bool {
    TABLE.iter().any(|(known, _)| *known == extension(path))
}
