//! The options of `solaris gait`: tables, maps and postures of the thesis's models.

use super::{HEIGHT, json, number, path, wrap};
use clap::builder::{PossibleValuesParser, ValueParser};
use clap::{Arg, ArgAction, Command};
use solaris::gait::determinants::{KeyParameter, TABLES, five, three};

const EXAMPLES: &str = "Examples:
  solaris gait table 7.7
      a table of the thesis computed anew, with what is printed beside it
  solaris gait explain --determinants 5 --step-frequency 110 -o postures.svg
      the key postures as stick figures, and how much room each inequality leaves
  solaris gait map --x heel-strike-angle --y tilt --step-frequency 110 -o map.svg
      where postures exist, and which inequality forbids them elsewhere";

const TABLE_EXAMPLES: &str = "Examples:
  solaris gait table 7.8
      one table; without a number all of them
  solaris gait table 8.1 --format markdown
      for a document";

const MAP_EXAMPLES: &str = "Examples:
  solaris gait map --x heel-strike-angle --y thigh-swing --step-frequency 110 -o map.svg
      five determinants; what is not on an axis is chosen, or given as an option
  solaris gait map --determinants 3 --x flexion --y tilt --body fit --step-frequency 100 --x-span 1:50 -o map.html
      three determinants with the thesis's proportions, as a page";

const EXPLAIN_EXAMPLES: &str = "Examples:
  solaris gait explain --determinants 3 --step-frequency 100 -o postures.svg
      the postures with their angles
  solaris gait explain --heel-strike-angle 32
      what fails, and the nearest value of each parameter at which all would hold (it exits with 1)";

const PEOPLE_EXAMPLES: &str = "Examples:
  solaris gait people
      a person of 1.75 m
  solaris gait people --height 1.5 --determinants 3 --format csv
      a smaller one without pelvic rotation, for a spreadsheet";

pub(super) fn command() -> Command {
    let table = Command::new("table")
        .about("Tables 7.1 to 7.8 and 8.1 to 8.7 of the thesis, computed anew beside what is printed")
        .after_help(TABLE_EXAMPLES)
        .arg(
            Arg::new("number")
                .value_name("NUMBER")
                .value_parser(PossibleValuesParser::new(TABLES))
                .hide_possible_values(true)
                .help("7.1 to 7.8, 8.1 to 8.7 [default: all]"),
        )
        .arg(format_option());
    let map = Command::new("map")
        .about("Where postures exist, over two parameters, and which inequality forbids them elsewhere")
        .after_help(MAP_EXAMPLES)
        .arg(axis("x", "across"))
        .arg(axis("y", "up"))
        .arg(span("x"))
        .arg(span("y"))
        .arg(number(
            "places",
            "N",
            "Places a side at which is looked, 2 to 2000; boundaries are exact whatever it is [default: 160]",
        ))
        .arg(picture("map"))
        .arg(json("Print the places and the boundary as JSON"))
        .args(body())
        .args(parameters());
    let explain = Command::new("explain")
        .about("The key postures with their angles, and how much room each inequality leaves")
        .after_help(EXPLAIN_EXAMPLES)
        .arg(picture("postures"))
        .arg(json("Print parameters, angles and inequalities as JSON"))
        .args(body())
        .args(parameters());
    let people = Command::new("people")
        .about("Every fact that is known of people's walking, beside smooth walks at 80 to 130 steps/min")
        .after_help(PEOPLE_EXAMPLES)
        .arg(determinants())
        .args(super::walk::person())
        .arg(format_option());
    Command::new("gait")
        .about("The thesis's walking models: tables, feasible regions, postures; walks beside people")
        .after_help(EXAMPLES)
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommands([table, map, explain, people])
}

fn determinants() -> Arg {
    Arg::new("determinants")
        .long("determinants")
        .value_name("N")
        .value_parser(["3", "5"])
        .hide_possible_values(true)
        .help("Determinants of gait, 3 or 5 [default: 5]")
}

/// The files of a picture.
fn picture(what: &str) -> Arg {
    let help = format!("Write the {what}: .svg picture, .html page; several -o are allowed [default: none]");
    path("output").short('o').action(ArgAction::Append).help(help)
}

/// How a table is written.
fn format_option() -> Arg {
    Arg::new("format")
        .long("format")
        .value_name("FORMAT")
        .value_parser(PossibleValuesParser::new(["text", "csv", "markdown"]))
        .hide_possible_values(true)
        .help("text, csv or markdown [default: text]")
}

fn axis(name: &'static str, where_: &str) -> Arg {
    Arg::new(name)
        .long(name)
        .value_name("PARAMETER")
        .required(true)
        .value_parser(PossibleValuesParser::new(super::key_options()))
        .hide_possible_values(true)
        .help(format!("The parameter that goes {where_}, by the name of its option"))
}

fn span(axis: &'static str) -> Arg {
    let name = if axis == "x" { "x-span" } else { "y-span" };
    Arg::new(name)
        .long(name)
        .value_name("FROM:TO")
        .allow_hyphen_values(true)
        .value_parser(ValueParser::new(parse_span))
        .help(format!("What of the parameter of {axis} is shown, in its unit [default: its range]"))
}

/// From one number to another.
fn parse_span(text: &str) -> Result<(f64, f64), String> {
    let wrong = || format!("'{text}' is no span; write two numbers as 5:30");
    let (from, to) = text.split_once(':').ok_or_else(wrong)?;
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite()).ok_or_else(wrong);
    Ok((number(from)?, number(to)?))
}

/// Whose postures, and how fast.
fn body() -> [Arg; 6] {
    [
        determinants(),
        Arg::new("body")
            .long("body")
            .value_name("WHOSE")
            .value_parser(["human", "thesis", "fit"])
            .hide_possible_values(true)
            .help(wrap(
                "human: a person's own segments and feet; thesis: the ankle on the ground, lengths by Drillis and Contini; fit: the \
                 proportions that give back tables 7.7 and 7.8, in units of the leg, of which --step-length and --speed are then too \
                 [default: human]",
            )),
        number("height", "M", &format!("Standing height in m [default: {HEIGHT}]")),
        number("step-frequency", "STEPS/MIN", "Steps a minute [default: 110, or what speed and step length say]"),
        number("step-length", "M", "S: from heel print to heel print [default: 0.004·height·frequency]"),
        number("speed", "M/S", "Speed; two of speed, frequency and length decide the third"),
    ]
}

/// The parameters of both models.
fn parameters() -> Vec<Arg> {
    let mut args = Vec::new();
    for name in super::key_options().into_iter().filter(|name| *name != "step-length") {
        let of = |parameters: &'static [KeyParameter]| parameters.iter().find(|p| p.name == name);
        let (five, three) = (of(five::PARAMETERS), of(three::PARAMETERS));
        let Some(any) = five.or(three) else { continue };
        let about = |parameter: &KeyParameter| {
            let (lower, upper) = parameter.range;
            format!("{}, {lower} to {upper}{}", parameter.help, parameter.unit)
        };
        let text = match (five, three) {
            (Some(five), Some(three)) if five.help != three.help => {
                format!("{}; of three determinants: {}", about(five), about(three))
            }
            (Some(one), Some(_)) => about(one),
            (Some(one), None) => format!("{} (five determinants)", about(one)),
            (None, Some(one)) => format!("{} (three determinants)", about(one)),
            (None, None) => continue,
        };
        let value = if any.unit == "°" { "DEGREES" } else { "M" };
        args.push(number(
            name,
            value,
            &format!("{}: {text} [default: chosen inside its bounds]", any.symbol),
        ));
    }
    args.into_iter().map(|arg| arg.help_heading("Parameters of the postures")).collect()
}
