//! The request of `solaris crowd`.

use super::value::within;
use super::{RATE, RigArgs, columns, walk_options, wrap};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

const EXAMPLES: &str = "Examples:
  solaris crowd --people people.csv -o crowd
      people.csv may be: name,age,manner,x,z,heading
                         Ann,34,happy,0,0,10
                         Bo,71,,1.5,0,
                         ,9,,3,-1,
  solaris crowd --count 100 --seed 7 -o crowd --format csv
      a hundred people by chance, none like another, as tables
  solaris crowd --count 100 --rate 30 -o crowd.glb
      the same with their bodies, in one file
  solaris crowd --count 100 --rig unreal --format glb -o crowd
      a file for each, on the bones of a rig";

/// The columns that are no option of a walk.
pub(crate) const PLACES: [&str; 4] = ["name", "x", "z", "heading"];

/// The most people that are drawn.
const MOST: u32 = 10_000;

/// A crowd.
#[derive(Debug, Args)]
#[command(about = "A crowd: a table of people in, a motion of each out", after_help = EXAMPLES)]
pub(crate) struct CrowdArgs {
    #[arg(long, value_name = "PEOPLE.csv", required_unless_present = "count", conflicts_with = "count", help = wrap(&format!(
        "A person a row; headings are {} (m, m, degrees to the left) and options of `solaris walk`: {}. What is left out is drawn: height, \
         mass, manner of steps [default: none]",
        PLACES.join(", "),
        columns(&walk_options()).join(", ")
    )))]
    pub(crate) people: Option<PathBuf>,
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(MOST)), help = wrap(&format!(
        "So many people by chance instead of a table, 1 to {MOST}, in rows [default: those of the table]"
    )))]
    pub(crate) count: Option<u32>,
    #[arg(short = 'o', long, value_name = "FOLDER", help = wrap(&format!(
        "Write a motion for each person, and crowd.csv with a row for each: who, where, in which file, or why not; or name a file that \
         ends in .glb, and all of them, {MOST_IN_ONE} at most, walk in it"
    )))]
    pub(crate) output: PathBuf,
    #[arg(long, value_name = "FORMAT", value_enum, hide_possible_values = true, help = wrap(
        "bvh: motion capture; glb: body and animation; csv: a table of positions and forces [default: bvh]"
    ))]
    pub(crate) format: Option<CrowdFormat>,
    #[arg(long, value_name = "N", default_value_t, hide_default_value = true, help = wrap(
        "Which crowd: the same seed is the same people [default: 0]"
    ))]
    pub(crate) seed: u64,
    #[arg(
        long, value_name = "FRAMES/S", allow_hyphen_values = true, default_value_t = CROWD_RATE, hide_default_value = true,
        value_parser = within("rate", RATE.1, RATE.2, " frames/s"),
        help = wrap(&format!("Samples a second of the motions, {} to {} [default: {CROWD_RATE}]", RATE.1, RATE.2))
    )]
    pub(crate) rate: f64,
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024), help = wrap(
        "People at a time, 1 to 1024; no file depends on it [default: one a core]"
    ))]
    pub(crate) threads: Option<u16>,
    #[arg(long, help = "Print the summary as JSON instead of a table")]
    pub(crate) json: bool,
    #[command(flatten)]
    pub(crate) bones: RigArgs,
}

/// The most people of one file: all of their motions are kept until it is written.
pub(crate) const MOST_IN_ONE: usize = 500;

/// Samples a second, as films have them.
const CROWD_RATE: f64 = 60.0;

/// What a person's motion is written as.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum CrowdFormat {
    #[default]
    Bvh,
    Glb,
    Csv,
}

impl CrowdFormat {
    pub(crate) fn extension(self) -> &'static str {
        match self {
            Self::Bvh => "bvh",
            Self::Glb => "glb",
            Self::Csv => "csv",
        }
    }
}
