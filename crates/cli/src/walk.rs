//! `solaris walk`: a person walks.

mod everyone;
mod notes;
mod numbers;
mod planned;
mod report;
mod request;
mod summary;
mod told;

use crate::animation::{self, BodyFormat, Bones};
use crate::args::{BODY_MASS_INDEX, HEIGHT, PersonArgs, WalkArgs, WalkFiles, WhoArgs};
use crate::error::{CliError, UsageError};
use crate::input;
use crate::limbs;
use crate::output::{Formats, Outputs};
use crate::print::print;
use crate::progress::Progress;
pub(crate) use everyone::dressed;
use planned::Planned;
use report::Report;
pub(crate) use request::asked;
use solaris::gait::{isolated_peaks, measure, missing_for_walking};
use solaris::model::{Figure, Human, Motion, RootOrder};
use solaris::view::{FilmOptions, PageOptions, Seen, film, page};
use std::io::Write;

/// What a file of a walk holds.
#[derive(Clone, Copy, Debug)]
enum Format {
    Html,
    Csv,
    Bvh,
    Body(BodyFormat),
    Json,
    Svg,
}

const MOTION: Formats<Format> = &[
    ("html", Format::Html),
    ("csv", Format::Csv),
    ("bvh", Format::Bvh),
    ("glb", Format::Body(BodyFormat::Glb)),
    ("usda", Format::Body(BodyFormat::Usda)),
    ("svg", Format::Svg),
];
const REPORT: Formats<Format> = &[("json", Format::Json)];

/// The most samples of a motion: the longest walk at the default rate has 1.2 million, some 6 GB.
const MOST_FRAMES: f64 = 1.5e6;

/// Plans the walk, finds its forces, writes it, and says what it came to.
pub(crate) fn run(args: &WalkArgs) -> Result<(), CliError> {
    let files = &args.files;
    let motions = files.outputs.iter().map(|path| ("-o", path, MOTION));
    let outputs = Outputs::new(motions.chain(files.report.iter().map(|path| ("--report", path, REPORT))))?;
    outputs.keep_off(args.who.figure.as_deref())?;
    let drawn = outputs.paths().any(|path| input::extension(path) == "svg");
    if let Some(option) = files.film.given().filter(|_| !drawn) {
        return Err(UsageError::NoStrip { option }.into());
    }
    animation::check(&files.bones, outputs.paths())?;
    let bones = animation::asked(&files.bones)?;
    let asked = asked(args)?;
    let mut figure = figure(&args.who)?;

    let progress = Progress::new(4);
    let (planned, motion) = Planned::of(&mut figure, &asked, args, &progress)?;
    progress.stage("measuring");
    let measures = measure(&figure, &motion).map_err(CliError::other)?;
    let lone = isolated_peaks(&motion).map_err(CliError::other)?;
    let limbs = limbs::nearest(&figure, &motion, &[])?;
    // Pages and clips go by their time; who plays frame after frame shall not see one twice.
    let shorter = planned.repeats.then(|| motion.without_last());
    let frames = shorter.as_ref().unwrap_or(&motion);
    let carried = args.who.person.loads.iter().map(|(_, load)| load).sum();
    let report = Report::new((figure.mass(), carried), planned, &motion, measures, &lone, limbs);
    progress.stage("writing");
    outputs.write(|format, writer| {
        let motion = if matches!(format, Format::Csv | Format::Json) { frames } else { &motion };
        write(format, writer, &figure, motion, &report, files, &bones)
    })?;
    drop(progress);

    if files.json {
        print(|out| report.write(out))
    } else {
        print(|out| out.write_all(summary::table(&report, outputs.written()).as_bytes()))
    }
}

/// Who walks: the figure of a file that has all that a walk needs, or a human.
pub(crate) fn figure(who: &WhoArgs) -> Result<Figure, CliError> {
    if let Some(path) = &who.figure {
        let figure = input::body(path)?.figure;
        let missing = missing_for_walking(&figure);
        return if missing.is_empty() {
            Ok(figure)
        } else {
            let list = missing.iter().map(|lack| format!("\n  - {lack}")).collect::<Vec<_>>().concat();
            Err(CliError::input(path, &format!("figure '{}' cannot walk:{list}", figure.name())))
        };
    }
    person(&who.person)
}

/// A human of the height and mass that are asked for, or of the usual ones.
pub(crate) fn person(person: &PersonArgs) -> Result<Figure, CliError> {
    person_with(person, RootOrder::Zyx)
}

/// The same whose root turns by its heading first.
pub(crate) fn heading_first(person: &PersonArgs) -> Result<Figure, CliError> {
    person_with(person, RootOrder::Yzx)
}

fn person_with(person: &PersonArgs, root: RootOrder) -> Result<Figure, CliError> {
    let height = person.height.as_ref().map_or(HEIGHT, |height| height.value);
    let mass = person.mass.as_ref().map_or(BODY_MASS_INDEX * height * height, |mass| mass.value);
    let human = Human::new(height, mass).root(root);
    let human = match &person.age {
        Some(age) => human.age(age.value),
        None => human,
    };
    let human = person.loads.iter().fold(human, |human, (side, load)| human.load(side.clone(), *load));
    let human = person.shorter.iter().fold(human, |human, (leg, by)| human.shorter_leg(leg.clone(), *by));
    human.build().map_err(|error| CliError::of_human(error, person))
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
    files: &WalkFiles,
    bones: &Bones,
) -> Result<(), CliError> {
    let strip = &files.film;
    match format {
        Format::Csv => solaris::io::csv::write(figure, motion, &mut writer).map_err(CliError::other),
        Format::Bvh => animation::bones(figure, motion, report.walk.repeats, bones, writer),
        Format::Body(how) => animation::body(how, figure, motion, "walk", bones, writer),
        Format::Html => {
            let options = PageOptions {
                title: summary::title(report),
                table: summary::page_rows(report),
                ..PageOptions::default()
            };
            let html = page(figure, motion, &options).map_err(CliError::other)?;
            writer.write_all(html.as_bytes()).map_err(CliError::other)
        }
        Format::Json => report.write(writer).map_err(CliError::other),
        Format::Svg => {
            let seen = strip.seen.map_or_else(Seen::default, Seen::from);
            let options = FilmOptions { title: summary::title(report), between: strip.between, seen };
            let svg = film(figure, motion, &options).map_err(CliError::other)?;
            writer.write_all(svg.as_bytes()).map_err(CliError::other)
        }
    }
}
