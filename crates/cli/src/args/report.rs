//! The request of `solaris report`.

use super::value::within;
use super::wrap;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "Examples:
  solaris report governor.ron -o report.html
      the scene by every method, step and tolerance: a page with error against time, and which setting to take
  solaris report pendulum.ron --error 1e-9
      the cheapest setting for errors up to 1e-9, as a table
  solaris report arm.ron -o error.svg --json
      the picture alone, and all numbers as JSON";

/// Errors that can be wanted (rad or m).
const WANTED: (f64, f64) = (1e-13, 0.1);

/// A scene to be studied.
#[derive(Debug, Args)]
#[command(
    about = "How far a scene can be trusted: every method, step and tolerance against the finest there are",
    after_help = EXAMPLES
)]
pub(crate) struct ReportArgs {
    #[arg(value_name = "SCENE", help = "A scene (.ron)")]
    pub(crate) scene: PathBuf,
    #[arg(short = 'o', long = "output", value_name = "FILE", help = wrap(
        "Write a page (.html), or the picture of error against time (.svg); several are allowed. Stopped before its end, \
         what is finished stays [default: none]"
    ))]
    pub(crate) outputs: Vec<PathBuf>,
    #[arg(
        long, value_name = "E", allow_hyphen_values = true, value_parser = within("error", WANTED.0, WANTED.1, " (rad or m)"),
        help = wrap("Error of positions that is wanted, in rad or m, 1e-13 to 0.1 [default: the scene's tolerance, or 1e-6]")
    )]
    pub(crate) error: Option<f64>,
    #[arg(long, help = "Print all numbers as JSON instead of a table")]
    pub(crate) json: bool,
}
