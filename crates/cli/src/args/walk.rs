//! The options of `solaris walk`.

use super::{BODY_MASS_INDEX, DEFAULT_STEPS, HEIGHT, RATE, json, number, parse_count, path, wrap};
use crate::error::{CliError, typed};
use clap::builder::ValueParser;
use clap::{Arg, ArgAction, ArgGroup, ArgMatches, Command};
use solaris::gait::{
    DEFAULT_STEP_FREQUENCY, PARAMETERS, SHORTEST_DISTANCE, STEP_FREQUENCY, STEPS, Unit, WALK_RATIO,
};

const WALK_EXAMPLES: &str = "Examples:
  solaris walk -o walk.html
      a person of 1.75 m walks ten steps; open walk.html in a browser
  solaris walk --height 1.2 --mass 25 --step-frequency 100 --distance 5 -o child.html -o child.csv
      a child walks five metres, as a page and as a table
  solaris walk --speed 1.2 --arm-swing 5 -o stiff.bvh --report stiff.json
      motion capture for an animation tool, and the numbers of the walk as JSON";

pub(super) fn command() -> Command {
    let (slowest, fastest) = STEP_FREQUENCY;
    let speed = |frequency: f64| WALK_RATIO * HEIGHT * frequency * frequency / 60.0;
    let command = Command::new("walk")
        .about("A person walks: from standing, some steps, to standing")
        .after_help(WALK_EXAMPLES)
        .args(files())
        .next_help_heading("The person")
        .arg(path("figure").help(wrap(
            "Who walks: a figure's text (.ron) with the segments of a human [default: a human of this height and mass]",
        )).conflicts_with_all(["height", "mass"]))
        .args(person())
        .next_help_heading("The walk")
        .arg(number(
            "step-frequency",
            "STEPS/MIN",
            &format!(
                "Steps a minute, {slowest} to {fastest} [default: {DEFAULT_STEP_FREQUENCY}, or what speed and step \
                 length say]"
            ),
        ))
        .arg(number(
            "step-length",
            "M",
            &format!(
                "From one heel print to the other foot's next in m, 12 % shorter to 12 % longer than people's (6 % \
                 at {fastest} steps/min) [default: people's, {WALK_RATIO}·height·frequency]"
            ),
        ))
        .arg(number(
            "speed",
            "M/S",
            &format!(
                "Speed of the steady part, {:.2} to {:.2} m/s at a height of {HEIGHT} m; two of speed, frequency and \
                 length decide the third [default: frequency·length]",
                speed(slowest),
                speed(fastest)
            ),
        ))
        .arg(
            Arg::new("steps")
                .long("steps")
                .value_name("N")
                .allow_hyphen_values(true)
                .value_parser(ValueParser::new(parse_count))
                .help(format!("Number of steps, {} to {} [default: {DEFAULT_STEPS}]", STEPS.0, STEPS.1)),
        )
        .arg(number(
            "distance",
            "M",
            &format!(
                "How far to walk, met exactly, instead of a number of steps: {SHORTEST_DISTANCE} m to {} steps \
                 [default: as far as the steps go]",
                STEPS.1
            ),
        ))
        .group(ArgGroup::new("extent").args(["steps", "distance"]))
        .arg(number(
            "rate",
            "FRAMES/S",
            &format!("Samples a second of the motion, {} to {} [default: {}]", RATE.1, RATE.2, RATE.0),
        ))
        .arg(Arg::new("root").long("root").value_name("LINK").value_parser(["pelvis", "foot"]).hide_possible_values(true).help(
            wrap(
                "What the forces are computed from: the pelvis outwards, or the foot that stands, as the thesis does; no force \
                 depends on it [default: pelvis]",
            ),
        ))
        .next_help_heading("Its style (people's: what people do at this frequency and step length)");
    PARAMETERS.iter().fold(command, |command, parameter| {
        let (unit, value) = match parameter.unit {
            Unit::Degrees => ("°", "DEGREES"),
            Unit::Metres => (" m", "M"),
        };
        let symbol =
            if parameter.symbol.is_empty() { String::new() } else { format!("{}: ", parameter.symbol) };
        let (lower, upper) = parameter.range;
        let help = format!("{symbol}{}, {lower} to {upper}{unit} [default: people's]", parameter.help);
        command.arg(number(parameter.name, value, &help))
    })
}

/// The options of a person's size.
pub(super) fn person() -> [Arg; 2] {
    [
        number("height", "M", &format!("Standing height, 0.8 to 2.3 m [default: {HEIGHT}]")),
        number(
            "mass",
            "KG",
            &format!(
                "Body mass in kg, 8 to 80 times the squared height [default: {BODY_MASS_INDEX}·height²]"
            ),
        ),
    ]
}

/// Where to write what.
fn files() -> [Arg; 3] {
    [
        path("output").short('o').action(ArgAction::Append).help(wrap(
            "Write the motion: .html page, .csv table, .bvh motion capture; several -o are allowed [default: none]",
        )),
        path("report").value_name("FILE.json").help("Write the numbers of the walk as JSON [default: none]"),
        json("Print the numbers of the walk as JSON instead of a table"),
    ]
}

/// Refuses three options of which two decide the third.
pub(crate) fn check(matches: &ArgMatches) -> Result<(), CliError> {
    let value = |option| typed(matches, option);
    match (value("step-frequency"), value("step-length"), value("speed")) {
        (Some(frequency), Some(length), Some(speed)) => Err(CliError::Usage(format!(
            "--step-frequency {frequency}, --step-length {length} and --speed {speed}: any two decide the third; drop one"
        ))),
        _ => Ok(()),
    }
}
