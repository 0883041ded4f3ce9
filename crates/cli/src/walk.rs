//! `solaris walk`: a person walks.

mod numbers;
mod report;
mod summary;

use crate::args::{BODY_MASS_INDEX, DEFAULT_STEPS, HEIGHT, RATE, check};
use crate::error::{CliError, typed};
use crate::input;
use crate::limbs::Limbs;
use crate::output::{Formats, Outputs};
use crate::print::print;
use crate::progress::Progress;
use clap::ArgMatches;
use report::Report;
use solaris::gait::{Extent, FEET, PARAMETERS, STEPS, WalkRequest, lacks, measure, walk};
use solaris::model::{Figure, Motion, Trajectory, human};
use solaris::modes::{ground_reactions, reactions_from_feet};
use solaris::view::{PageOptions, page};
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

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
    let start = Instant::now();
    progress.stage("planning the walk");
    let plan = walk(&figure, &request).map_err(|error| CliError::of_gait(error, matches))?;
    let planned = start.elapsed();
    check_size(plan.duration(), rate)?;
    progress.stage("finding the forces");
    let mut motion = plan.motion(&figure, rate).map_err(CliError::other)?;
    let reactions = ground_reactions(&figure, &mut motion, FEET, &plan).map_err(CliError::other)?;
    let from_feet = matches.get_one::<String>("root").is_some_and(|root| root == "foot");
    let rooted = from_feet.then(|| reactions_from_feet(&figure, &mut motion, FEET)).transpose();
    let rooted = rooted.map_err(CliError::other)?;
    progress.stage("measuring");
    let measures = measure(&figure, &motion).map_err(CliError::other)?;
    let solved = start.elapsed();
    let limbs = Limbs::of(&figure, &motion)?;
    let person = (plan.stature(), figure.mass());
    let forces = (&reactions, rooted.as_ref());
    let report = Report::new(person, &plan, &motion, forces, (&measures, limbs), (planned, solved));
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
        let lacks = lacks(&figure);
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

/// What is asked of the walk.
pub(crate) fn request(matches: &ArgMatches) -> Result<WalkRequest, CliError> {
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
