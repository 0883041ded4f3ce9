//! `solaris report`: how far a scene can be trusted.

mod numbers;
mod summary;
mod watching;

use crate::error::{CliError, typed};
use crate::output::{Formats, Outputs};
use crate::print::print;
use crate::run::{Loaded, load, refuse};
use clap::ArgMatches;
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

/// Errors that can be wanted (rad or m).
const WANTED: (f64, f64) = (1e-13, 0.1);
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
pub(crate) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    let paths = matches.get_many::<PathBuf>("output").unwrap_or_default();
    let outputs = Outputs::new(paths.map(|path| ("-o", path, FORMATS)))?;
    let path = matches.get_one::<PathBuf>("scene").cloned().unwrap_or_default();
    let Loaded { scene, reads } = load(&path)?;
    outputs.keep_off(reads.iter().map(PathBuf::as_path))?;
    let settings = scene.settings().clone();
    let wanted = wanted(matches, settings.method)?;
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
    let study = found.map_err(|error| refuse(&path, SceneError::Run(error)))?;
    outputs.write(|format, writer| write(format, writer, &study, &subject))?;
    drop(watching);

    if matches.get_flag("json") {
        return print(|out| numbers::write(out, &study, &subject.settings));
    }
    print(|out| out.write_all(summary::table(&study, &subject, outputs.paths()).as_bytes()))
}

/// The error that is asked for, or that the scene asks for.
fn wanted(matches: &ArgMatches, method: Method) -> Result<f64, CliError> {
    let Some(&wanted) = matches.get_one::<f64>("error") else {
        return Ok(if let Method::Automatic { tolerance } = method { tolerance } else { DEFAULT });
    };
    if (WANTED.0..=WANTED.1).contains(&wanted) {
        return Ok(wanted);
    }
    let (option, value) = ("error".to_owned(), typed(matches, "error").unwrap_or_default());
    Err(CliError::Option { option, value, why: "it must be 1e-13 to 0.1 (rad or m)".to_owned() })
}

fn write(format: Format, writer: &mut dyn Write, study: &Study, subject: &Subject) -> Result<(), CliError> {
    let Subject { title, settings: Settings { duration, rate, .. } } = subject;
    let text = match format {
        Format::Html => page(&report(study, title, *duration, *rate)),
        Format::Svg => svg(&diagram(study, title, *duration, *rate), Against::Seconds),
    };
    writer.write_all(text.as_bytes()).map_err(CliError::other)
}
