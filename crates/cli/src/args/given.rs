//! Options for a figure in a motion: how both are taken.

use super::markers::MarkerArgs;
use super::wrap;
use clap::{Args, ValueEnum};
use solaris::model::{Base, Vector3};
use std::path::PathBuf;

pub(super) const FIGURE: &str = "A figure (.ron), URDF (.urdf), SDF (.sdf), MuJoCo (.xml, .mjcf) or OpenSim (.osim) model, or bones (.bvh, .glb)";
pub(super) const FILES: &str = "Folder of the other files of a MuJoCo or SDF model, which holds the model; nothing outside is read [default: the model's own]";
pub(super) const MOTION: &str =
    "Its motion: .csv with columns DOF.q and, where known, .v and .a; .mot, .sto; or markers, .trc, .c3d";

/// Order of the filter when none is asked for.
const FILTER_ORDER: u8 = 2;

/// How the motion is differentiated.
#[derive(Debug, Args)]
pub(crate) struct RecordArgs {
    #[arg(long, value_name = "HZ", allow_hyphen_values = true, value_parser = parse_frequency, help = wrap(
        "Filter positions before they are differentiated: a zero-phase Butterworth low-pass of this cut-off [default: none]"
    ))]
    pub(crate) filter: Option<f64>,
    #[arg(
        long, value_name = "N", requires = "filter", value_parser = clap::value_parser!(u8).range(1..=10),
        default_value_t = FILTER_ORDER, hide_default_value = true,
        help = "Order of the filter, there and back; OpenSim's is 3 [default: 2]"
    )]
    pub(crate) filter_order: u8,
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true, value_parser = parse_time, help = wrap(
        "Take the motion between these times (s) alone, such as 1.2:3.4 [default: all of it]"
    ))]
    pub(crate) time: Option<Span>,
    #[command(flatten, next_help_heading = "A motion that is markers")]
    pub(crate) markers: MarkerArgs,
}

/// A part of a motion (s), and how it was typed.
#[derive(Clone, Debug)]
pub(crate) struct Span {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) typed: String,
}

/// Means over strides.
#[derive(Debug, Args)]
pub(crate) struct CyclesArgs {
    #[arg(long = "cycles", value_name = "FOOT", requires = "cycles_out", help = wrap(
        "Cut the motion at the touch-downs of this foot: right, left, or a sole's name"
    ))]
    pub(crate) foot: Option<String>,
    #[arg(id = "cycles_out", long = "cycles-out", value_name = "FILE", requires = "foot", help = wrap(
        "Write mean and standard deviation over these strides at every percent of them: .csv (COLUMN.mean, COLUMN.sd), or draw \
         them: .svg [default: none]"
    ))]
    pub(crate) outputs: Vec<PathBuf>,
}

/// What the figure is under, and what its root is.
#[derive(Debug, Args)]
pub(crate) struct FrameArgs {
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = parse_gravity, help = wrap(
        "Gravity in m/s² [default: the file's, or 9.80665 along the format's own down axis]"
    ))]
    pub(crate) gravity: Option<Gravity>,
    #[arg(long, value_name = "KIND", value_enum, hide_possible_values = true, help = wrap(
        "Root of a figure that is fixed to the world: fixed; floating (root.tx ty tz rz ry rx); free (position and \
         quaternion) [default: as the file says]"
    ))]
    pub(crate) base: Option<AskedBase>,
    #[arg(long, value_name = "FOLDER", help = wrap(FILES))]
    pub(crate) files: Option<PathBuf>,
}

/// What the root of a figure that is fixed to the world may become.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum AskedBase {
    Fixed,
    Floating,
    Free,
}

impl From<AskedBase> for Base {
    fn from(base: AskedBase) -> Self {
        match base {
            AskedBase::Fixed => Self::Fixed,
            AskedBase::Floating => Self::Floating,
            AskedBase::Free => Self::Free,
        }
    }
}

/// An acceleration of gravity (m/s²), and how it was typed.
#[derive(Clone, Debug)]
pub(crate) struct Gravity {
    pub(crate) vector: Vector3<f64>,
    pub(crate) typed: String,
}

fn parse_gravity(text: &str) -> Result<Gravity, String> {
    let numbers: Option<Vec<f64>> =
        text.split(',').map(|part| part.trim().parse().ok().filter(|x: &f64| x.is_finite())).collect();
    match numbers.as_deref() {
        Some(&[x, y, z]) => Ok(Gravity { vector: Vector3::new(x, y, z), typed: text.to_owned() }),
        _ => Err("it must be three numbers with commas between them, such as 0,0,-9.81".to_owned()),
    }
}

/// Two times that rise.
fn parse_time(text: &str) -> Result<Span, String> {
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    let times = text.split_once(':').and_then(|(from, to)| number(from).zip(number(to)));
    match times {
        Some((from, to)) if from < to => Ok(Span { from, to, typed: text.to_owned() }),
        _ => Err("it must be two times in s, the earlier one first, such as 1.2:3.4".to_owned()),
    }
}

/// A frequency, with or without its unit.
fn parse_frequency(text: &str) -> Result<f64, String> {
    let number = text.strip_suffix("Hz").or_else(|| text.strip_suffix("hz")).unwrap_or(text).trim();
    match number.parse::<f64>() {
        Ok(value) if value > 0.0 && value.is_finite() => Ok(value),
        _ => Err("it must be a frequency above zero, such as 6Hz".to_owned()),
    }
}
