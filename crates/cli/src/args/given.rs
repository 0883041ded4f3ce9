//! The options of what is given to find forces: a figure, its motion, and how both are taken.

use super::wrap;
use clap::Arg;
use clap::builder::ValueParser;
use solaris::model::{Base, Vector3};

/// What the root of a figure that is fixed to the world may become.
pub(crate) const BASES: [(&str, Base); 3] =
    [("fixed", Base::Fixed), ("floating", Base::Floating), ("free", Base::Free)];

pub(super) const FIGURE: &str =
    "A figure (.ron), URDF (.urdf), MuJoCo (.xml, .mjcf) or OpenSim (.osim) model";
pub(super) const MOTION: &str =
    "Its motion: .csv with columns DOF.q and, where known, .v and .a; or .mot, .sto";

/// How the motion is differentiated.
pub(super) fn motion() -> [Arg; 2] {
    [
        Arg::new("filter")
            .long("filter")
            .value_name("HZ")
            .allow_hyphen_values(true)
            .value_parser(ValueParser::new(parse_frequency))
            .help(wrap(
                "Filter positions before they are differentiated: a zero-phase Butterworth low-pass of this cut-off \
                 [default: none]",
            )),
        Arg::new("filter-order")
            .long("filter-order")
            .value_name("N")
            .requires("filter")
            .value_parser(clap::value_parser!(u8).range(1..=10))
            .help("Order of the filter, there and back; OpenSim's is 3 [default: 2]"),
    ]
}

/// What the figure is under, and what its root is.
pub(super) fn figure() -> [Arg; 2] {
    [
        Arg::new("gravity")
            .long("gravity")
            .value_name("X,Y,Z")
            .allow_hyphen_values(true)
            .value_parser(ValueParser::new(parse_gravity))
            .help(wrap("Gravity in m/s² [default: the file's, or 9.80665 along the format's own down axis]")),
        Arg::new("base")
            .long("base")
            .value_name("KIND")
            .value_parser(BASES.map(|(name, _)| name))
            .hide_possible_values(true)
            .help(wrap(
                "Root of a figure that is fixed to the world: fixed; floating (root.tx ty tz rz ry rx); free (position and \
                 quaternion) [default: as the file says]",
            )),
    ]
}

/// An acceleration of gravity (m/s²).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gravity(pub(crate) Vector3<f64>);

fn parse_gravity(text: &str) -> Result<Gravity, String> {
    let numbers: Option<Vec<f64>> =
        text.split(',').map(|part| part.trim().parse().ok().filter(|x: &f64| x.is_finite())).collect();
    match numbers.as_deref() {
        Some(&[x, y, z]) => Ok(Gravity(Vector3::new(x, y, z))),
        _ => Err("it must be three numbers with commas between them, such as 0,0,-9.81".to_owned()),
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
