//! The options of `solaris ground`, and those of the ground that `solaris inverse` shares with it.

use super::{given, input, json, path, wrap};
use clap::builder::ValueParser;
use clap::{Arg, ArgAction, Command};
use solaris::analysis::ground::{ConsistencyOptions, Split, StanceOptions};

const EXAMPLES: &str = "Examples:
  solaris ground walk.mot subject.osim --soles soles.ron --filter 6Hz -o grf.mot
      forces under both feet of a measured walk, without force plates; OpenSim reads them
  solaris ground walk.mot subject.osim --soles soles.ron --filter 6Hz --split transition --json
      another assumption of how two feet share what both bear; numbers for a program
  solaris ground walk.mot subject.osim --soles soles.ron --filter 6Hz \
      --against plates.mot --plate right= --plate left=1_ -o forces.svg
      how far they are from what plates measured, and a picture of both
  solaris ground walk.csv human.ron -o grf.csv
      a walk of `solaris walk`; the figure has soles of its own
  solaris ground clip.csv human.ron --consistent --motion-out moved.csv
      an animation that floats or leans too far: its root moved by the least after which the ground can bear it
  solaris inverse subject.osim walk.mot --ground --soles soles.ron --filter 6Hz -o moments.sto
      joint moments with these forces, in one command";

pub(super) fn command() -> Command {
    Command::new("ground")
        .about("What the ground does to the feet in a given motion, without force plates")
        .after_help(EXAMPLES)
        .arg(input("motion", "MOTION", given::MOTION))
        .arg(input("figure", "FIGURE", given::FIGURE))
        .arg(path("output").short('o').action(ArgAction::Append).help(wrap(
            "Write force, moment and centre of pressure of each foot: .mot or .sto with OpenSim's names (NAME_ground_force_vx), \
             .csv with NAME.fx; or draw the forces: .svg [default: none]",
        )))
        .arg(path("against").requires("plate").help(wrap(
            "Measured forces to hold the found ones against, in the summary and the picture: .mot, .sto or .csv, as \
             --external of `solaris inverse`",
        )))
        .arg(
            Arg::new("plate")
                .long("plate")
                .value_name("FOOT=PREFIX")
                .action(ArgAction::Append)
                .requires("against")
                .value_parser(ValueParser::new(parse_plate))
                .help(wrap(
                    "Which columns of that file were measured under which sole, by its name: PREFIX is what stands before \
                     ground_force_vx (may be empty) or before .fx. Several are allowed",
                )),
        )
        .arg(json("Print the summary as JSON instead of a table"))
        .next_help_heading("The ground")
        .args(options())
        .next_help_heading("A motion that the ground can bear")
        .args(consistent())
        .next_help_heading("The motion")
        .args(given::motion())
        .next_help_heading("The figure")
        .args(given::figure())
}

/// What was measured under a sole.
#[derive(Clone, Debug)]
pub(crate) struct AskedPlate {
    /// The name of the sole.
    pub(crate) foot: String,
    /// What its columns begin with.
    pub(crate) prefix: String,
}

fn parse_plate(text: &str) -> Result<AskedPlate, String> {
    let (foot, prefix) = text.split_once('=').ok_or("it must be FOOT=PREFIX, such as right= or left=1_")?;
    Ok(AskedPlate { foot: foot.trim().to_owned(), prefix: prefix.to_owned() })
}

/// How the ground treadmills.
#[derive(Clone, Copy, Debug)]
pub(crate) enum AskedBelt {
    Auto,
    Still,
    /// Its speed (m/s).
    Speed(f64),
}

/// How the ground's forces are found.
pub(super) fn options() -> [Arg; 6] {
    let standing = StanceOptions::default();
    [
        Arg::new("split")
            .long("split")
            .value_name("NAME")
            .value_parser(Split::ALL.map(Split::name))
            .hide_possible_values(true)
            .help(wrap(&format!(
                "How two feet share what both bear, an assumption: transition (the smooth curves of people who walk), pivot \
                 (forces that point at one point above the centre of mass), effort (least joint moments) [default: {}]",
                Split::default().name()
            ))),
        path("soles").help(wrap(
            "Where the feet meet the ground: heel, ball and tip of each sole, as text (docs/ground.md has one) \
             [default: the figure's own, or a guess by the bodies calcn and toes]",
        )),
        Arg::new("belt")
            .long("belt")
            .value_name("SPEED|auto|still")
            .allow_hyphen_values(true)
            .value_parser(ValueParser::new(parse_belt))
            .help(wrap(
                "How the ground itself moves, on a treadmill: its speed in m/s, along the feet on it; still; or as the feet on \
                 it tell [default: auto]",
            )),
        length("stance-height", "M").help(wrap(&format!(
            "How far above its lowest place a point of the sole may be and still stand, in m [default: {}]",
            standing.height
        ))),
        length("stance-speed", "M/S").help(wrap(&format!(
            "How fast it may be against the ground and still stand, in m/s [default: {}]",
            standing.speed
        ))),
        length("stance-shortest", "S").help(wrap(&format!(
            "Stances and gaps between them that are shorter than this are none, in s [default: {}]",
            standing.shortest
        ))),
    ]
}

/// How the motion is changed before forces are found.
pub(super) fn consistent() -> [Arg; 3] {
    let default = ConsistencyOptions::default();
    [
        Arg::new("consistent").long("consistent").action(ArgAction::SetTrue).help(wrap(&format!(
            "First move the root by the least that keeps the ground from pulling and the centre of pressure {} mm inside of the \
             soles that stand; all else stays, so the feet go with it",
            default.margin * 1e3
        ))),
        super::number("consistent-limit", "M", &format!(
            "How far it may be moved, in m, or inf; where that does not suffice it goes beyond, and the summary says so \
             [default: {}]",
            default.limit
        ))
        .requires("consistent"),
        path("motion-out").requires("consistent").action(ArgAction::Append).help(wrap(
            "Write the motion that was moved: .csv with DOF.q, .v and .a; .mot, .sto (positions); .bvh [default: none]",
        )),
    ]
}

/// A number that is not below zero; what it may be is said where it is used.
fn length(name: &'static str, unit: &'static str) -> Arg {
    super::number(name, unit, "")
}

fn parse_belt(text: &str) -> Result<AskedBelt, String> {
    match text {
        "auto" => Ok(AskedBelt::Auto),
        "still" => Ok(AskedBelt::Still),
        _ => match text.parse::<f64>() {
            Ok(speed) if speed > 0.0 && speed.is_finite() => Ok(AskedBelt::Speed(speed)),
            _ => Err("it must be a speed above zero in m/s, such as 1.2, or auto, or still".to_owned()),
        },
    }
}
