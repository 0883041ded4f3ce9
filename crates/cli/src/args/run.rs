//! The request of `solaris run`.

use super::{FilmArgs, RigArgs, wrap};
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "Examples:
  solaris run walk_loose_arm.ron -o walk.html
      a person walks with one loose arm; open walk.html in a browser
  solaris run pendulum.ron -o swing.csv -o swing.mot --report swing.json
      tables of the motion, and all that there is to say of the run as JSON
  solaris run reach.ron --between 0:3 --seen corner -o reach.svg
      a film strip of it, from the right, in front and above
  solaris run arm_modes.ron --plan
      what is computed in which part of the run, what is left out, and what that saves";

/// A scene, and what to make of it.
#[derive(Debug, Args)]
#[command(about = "Runs a scene: a figure, what drives it, and for how long", after_help = EXAMPLES)]
pub(crate) struct RunArgs {
    #[arg(value_name = "SCENE.ron", help = wrap("The scene; figures that it names as files are sought beside it"))]
    pub(crate) scene: PathBuf,
    #[arg(short = 'o', long = "output", value_name = "FILE", help = wrap(
        "Write the motion: .html page, .svg picture of the coordinates, or with --between or --seen a film strip, .csv table, \
         .bvh motion capture, .glb or .usda body and animation, .sto or .mot coordinates for OpenSim; several -o are allowed [default: none]"
    ))]
    pub(crate) outputs: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) bones: RigArgs,
    #[command(flatten)]
    pub(crate) film: FilmArgs,
    #[arg(
        long,
        value_name = "FILE.json",
        help = "Write what there is to say of the run as JSON [default: none]"
    )]
    pub(crate) report: Option<PathBuf>,
    #[arg(long, help = wrap(
        "Print what was computed, what was left out, and the cost of one evaluation with and without that"
    ))]
    pub(crate) plan: bool,
    #[arg(long, help = "Print what there is to say of the run as JSON instead of a table")]
    pub(crate) json: bool,
}
