//! The request of `solaris studio`.

use super::wrap;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "Examples:
  solaris studio -o studio.html
      the interactive environment: open it by a double click, it needs no server and no network
  solaris studio robot.urdf -o robot.html
      the same with a robot in it, which it shows at once
  solaris studio subject.osim walk.mot grf.mot -o subject.html
      a model, its motion and measured forces: joint moments at once";

/// The studio, and what it begins with.
#[derive(Debug, Args)]
#[command(about = "The interactive environment, in one file that opens in any browser", after_help = EXAMPLES)]
pub(crate) struct StudioArgs {
    #[arg(value_name = "FILE", help = wrap(
        "Models, motions, markers, forces, scenes: what the studio opens when it begins, as if they had been dropped on it; a folder means all files in it"
    ))]
    pub(crate) files: Vec<PathBuf>,
    #[arg(
        short = 'o',
        long = "output",
        value_name = "FILE",
        required = true,
        help = "Write the page (.html)"
    )]
    pub(crate) output: PathBuf,
}
