//! `solaris convert`: a figure or a motion from one format to another.

mod markers;

use crate::animation::{self, BodyFormat};
use crate::args::{BonesArgs, ConvertArgs, UpArg};
use crate::error::{CliError, UsageError};
use crate::figure::TEXT;
use crate::findings::{list, of_medium};
use crate::input::{self, Body, extension, refuse_unread};
use crate::output::{Formats, Outputs};
use crate::print::print;
use crate::words::{rounded, some};
use solaris::io::bvh;
use solaris::io::clip::{ReadOptions, Up};
#[cfg(feature = "parquet")]
use solaris::io::parquet;
use solaris::io::{Table, csv, headings, record, sto};
use solaris::model::{Figure, Finding, FindingKind, Motion, Scaling, Vector3, text};
use solaris::view::{PageOptions, TableRow, page};
use std::path::Path;

/// What a table is written as.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum TableFormat {
    /// Comma-separated, `DOF.q`.
    Csv,
    /// OpenSim's, `DOF`.
    Sto,
    /// Parquet, headed as CSV.
    #[cfg(feature = "parquet")]
    Parquet,
}

/// What a motion is written as.
#[derive(Clone, Copy, Debug, PartialEq)]
enum MotionFormat {
    Table(TableFormat),
    Bvh,
    Body(BodyFormat),
    /// The figure in its motion, on a page.
    Page,
}

const MOTION: Formats<MotionFormat> = &[
    ("csv", MotionFormat::Table(TableFormat::Csv)),
    ("sto", MotionFormat::Table(TableFormat::Sto)),
    ("mot", MotionFormat::Table(TableFormat::Sto)),
    ("bvh", MotionFormat::Bvh),
    ("glb", MotionFormat::Body(BodyFormat::Glb)),
    ("usda", MotionFormat::Body(BodyFormat::Usda)),
    #[cfg(feature = "parquet")]
    ("parquet", MotionFormat::Table(TableFormat::Parquet)),
    ("html", MotionFormat::Page),
];

/// Motions that are read, beside those that come with their bones.
const READ: [&str; 3] = ["csv", "sto", "mot"];

/// How far a frame may be from where the frames' rate has it, as a part of the time between two (BVH has one such time).
const UNEVEN: f64 = 0.01;

pub(crate) fn run(args: &ConvertArgs) -> Result<(), CliError> {
    if crate::recording::is_one(&args.from) {
        return markers::run(args);
    }
    if args.axes.is_some() {
        return Err(UsageError::OnlyOfMarkers.into());
    }
    refuse_unread(
        &args.from,
        "read are figures (.ron, .urdf, .sdf, .xml, .mjcf, .osim), motions (.csv, .mot, .sto), both (.bvh, .glb) and markers (.c3d, .trc)",
    )?;
    let is_clip = input::is_clip(&args.from);
    if args.skeleton.is_asked() && !is_clip {
        return Err(UsageError::OnlyOfBones.into());
    }
    let is_written = MOTION.iter().any(|(known, _)| *known == extension(&args.to));
    let is_motion = if is_clip { is_written } else { READ.contains(&extension(&args.from).as_str()) };
    if !is_motion {
        return figure(args);
    }
    if args.size.is_asked() {
        return Err(UsageError::MotionHasNoSize.into());
    }
    motion(args)
}

/// What a file of bones does not say.
pub(crate) fn options(args: &BonesArgs) -> Result<ReadOptions, CliError> {
    let masses = match &args.masses {
        Some(path) => {
            let text = input::text(path)?;
            bvh::masses(&text).map_err(|faults| input::faulty(path, &text, faults))?
        }
        None => Vec::new(),
    };
    let up = args.up.map(|up| match up {
        UpArg::Y => Up::Y,
        UpArg::Z => Up::Z,
    });
    let clip = args.clip.clone();
    Ok(ReadOptions { unit: args.unit, up, masses, skip: args.skip_frames, mass: None, clip })
}

fn figure(ConvertArgs { from, to, size, files, skeleton, .. }: &ConvertArgs) -> Result<(), CliError> {
    if MOTION.iter().any(|(known, _)| *known == extension(to)) {
        let why = format!("IN {} is a figure, and a figure is written as .ron", from.display());
        return Err(CliError::Output { option: "OUT", path: to.clone(), why });
    }
    let outputs = Outputs::new([("OUT", to, TEXT)])?;
    let Body { mut figure, language, mut findings, medium, .. } =
        input::body_with(from, files.as_deref(), &options(skeleton)?)?;
    findings.extend(of_medium(&medium, FindingKind::Missing));
    if size.is_asked() {
        let [height, mass] =
            [&size.height, &size.mass].map(|number| number.as_ref().map(|number| number.value));
        let scaling = Scaling { height, mass, segments: size.segments.clone() };
        figure = figure.scaled(&scaling).map_err(|error| CliError::input(from, &error))?;
    }
    let text = text::write(&figure);
    outputs.write(|(), writer| writer.write_all(text.as_bytes()).map_err(CliError::other))?;
    print(|out| {
        let (name, links, dofs) = (figure.name(), figure.links().len(), figure.layout().nv());
        let (what, mass) = (language.name(), rounded(figure.mass()));
        writeln!(out, "{what} '{name}': {links} links, {dofs} degrees of freedom, {mass} kg")?;
        list(out, &findings)?;
        outputs.written().try_for_each(|line| writeln!(out, "{line}"))
    })
}

fn motion(
    ConvertArgs { from, to, figure, files, skeleton, bones, .. }: &ConvertArgs,
) -> Result<(), CliError> {
    animation::check(bones, [to.as_path()])?;
    let bones = &animation::asked(bones)?;
    let outputs = Outputs::new([("OUT", to, MOTION)])?;
    let body = match figure {
        Some(path) => Some(input::body_in(path, files.as_deref())?),
        None => None,
    };
    let Positions { table, left_out, body, findings } = positions(from, body, skeleton)?;
    if body.is_none() && ["bvh", "glb", "html"].contains(&extension(to).as_str()) {
        let what = extension(to);
        return Err(UsageError::OfFigure { what, to: to.clone() }.into());
    }
    let (bare, no_positions) = headings::to_opensim(&table);
    if bare.columns.iter().all(|name| name == "time") {
        let why = match &body {
            Some(body) => format!("it has no position of figure '{}'", body.figure.name()),
            None => "it has no position: no heading ends in .q".to_owned(),
        };
        return Err(CliError::input(from, &why));
    }
    outputs.write(|format, mut writer| match format {
        MotionFormat::Table(TableFormat::Csv) => {
            csv::write_table(&table, &mut writer).map_err(CliError::other)
        }
        MotionFormat::Table(TableFormat::Sto) => sto::write(&bare, &mut writer).map_err(CliError::other),
        #[cfg(feature = "parquet")]
        MotionFormat::Table(TableFormat::Parquet) => {
            parquet::write_table(&table, &mut writer).map_err(CliError::other)
        }
        MotionFormat::Bvh => {
            let Some(body) = &body else { return Ok(()) };
            let motion = even(&body.figure, body.gravity, &table, from)?;
            animation::bones(&body.figure, &motion, false, bones, writer)
        }
        MotionFormat::Body(how) => {
            let Some(body) = &body else { return Ok(()) };
            let found = record::read(&body.figure, body.gravity, &table);
            let motion = found.map_err(|error| CliError::input(from, &error))?.motion;
            animation::body(how, &body.figure, &motion, &stem(from), bones, writer)
        }
        MotionFormat::Page => {
            let Some(body) = &body else { return Ok(()) };
            let found = record::read(&body.figure, body.gravity, &table);
            let motion = found.map_err(|error| CliError::input(from, &error))?.motion;
            let title = stem(from);
            let rows = findings.iter().map(|finding| TableRow::new("Look at", "", "", finding.to_string()));
            let (table, forward) = (rows.collect(), body.forward());
            let options = PageOptions { title, table, forward, ..PageOptions::default() };
            let page = page(&body.figure, &motion, &options).map_err(CliError::other)?;
            writer.write_all(page.as_bytes()).map_err(CliError::other)
        }
    })?;
    print(|out| {
        writeln!(
            out,
            "{} rows of {} coordinates, in rad and m",
            bare.len(),
            bare.columns.len().saturating_sub(1)
        )?;
        for left_out in [left_out, no_positions].iter().filter(|names| !names.is_empty()) {
            writeln!(out, "left out, as no positions: {}", some(left_out))?;
        }
        list(out, &findings)?;
        outputs.written().try_for_each(|line| writeln!(out, "{line}"))
    })
}

/// A file's name without its extension.
pub(crate) fn stem(path: &Path) -> String {
    path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default()
}

/// The motion of a table, of a figure.
pub(crate) fn motion_of(from: &Path, body: &Body) -> Result<Motion, CliError> {
    let refuse = |error: &dyn ToString| CliError::input(from, error);
    let table = input::table(from)?;
    let table = match extension(from).as_str() {
        "csv" => table,
        _ => headings::from_opensim(&table, Some(&body.figure)).map_err(|error| refuse(&error))?.0,
    };
    Ok(record::read(&body.figure, body.gravity, &table).map_err(|error| refuse(&error))?.motion)
}

/// The positions of a motion, headed as in CSV, and what comes with them.
struct Positions {
    table: Table,
    /// Headings of what is no position.
    left_out: Vec<String>,
    body: Option<Body>,
    findings: Vec<Finding>,
}

/// Reads a motion, of a figure where there is one.
fn positions(from: &Path, body: Option<Body>, skeleton: &BonesArgs) -> Result<Positions, CliError> {
    let refuse = |error: &dyn ToString| CliError::input(from, error);
    let figure = body.as_ref().map(|body| &body.figure);
    match extension(from).as_str() {
        _ if input::is_clip(from) => {
            let clip = input::clip(from, &options(skeleton)?)?;
            let table = match figure {
                Some(figure) => clip.table_of(figure).map_err(|error| refuse(&error))?,
                None => clip.table(),
            };
            let body = body.unwrap_or_else(|| Body::own(clip.figure));
            Ok(Positions { table, left_out: Vec::new(), body: Some(body), findings: clip.findings })
        }
        "csv" => {
            Ok(Positions { table: input::table(from)?, left_out: Vec::new(), body, findings: Vec::new() })
        }
        _ => {
            let found = headings::from_opensim(&input::table(from)?, figure);
            let (table, left_out) = found.map_err(|error| refuse(&error))?;
            Ok(Positions { table, left_out, body, findings: Vec::new() })
        }
    }
}

/// The motion of a table whose rows are evenly apart.
fn even(figure: &Figure, gravity: Vector3<f64>, table: &Table, from: &Path) -> Result<Motion, CliError> {
    let motion = record::read(figure, gravity, table).map_err(|error| CliError::input(from, &error))?.motion;
    let (time, rate) = (motion.time(), motion.info.rate);
    let off = |row: &usize| ((time[*row] - time[0]) * rate - *row as f64).abs() > UNEVEN;
    match (0..time.len()).find(off) {
        Some(row) => {
            let why = format!(
                "its rows are not evenly apart, and .bvh has one time between frames: row {} is at {} s; resample it first",
                row + 1,
                rounded(time[row])
            );
            Err(CliError::input(from, &why))
        }
        None => Ok(motion),
    }
}
