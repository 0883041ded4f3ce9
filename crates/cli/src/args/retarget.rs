//! Requests of the command `retarget`.

use super::{BonesArgs, wrap};
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "Examples:
  solaris walk -o walk.bvh && solaris retarget walk.bvh --onto hero.glb -o hero-walks.glb
      a walk of our own on a character of a 3D program
  solaris retarget capture.bvh --onto hero.glb -o out.glb --name walk
      motion capture
  solaris retarget other.glb --clip run --onto hero.glb -o out.glb
      an animation of another character
  solaris retarget clips.glb --all --onto hero.glb -o out.glb
      all of its animations
  solaris retarget capture.bvh --onto robot.glb --map robot-bones.ron -o out.glb
      a character whose bones have names of their own: Bones(pelvis: \"Root_M\", left_thigh: \"Hip_L\", …)";

/// A motion that goes onto a character.
#[derive(Debug, Args)]
#[command(
    about = "Puts a motion onto a character of a .glb file, which stays as it is and gets one more animation",
    after_help = EXAMPLES
)]
pub(crate) struct RetargetArgs {
    #[arg(value_name = "CLIP", help = wrap(
        "The motion: .bvh, .glb, or with --figure a table (.csv, .mot, .sto)"
    ))]
    pub(crate) motion: PathBuf,
    #[arg(long, value_name = "FILE", help = "The character: .glb, or a .gltf that holds its bytes itself")]
    pub(crate) onto: PathBuf,
    #[arg(
        short = 'o',
        long,
        value_name = "FILE",
        help = "Where to write the character with the animation: .glb"
    )]
    pub(crate) output: PathBuf,
    #[arg(
        long,
        value_name = "NAME",
        help = "What the animation is called [default: --clip, or the clip's file name]"
    )]
    pub(crate) name: Option<String>,
    #[arg(long, conflicts_with_all = ["name", "clip"], help = wrap(
        "Every animation of a .glb file, each by its own name, instead of --clip"
    ))]
    pub(crate) all: bool,
    #[arg(long, help = "Left and right exchanged: who turned left turns right")]
    pub(crate) mirror: bool,
    #[arg(long, value_name = "FILE", help = wrap(
        "Which bones of the character are which: Bones(pelvis: \"NAME\", left_thigh: \"NAME\", …), by the names of a human's links [default: \
         by their names]"
    ))]
    pub(crate) map: Option<PathBuf>,
    #[arg(long, value_name = "FILE", help = wrap("The same of the clip's bones [default: by their names]"))]
    pub(crate) clip_map: Option<PathBuf>,
    #[arg(long, value_name = "N", help = wrap(
        "The frame of the clip, from 0, in which it stands upright with its soles on the ground [default: with all joints at zero]"
    ))]
    pub(crate) rest_frame: Option<usize>,
    #[arg(long, value_name = "FILE", help = "Whose motion a table is")]
    pub(crate) figure: Option<PathBuf>,
    #[command(flatten, next_help_heading = "What a file of bones does not say")]
    pub(crate) skeleton: BonesArgs,
}
