//! `solaris ground`: what the ground does to the feet in a given motion.

mod against;
mod files;
mod moved;
mod predicted;
mod report;
mod soles;
mod summary;
mod told;

pub(crate) use files::{Content, CyclesFormat, outputs, write_motion};
pub(crate) use predicted::{Ground, Standing, needs_times, say_medium};
pub(crate) use report::GroundReport;
pub(crate) use soles::{From as SolesFrom, find as find_soles, known as known_soles};

use crate::args::GroundCommandArgs;
use crate::convert::TableFormat;
use crate::cycles::{Column, Cycles};
use crate::error::CliError;
use crate::given::{Given, GivenReport, in_order};
use crate::print::{print, write_json};
use crate::progress::Progress;
use crate::shown::{Shown, axes, given_rows, stem, warning_rows};
use crate::subject;
use against::Plates;
use serde::Serialize;
use solaris::io::record::{ForceHeadings, force_table};
use solaris::io::{Table, csv, sto};
use solaris::model::ContactTrack;
use solaris::view::{FootForces, TableRow, forces};
use std::path::PathBuf;

/// What is printed as JSON.
#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    given: GivenReport,
    ground: GroundReport,
    /// The strides, where means over them were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    cycles: Option<Cycles>,
}

pub(crate) fn run(args: &GroundCommandArgs) -> Result<(), CliError> {
    let outputs = outputs(&args.outputs, &args.consistent.motions, &args.cycles.outputs)?;
    let (of, from) = (args.figure.as_path(), args.motion.as_path());
    in_order("ground", of, from)?;
    let others = [&args.ground.soles, &args.stances, &args.against, &args.loads];
    outputs.keep_off([of, from].into_iter().chain(others.into_iter().flatten().map(PathBuf::as_path)))?;

    let progress = Progress::new(4);
    progress.stage("reading");
    let body = subject::body(of, &args.subject, &args.record.markers, &args.frame, &[from])?;
    let mut given = Given::of(body, [of, from], &args.record, &args.frame, &progress)?;
    progress.stage("finding the ground's forces");
    say_medium(&mut given);
    let ground = Ground::new(&args.ground, &args.frame, args.stances.as_deref(), &given)?;
    let moved = ground.make_consistent(&args.consistent, &mut given)?;
    let prepared = given.prepared()?;
    let ground = ground.predict(&given, &prepared, moved)?;
    let plates = Plates::read(args, &given.body.figure, &ground.soles)?;
    let plausible = match &plates {
        Some(plates) => Some(plates.plausibility(&given, &prepared, &ground)?),
        None => None,
    };
    let (time, weight) = (given.motion().time(), ground.forces.report.weight);
    let (soles, stances) = (ground.soles.clone(), ground.forces.stances.clone());
    let tracks = ground.forces.contacts.clone();
    // The same by link, where tables go by the sole.
    let contacts = ground.forces.loads().contacts(&given.body.figure);
    let mut report =
        Report { ground: GroundReport::new(ground, &given), given: GivenReport::new(&given), cycles: None };
    if let (Some(plates), Some(plausible)) = (&plates, plausible) {
        let (feet, whole) = plates.beside(time, &tracks, weight);
        report.ground.hold_against(feet, whole, plausible);
    }
    let table = |headings| force_table(headings, time, &tracks).map_err(CliError::other);
    if let Some(foot) = &args.cycles.foot {
        let columns = columns(&table(ForceHeadings::Solaris)?);
        report.cycles = Some(Cycles::of(foot, (&soles, &stances), time, columns)?);
    }
    let shown = Shown {
        given: &given,
        contacts: &contacts,
        is_measured: false,
        soles: &soles,
        level: Some(stances.level),
        forces: None,
        bands: None,
    };

    progress.stage("writing");
    outputs.write(|content, mut writer| {
        let text = match content {
            Content::Forces(TableFormat::Csv) => {
                let table = table(ForceHeadings::Solaris)?;
                return csv::write_table(&table, &mut writer).map_err(CliError::other);
            }
            Content::Forces(TableFormat::Sto) => {
                let table = table(ForceHeadings::OpenSim)?;
                return sto::write(&table, &mut writer).map_err(CliError::other);
            }
            #[cfg(feature = "parquet")]
            Content::Forces(TableFormat::Parquet) => {
                let table = table(ForceHeadings::Solaris)?;
                return solaris::io::parquet::write_table(&table, &mut writer).map_err(CliError::other);
            }
            Content::Motion(format) => return write_motion(format, writer, &given),
            Content::Cycles(format) => {
                let title = stem(&given);
                return report
                    .cycles
                    .iter()
                    .try_for_each(|cycles| cycles.write_file(format, &title, &mut *writer));
            }
            Content::Page => shown.page("the ground's forces", report.page_rows())?,
            Content::Picture => picture(&tracks, &given, plates.as_ref()),
        };
        writer.write_all(text.as_bytes()).map_err(CliError::other)
    })?;
    drop(progress);
    print(|out| {
        if args.json {
            return write_json(out, &report);
        }
        report.given.write(out)?;
        report.given.write_doubts(out)?;
        report.cycles.iter().try_for_each(|cycles| cycles.write(out))?;
        report.ground.write(out)?;
        outputs.written().try_for_each(|line| writeln!(out, "\n{line}"))
    })
}

impl Report {
    fn page_rows(&self) -> Vec<TableRow> {
        let mut rows = given_rows(&self.given);
        rows.extend(warning_rows(&self.ground.warnings));
        rows.extend(self.ground.plausibility().iter().flat_map(|plausible| plausible.page_rows()));
        rows.extend(self.cycles.iter().map(|cycles| TableRow::new("Strides", "", "", cycles.words())));
        rows.extend(self.ground.page_rows());
        rows
    }
}

/// Every column of a table of forces; pictures have the forces alone.
fn columns(table: &Table) -> Vec<Column> {
    let forces = table.columns.iter().enumerate().filter(|(_, heading)| *heading != "time");
    let column = |(index, heading): (usize, &String)| Column {
        heading: heading.clone(),
        name: [".fx", ".fy", ".fz"].iter().any(|end| heading.ends_with(end)).then(|| heading.clone()),
        unit: "N",
        factor: 1.0,
        values: table.values_of(index).collect(),
    };
    forces.map(column).collect()
}

/// Forces of each foot along the world's axes, and what plates measured.
fn picture(tracks: &[ContactTrack], given: &Given, plates: Option<&Plates>) -> String {
    let time = given.motion().time();
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
    forces(&feet, &axes(), &format!("{}: forces of the ground", stem(given)))
}
