//! The request of `solaris sweep`, and those options of `solaris walk` that can head its columns.

use super::value::within;
use super::{RATE, WalkArgs, wrap};
use clap::{Arg, Args, Command};
use std::path::PathBuf;

const EXAMPLES: &str = "Examples:
  solaris sweep people.csv -o metrics.csv
      people.csv may be: height,mass,speed
                         1.60,55,1.2
                         1.85,,1.4
  solaris sweep people.csv -o metrics.csv --threads 1 --rate 60 --json
      on one core, half the samples; the file is the same with any number of threads";

/// Options of a walk that are no number of it: files, and how it is told.
const NO_COLUMNS: [&str; 10] =
    ["output", "report", "json", "between", "seen", "rate", "root", "rig", "loop", "style-file"];

/// Walks, each a row of a table.
#[derive(Debug, Args)]
#[command(about = "Many walks: a table of people and paces in, a table of measures out", after_help = EXAMPLES)]
pub(crate) struct SweepArgs {
    #[arg(value_name = "PARAMS.csv", help = wrap(&format!(
        "A walk a row; headings are options of `solaris walk`: {}. An empty field is an option that is left out",
        columns(&walk_options()).join(", ")
    )))]
    pub(crate) params: PathBuf,
    #[arg(short = 'o', long, value_name = "METRICS.csv", help = wrap(
        "Write the same columns, the measures of each walk, and last why a row is refused"
    ))]
    pub(crate) output: PathBuf,
    #[arg(
        long, value_name = "FRAMES/S", allow_hyphen_values = true, default_value_t = RATE.0, hide_default_value = true,
        value_parser = within("rate", RATE.1, RATE.2, " frames/s"),
        help = wrap(&format!("Samples a second that are measured, {} to {} [default: {}]", RATE.1, RATE.2, RATE.0))
    )]
    pub(crate) rate: f64,
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024), help = wrap(
        "Walks at a time, 1 to 1024; the file does not depend on it [default: one a core]"
    ))]
    pub(crate) threads: Option<u16>,
    #[arg(long, help = "Print the summary as JSON instead of a table")]
    pub(crate) json: bool,
}

/// The options of a walk, each row of a sweep in the words of a command line.
pub(crate) fn walk_options() -> Command {
    WalkArgs::augment_args(Command::new("walk")).no_binary_name(true)
}

/// Which of them can head a column.
pub(crate) fn columns(walk: &Command) -> Vec<String> {
    let is_column = |option: &&Arg| option.get_action().takes_values() && !option.is_hide_set();
    let names = walk.get_arguments().filter(is_column).filter_map(|option| option.get_long());
    names.filter(|name| !NO_COLUMNS.contains(name)).map(str::to_owned).collect()
}
