//! Options of who walks how: populations, manners, and steps that differ.

use crate::args::wrap;
use clap::{Args, ValueEnum};
use solaris::gait::{
    CANE_LOAD, CANE_LOADS, MANNERS, MOST_VARIABILITY, Population, SIDE_MANNERS, ShippedManner,
};
use std::path::PathBuf;

/// Whose walk it is, in which manner, and how even.
#[derive(Debug, Args)]
pub(crate) struct EveryoneArgs {
    #[arg(long, value_name = "WHO", value_enum, hide_possible_values = true, help = wrap(
        "Whose steps: adult: 0.0037·height·frequency; treadmill: 0.0031; child: as quick for its height as adults are; older: nine \
         tenths of an adult's, a little longer on both feet [default: adult]"
    ))]
    pub(crate) population: Option<Who>,
    #[arg(long, value_name = "MANNER", allow_hyphen_values = true, help = wrap(&format!(
        "In which manner: {}; a part of one as sad:0.6, several as sad:0.6,heavy:0.3; several --manner add up [default: none]",
        names(MANNERS)
    )))]
    pub(crate) manner: Vec<String>,
    #[arg(long, value_name = "FILE.ron", help = wrap(
        "A manner of your own, as text: docs/manners.md has the numbers; several add up [default: none]"
    ))]
    pub(crate) style_file: Vec<PathBuf>,
    #[arg(long, value_name = "MANNER", allow_hyphen_values = true, help = wrap(&format!(
        "What is different of the left leg and arm: {}, in parts as --manner, or a FILE.ron [default: nothing]",
        names(SIDE_MANNERS)
    )))]
    pub(crate) left: Option<String>,
    #[arg(long, value_name = "MANNER", allow_hyphen_values = true, help = wrap(
        "What is different of the right leg and arm [default: nothing]"
    ))]
    pub(crate) right: Option<String>,
    #[arg(long, value_name = "PART", allow_hyphen_values = true, help = wrap(&format!(
        "Of somebody with a cane: the part of the whole vertical force that it bears at most, {} to {} [default: {CANE_LOAD}]", CANE_LOADS.0, CANE_LOADS.1
    )))]
    pub(crate) cane_load: Option<super::Number>,
    #[arg(
        long, value_name = "TIMES",
        num_args = 0..=1, default_missing_value = "1",
        help = wrap(&format!(
            "How steps differ from each other, and left from right, times as much as people's, 0 to {MOST_VARIABILITY}; 1 where the number \
             is left out [default: not at all]"
        ))
    )]
    pub(crate) variability: Option<super::Number>,
    #[arg(long, value_name = "N", help = wrap(
        "Whose differences: the same seed is the same walk [default: 0]"
    ))]
    pub(crate) seed: Option<u64>,
}

/// Whose step length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Who {
    Adult,
    Treadmill,
    Child,
    Older,
}

impl From<Who> for Population {
    fn from(who: Who) -> Self {
        match who {
            Who::Adult => Self::Adult,
            Who::Treadmill => Self::Treadmill,
            Who::Child => Self::Child,
            Who::Older => Self::Older,
        }
    }
}

/// The manners that there are.
fn names(all: &[ShippedManner]) -> String {
    all.iter().map(|manner| manner.name).collect::<Vec<_>>().join(", ")
}

impl EveryoneArgs {
    /// The first of the options that make steps differ, as it was typed.
    pub(crate) fn uneven(&self) -> Option<(&'static str, String)> {
        let left = || Some(("left", self.left.clone()?));
        let right = || Some(("right", self.right.clone()?));
        let even = self.variability.as_ref().map(|variability| ("variability", variability.typed.clone()));
        even.or_else(left).or_else(right)
    }

    /// The first of these options that was given, as it was typed.
    pub(crate) fn given(&self) -> Option<(&'static str, String)> {
        let who = self.population.map(|who| ("population", Population::from(who).name().to_owned()));
        let manner = || Some(("manner", self.manner.first()?.clone()));
        let file = || Some(("style-file", self.style_file.first()?.display().to_string()));
        let even = || Some(("variability", self.variability.as_ref()?.typed.clone()));
        let seed = || Some(("seed", self.seed?.to_string()));
        let left = || Some(("left", self.left.clone()?));
        let right = || Some(("right", self.right.clone()?));
        let cane = || Some(("cane-load", self.cane_load.as_ref()?.typed.clone()));
        let who = who.or_else(cane);
        who.or_else(manner).or_else(file).or_else(left).or_else(right).or_else(even).or_else(seed)
    }
}
