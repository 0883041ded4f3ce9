//! The commands and their options.

use clap::builder::ValueParser;
use clap::{Arg, ArgAction, ArgGroup, Command};
use solaris::gait::{PARAMETERS, STEP_FREQUENCY, STEPS, Unit};

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

fn walk() -> Command {
    let number = |name: &'static str, value: &'static str, help: String| {
        Arg::new(name).long(name).value_name(value).value_parser(ValueParser::new(parse_number)).help(help)
    };
    let command = Command::new("walk")
        .about("A person walks: from standing, some steps, to standing")
        .after_help(WALK_EXAMPLES)
        .allow_negative_numbers(true)
        .arg(
            Arg::new("output")
                .short('o')
                .long("output")
                .value_name("FILE")
                .action(ArgAction::Append)
                .value_parser(clap::value_parser!(std::path::PathBuf))
                .help("Write the motion: .html page, .csv table, .bvh motion capture; several are allowed"),
        )
        .arg(
            Arg::new("report")
                .long("report")
                .value_name("FILE.json")
                .value_parser(clap::value_parser!(std::path::PathBuf))
                .help("Write the numbers of the walk as JSON"),
        )
        .arg(
            Arg::new("json")
                .long("json")
                .action(ArgAction::SetTrue)
                .help("Print the numbers of the walk as JSON instead of a table"),
        )
        .next_help_heading("The person")
        .arg(number("height", "M", format!("Standing height, 0.8 to 2.3 m [default: {HEIGHT}]")))
        .arg(number("mass", "KG", format!("Body mass [default: {BODY_MASS_INDEX}·height²]")))
        .next_help_heading("The walk")
        .arg(number(
            "step-frequency",
            "STEPS/MIN",
            format!(
                "Steps a minute, {} to {} [default: {}, or what speed and step length say]",
                STEP_FREQUENCY.0,
                STEP_FREQUENCY.1,
                solaris::gait::DEFAULT_STEP_FREQUENCY
            ),
        ))
        .arg(number(
            "step-length",
            "M",
            "From one heel print to the other foot's next, within 12 % of people's [default: 0.0037·height·frequency]"
                .into(),
        ))
        .arg(number("speed", "M/S", "Speed of the steady part; two of speed, frequency and length decide the third".into()))
        .arg(
            Arg::new("steps")
                .long("steps")
                .value_name("N")
                .value_parser(ValueParser::new(parse_count))
                .help(format!("Number of steps, {} to {} [default: {DEFAULT_STEPS}]", STEPS.0, STEPS.1)),
        )
        .arg(number("distance", "M", "Walk so far instead, met exactly".into()))
        .group(ArgGroup::new("extent").args(["steps", "distance"]))
        .arg(number(
            "rate",
            "FRAMES/S",
            format!("Samples a second of the motion, {} to {} [default: {}]", RATE.1, RATE.2, RATE.0),
        ))
        .next_help_heading("Its style (what is left out is people's at this frequency and length)");
    PARAMETERS.iter().fold(command, |command, parameter| {
        let (unit, value) = match parameter.unit {
            Unit::Degrees => ("°", "DEGREES"),
            Unit::Metres => (" m", "M"),
        };
        let symbol =
            if parameter.symbol.is_empty() { String::new() } else { format!("{}: ", parameter.symbol) };
        let (lower, upper) = parameter.range;
        command.arg(number(
            parameter.name,
            value,
            format!("{symbol}{}, {lower} to {upper}{unit} [default: people's]", parameter.help),
        ))
    })
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
