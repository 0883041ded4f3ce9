//! The options of `solaris walk`.

use super::{BODY_MASS_INDEX, DEFAULT_STEPS, HEIGHT, RATE, json, number, parse_count, path, wrap};
use crate::error::{CliError, typed};
use clap::builder::{PossibleValuesParser, ValueParser};
use clap::{Arg, ArgAction, ArgGroup, ArgMatches, Command};
use solaris::gait::determinants::{KeyParameter, THESIS_WALK_RATIO, five, three};
use solaris::gait::{
    DEFAULT_STEP_FREQUENCY, PARAMETERS, Parameter, SHORTEST_DISTANCE, STEP_FREQUENCY, STEPS,
    THESIS_STEP_FREQUENCY, Unit, WALK_RATIO,
};

const WALK_EXAMPLES: &str = "Examples:
  solaris walk -o walk.html
      a person of 1.75 m walks ten steps; open walk.html in a browser
  solaris walk --height 1.2 --mass 25 --step-frequency 100 --distance 5 -o child.html -o child.csv
      a child walks five metres, as a page and as a table
  solaris walk --speed 1.2 --arm-swing 5 -o stiff.bvh --report stiff.json
      motion capture for an animation tool, and the numbers of the walk as JSON
  solaris walk --style thesis --determinants 3 --step-frequency 95 -o thesis.html
      through the key postures of three determinants, from rest to rest
  solaris walk --loop in-place -o loop.bvh
      one stride that repeats, for a game";

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
        .args(manner());
    with_parameters(command)
}

/// The parameters of the styles, those of the default one first.
fn with_parameters(command: Command) -> Command {
    let command =
        command.next_help_heading("Its style (people's: what people do at this frequency and step length)");
    let command = PARAMETERS.iter().fold(command, |command, parameter| {
        let (unit, value) = match parameter.unit {
            Unit::Degrees => ("°", "DEGREES"),
            Unit::Metres => (" m", "M"),
        };
        let symbol =
            if parameter.symbol.is_empty() { String::new() } else { format!("{}: ", parameter.symbol) };
        let (lower, upper) = parameter.range;
        let thesis = key_parameters().find(|key| key.name == parameter.name);
        let thesis = thesis.map_or_else(String::new, |key| {
            let (lower, upper) = key.range;
            format!("; style thesis: {}, {lower} to {upper}{}", key.help, key.unit)
        });
        let help = format!(
            "{symbol}{}, {lower} to {upper}{unit}{thesis} [default: {}]",
            parameter.help,
            if thesis.is_empty() { "people's" } else { "people's, or chosen" }
        );
        command.arg(number(parameter.name, value, &help))
    });
    let of_thesis = |command: Command, parameters: &'static [KeyParameter]| {
        let own = |parameter: &&KeyParameter| {
            parameter.name != "step-length" && Parameter::named(parameter.name).is_none()
        };
        parameters.iter().filter(own).fold(command, |command, parameter| {
            let value = if parameter.unit == "°" { "DEGREES" } else { "M" };
            let (lower, upper) = parameter.range;
            let (symbol, unit) = (parameter.symbol, parameter.unit);
            let help = format!(
                "{symbol}: {}, {lower} to {upper}{unit} [default: chosen inside its bounds]",
                parameter.help
            );
            command.arg(number(parameter.name, value, &help))
        })
    };
    let command = command.next_help_heading("Key postures of five determinants (--style thesis)");
    let command = of_thesis(command, five::PARAMETERS);
    let command =
        command.next_help_heading("Key postures of three determinants (--style thesis --determinants 3)");
    of_thesis(command, three::PARAMETERS)
}

/// All parameters of key postures, those of five determinants first.
fn key_parameters() -> impl Iterator<Item = &'static KeyParameter> {
    five::PARAMETERS.iter().chain(three::PARAMETERS)
}

/// The names of the options that are parameters of key postures.
pub(crate) fn key_options() -> Vec<&'static str> {
    let mut names: Vec<&str> = key_parameters().map(|parameter| parameter.name).collect();
    names.sort_unstable();
    names.dedup();
    names
}

/// In which manner it walks.
fn manner() -> [Arg; 7] {
    let choice = |name: &'static str, value: &'static str, of: &'static [&'static str]| {
        Arg::new(name)
            .long(name)
            .value_name(value)
            .value_parser(PossibleValuesParser::new(of))
            .hide_possible_values(true)
    };
    let (slowest, fastest) = THESIS_STEP_FREQUENCY;
    [
        choice("style", "STYLE", &["smooth", "thesis"]).help(wrap(&format!(
            "smooth: forces first, as people walk; thesis: through key postures, the body stopping at each, {slowest} to {fastest} \
             steps/min, {THESIS_WALK_RATIO}·height·frequency a step [default: smooth]"
        ))),
        choice("determinants", "N", &["3", "5"]).help(wrap(
            "5: pelvic rotation, pelvic tilt, flexion of the stance knee, the foot's plantar flexion, compass gait; 3: without \
             the first and the foot's [default: 5]",
        )),
        choice("first", "SIDE", &["left", "right"]).help("Which foot makes the first step [default: right]"),
        choice("loop", "HOW", &["in-place", "moving"]).help(wrap(
            "One stride that repeats instead of a walk: on the spot, or going on; the rate is fitted to it [default: a walk]",
        )).conflicts_with("extent"),
        choice("in-betweens", "HOW", &["rest", "linear"]).help(wrap(
            "Style thesis: from posture to posture by minimum jerk, at rest in each, or at an even pace [default: rest]",
        )),
        choice("double-support", "LAW", &["thesis", "measured", "travel"]).help(wrap(
            "Style thesis: how long both feet stand: the thesis's law, the measured one, or as long as the pelvis takes at an \
             even pace [default: thesis]",
        )),
        number("sway", "M", "Style thesis: amplitude of the pelvis' way to the sides, towards the foot that stands [default: 0]"),
    ]
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
