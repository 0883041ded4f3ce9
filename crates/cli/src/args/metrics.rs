//! The request of `solaris metrics`.

use super::given::{self, FrameArgs, RecordArgs};
use super::ground::GroundArgs;
use super::{PersonArgs, wrap};
use clap::{Arg, Args, ValueEnum};
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "Examples:
  solaris metrics walk.csv
      a walk of `solaris walk`, with the forces that stand in its file
  solaris metrics walk.csv --height 1.75 --stances feet --ground -o metrics.json -o metrics.csv
      the same from its positions alone: stances from how the feet move, forces predicted; both files
  solaris metrics subject.osim walk.mot --soles soles.ron --filter 6Hz --ground
      a measured walk of any figure";

/// A motion to be measured.
#[derive(Debug, Args)]
#[command(
    about = "Foot slide, sink, steps, force peaks, smoothness: numbers of any motion of any figure with feet",
    after_help = EXAMPLES,
    allow_missing_positional = true,
    mut_args(of_metrics)
)]
pub(crate) struct MetricsArgs {
    #[arg(value_name = "FIGURE", conflicts_with_all = ["height", "mass"], help = wrap(&format!(
        "Who moves: {} [default: a human of this height and mass]", given::FIGURE.replacen('A', "a", 1)
    )))]
    pub(crate) figure: Option<PathBuf>,
    #[arg(value_name = "MOTION", help = wrap(given::MOTION))]
    pub(crate) motion: PathBuf,
    #[arg(short = 'o', long = "output", value_name = "FILE", help = wrap(
        "Write the numbers: .json, or .csv with a metric a row; several are allowed [default: none]"
    ))]
    pub(crate) outputs: Vec<PathBuf>,
    #[arg(long, help = "Print the numbers as JSON instead of a table")]
    pub(crate) json: bool,
    #[arg(
        long = "figure", value_name = "FILE", conflicts_with_all = ["height", "mass", "figure"],
        help = "The same as FIGURE", help_heading = "The figure"
    )]
    of: Option<PathBuf>,
    #[command(flatten, next_help_heading = "The figure")]
    pub(crate) person: PersonArgs,
    #[command(flatten)]
    pub(crate) frame: FrameArgs,
    #[command(flatten, next_help_heading = "The ground")]
    pub(crate) feet: FeetArgs,
    #[command(flatten)]
    pub(crate) how: GroundArgs,
    #[command(flatten, next_help_heading = "The motion")]
    pub(crate) record: RecordArgs,
}

impl MetricsArgs {
    /// Who moves, where it is no human of some size.
    pub(crate) fn figure(&self) -> Option<&Path> {
        self.figure.as_deref().or(self.of.as_deref())
    }
}

/// What is known of the feet.
#[derive(Debug, Args)]
pub(crate) struct FeetArgs {
    #[arg(long, help = wrap(
        "Predict the ground's forces from the motion, as `solaris ground` does, for their peaks"
    ))]
    pub(crate) ground: bool,
    #[arg(long, value_name = "contacts|feet", value_enum, hide_possible_values = true, help = wrap(
        "What tells which foot stands: the forces in the motion's own file (NAME.fx … of each sole), or how the feet \
         move [default: contacts where the file has them]"
    ))]
    pub(crate) stances: Option<StancesFrom>,
    #[arg(long, value_name = "M|feet", allow_hyphen_values = true, value_parser = parse_level, help = wrap(
        "Height of the ground along up in m, or where the soles are lowest (feet), which hides that all of the motion \
         sinks [default: 0 where the figure has soles of its own, else feet]"
    ))]
    pub(crate) level: Option<AskedLevel>,
}

/// What the options of the ground are here.
fn of_metrics(arg: Arg) -> Arg {
    match arg.get_id().as_str() {
        "split" => arg.requires("ground"),
        "belt" => arg.help(wrap(
            "How the ground itself moves, on a treadmill: its speed in m/s, along the feet on it; still; or as the feet on \
             it tell (auto) [default: still, unless the feet on it are faster than --stance-speed]",
        )),
        _ => arg,
    }
}

/// What tells which foot stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum StancesFrom {
    Contacts,
    Feet,
}

/// How high the ground is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum AskedLevel {
    Feet,
    /// Height along up (m).
    At(f64),
}

fn parse_level(text: &str) -> Result<AskedLevel, String> {
    match text.parse::<f64>() {
        _ if text == "feet" => Ok(AskedLevel::Feet),
        Ok(level) if level.is_finite() => Ok(AskedLevel::At(level)),
        _ => Err("it must be a height in m, such as 0 or -0.012, or feet".to_owned()),
    }
}
