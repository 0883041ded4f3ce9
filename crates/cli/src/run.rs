//! `solaris run`: a scene comes to a motion.

mod contact;
mod energy;
mod outcomes;
mod plan;
mod report;
mod summary;
mod watch;

pub(crate) use solaris::files::{LoadedScene, scene as load};

use crate::animation::{self, BodyFormat, Bones};
use crate::args::RunArgs;
use crate::error::{CliError, UsageError};
use crate::input::extension;
use crate::limbs;
use crate::output::{Formats, Outputs};
use crate::print::print;
use report::Report;
use solaris::io::record;
use solaris::io::rig::Rigged;
use solaris::model::{Motion, MotionInfo};
use solaris::modes::RunError;
use solaris::scene::{Scene, SceneError, Simulated};
use solaris::view::{FilmOptions, PageOptions, PagePerson, Seen, coordinates, film, page};
use std::io::Write;
use std::path::{Path, PathBuf};
use watch::Watcher;

/// What a file of a run holds.
#[derive(Clone, Copy, Debug)]
enum Format {
    Html,
    Csv,
    Bvh,
    Body(BodyFormat),
    Sto,
    Svg,
    Json,
}

const MOTION: Formats<Format> = &[
    ("html", Format::Html),
    ("svg", Format::Svg),
    ("csv", Format::Csv),
    ("bvh", Format::Bvh),
    ("glb", Format::Body(BodyFormat::Glb)),
    ("usda", Format::Body(BodyFormat::Usda)),
    ("sto", Format::Sto),
    ("mot", Format::Sto),
];
const REPORT: Formats<Format> = &[("json", Format::Json)];

/// How to come to methods that are not built in.
const BUILD_STIFF: &str = "build with 'cargo build --release --features stiff'";

/// The most numbers of a motion: about 5 GB.
const MOST_NUMBERS: f64 = 6e8;

/// Runs the scene, writes its motion, and says what it came to.
pub(crate) fn run(args: &RunArgs) -> Result<(), CliError> {
    let path = args.scene.as_path();
    let motions = args.outputs.iter().map(|path| ("-o", path, MOTION));
    let outputs = Outputs::new(motions.chain(args.report.iter().map(|path| ("--report", path, REPORT))))?;
    let drawn = outputs.paths().any(|path| extension(path) == "svg");
    if let Some(option) = args.film.given().filter(|_| !drawn) {
        return Err(UsageError::NoStrip { option }.into());
    }
    let LoadedScene { mut scene, reads } = load(path)?;
    // Only tables, pages and arrows show forces; those of a walk are found with its ground reactions.
    let shows = |path: &Path| matches!(extension(path).as_str(), "csv" | "html");
    scene.settings_mut().forces = scene.walk().is_some() || args.bones.arrows || outputs.paths().any(shows);
    outputs.keep_off(reads.iter().map(PathBuf::as_path))?;
    check_size(path, &scene)?;

    animation::check(&args.bones, outputs.paths())?;
    let bones = animation::asked(&args.bones)?;
    check_bones(&outputs, &scene, &bones)?;

    let mut watcher = Watcher::new();
    let simulated = scene.simulate(&mut watcher).map_err(|error| refuse(path, &error, scene.notes()))?;
    watcher.writing();
    let ends = scene.simulation().loops().iter().map(|closed| closed.between.map(|anchor| anchor.link));
    let joined: Vec<[usize; 2]> = ends.filter_map(|[a, b]| Some([a?, b?])).collect();
    let limbs = limbs::nearest(scene.figure(), &simulated.motion, &joined)?;
    let report = Report::new(&scene, &simulated, limbs);
    outputs.write(|format, writer| write(format, writer, &scene, &simulated, &report, args, &bones))?;
    drop(watcher);

    if args.json {
        return print(|out| report.write(out));
    }
    print(|out| {
        out.write_all(summary::text(&report).as_bytes())?;
        if args.plan {
            out.write_all(plan::text(&report.run.phases).as_bytes())?;
        }
        out.write_all(summary::written(outputs.written()).as_bytes())
    })
}

/// Refuses a figure whose bones no file can hold, before anything is computed.
fn check_bones(outputs: &Outputs<Format>, scene: &Scene, bones: &Bones) -> Result<(), CliError> {
    let (figure, simulation) = (scene.figure(), scene.simulation());
    let (q, v) = simulation.state();
    let (rate, gravity) = (scene.settings().rate, *simulation.gravity());
    let info = MotionInfo { rate, gravity, ..MotionInfo::on_earth(figure, rate) };
    let start = Motion::new(figure, info, vec![0.0], [q.to_vec(), v.to_vec(), vec![0.0; v.len()]]);
    let start = start.map_err(CliError::other)?;
    outputs.try_out(|format| match format {
        Format::Bvh => animation::bones(figure, &start, false, bones, &mut std::io::sink()),
        // Of several figures those that are people have a rig's bones.
        Format::Body(BodyFormat::Glb) if scene.is_of_several() => Ok(()),
        Format::Body(_) => {
            let on = bones.rig.as_ref().map_or(Ok(()), |rig| Rigged::new(figure, rig).map(drop));
            on.map_err(CliError::other)
        }
        _ => Ok(()),
    })
}

/// Refuses a motion for which no memory may be left.
fn check_size(path: &Path, scene: &Scene) -> Result<(), CliError> {
    let (settings, layout) = (scene.settings(), scene.figure().layout());
    let frames = settings.duration * settings.rate;
    let numbers = frames * (layout.nq() + 3 * layout.nv() + 1) as f64;
    if numbers <= MOST_NUMBERS {
        return Ok(());
    }
    let why = format!(
        "{} s at {} frames/s make {frames:.0} frames of {} degrees of freedom, more than there is memory for; lower the \
         rate or the duration",
        settings.duration,
        settings.rate,
        layout.nv()
    );
    Err(CliError::input(path, &why))
}

/// Why a scene has no motion.
pub(crate) fn refuse(path: &Path, error: &SceneError, notes: &[String]) -> CliError {
    if matches!(error, SceneError::Run(RunError::Cancelled)) {
        return CliError::input(path, &"the run was stopped");
    }
    // What was to be said of the scene may be why.
    let said: Vec<String> =
        std::iter::once(error.to_string()).chain(notes.iter().map(|note| format!("note: {note}"))).collect();
    CliError::input(path, &said.join("\n\n"))
}

fn write(
    format: Format,
    mut writer: &mut dyn Write,
    scene: &Scene,
    simulated: &Simulated,
    report: &Report,
    args: &RunArgs,
    bones: &Bones,
) -> Result<(), CliError> {
    let strip = &args.film;
    let (figure, motion) = (scene.figure(), &simulated.motion);
    match format {
        Format::Csv => solaris::io::csv::write(figure, motion, &mut writer).map_err(CliError::other),
        Format::Bvh => animation::bones(figure, motion, false, bones, writer),
        Format::Body(how) => {
            let several = scene.several(motion).map_err(CliError::other)?;
            if how == BodyFormat::Glb && !several.is_empty() {
                return animation::scene(&several, bones, writer);
            }
            animation::body(how, figure, motion, "run", bones, writer)
        }
        Format::Sto => {
            solaris::io::sto::write(&record::positions(figure, motion), &mut writer).map_err(CliError::other)
        }
        Format::Html => {
            let (title, table) = (summary::title(report), summary::page_rows(report));
            let several = scene.several(motion).map_err(CliError::other)?;
            let people = several.into_iter().map(|one| PagePerson { first: one.first, figure: one.alone });
            let options = PageOptions { title, table, people: people.collect(), ..PageOptions::default() };
            let html = page(figure, motion, &options).map_err(CliError::other)?;
            writer.write_all(html.as_bytes()).map_err(CliError::other)
        }
        Format::Svg if strip.given().is_some() => {
            let seen = strip.seen.map_or_else(Seen::default, Seen::from);
            let options = FilmOptions { title: summary::title(report), between: strip.between, seen };
            let svg = film(figure, motion, &options).map_err(CliError::other)?;
            writer.write_all(svg.as_bytes()).map_err(CliError::other)
        }
        Format::Svg => {
            let picture = coordinates(figure, motion, &summary::title(report));
            writer.write_all(picture.as_bytes()).map_err(CliError::other)
        }
        Format::Json => report.write(writer).map_err(CliError::other),
    }
}
