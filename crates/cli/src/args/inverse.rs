//! The options of `solaris inverse`.

use super::{input, json, path, wrap};
use clap::builder::ValueParser;
use clap::{Arg, ArgAction, Command};
use solaris::model::{Base, Vector3};

/// What the root of a figure that is fixed to the world may become.
pub(crate) const BASES: [(&str, Base); 3] =
    [("fixed", Base::Fixed), ("floating", Base::Floating), ("free", Base::Free)];

const EXAMPLES: &str = "Examples:
  solaris inverse subject.osim walk.mot --external grf.mot --plate calcn_r= --plate calcn_l=1_ --filter 6Hz \\
      --filter-order 3 -o moments.sto
      joint moments of a measured walk on force plates; the left foot's columns begin with 1_
  solaris inverse subject.osim walk.mot --external-loads loads.xml --filter 6Hz -o moments.sto
      the same, with OpenSim's own description of the forces
  solaris inverse robot.urdf trajectory.csv -o tau.csv
      motor torques of a robot
  solaris inverse human.ron walk.csv --external walk.csv --plate left_foot+left_toes=left_foot \\
      --plate right_foot+right_toes=right_foot -o tau.csv
      a walk of `solaris walk`: the toes carry the force once the centre of pressure has passed the ball";

pub(super) fn command() -> Command {
    Command::new("inverse")
        .about("Joint torques of a given motion")
        .after_help(EXAMPLES)
        .arg(input("figure", "FIGURE", "A figure (.ron), URDF (.urdf), MuJoCo (.xml, .mjcf) or OpenSim (.osim) model"))
        .arg(input(
            "motion",
            "MOTION",
            "Its motion: .csv with columns DOF.q and, where known, .v and .a; or .mot, .sto",
        ))
        .arg(path("output").short('o').action(ArgAction::Append).help(wrap(
            "Write the torques: .csv with columns DOF.tau, or .sto with OpenSim's names [default: none]",
        )))
        .arg(json("Print the summary as JSON instead of a table"))
        .next_help_heading("Forces from outside")
        .args(forces())
        .next_help_heading("The motion")
        .arg(
            Arg::new("filter")
                .long("filter")
                .value_name("HZ")
                .allow_hyphen_values(true)
                .value_parser(ValueParser::new(parse_frequency))
                .help(wrap(
                    "Filter positions before they are differentiated: a zero-phase Butterworth low-pass of this cut-off \
                     [default: none]",
                )),
        )
        .arg(
            Arg::new("filter-order")
                .long("filter-order")
                .value_name("N")
                .requires("filter")
                .value_parser(clap::value_parser!(u8).range(1..=10))
                .help("Order of the filter, there and back; OpenSim's is 3 [default: 2]"),
        )
        .next_help_heading("The figure")
        .args(body())
}

/// What pushes from outside.
fn forces() -> [Arg; 3] {
    [
        path("external").conflicts_with("external-loads").requires("plate").help(wrap(
            "Measured forces: .mot, .sto (forces, centre of pressure, free moment) or .csv (as `solaris walk` writes)",
        )),
        Arg::new("plate")
            .long("plate")
            .value_name("LINK=PREFIX")
            .action(ArgAction::Append)
            .requires("external")
            .conflicts_with("external-loads")
            .value_parser(ValueParser::new(parse_plate))
            .help(wrap(
                "Which link which columns push: PREFIX is what stands before ground_force_vx (may be empty) or before .fx; \
                 LINK may be two, HEEL+TOES: the second once the centre of pressure has passed the ball. Several are allowed",
            )),
        path("external-loads").value_name("FILE.xml").help("The same as OpenSim's ExternalLoads file"),
    ]
}

/// What the figure is under.
fn body() -> [Arg; 3] {
    [
        Arg::new("gravity")
            .long("gravity")
            .value_name("X,Y,Z")
            .allow_hyphen_values(true)
            .value_parser(ValueParser::new(parse_gravity))
            .help(wrap("Gravity in m/s² [default: the file's, or 9.80665 along the format's own down axis]")),
        Arg::new("base").long("base").value_name("KIND").value_parser(BASES.map(|(name, _)| name)).hide_possible_values(true).help(wrap(
            "Root of a figure that is fixed to the world: fixed; floating (root.tx ty tz rz ry rx); free (position and \
             quaternion) [default: as the file says]",
        )),
        Arg::new("passive").long("passive").value_name("ON|OFF").value_parser(["on", "off"]).hide_possible_values(true).help(wrap(
            "Whether armature, damping, springs and friction of the joints count [default: on]",
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

/// The links that a plate pushes, and what its columns begin with.
fn parse_plate(text: &str) -> Result<(Vec<String>, String), String> {
    let (links, prefix) = text
        .split_once('=')
        .ok_or("it must be LINK=PREFIX, such as calcn_r= or left_foot+left_toes=left_foot")?;
    let links: Vec<String> = links.split('+').map(|link| link.trim().to_owned()).collect();
    if links.iter().any(String::is_empty) || links.len() > 2 {
        return Err("before '=' stands one link, or two with '+' between them".to_owned());
    }
    Ok((links, prefix.to_owned()))
}
