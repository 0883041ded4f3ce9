//! What can go wrong, in the words of the command line.

use solaris::gait::GaitError;
use solaris::model::HumanError;
use std::path::PathBuf;

/// Why a command could not be done; exit code 1.
#[derive(Debug, thiserror::Error)]
pub(crate) enum CliError {
    #[error("--{option} {rest}")]
    Option { option: String, rest: String },
    #[error("{option} {path}: {why}", path = .path.display())]
    Output { option: &'static str, path: PathBuf, why: String },
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

    /// The message `text`, which begins with what it is about, said of an option and its value.
    fn of_option(option: &str, value: f64, text: &str) -> Self {
        let rest = text.split_once(": ").map_or(text, |(_, rest)| rest);
        Self::Option { option: option.to_owned(), rest: format!("{value}: {rest}") }
    }
}

impl From<HumanError> for CliError {
    fn from(error: HumanError) -> Self {
        match &error {
            HumanError::Height { height } => Self::of_option("height", *height, &error.to_string()),
            HumanError::Mass { mass, .. } => Self::of_option("mass", *mass, &error.to_string()),
            _ => Self::other(error),
        }
    }
}

impl From<GaitError> for CliError {
    fn from(error: GaitError) -> Self {
        match &error {
            GaitError::Range { parameter, value, .. } | GaitError::StepLength { parameter, value, .. } => {
                Self::of_option(&parameter.replace(' ', "-"), *value, &error.to_string())
            }
            _ => Self::other(error),
        }
    }
}

/// Prints an error and what to do next.
#[allow(clippy::print_stderr, reason = "this is where errors are shown")]
pub(crate) fn show(error: &CliError) {
    anstream::eprintln!("\x1b[1;31merror:\x1b[0m {error}");
    if let CliError::Option { option, .. } = error {
        anstream::eprintln!("\nsolaris walk --help tells what --{option} is");
    }
}
