//! Errors of the program, in the words of the command line.

mod refusal;
mod usage;

pub(crate) use refusal::Refusal;
pub(crate) use usage::UsageError;

use crate::args::{Cli, Number, ValueError};
use crate::underline;
use clap::Parser;
use solaris::files::{ExternalError, FileError};
use solaris::gait::{GaitError, RequestError};
use solaris::io::FilesError;
use solaris::model::{HumanError, TextError, plain};
use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Why a command could not be done.
#[derive(Debug, thiserror::Error)]
pub(crate) enum CliError {
    /// The command line cannot be understood.
    #[error(transparent)]
    Usage(#[from] UsageError),
    /// The value of an option, as it was typed.
    #[error("--{option}{}{value}: {why}", if value.is_empty() { "" } else { " " })]
    Option { option: String, value: String, why: Box<Refusal> },
    /// A number that no option gave, but that those given lead to.
    #[error("{name} {}{unit}, from {from}: {why}", four(*.value))]
    Derived { name: String, value: f64, unit: &'static str, from: String, why: Box<Refusal> },
    #[error("{option} {path}: {why}", path = .path.display())]
    Output { option: &'static str, path: PathBuf, why: String },
    #[error(
        "{duration:.0} s at {rate} frames/s make {frames:.0} frames, more than {most}; lower --rate or walk fewer steps"
    )]
    TooLong { duration: f64, rate: f64, frames: f64, most: f64 },
    /// A file that cannot be read, or that does not hold what is needed.
    #[error("{path}: {why}", path = .path.display())]
    Input { path: PathBuf, why: String },
    /// A text with faults that have places.
    #[error("{path} cannot be used", path = .path.display())]
    Text { path: PathBuf, text: String, faults: TextError },
    /// A model with faults in its file, or in others that it names.
    #[error("{path} cannot be used", path = .path.display())]
    Files { path: PathBuf, error: FilesError },
    /// Something looks wrong where nothing was to.
    #[error("{path}: {count} thing{} wrong, and --strict asks for none", if *.count == 1 { " looks" } else { "s look" }, path = .path.display())]
    Strict { path: PathBuf, count: usize },
    /// Of many motions some cannot be used; each is told in the summary.
    #[error("{failed} of {of} motions failed; the summary says why")]
    Motions { failed: usize, of: usize },
    /// The program holds no studio.
    #[error(
        "this program was built without the studio; in a clone of the project `cargo xtask studio` builds it (with Node.js), and \
         the next `cargo build --release` puts it into the program"
    )]
    NoStudio,
    #[error("standard output: {0}")]
    Stdout(std::io::Error),
    #[error(transparent)]
    Other(Box<dyn Error + Send + Sync>),
}

/// Options that a library's error may be about, by the names that the libraries use.
pub(crate) trait Typed {
    /// The value of an option as it was typed.
    fn typed(&self, name: &str) -> Option<&str>;

    /// What was given of step frequency, step length and speed, with the names of the options.
    fn pace(&self) -> Vec<(&'static str, &Number)>;
}

impl CliError {
    /// Anything that is nobody's option.
    pub(crate) fn other(error: impl Error + Send + Sync + 'static) -> Self {
        Self::Other(Box::new(error))
    }

    /// A file that is at fault.
    pub(crate) fn input(path: &Path, why: &dyn ToString) -> Self {
        Self::Input { path: path.to_owned(), why: why.to_string() }
    }

    /// The value of an option that is refused for a reason of its own.
    pub(crate) fn option(option: &str, value: impl Into<String>, why: impl Into<Refusal>) -> Self {
        Self::Option { option: option.to_owned(), value: value.into(), why: Box::new(why.into()) }
    }

    /// 2 where the command line cannot be understood, 1 where it cannot be done.
    pub(crate) fn exit_code(&self) -> ExitCode {
        ExitCode::from(if matches!(self, Self::Usage(_)) { 2 } else { 1 })
    }

    /// A command line that clap refuses: a number that is understood and out of range is for us to say.
    ///
    /// # Errors
    ///
    /// clap's own, where it knows best; help and version come as such.
    pub(crate) fn of_clap(error: clap::Error) -> Result<Self, clap::Error> {
        let value = error.source().and_then(|source| source.downcast_ref::<ValueError>());
        let Some(ValueError::OutOfRange { option, typed, lower, upper, unit }) = value else {
            return Err(error);
        };
        let why = Refusal::Range { lower: *lower, upper: *upper, unit, more: String::new() };
        Ok(Self::option(option, typed, why))
    }

    /// A height or a mass of which there is no person.
    pub(crate) fn of_human(error: HumanError, asked: &dyn Typed) -> Self {
        let (name, value, unit) = match error {
            HumanError::Height { height } => ("height", height, " m"),
            HumanError::Mass { mass, .. } => ("mass", mass, " kg"),
            HumanError::Age { age } => ("age", age, " years"),
            _ => return Self::other(error),
        };
        Self::of_value(name, value, unit, Refusal::Person(error), asked)
    }

    /// A walk that cannot be.
    pub(crate) fn of_gait(error: GaitError, asked: &dyn Typed) -> Self {
        match out_of_range(error) {
            Ok(OutOfRange { name, value, unit, why }) => Self::of_value(name, value, unit, why, asked),
            Err(error) => Self::other(error),
        }
    }

    /// A part of a walk that cannot be, said of the `--then` that asks for it.
    pub(crate) fn of_then(error: GaitError, then: String) -> Self {
        Self::of_part(error, "then", then)
    }

    /// A part of a walk that cannot be, said of the option that asks for it.
    pub(crate) fn of_part(error: GaitError, option: &str, typed: String) -> Self {
        let why = match out_of_range(error) {
            Ok(OutOfRange { name, value, unit, why }) => format!("{name} {}{unit}: {why}", four(value)),
            Err(error) => error.to_string(),
        };
        Self::option(option, typed, why)
    }

    /// A value of this name, said of the option of that name as it was typed, or of what led to it.
    fn of_value(name: &str, value: f64, unit: &'static str, why: Refusal, asked: &dyn Typed) -> Self {
        if let Some(typed) = asked.typed(name) {
            return Self::option(&name.replace(' ', "-"), typed, why);
        }
        let given = asked.pace();
        let given: Vec<String> =
            given.iter().map(|(option, number)| format!("--{option} {}", number.typed)).collect();
        let from = if given.is_empty() { "the defaults".to_owned() } else { given.join(" and ") };
        Self::Derived { name: name.to_owned(), value, unit, from, why: Box::new(why) }
    }
}

impl From<ExternalError> for CliError {
    fn from(error: ExternalError) -> Self {
        match error {
            ExternalError::File(error) => error.into(),
            ExternalError::Plate { links, prefix, why } => {
                Self::option("plate", format!("{links}={prefix}"), why)
            }
            other => Self::other(other),
        }
    }
}

impl From<FileError> for CliError {
    fn from(error: FileError) -> Self {
        match error {
            FileError::Input { path, why } => Self::Input { path, why },
            FileError::Text { path, text, faults } => Self::Text { path, text, faults },
            FileError::Files { path, error } => Self::Files { path, error },
            FileError::Folder { folder, why } => Self::option("files", folder.display().to_string(), why),
            other => Self::other(other),
        }
    }
}

/// A number of a walk that is out of its range.
struct OutOfRange {
    name: &'static str,
    value: f64,
    unit: &'static str,
    why: Refusal,
}

/// What is out of range, if that is what is wrong.
fn out_of_range(error: GaitError) -> Result<OutOfRange, GaitError> {
    match error {
        GaitError::Request(RequestError::Range { parameter, value, unit, lower, upper, why }) => {
            let why = Refusal::Range { lower, upper, unit, more: why };
            Ok(OutOfRange { name: parameter, value, unit, why })
        }
        GaitError::Request(RequestError::StepLength { parameter, value, unit, lower, upper, at, why }) => {
            let why = Refusal::Pace { lower, upper, unit, at, more: why };
            Ok(OutOfRange { name: parameter, value, unit, why })
        }
        other => Err(other),
    }
}

/// To four decimals.
fn four(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}

/// Ends the program as clap does, with help, the version or what it cannot understand: that with the words of the command line as they
/// may be shown.
pub(crate) fn end(error: &clap::Error) -> ! {
    if error.use_stderr() {
        let words = std::env::args_os().map(|word| plain(&word.to_string_lossy()).into_owned());
        if let Err(shown) = Cli::try_parse_from(words) {
            shown.exit();
        }
    }
    error.exit()
}

/// Prints an error and what to do next. Where that cannot be printed either, the exit code has to do.
pub(crate) fn show(error: &CliError, command: &str) {
    let mut stderr = anstream::stderr().lock();
    let _ = writeln!(stderr, "\x1b[1;31merror:\x1b[0m {}", plain(&error.to_string()));
    let _ = match error {
        CliError::Option { option, .. } => {
            writeln!(stderr, "\nsolaris {} --help tells what --{option} is", plain(command))
        }
        CliError::Usage(_) => writeln!(stderr, "\nFor more information, try '--help'."),
        CliError::Text { path, text, faults } => write!(stderr, "{}", underline::faults(path, text, faults)),
        CliError::Files { path, error } => error.files.iter().try_for_each(|file| {
            let other = path.with_file_name(&file.path);
            let path = if file.path.is_empty() { path } else { &other };
            write!(stderr, "{}", underline::faults(path, &file.text, &file.error))
        }),
        _ => Ok(()),
    };
}
