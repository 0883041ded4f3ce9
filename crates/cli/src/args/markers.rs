//! Options for motions that are markers.

use super::wrap;
use clap::Args;
use solaris::io::markers::{Axes, LengthUnit};
use std::path::PathBuf;

/// How markers are read, and how a figure is brought to them.
#[derive(Debug, Default, Args)]
pub(crate) struct MarkerArgs {
    #[arg(long, value_name = "FILE.xml", help = wrap(
        "Markers of the figure: an OpenSim MarkerSet; they join the model's own [default: the model's, or its named frames]"
    ))]
    pub(crate) marker_set: Option<PathBuf>,
    #[arg(long, value_name = "FILE.xml", help = wrap(
        "Weights of markers and coordinates: the setup of OpenSim's InverseKinematicsTool [default: all markers weigh 1]"
    ))]
    pub(crate) ik_setup: Option<PathBuf>,
    #[arg(long, value_name = "UP,FORWARD", allow_hyphen_values = true, help = wrap(
        "Which ways of files of markers are up and forward, such as z,-y [default: found where up is not the figure's up]"
    ))]
    pub(crate) axes: Option<Axes>,
    #[arg(id = "marker_unit", long = "marker-unit", value_name = "UNIT", value_parser = parse_unit, help = wrap(
        "Unit of their lengths, whatever they say: mm, cm, m or inch [default: what they say, unless nobody is that large]"
    ))]
    pub(crate) unit: Option<LengthUnit>,
    #[arg(long, help = wrap("Take labels as they are, even where two markers have clearly exchanged theirs"))]
    pub(crate) keep_labels: bool,
}

fn parse_unit(text: &str) -> Result<LengthUnit, String> {
    LengthUnit::named(text).ok_or_else(|| "it must be mm, cm, m or inch".to_owned())
}
