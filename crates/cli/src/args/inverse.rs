//! The options of `solaris inverse`.

use super::{given, ground, input, json, path, wrap};
use clap::builder::ValueParser;
use clap::{Arg, ArgAction, Command};

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
      a walk of `solaris walk`: the toes carry the force once the centre of pressure has passed the ball
  solaris inverse subject.osim walk.mot --ground --soles soles.ron --filter 6Hz -o moments.sto
      joint moments without force plates: the ground's forces are found from the motion (solaris ground)
  solaris inverse human.ron clip.csv --ground --consistent --motion-out moved.csv -o tau.csv
      joint torques of an animation whose root is moved before, by the least after which the ground can bear it";

pub(super) fn command() -> Command {
    Command::new("inverse")
        .about("Joint torques of a given motion")
        .after_help(EXAMPLES)
        .arg(input("figure", "FIGURE", given::FIGURE))
        .arg(input("motion", "MOTION", given::MOTION))
        .arg(path("output").short('o').action(ArgAction::Append).help(wrap(
            "Write the torques: .csv with columns DOF.tau, or .sto with OpenSim's names [default: none]",
        )))
        .arg(json("Print the summary as JSON instead of a table"))
        .next_help_heading("Forces from outside")
        .args(forces())
        .next_help_heading("Forces found from the motion")
        .arg(predicted())
        .args(ground::options().map(|option| option.requires("ground")))
        .args(ground::consistent().map(|option| option.requires("ground")))
        .next_help_heading("The motion")
        .args(given::motion())
        .next_help_heading("The figure")
        .args(given::figure())
        .arg(passive())
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

/// Whether the ground's forces are found from the motion.
fn predicted() -> Arg {
    Arg::new("ground")
        .long("ground")
        .action(ArgAction::SetTrue)
        .conflicts_with_all(["external", "external-loads", "plate"])
        .help(wrap("Find the ground's forces on the feet from the motion itself, as `solaris ground` does"))
}

/// What acts in the joints by itself.
fn passive() -> Arg {
    Arg::new("passive")
        .long("passive")
        .value_name("ON|OFF")
        .value_parser(["on", "off"])
        .hide_possible_values(true)
        .help(wrap("Whether armature, damping, springs and friction of the joints count [default: on]"))
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
