//! `solaris walk`: a person walks.

mod numbers;
mod report;
mod summary;

use crate::args::{BODY_MASS_INDEX, DEFAULT_STEPS, HEIGHT, RATE, check};
use crate::error::{CliError, typed};
use crate::output::{Format, Outputs};
use crate::progress::Progress;
use clap::ArgMatches;
use report::Report;
use solaris::gait::{Extent, FEET, PARAMETERS, STEPS, WalkRequest, measure, walk};
use solaris::model::{Figure, Motion, Trajectory, human};
use solaris::modes::ground_reactions;
use solaris::view::{PageOptions, page};
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

/// The most samples of a motion: the longest walk at the default rate has 1.2 million, some 6 GB.
const MOST_FRAMES: f64 = 1.5e6;

/// Plans the walk, finds its forces, writes it, and says what it came to.
pub(crate) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    check(matches)?;
    let outputs = Outputs::new(
        matches.get_many::<PathBuf>("output").unwrap_or_default(),
        matches.get_one::<PathBuf>("report"),
    )?;
    let rate = number(matches, "rate").unwrap_or(RATE.0);
    if !(RATE.1..=RATE.2).contains(&rate) {
        return Err(out_of_range(matches, "rate", format!("it must be {} to {} frames/s", RATE.1, RATE.2)));
    }
    let height = number(matches, "height").unwrap_or(HEIGHT);
    let mass = number(matches, "mass").unwrap_or(BODY_MASS_INDEX * height * height);
    let figure = human(height, mass).map_err(|error| CliError::of_human(error, matches))?;
    let request = request(matches)?;

    let progress = Progress::new(4);
    let start = Instant::now();
    progress.stage("planning the walk");
    let plan = walk(&figure, &request).map_err(|error| CliError::of_gait(error, matches))?;
    let planned = start.elapsed();
    check_size(plan.duration(), rate)?;
    progress.stage("finding the forces");
    let mut motion = plan.motion(&figure, rate).map_err(CliError::other)?;
    let reactions = ground_reactions(&figure, &mut motion, FEET, &plan).map_err(CliError::other)?;
    progress.stage("measuring");
    let measures = measure(&figure, &motion).map_err(CliError::other)?;
    let solved = start.elapsed();
    let report = Report::new(height, mass, &plan, &motion, &reactions, &measures, (planned, solved));
    progress.stage("writing");
    outputs.write(|format, writer| write(format, writer, &figure, &motion, &report))?;
    drop(progress);

    let mut stdout = anstream::stdout().lock();
    let printed = if matches.get_flag("json") {
        report.write(&mut stdout)
    } else {
        stdout.write_all(summary::table(&report, outputs.paths()).as_bytes())
    };
    match printed.and_then(|()| stdout.flush()) {
        // Whoever reads has read enough.
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
        other => other.map_err(CliError::Stdout),
    }
}

fn number(matches: &ArgMatches, name: &str) -> Option<f64> {
    matches.get_one::<f64>(name).copied()
}

fn out_of_range(matches: &ArgMatches, option: &str, why: String) -> CliError {
    CliError::Option { option: option.to_owned(), value: typed(matches, option).unwrap_or_default(), why }
}

/// Refuses a motion for which no memory may be left.
fn check_size(duration: f64, rate: f64) -> Result<(), CliError> {
    let frames = duration * rate;
    if frames <= MOST_FRAMES {
        return Ok(());
    }
    Err(CliError::TooLong { duration, rate, frames, most: MOST_FRAMES })
}

fn request(matches: &ArgMatches) -> Result<WalkRequest, CliError> {
    let steps = matches.get_one::<i64>("steps").copied().unwrap_or(DEFAULT_STEPS);
    let extent = if let Some(distance) = number(matches, "distance") {
        Extent::Distance(distance)
    } else {
        let in_range = usize::try_from(steps).ok().filter(|steps| (STEPS.0..=STEPS.1).contains(steps));
        let why = || format!("it must be {} to {}", STEPS.0, STEPS.1);
        let steps = in_range.ok_or_else(|| out_of_range(matches, "steps", why()))?;
        Extent::Steps(steps)
    };
    let parameters = PARAMETERS.iter().filter_map(|p| number(matches, p.name).map(|value| (p.name, value)));
    Ok(WalkRequest {
        step_frequency: number(matches, "step-frequency"),
        step_length: number(matches, "step-length"),
        speed: number(matches, "speed"),
        extent,
        parameters: parameters.collect(),
        ..WalkRequest::default()
    })
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
