//! Options of the ground that is walked on.

use crate::args::value::{Number, count};
use crate::args::wrap;
use clap::Args;
use solaris::gait::{SLOPES, STAIR_COUNT, STAIRS, Stairs};
use std::path::PathBuf;

/// What is walked on.
#[derive(Debug, Args)]
pub(crate) struct TerrainArgs {
    #[arg(
        long, value_name = "DEGREES", allow_hyphen_values = true,
        conflicts_with_all = ["stairs", "ground", "turn", "path", "then", "repeats"],
        help = wrap(&format!(
            "Walk up a slope from standing to standing, down where it is negative, {:.0} to {:.0}° [default: level]",
            SLOPES.0.to_degrees(), SLOPES.1.to_degrees()
        ))
    )]
    pub(crate) slope: Option<Number>,
    #[arg(
        long, value_name = "N", value_parser = count("stairs", STAIR_COUNT.0, STAIR_COUNT.1),
        conflicts_with_all = ["ground", "turn", "path", "then", "repeats", "steps", "distance"],
        help = wrap("Walk up so many stairs, with three level steps before and after them [default: level]")
    )]
    pub(crate) stairs: Option<usize>,
    #[arg(long, value_name = "M", allow_hyphen_values = true, requires = "stairs", help = wrap(&format!(
        "Height of a stair, {} to {} m, negative for the way down [default: {}]",
        STAIRS.0.0, STAIRS.0.1, Stairs::default().rise
    )))]
    pub(crate) rise: Option<Number>,
    #[arg(long, value_name = "M", allow_hyphen_values = true, requires = "stairs", help = wrap(&format!(
        "Depth of a stair, {} to {} m [default: {}]", STAIRS.1.0, STAIRS.1.1, Stairs::default().tread
    )))]
    pub(crate) tread: Option<Number>,
    #[arg(long, value_name = "FILE.csv", conflicts_with_all = ["turn", "path", "then", "repeats"], help = wrap(
        "Walk over ground of this shape: a table with the columns z (ahead) and height in m, straight between its points, level before and \
         after; two points at one place are a kerb [default: level]"
    ))]
    pub(crate) ground: Option<PathBuf>,
    #[arg(
        long, value_name = "FILE.csv",
        conflicts_with_all = ["slope", "stairs", "ground", "turn", "path", "then", "repeats", "steps", "distance"],
        help = wrap(
            "Set each foot down where a table says: a row for each step, with the columns z (ahead, of the heel) in m and, where there are any,              x (to the left) and height in m, pitch (uphill) and heading (to the left) in degrees [default: level]"
        )
    )]
    pub(crate) footholds: Option<PathBuf>,
}

impl TerrainArgs {
    /// The first of these options that was given, as it was typed.
    pub(crate) fn given(&self) -> Option<(&'static str, String)> {
        let slope = self.slope.as_ref().map(|slope| ("slope", slope.typed.clone()));
        let stairs = || Some(("stairs", self.stairs?.to_string()));
        let ground = || Some(("ground", self.ground.as_ref()?.display().to_string()));
        let footholds = || Some(("footholds", self.footholds.as_ref()?.display().to_string()));
        slope.or_else(stairs).or_else(ground).or_else(footholds)
    }
}
