//! Options for a figure that is brought to a person's size, and the request of `solaris scale`.

use super::given::{FIGURE, FrameArgs};
use super::markers::MarkerArgs;
use super::{Number, wrap};
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "Examples:
  solaris scale generic.osim --scale-setup Setup_Scale.xml -o subject.osim
      as OpenSim's ScaleTool: measured factors, mass, and markers where the static trial has them
  solaris scale generic.osim --static static.trc --mass 72.6 -o subject.osim
      without a setup: lengths and marker places are fitted to the static trial
  solaris scale generic.osim walk1.trc walk2.trc --fit --static static.trc --mass 72.6 -o subject.osim
      the same over all trials, with the errors of the lengths
  solaris scale generic.osim --static static.trc --scale-setup Setup_Scale.xml --mass 72.6 -o subject.ron
      the same of another trial and mass, as a figure's text";

/// How a figure is brought to a person's size.
#[derive(Debug, Default, Args)]
pub(crate) struct SubjectArgs {
    #[arg(long = "static", value_name = "FILE", help = wrap(
        "A trial of the person standing still, .trc or .c3d: the figure is brought to its size and wears its markers \
         [default: the setup's]"
    ))]
    pub(crate) standing: Option<PathBuf>,
    #[arg(long, value_name = "FILE.xml", help = wrap(
        "What to measure and to weigh: the setup of OpenSim's ScaleTool [default: none]"
    ))]
    pub(crate) scale_setup: Option<PathBuf>,
    #[arg(long, help = wrap(
        "Find segment lengths and marker places together with the motion, over all trials of markers that are given, with a          standard error for each length"
    ))]
    pub(crate) fit: bool,
    #[arg(long, value_name = "KG", allow_hyphen_values = true, help = wrap(
        "The person's mass, met exactly [default: the setup's, or else the figure's]"
    ))]
    pub(crate) mass: Option<Number>,
}

impl SubjectArgs {
    /// Whether the figure is to change.
    pub(crate) fn is_asked(&self) -> bool {
        self.standing.is_some() || self.scale_setup.is_some() || self.mass.is_some() || self.fit
    }
}

/// A figure that is brought to a person's size.
#[derive(Debug, Args)]
#[command(about = "A generic figure to a person's size, by markers", after_help = EXAMPLES)]
pub(crate) struct ScaleArgs {
    #[arg(value_name = "FIGURE", help = wrap(FIGURE))]
    pub(crate) figure: PathBuf,
    #[arg(value_name = "TRIALS", help = wrap("Trials of the person's markers, for --fit: .trc or .c3d"))]
    pub(crate) trials: Vec<PathBuf>,
    #[arg(short = 'o', long = "output", value_name = "FILE", help = wrap(
        "Write the figure: .osim, the model's own text scaled; .ron, its markers as named frames; several are allowed [default: none]"
    ))]
    pub(crate) outputs: Vec<PathBuf>,
    #[arg(long, help = "Print the summary as JSON instead of a table")]
    pub(crate) json: bool,
    #[command(flatten, next_help_heading = "The person")]
    pub(crate) subject: SubjectArgs,
    #[command(flatten, next_help_heading = "The markers")]
    pub(crate) markers: MarkerArgs,
    #[command(flatten, next_help_heading = "The figure")]
    pub(crate) frame: FrameArgs,
}
