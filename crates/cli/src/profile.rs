//! `solaris profile`: one motion curve as a table, a picture, a page or a text.

mod facts;
mod feasible;
mod list;
mod refused;
mod request;
mod summary;
mod table;
mod written;

use crate::args::{CurveArgs, KindCommand, ProfileCommand};
use crate::error::{CliError, UsageError};
use crate::output::{Formats, Outputs};
use crate::print::print;
use facts::Facts;
use request::Request;
use solaris::profiles::{ProfileCurve, text};
use solaris::view::profile::{Labels, page, svg};
use std::io::Write;
use table::Times;

/// What a file of a curve holds.
#[derive(Clone, Copy, Debug)]
enum Format {
    Svg,
    Html,
    Csv,
    Ron,
}

const FORMATS: Formats<Format> =
    &[("svg", Format::Svg), ("html", Format::Html), ("csv", Format::Csv), ("ron", Format::Ron)];

pub(crate) fn run(command: &ProfileCommand) -> Result<(), CliError> {
    match command {
        ProfileCommand::List(args) => list::run(args),
        ProfileCommand::Kind(KindCommand(args)) => draw(&args.curve, || Request::of_kind(args)),
        ProfileCommand::Blend(args) => draw(&args.curve, || Request::of_blend(args)),
        ProfileCommand::Read(args) => draw(&args.curve, || Request::of_file(args)),
    }
}

/// Tabulates or draws a curve.
fn draw<'a>(
    args: &CurveArgs,
    request: impl FnOnce() -> Result<Request<'a>, CliError>,
) -> Result<(), CliError> {
    let outputs = Outputs::new(args.outputs.iter().map(|path| ("-o", path, FORMATS)))?;
    let request = request()?;
    outputs.keep_off(request.reads.as_deref())?;
    let feasible = request.feasible()?;
    if !request.is_complete {
        if outputs.paths().next().is_some() {
            return Err(UsageError::FreeHasNoValue.into());
        }
        return print(|out| facts::write_feasible(out, &feasible, args.json));
    }
    let curve = request.curve()?;
    if args.monotone {
        let refused = request.profile.refuse_reversal();
        refused.map_err(|error| request.refuse(&error))?;
    }
    let labels = summary::labels(&request, args, &feasible);
    outputs.write(|format, writer| write(format, writer, &request, &curve, &labels, args))?;

    let is_written = outputs.paths().next().is_some();
    if args.json {
        let facts = Facts::of(&request, &curve, &labels, &feasible, Times::of_table(&curve, args)?);
        return print(|out| facts.write(out));
    }
    let times = if is_written { None } else { Some(Times::of_table(&curve, args)?) };
    print(|out| {
        summary::heading(out, &request, &labels)?;
        times.map_or(Ok(()), |times| table::print(out, &curve, &labels.unit, times))?;
        summary::answers(out, &curve, &labels)?;
        if is_written {
            writeln!(out)?;
        }
        outputs.written().try_for_each(|line| writeln!(out, "{line}"))
    })
}

fn write(
    format: Format,
    writer: &mut dyn Write,
    request: &Request<'_>,
    curve: &ProfileCurve,
    labels: &Labels,
    args: &CurveArgs,
) -> Result<(), CliError> {
    let written = match format {
        Format::Svg => svg(curve, labels),
        Format::Html => page(curve, labels),
        Format::Ron => text::write(&request.profile),
        Format::Csv => return table::csv(writer, curve, Times::of_file(curve, args)?),
    };
    writer.write_all(written.as_bytes()).map_err(CliError::other)
}
