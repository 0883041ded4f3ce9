//! The files of a motion that is planned: page, table, motion capture, bodies, film strip, and its numbers.

use crate::animation::{self, BodyFormat, Bones};
use crate::args::MotionFiles;
use crate::error::{CliError, UsageError};
use crate::input;
use crate::output::{Formats, Outputs};
use solaris::model::{Figure, Motion};
use solaris::view::{FilmOptions, PageOptions, Seen, TableRow, film, page};
use std::io::{self, Write};
use std::path::Path;

/// What a file holds.
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

/// The files that are asked for, checked before the work begins.
pub(crate) struct PlannedFiles<'a> {
    asked: &'a MotionFiles,
    outputs: Outputs<Format>,
    bones: Bones,
}

/// What is shown of a motion besides itself.
pub(crate) struct Shown<'a> {
    /// What its animation is called.
    pub(crate) name: &'static str,
    pub(crate) title: String,
    pub(crate) rows: Vec<TableRow>,
    /// Whether its last frame is its first one again.
    pub(crate) repeats: bool,
    /// Writes its numbers as JSON.
    pub(crate) report: &'a dyn Fn(&mut dyn Write) -> io::Result<()>,
}

impl<'a> PlannedFiles<'a> {
    /// Of somebody whose figure is read from a file, if it is.
    pub(crate) fn new(asked: &'a MotionFiles, figure: Option<&Path>) -> Result<Self, CliError> {
        let motions = asked.outputs.iter().map(|path| ("-o", path, MOTION));
        let outputs =
            Outputs::new(motions.chain(asked.report.iter().map(|path| ("--report", path, REPORT))))?;
        outputs.keep_off(figure)?;
        let drawn = outputs.paths().any(|path| input::extension(path) == "svg");
        if let Some(option) = asked.film.given().filter(|_| !drawn) {
            return Err(UsageError::NoStrip { option }.into());
        }
        animation::check(&asked.bones, outputs.paths())?;
        let bones = animation::asked(&asked.bones)?;
        Ok(Self { asked, outputs, bones })
    }

    /// A line for each file that was written.
    pub(crate) fn written(&self) -> impl Iterator<Item = String> {
        self.outputs.written()
    }

    /// Writes all of them, or none.
    pub(crate) fn write(&self, figure: &Figure, motion: &Motion, shown: &Shown<'_>) -> Result<(), CliError> {
        // Pages and clips go by their time; who plays frame after frame shall not see one twice.
        let shorter = shown.repeats.then(|| motion.without_last());
        let frames = shorter.as_ref().unwrap_or(motion);
        self.outputs.write(|format, mut writer| match format {
            Format::Csv => solaris::io::csv::write(figure, frames, &mut writer).map_err(CliError::other),
            Format::Bvh => animation::bones(figure, motion, shown.repeats, &self.bones, writer),
            Format::Body(how) => animation::body(how, figure, motion, shown.name, &self.bones, writer),
            Format::Html => {
                let table = shown.rows.clone();
                let options = PageOptions { title: shown.title.clone(), table, ..PageOptions::default() };
                let html = page(figure, motion, &options).map_err(CliError::other)?;
                writer.write_all(html.as_bytes()).map_err(CliError::other)
            }
            Format::Json => (shown.report)(writer).map_err(CliError::other),
            Format::Svg => {
                let strip = &self.asked.film;
                let seen = strip.seen.map_or_else(Seen::default, Seen::from);
                let options = FilmOptions { title: shown.title.clone(), between: strip.between, seen };
                let svg = film(figure, motion, &options).map_err(CliError::other)?;
                writer.write_all(svg.as_bytes()).map_err(CliError::other)
            }
        })
    }
}

/// Refuses a motion for which no memory may be left.
pub(crate) fn check_size(duration: f64, rate: f64) -> Result<(), CliError> {
    let frames = duration * rate;
    if frames <= MOST_FRAMES {
        return Ok(());
    }
    Err(CliError::TooLong { duration, rate, frames, most: MOST_FRAMES })
}
