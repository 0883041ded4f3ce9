//! `solaris profile`: one motion curve as a table, a picture, a page or a text.

mod facts;
mod feasible;
mod list;
mod request;
mod summary;
mod table;
mod written;

use crate::error::CliError;
use crate::output::{Formats, Outputs};
use crate::print::print;
use clap::ArgMatches;
use facts::Facts;
use request::Request;
use solaris::profiles::{ProfileCurve, text};
use solaris::view::profile::{Labels, page, svg};
use std::io::Write;
use std::path::PathBuf;
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

pub(crate) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    match matches.subcommand() {
        Some(("list", matches)) => list::run(matches),
        Some((name, matches)) => draw(name, matches),
        // clap asks for a subcommand.
        None => Ok(()),
    }
}

/// Tabulates or draws a curve.
fn draw(name: &str, matches: &ArgMatches) -> Result<(), CliError> {
    let paths = matches.get_many::<PathBuf>("output").unwrap_or_default();
    let outputs = Outputs::new(paths.map(|path| ("-o", path, FORMATS)))?;
    let request = Request::of(name, matches)?;
    outputs.keep_off(request.reads.as_deref())?;
    let feasible = request.feasible(matches)?;
    if !request.is_complete {
        if outputs.paths().next().is_some() {
            let why = "-o writes one curve, and its free parameter has no value; give it one";
            return Err(CliError::Usage(why.to_owned()));
        }
        return print(|out| facts::write_feasible(out, &feasible, matches.get_flag("json")));
    }
    let curve = request.curve(matches)?;
    if matches.get_flag("monotone") {
        let refused = request.profile.refuse_reversal();
        refused.map_err(|error| request.refuse(&error, matches))?;
    }
    let labels = summary::labels(&request, matches, &feasible);
    outputs.write(|format, writer| write(format, writer, &request, &curve, &labels, matches))?;

    let is_written = outputs.paths().next().is_some();
    if matches.get_flag("json") {
        let facts = Facts::of(&request, &curve, &labels, &feasible, Times::of_table(&curve, matches)?);
        return print(|out| facts.write(out));
    }
    let times = if is_written { None } else { Some(Times::of_table(&curve, matches)?) };
    print(|out| {
        summary::heading(out, &request, &labels)?;
        times.map_or(Ok(()), |times| table::print(out, &curve, &labels.unit, times))?;
        summary::answers(out, &curve, &labels)?;
        if is_written {
            writeln!(out)?;
        }
        outputs.paths().try_for_each(|path| writeln!(out, "wrote {}", path.display()))
    })
}

fn write(
    format: Format,
    writer: &mut dyn Write,
    request: &Request,
    curve: &ProfileCurve,
    labels: &Labels,
    matches: &ArgMatches,
) -> Result<(), CliError> {
    let written = match format {
        Format::Svg => svg(curve, labels),
        Format::Html => page(curve, labels),
        Format::Ron => text::write(&request.profile),
        Format::Csv => return table::csv(writer, curve, Times::of_file(curve, matches)?),
    };
    writer.write_all(written.as_bytes()).map_err(CliError::other)
}
