//! Options for motions that are markers.

use super::wrap;
use clap::Args;
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
    #[arg(long, help = wrap("Take labels as they are, even where two markers have clearly exchanged theirs"))]
    pub(crate) keep_labels: bool,
}
