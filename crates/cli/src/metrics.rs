//! `solaris metrics`: numbers of any motion.

mod evidence;
mod report;

use crate::args::MetricsArgs;
use crate::error::CliError;
use crate::given::{Given, GivenReport, in_order};
use crate::ground::needs_times;
use crate::input::{self, Body};
use crate::markers;
use crate::output::{Formats, Outputs};
use crate::print::print;
use crate::progress::Progress;
use crate::walk::person;
use evidence::Evidence;
use report::Report;
use solaris::gait::metrics::metrics;
use std::path::Path;

/// What a file of metrics is.
#[derive(Clone, Copy, Debug)]
enum Format {
    Json,
    Csv,
}

const FILES: Formats<Format> = &[("json", Format::Json), ("csv", Format::Csv)];

pub(crate) fn run(args: &MetricsArgs) -> Result<(), CliError> {
    let outputs = Outputs::new(args.outputs.iter().map(|path| ("-o", path, FILES)))?;
    let (figure, from) = (args.figure(), args.motion.as_path());
    if let Some(of) = figure {
        in_order("metrics", of, from)?;
    }
    outputs.keep_off([from].into_iter().chain(figure).chain(args.how.soles.as_deref()))?;

    let progress = Progress::new(4);
    progress.stage("reading");
    let (mut body, of) = match figure {
        Some(path) => (input::body_in(path, args.frame.files.as_deref())?, path),
        None => (Body::own(person(&args.person)?), Path::new("the human")),
    };
    body.markers.markers = markers::markers(&body, args.record.markers.marker_set.as_deref())?;
    let is_guess = figure.is_none();
    let given = Given::of((body, None), [of, from], &args.record, &args.frame, &progress).map_err(
        |error| match error {
            CliError::Input { path, why } if is_guess && path.is_file() => {
                let why = format!(
                    "{why}; with no FIGURE before it, it is taken for the motion of a human of `solaris walk`"
                );
                CliError::Input { path, why }
            }
            other => other,
        },
    )?;
    needs_times(&given)?;
    progress.stage("finding the steps");
    let prepared = given.prepared()?;
    let evidence = Evidence::find(args, &given, &prepared)?;
    progress.stage("measuring");
    let all = metrics(&evidence.input()).map_err(|error| CliError::input(from, &error))?;
    let report = Report::new(GivenReport::new(&given), &evidence, all);
    outputs.write(|format, mut writer| match format {
        Format::Json => report.write_json(writer).map_err(CliError::other),
        Format::Csv => report.write_csv(&mut writer).map_err(CliError::other),
    })?;
    drop(progress);
    print(|out| {
        if args.json {
            return report.write_json(out);
        }
        report.write(out)?;
        outputs.written().try_for_each(|line| writeln!(out, "\n{line}"))
    })
}
