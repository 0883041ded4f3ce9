//! The commands and their options.

use crate::error::{CliError, typed};
use clap::builder::ValueParser;
use clap::{Arg, ArgAction, ArgGroup, ArgMatches, Command};
use solaris::gait::{
    DEFAULT_STEP_FREQUENCY, PARAMETERS, SHORTEST_DISTANCE, STEP_FREQUENCY, STEPS, Unit, WALK_RATIO,
};

/// Height of the person when none is given (m).
pub(crate) const HEIGHT: f64 = 1.75;
/// Mass over the squared height when no mass is given (kg/m²).
pub(crate) const BODY_MASS_INDEX: f64 = 23.8;
/// Number of steps when neither steps nor a distance are given.
pub(crate) const DEFAULT_STEPS: i64 = 10;
/// Samples a second of the motion (1/s): default and range.
pub(crate) const RATE: (f64, f64, f64) = (120.0, 10.0, 1000.0);

const WALK_EXAMPLES: &str = "Examples:
  solaris walk -o walk.html
      a person of 1.75 m walks ten steps; open walk.html in a browser
  solaris walk --height 1.2 --mass 25 --step-frequency 100 --distance 5 -o child.html -o child.csv
      a child walks five metres, as a page and as a table
  solaris walk --speed 1.2 --arm-swing 5 -o stiff.bvh --report stiff.json
      motion capture for an animation tool, and the numbers of the walk as JSON";

pub(crate) fn command() -> Command {
    Command::new("solaris")
        .version(env!("CARGO_PKG_VERSION"))
        .about("Motion of articulated figures that obeys physics")
        .after_help(
            "Example:\n  solaris walk --height 1.75 --mass 73 --step-frequency 110 --steps 10 -o walk.html",
        )
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(walk())
}

/// Columns of a help text; with the widest option before it a line has 110.
const HELP_WIDTH: usize = 72;

fn walk() -> Command {
    let number = |name: &'static str, value: &'static str, help: &str| {
        let parser = ValueParser::new(parse_number);
        // A value may begin with a hyphen: -1 and -inf are numbers, and out of range.
        Arg::new(name)
            .long(name)
            .value_name(value)
            .allow_hyphen_values(true)
            .value_parser(parser)
            .help(wrap(help))
    };
    let (slowest, fastest) = STEP_FREQUENCY;
    let speed = |frequency: f64| WALK_RATIO * HEIGHT * frequency * frequency / 60.0;
    let command = Command::new("walk")
        .about("A person walks: from standing, some steps, to standing")
        .after_help(WALK_EXAMPLES)
        .args(files())
        .next_help_heading("The person")
        .arg(number("height", "M", &format!("Standing height, 0.8 to 2.3 m [default: {HEIGHT}]")))
        .arg(number(
            "mass",
            "KG",
            &format!(
                "Body mass in kg, 8 to 80 times the squared height [default: {BODY_MASS_INDEX}·height²]"
            ),
        ))
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

/// Where to write what.
fn files() -> [Arg; 3] {
    let path =
        |name: &'static str| Arg::new(name).long(name).value_parser(clap::value_parser!(std::path::PathBuf));
    [
        path("output").short('o').value_name("FILE").action(ArgAction::Append).help(wrap(
            "Write the motion: .html page, .csv table, .bvh motion capture; several -o are allowed [default: none]",
        )),
        path("report").value_name("FILE.json").help("Write the numbers of the walk as JSON [default: none]"),
        Arg::new("json")
            .long("json")
            .action(ArgAction::SetTrue)
            .help("Print the numbers of the walk as JSON instead of a table"),
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

/// Breaks a help text into lines; the default in brackets at its end stays in one piece.
fn wrap(text: &str) -> String {
    let (words, default) = text.split_once(" [").unwrap_or((text, ""));
    let default = if default.is_empty() { String::new() } else { format!("[{default}") };
    let (mut lines, mut width) = (String::new(), 0);
    for piece in words.split(' ').chain([default.as_str()]).filter(|piece| !piece.is_empty()) {
        let length = piece.chars().count();
        if width > 0 && width + 1 + length > HELP_WIDTH {
            lines.push('\n');
            width = 0;
        } else if width > 0 {
            lines.push(' ');
            width += 1;
        }
        lines.push_str(piece);
        width += length;
    }
    lines
}

/// A number; NaN is none.
fn parse_number(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if !number.is_nan() => Ok(number),
        _ => Err("it must be a number".to_owned()),
    }
}

/// A whole number; one too large for any walk is kept as the largest, so that it is out of range and not unreadable.
fn parse_count(text: &str) -> Result<i64, String> {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err("it must be a whole number".to_owned());
    }
    let largest = if text.starts_with('-') { i64::MIN } else { i64::MAX };
    Ok(text.parse().unwrap_or(largest))
}
