//! The request of `solaris ik`.

use super::given::{FIGURE, FrameArgs};
use super::markers::MarkerArgs;
use super::subject::SubjectArgs;
use super::wrap;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "Examples:
  solaris ik subject.osim walk.trc -o ik.mot
      joint angles of measured markers, and how far each marker is off
  solaris ik subject.osim walk.trc --ik-setup setup.xml -o ik.mot --errors-out errors.csv
      the same with weights of OpenSim's setup, and each marker's distance in every frame";

/// A figure and where its markers were seen.
#[derive(Debug, Args)]
#[command(about = "Joint angles from markers: inverse kinematics", after_help = EXAMPLES)]
pub(crate) struct IkArgs {
    #[arg(value_name = "FIGURE", help = wrap(FIGURE))]
    pub(crate) figure: PathBuf,
    #[arg(value_name = "MARKERS", help = wrap("Where its markers were seen: .trc or .c3d"))]
    pub(crate) trial: PathBuf,
    #[arg(short = 'o', long = "output", value_name = "FILE", help = wrap(
        "Write the angles: .mot or .sto as OpenSim does, .csv, .bvh, .glb, .usda; several are allowed [default: none]"
    ))]
    pub(crate) outputs: Vec<PathBuf>,
    #[arg(long, value_name = "FILE.csv", help = wrap(
        "Write how far each marker is from where it was seen, in every frame [default: none]"
    ))]
    pub(crate) errors_out: Option<PathBuf>,
    #[arg(long, help = "Print the summary as JSON instead of a table")]
    pub(crate) json: bool,
    #[command(flatten, next_help_heading = "A figure that is brought to a person's size")]
    pub(crate) subject: SubjectArgs,
    #[command(flatten, next_help_heading = "The markers")]
    pub(crate) markers: MarkerArgs,
    #[command(flatten, next_help_heading = "The figure")]
    pub(crate) frame: FrameArgs,
}
