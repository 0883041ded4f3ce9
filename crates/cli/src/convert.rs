//! `solaris convert`: a figure or a motion from one format to another.

use crate::args::ConvertArgs;
use crate::error::{CliError, UsageError};
use crate::figure::TEXT;
use crate::findings::{list, of_medium};
use crate::input::{self, Body, extension, refuse_unread};
use crate::output::{Formats, Outputs};
use crate::print::print;
use crate::words::{rounded, some};
use solaris::io::{csv, headings, sto};
use solaris::model::{FindingKind, Scaling, text};

/// What a table is written as.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum TableFormat {
    /// Comma-separated, `DOF.q`.
    Csv,
    /// OpenSim's, `DOF`.
    Sto,
}

/// The formats of a table.
pub(crate) const TABLE: Formats<TableFormat> =
    &[("csv", TableFormat::Csv), ("sto", TableFormat::Sto), ("mot", TableFormat::Sto)];

pub(crate) fn run(args: &ConvertArgs) -> Result<(), CliError> {
    refuse_unread(
        &args.from,
        "read are figures (.ron, .urdf, .sdf, .xml, .mjcf, .osim) and motions (.csv, .mot, .sto)",
    )?;
    let is_table = TABLE.iter().any(|(known, _)| *known == extension(&args.from));
    if !is_table {
        return figure(args);
    }
    if args.size.is_asked() {
        return Err(UsageError::MotionHasNoSize.into());
    }
    motion(args)
}

fn figure(ConvertArgs { from, to, size, files, .. }: &ConvertArgs) -> Result<(), CliError> {
    if TABLE.iter().any(|(known, _)| *known == extension(to)) {
        let why = format!("IN {} is a figure, and a figure is written as .ron", from.display());
        return Err(CliError::Output { option: "OUT", path: to.clone(), why });
    }
    let outputs = Outputs::new([("OUT", to, TEXT)])?;
    let Body { mut figure, language, mut findings, medium, .. } = input::body_in(from, files.as_deref())?;
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

fn motion(ConvertArgs { from, to, figure, files, .. }: &ConvertArgs) -> Result<(), CliError> {
    let outputs = Outputs::new([("OUT", to, TABLE)])?;
    let table = input::table(from)?;
    let figure = match figure {
        Some(path) => Some(input::body_in(path, files.as_deref())?.figure),
        None => None,
    };
    let (positions, left_out) = if extension(from) == "csv" {
        (table, Vec::new())
    } else {
        headings::from_opensim(&table, figure.as_ref()).map_err(|error| CliError::input(from, &error))?
    };
    let (bare, no_positions) = headings::to_opensim(&positions);
    if bare.columns.iter().all(|name| name == "time") {
        let why = match &figure {
            Some(figure) => format!("it has no position of figure '{}'", figure.name()),
            None => "it has no position: no heading ends in .q".to_owned(),
        };
        return Err(CliError::input(from, &why));
    }
    outputs.write(|format, mut writer| {
        match format {
            TableFormat::Csv => csv::write_table(&positions, &mut writer),
            TableFormat::Sto => sto::write(&bare, &mut writer),
        }
        .map_err(CliError::other)
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
        outputs.written().try_for_each(|line| writeln!(out, "{line}"))
    })
}
