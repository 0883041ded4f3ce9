//! `solaris walk`: a person walks.

mod notes;
mod numbers;
mod planned;
mod report;
mod request;
mod summary;
mod told;

use crate::args::{BODY_MASS_INDEX, HEIGHT, RATE, check};
use crate::error::CliError;
use crate::input;
use crate::limbs::Limbs;
use crate::output::{Formats, Outputs};
use crate::print::print;
use crate::progress::Progress;
use clap::ArgMatches;
use planned::Planned;
use report::Report;
pub(crate) use request::request;
use request::{looped, number, out_of_range};
use solaris::gait::{isolated_peaks, measure, missing_for_walking};
use solaris::model::{Figure, Motion, human};
use solaris::view::{PageOptions, page};
use std::io::Write;
use std::path::PathBuf;

/// What a file of a walk holds.
#[derive(Clone, Copy, Debug)]
enum Format {
    Html,
    Csv,
    Bvh,
    Json,
}

const MOTION: Formats<Format> = &[("html", Format::Html), ("csv", Format::Csv), ("bvh", Format::Bvh)];
const REPORT: Formats<Format> = &[("json", Format::Json)];

/// The most samples of a motion: the longest walk at the default rate has 1.2 million, some 6 GB.
const MOST_FRAMES: f64 = 1.5e6;

/// Plans the walk, finds its forces, writes it, and says what it came to.
pub(crate) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    check(matches)?;
    let motions = matches.get_many::<PathBuf>("output").unwrap_or_default();
    let outputs = Outputs::new(
        motions
            .map(|path| ("-o", path, MOTION))
            .chain(matches.get_one::<PathBuf>("report").map(|path| ("--report", path, REPORT))),
    )?;
    outputs.keep_off(matches.get_one::<PathBuf>("figure").map(PathBuf::as_path))?;
    let rate = number(matches, "rate").unwrap_or(RATE.0);
    if !(RATE.1..=RATE.2).contains(&rate) {
        return Err(out_of_range(matches, "rate", format!("it must be {} to {} frames/s", RATE.1, RATE.2)));
    }
    let figure = figure(matches)?;
    let request = request(matches)?;

    let progress = Progress::new(4);
    let planned = Planned::of(&figure, &request, looped(matches), rate, &progress, matches)?;
    progress.stage("measuring");
    let measures = measure(&figure, &planned.motion).map_err(CliError::other)?;
    let lone = isolated_peaks(&planned.motion).map_err(CliError::other)?;
    let limbs = Limbs::of(&figure, &planned.motion)?;
    let motion = planned.motion.clone();
    let report = Report::new(figure.mass(), planned, &measures, &lone, limbs);
    progress.stage("writing");
    outputs.write(|format, writer| write(format, writer, &figure, &motion, &report))?;
    drop(progress);

    if matches.get_flag("json") {
        print(|out| report.write(out))
    } else {
        print(|out| out.write_all(summary::table(&report, outputs.paths()).as_bytes()))
    }
}

/// Who walks: the figure of a file that has all that a walk needs, or a human.
pub(crate) fn figure(matches: &ArgMatches) -> Result<Figure, CliError> {
    if let Some(path) = matches.get_one::<PathBuf>("figure") {
        let figure = input::body(path)?.figure;
        let lacks = missing_for_walking(&figure);
        return if lacks.is_empty() {
            Ok(figure)
        } else {
            let list = lacks.iter().map(|lack| format!("\n  - {lack}")).collect::<Vec<_>>().concat();
            Err(CliError::input(path, &format!("figure '{}' cannot walk:{list}", figure.name())))
        };
    }
    person(matches)
}

/// A human of the height and mass that are asked for, or of the usual ones.
pub(crate) fn person(matches: &ArgMatches) -> Result<Figure, CliError> {
    let height = number(matches, "height").unwrap_or(HEIGHT);
    let mass = number(matches, "mass").unwrap_or(BODY_MASS_INDEX * height * height);
    human(height, mass).map_err(|error| CliError::of_human(error, matches))
}

/// Refuses a motion for which no memory may be left.
fn check_size(duration: f64, rate: f64) -> Result<(), CliError> {
    let frames = duration * rate;
    if frames <= MOST_FRAMES {
        return Ok(());
    }
    Err(CliError::TooLong { duration, rate, frames, most: MOST_FRAMES })
}

fn write(
    format: Format,
    mut writer: &mut dyn Write,
    figure: &Figure,
    motion: &Motion,
    report: &Report,
) -> Result<(), CliError> {
    match format {
        Format::Csv => solaris::io::csv::write(figure, motion, &mut writer).map_err(CliError::other),
        Format::Bvh => {
            let unit = solaris::io::bvh::Unit::default();
            solaris::io::bvh::write(figure, motion, unit, &mut writer).map_err(CliError::other)
        }
        Format::Html => {
            let options = PageOptions { title: summary::title(report), table: summary::page_rows(report) };
            let html = page(figure, motion, &options).map_err(CliError::other)?;
            writer.write_all(html.as_bytes()).map_err(CliError::other)
        }
        Format::Json => report.write(writer).map_err(CliError::other),
    }
}
