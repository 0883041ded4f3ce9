//! `solaris report`: how far a scene can be trusted.

mod numbers;
mod summary;
mod watching;

use crate::args::ReportArgs;
use crate::error::CliError;
use crate::output::{Formats, Outputs};
use crate::print::print;
use crate::run::{LoadedScene, load, refuse};
use solaris::modes::study::{Study, StudyOptions, study};
use solaris::modes::{Method, Settings};
use solaris::scene::SceneError;
use solaris::view::precision::{Against, diagram, page, report, svg};
use std::io::Write;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use watching::Watching;

/// What a file of a report holds.
#[derive(Clone, Copy, Debug)]
enum Format {
    Html,
    Svg,
}

const FORMATS: Formats<Format> = &[("html", Format::Html), ("svg", Format::Svg)];

/// The error that is wanted where neither the command line nor the scene says one.
const DEFAULT: f64 = 1e-6;
/// So often files are written while the study goes on: whoever stops it keeps what there is.
const EVERY: Duration = Duration::from_secs(2);

/// What is studied.
struct Subject {
    title: String,
    settings: Settings,
}

/// Runs the scene by every method and writes what came of it.
pub(crate) fn run(args: &ReportArgs) -> Result<(), CliError> {
    let outputs = Outputs::new(args.outputs.iter().map(|path| ("-o", path, FORMATS)))?;
    let path = args.scene.as_path();
    let LoadedScene { scene, reads } = load(path)?;
    outputs.keep_off(reads.iter().map(PathBuf::as_path))?;
    let settings = scene.settings().clone();
    // What the scene asks for, where the command line does not.
    let wanted = args.error.unwrap_or(match settings.method {
        Method::Automatic { tolerance } => tolerance,
        _ => DEFAULT,
    });
    let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let subject = Subject { title: format!("{name}: precision against work"), settings };

    let options = StudyOptions { wanted, ..StudyOptions::default() };
    let mut watching = Watching::new();
    let mut written = Instant::now();
    let mut refused = Ok(());
    let found = study(scene.simulation(), &subject.settings, &options, &mut watching, &mut |study| {
        if refused.is_ok() && written.elapsed() >= EVERY {
            refused = outputs.write(|format, writer| write(format, writer, study, &subject));
            written = Instant::now();
        }
    });
    refused?;
    let study = found.map_err(|error| refuse(path, &SceneError::Run(error), scene.notes()))?;
    outputs.write(|format, writer| write(format, writer, &study, &subject))?;
    drop(watching);

    if args.json {
        return print(|out| numbers::write(out, &study, &subject.settings));
    }
    print(|out| out.write_all(summary::table(&study, &subject, outputs.written()).as_bytes()))
}

fn write(format: Format, writer: &mut dyn Write, study: &Study, subject: &Subject) -> Result<(), CliError> {
    let Subject { title, settings: Settings { duration, rate, .. } } = subject;
    let text = match format {
        Format::Html => page(&report(study, title, *duration, *rate)),
        Format::Svg => svg(&diagram(study, title, *duration, *rate), Against::Seconds),
    };
    writer.write_all(text.as_bytes()).map_err(CliError::other)
}
