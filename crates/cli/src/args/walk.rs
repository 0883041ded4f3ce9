//! The options of `solaris walk`.

use super::{BODY_MASS_INDEX, DEFAULT_STEPS, HEIGHT, RATE, json, number, parse_count, path, wrap};
use crate::error::{CliError, typed};
use clap::builder::{PossibleValuesParser, ValueParser};
use clap::{Arg, ArgAction, ArgGroup, ArgMatches, Command};
use solaris::gait::determinants::{KeyParameter, THESIS_WALK_RATIO, five, three};
use solaris::gait::{
    DEFAULT_STEP_FREQUENCY, PARAMETERS, Parameter, SHORTEST_DISTANCE, STEP_FREQUENCY, STEPS,
    THESIS_STEP_FREQUENCY, TURN, TURN_IN_ALL, Unit, WALK_RATIO, WalkPart,
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
  solaris walk --steps 4 --then steps=3,turn=20 --then stand=1 --then steps=3,step-frequency=90 -o corner.html
      round a corner to the left, a stop, and on more slowly
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
                "From one heel print to the other foot's next in m, 12 % shorter to 12 % longer than people's (2 % \
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
        .args(manner())
        .next_help_heading("Changes on the way (style smooth)")
        .args(changes())
        .next_help_heading("Its style (people's: what people do at this frequency and step length)");
    let command = command.args(PARAMETERS.iter().map(of_style));
    let command = command.next_help_heading("Key postures of five determinants (--style thesis)");
    let command = command.args(of_postures(five::PARAMETERS));
    let command =
        command.next_help_heading("Key postures of three determinants (--style thesis --determinants 3)");
    command.args(of_postures(three::PARAMETERS))
}

/// A parameter of the smooth style; of the thesis's too, where that has one of the same name.
fn of_style(parameter: &Parameter) -> Arg {
    let (unit, value) = match parameter.unit {
        Unit::Degrees => ("°", "DEGREES"),
        Unit::Metres => (" m", "M"),
    };
    let symbol = if parameter.symbol.is_empty() { String::new() } else { format!("{}: ", parameter.symbol) };
    let (lower, upper) = parameter.range;
    let thesis = key_parameters().find(|key| key.name == parameter.name);
    let thesis = thesis.map_or_else(String::new, |key| {
        let (lower, upper) = key.range;
        format!("; style thesis: {}, {lower} to {upper}{}", key.help, key.unit)
    });
    let default = if thesis.is_empty() { "people's" } else { "people's, or chosen" };
    let help = format!("{symbol}{}, {lower} to {upper}{unit}{thesis} [default: {default}]", parameter.help);
    number(parameter.name, value, &help)
}

/// Parameters of key postures that no other option has.
fn of_postures(parameters: &'static [KeyParameter]) -> impl Iterator<Item = Arg> {
    let own = |parameter: &&KeyParameter| {
        parameter.name != "step-length" && Parameter::named(parameter.name).is_none()
    };
    parameters.iter().filter(own).map(|parameter| {
        let value = if parameter.unit == "°" { "DEGREES" } else { "M" };
        let (lower, upper) = parameter.range;
        let (symbol, unit, what) = (parameter.symbol, parameter.unit, parameter.help);
        let help = format!("{symbol}: {what}, {lower} to {upper}{unit} [default: chosen inside its bounds]");
        number(parameter.name, value, &help)
    })
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
        )).conflicts_with_all(["extent", "turn", "then"]),
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

/// What changes on the way.
fn changes() -> [Arg; 2] {
    let (turn, in_all) = (TURN.to_degrees().round(), TURN_IN_ALL.to_degrees().round());
    [
        number(
            "turn",
            "DEGREES",
            &format!(
                "By how much each step turns to the left, -{turn} to {turn}°, {in_all}° in all [default: 0]"
            ),
        ),
        Arg::new("then")
            .long("then")
            .value_name("WHAT")
            .action(ArgAction::Append)
            .value_parser(ValueParser::new(parse_then))
            .help(wrap(
                "What comes next; several are allowed. steps=4,step-frequency=95,step-length=0.6,speed=1,turn=15: steps of another \
                 pace or direction (with neither frequency, length nor speed the pace stays; else what is left out is people's); a short \
                 step-length is a half step. stand=2: stop and \
                 stand for 2 s; what follows starts anew, and may be distance=3 instead of steps [default: nothing]",
            )),
    ]
}

/// What comes next in a walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Then {
    /// Stop, and stand so long (s).
    Stand(f64),
    /// Some steps.
    Steps(WalkPart),
    /// As many steps as reach so far (m), from standing.
    Distance(f64, WalkPart),
}

/// `stand=2`, or `steps=4,step-frequency=95,turn=15`.
fn parse_then(text: &str) -> Result<Then, String> {
    const KEYS: [&str; 7] = ["steps", "distance", "stand", "step-frequency", "step-length", "speed", "turn"];
    let mut values = [None; KEYS.len()];
    for item in text.split([',', ' ']).filter(|item| !item.is_empty()) {
        let example = "such as steps=4,step-frequency=95 or stand=2";
        let (key, value) = item.split_once('=').ok_or(format!("'{item}' must be KEY=NUMBER, {example}"))?;
        let index = KEYS.iter().position(|known| *known == key);
        let index = index.ok_or(format!("there is no '{key}'; there are {}", KEYS.join(", ")))?;
        let value: f64 = value.parse().map_err(|_| format!("{key} '{value}': it must be a number"))?;
        if values[index].replace(value).is_some() {
            return Err(format!("{key} is given twice"));
        }
    }
    let [steps, distance, stand, step_frequency, step_length, speed, turn] = values;
    if let Some(stand) = stand {
        let alone = values.iter().flatten().count() == 1;
        return if alone { Ok(Then::Stand(stand)) } else { Err("stand goes alone".to_owned()) };
    }
    let turn = turn.unwrap_or_default().to_radians();
    let part = WalkPart { steps: 0, step_frequency, step_length, speed, turn };
    match (steps, distance) {
        (Some(steps), None) if steps.fract() == 0.0 && steps >= 0.0 && steps <= STEPS.1 as f64 => {
            Ok(Then::Steps(WalkPart { steps: steps as usize, ..part }))
        }
        (Some(steps), None) => {
            Err(format!("steps {steps}: it must be a whole number, {} to {}", STEPS.0, STEPS.1))
        }
        (None, Some(distance)) => Ok(Then::Distance(distance, part)),
        (None, None) => Err("it needs steps, a distance or stand".to_owned()),
        (Some(_), Some(_)) => Err("steps and distance: any one of them; drop the other".to_owned()),
    }
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
