//! What can go wrong, in the words of the command line.

use crate::underline;
use clap::ArgMatches;
use solaris::gait::{GaitError, RequestError};
use solaris::model::{HumanError, TextError};
use solaris::profiles::ProfileError;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Why a command could not be done.
#[derive(Debug, thiserror::Error)]
pub(crate) enum CliError {
    /// The options contradict each other.
    #[error("{0}")]
    Usage(String),
    #[error("--{option} {value}: {why}")]
    Option { option: String, value: String, why: String },
    /// A number that no option gave, but that those given lead to.
    #[error("{name} {value}, from {from}: {why}")]
    Derived { name: String, value: String, from: String, why: String },
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
    /// Something looks wrong where nothing was to.
    #[error("{path}: {count} thing{} wrong, and --strict asks for none", if *.count == 1 { " looks" } else { "s look" }, path = .path.display())]
    Strict { path: PathBuf, count: usize },
    #[error("standard output: {0}")]
    Stdout(std::io::Error),
    #[error(transparent)]
    Other(Box<dyn std::error::Error>),
}

impl CliError {
    /// Anything that is nobody's option.
    pub(crate) fn other(error: impl std::error::Error + 'static) -> Self {
        Self::Other(Box::new(error))
    }

    /// A file that is at fault.
    pub(crate) fn input(path: &Path, why: &dyn ToString) -> Self {
        Self::Input { path: path.to_owned(), why: why.to_string() }
    }

    /// 2 where the command line cannot be understood, 1 where it cannot be done.
    pub(crate) fn exit_code(&self) -> ExitCode {
        ExitCode::from(if matches!(self, Self::Usage(_)) { 2 } else { 1 })
    }

    /// A height or a mass of which there is no person.
    pub(crate) fn of_human(error: HumanError, matches: &ArgMatches) -> Self {
        match &error {
            HumanError::Height { height } => Self::of_value("height", *height, "m", &error, matches),
            HumanError::Mass { mass, .. } => Self::of_value("mass", *mass, "kg", &error, matches),
            _ => Self::other(error),
        }
    }

    /// A walk that cannot be.
    pub(crate) fn of_gait(error: GaitError, matches: &ArgMatches) -> Self {
        match &error {
            GaitError::Request(
                RequestError::Range { parameter, value, unit, .. }
                | RequestError::StepLength { parameter, value, unit, .. },
            ) => Self::of_value(parameter, *value, unit.trim(), &error, matches),
            _ => Self::other(error),
        }
    }

    /// A curve that cannot be, in the words of the options that ask for it.
    pub(crate) fn of_profile(error: &ProfileError, matches: &ArgMatches) -> Self {
        let text = error.to_string();
        let (what, value) = match error {
            ProfileError::NotFinite { what, value }
            | ProfileError::NotWhole { what, value }
            | ProfileError::OutOfRange { what, value, .. }
            | ProfileError::Infeasible { what, value, .. } => (*what, *value),
            ProfileError::Duration { duration } => ("duration", *duration),
            ProfileError::Knots { .. } | ProfileError::Count { .. } => ("keys", f64::NAN),
            _ => return Self::Other(text.into()),
        };
        // The window of a blend is one option.
        let option = if what.ends_with("the window") { "window".to_owned() } else { what.replace(' ', "-") };
        let option = if option == "key" { "keys".to_owned() } else { option };
        // Of options that there are: a text has its parameters inside.
        if matches.try_get_raw(&option).is_err() {
            return Self::Other(text.into());
        }
        let value = typed(matches, &option).unwrap_or_else(|| value.to_string());
        let said = [format!("{what} is {value}"), format!("{what} {value}")];
        let why = said.iter().find_map(|said| text.strip_prefix(said.as_str())).unwrap_or(&text);
        let why = why.trim_start_matches("keys");
        Self::Option { option, value, why: why.trim_start_matches([':', ';', ' ']).to_owned() }
    }

    /// `error`, whose message begins with a name and a value, said of the option of that name and its value as typed.
    fn of_value(
        name: &str,
        value: f64,
        unit: &str,
        error: &dyn std::error::Error,
        matches: &ArgMatches,
    ) -> Self {
        let text = error.to_string();
        let why = text.split_once(": ").map_or(text.as_str(), |(_, why)| why).to_owned();
        let option = name.replace(' ', "-");
        if let Some(value) = typed(matches, &option) {
            return Self::Option { option, value, why };
        }
        let pace = ["step-frequency", "step-length", "speed"];
        let given = pace.iter().filter_map(|o| Some(format!("--{o} {}", typed(matches, o)?)));
        let from = given.collect::<Vec<_>>().join(" and ");
        let from = if from.is_empty() { "the defaults".to_owned() } else { from };
        let value = (value * 1e4).round() / 1e4;
        Self::Derived { name: name.to_owned(), value: format!("{value} {unit}"), from, why }
    }
}

/// The value of an option as it was typed.
pub(crate) fn typed(matches: &ArgMatches, option: &str) -> Option<String> {
    let mut values = matches.try_get_raw(option).ok()??;
    values.next().map(|value| value.to_string_lossy().into_owned())
}

/// Prints an error and what to do next. Where that cannot be printed either, the exit code has to do.
pub(crate) fn show(error: &CliError, command: &str) {
    let mut stderr = anstream::stderr().lock();
    let _ = writeln!(stderr, "\x1b[1;31merror:\x1b[0m {error}");
    let _ = match error {
        CliError::Option { option, .. } => {
            writeln!(stderr, "\nsolaris {command} --help tells what --{option} is")
        }
        CliError::Usage(_) => writeln!(stderr, "\nFor more information, try '--help'."),
        CliError::Text { path, text, faults } => write!(stderr, "{}", underline::faults(path, text, faults)),
        _ => Ok(()),
    };
}
