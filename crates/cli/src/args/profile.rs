//! The options of `solaris profile`: a command for each kind of curve, made from the table of kinds.

use super::{RATE, json, number, parse_number, path, wrap};
use clap::builder::ValueParser;
use clap::{Arg, ArgAction, Command};
use solaris::profiles::blend::{FadeKind, Leaving};
use solaris::profiles::{Family, Kind, Measure, Parameter, Profile};
use std::path::PathBuf;

/// A fade with this stiffness, where it has one.
type MakeFade = fn(f64) -> FadeKind;

/// How one motion may fade into another.
pub(crate) const FADES: [(&str, MakeFade); 5] = [
    ("smooth", |_| FadeKind::Smooth),
    ("linear", |_| FadeKind::Linear),
    ("exponential", |stiffness| FadeKind::Exponential { stiffness }),
    ("sinh", |stiffness| FadeKind::Sinh { stiffness }),
    ("trigonometric", |stiffness| FadeKind::Trigonometric { stiffness }),
];

/// What to do with a fade that leaves 0 to 1.
pub(crate) const LEAVING: [(&str, Leaving); 3] =
    [("refuse", Leaving::Refuse), ("clamp", Leaving::Clamp), ("allow", Leaving::Allow)];

const EXAMPLES: &str = "Examples:
  solaris profile list
      all kinds of curves; `solaris profile tension --help` has the parameters of one
  solaris profile minimum-jerk --from 0 --to 1.2 --duration 2 --unit rad
      a table of position, velocity, acceleration and jerk, and what the whole curve answers
  solaris profile catmull-rom --keys '0:5, 1:7, 2:-9' -o curve.svg -o curve.html -o curve.csv
      a picture, a page with a crosshair, and a table for other programs
  solaris profile cubic --from 0 --to 5 --duration 2 --v1 5 --free v0
      with which start velocities the motion never turns round";

const READ_EXAMPLES: &str = "Examples:
  solaris profile minimum-jerk --from 0 --to 1.2 --duration 2 -o curve.ron
      writes a profile as text: MinimumJerk(from: 0.0, to: 1.2, duration: 2.0)
  solaris profile read curve.ron -o curve.svg
      draws the profile of a text; blends and weighted means too";

const BLEND_EXAMPLES: &str = "Examples:
  solaris profile blend --curve 'MinimumJerk(from: 0, to: 5, duration: 2)' \\
      --curve 'Power(from: 0, to: 5, duration: 2, exponent: 3)' --fade smooth --window 0.5:1.5 -o blend.svg
      the first motion fades into the second
  solaris profile blend --curve 'Line(from: 0, to: 1, duration: 1)' \\
      --curve '(profile: Line(from: 1, to: 0, duration: 1), start: 1.5)' --fade linear --window 1:1.5
      the second begins at 1.5 s; before and after its own span a motion rests at its ends";

pub(super) fn command() -> Command {
    let list = Command::new("list")
        .about("All kinds of curves, one a line")
        .arg(json("Print the kinds with their parameters, units and ranges as JSON"));
    let read = Command::new("read")
        .about("A curve from a text (.ron): any kind, blends and weighted means")
        .after_help(READ_EXAMPLES)
        .arg(super::input("file", "FILE", "A profile's text (.ron)"))
        .args(common());
    Command::new("profile")
        .about("Tabulates or draws one motion curve: position, velocity, acceleration, jerk")
        .after_help(EXAMPLES)
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(list)
        .subcommands(Profile::KINDS.iter().map(kind))
        .subcommands([blend(), read])
}

/// The command of one kind.
fn kind(kind: &'static Kind) -> Command {
    let amplitude = amplitude(kind);
    let mut usage = format!("solaris profile {}", kind.name);
    let mut args: Vec<Arg> = Vec::new();
    if kind.has_keys() {
        usage.push_str(" --keys <KEYS>");
        args.push(keys());
    }
    for parameter in kind.parameters() {
        let required = kind.required.contains(&parameter);
        let arg = self::parameter(kind, parameter, required);
        let value = arg.get_value_names().and_then(|names| names.first()).map_or("", |name| name.as_str());
        let text = format!("--{} <{value}>", option(parameter));
        let follows = amplitude == Some(parameter);
        match (required, follows) {
            (true, false) => usage.extend([" ", &text]),
            (true, true) => usage.extend([" <", &text, "|--to <X>>"]),
            _ => {}
        }
        // A free parameter needs no value; which one is free is not known here.
        args.push(match (required, follows) {
            (true, true) => arg.required_unless_present_any(["to", "free"]),
            (true, false) => arg.required_unless_present("free"),
            _ => arg,
        });
    }
    if let Some(amplitude) = amplitude {
        let help = format!("Position at the end (x), in place of the {}", amplitude.name);
        let to = number("to", "X", &help).visible_alias(Parameter::TO.symbol);
        args.push(to.conflicts_with(option(amplitude)).conflicts_with("free"));
    }
    Command::new(kind.name)
        .about(kind.summary)
        .override_usage(usage + " [OPTIONS]")
        .after_help(format!("Example:\n  solaris profile {}", example(kind)))
        .next_help_heading("Parameters (x: the unit of positions)")
        .args(args)
        .next_help_heading(None)
        .args(common())
}

/// The option of a parameter: its name with hyphens.
pub(crate) fn option(parameter: &Parameter) -> String {
    parameter.name.replace(' ', "-")
}

/// The parameter of a kind that may follow from where the motion ends.
pub(crate) fn amplitude(kind: &Kind) -> Option<&'static Parameter> {
    let measure = match kind.family {
        Family::Acceleration => Measure::Acceleration,
        Family::Velocity => Measure::Velocity,
        _ => return None,
    };
    let mut given =
        kind.parameters().filter(|p| p.measure == measure && p.symbol != Parameter::START_VELOCITY.symbol);
    // An arc of a circle has two: its third velocity and its end velocity.
    given.next().filter(|_| given.next().is_none())
}

fn parameter(kind: &Kind, parameter: &'static Parameter, required: bool) -> Arg {
    let value = match parameter.measure {
        Measure::Position => "X",
        Measure::Velocity => "X/S",
        Measure::Acceleration => "X/S²",
        Measure::Jerk => "X/S³",
        Measure::Time => "S",
        Measure::Number => "NUMBER",
    };
    let unit = parameter.measure.to_string();
    let unit = if unit.is_empty() { unit } else { format!(" in {unit}") };
    let range = parameter.range.to_string();
    let range = if range == "any number" { String::new() } else { format!(", {range}") };
    let default = if required { "" } else { " [default: 0]" };
    let arg = number(option(parameter), value, &format!("{}{unit}{range}{default}", parameter.summary));
    let taken = kind.parameters().any(|other| option(other) == parameter.symbol);
    if taken { arg } else { arg.visible_alias(parameter.symbol) }
}

/// Keys as they were given.
#[derive(Clone, Debug)]
pub(crate) enum Keys {
    /// Times and positions.
    Given(Vec<(f64, f64)>),
    /// A table that has them.
    File(PathBuf),
}

fn keys() -> Arg {
    Arg::new("keys")
        .long("keys")
        .value_name("KEYS")
        .required(true)
        .allow_hyphen_values(true)
        .value_parser(ValueParser::new(parse_keys))
        .help(wrap(
            "Times in s, rising, and positions, such as '0:5, 1:7, 2:-9'; or a table FILE.csv of two columns, whose first line names them",
        ))
}

fn parse_keys(text: &str) -> Result<Keys, String> {
    let path = PathBuf::from(text);
    if crate::input::extension(&path) == "csv" {
        return Ok(Keys::File(path));
    }
    let key = |text: &str| {
        let (time, position) = text.split_once(':')?;
        Some((parse_number(time.trim()).ok()?, parse_number(position.trim()).ok()?))
    };
    let pieces = text.split([',', ';']).map(str::trim).filter(|piece| !piece.is_empty());
    let keys = pieces
        .map(|piece| key(piece).ok_or_else(|| format!("'{piece}' is no TIME:POSITION, such as 0.5:-9")))
        .collect::<Result<Vec<_>, _>>()?;
    if keys.is_empty() { Err("it must be TIME:POSITION, …".to_owned()) } else { Ok(Keys::Given(keys)) }
}

fn blend() -> Command {
    let choice = |name: &'static str, values: Vec<&'static str>| {
        Arg::new(name).long(name).value_name("HOW").value_parser(values).hide_possible_values(true)
    };
    Command::new("blend")
        .about("One curve that fades into another")
        .after_help(BLEND_EXAMPLES)
        .override_usage("solaris profile blend --curve <RON> --curve <RON> --fade <HOW> --window <START:END> [OPTIONS]")
        .next_help_heading("The blend")
        .arg(Arg::new("curve").long("curve").value_name("RON").required(true).action(ArgAction::Append).help(wrap(
            "A profile's text, as `-o FILE.ron` writes it, or (profile: …, start: S, outside: Hold|Extrapolate|Repeat|\
             Mirror); twice: what fades out, what fades in",
        )))
        .arg(choice("fade", FADES.map(|(name, _)| name).to_vec()).required(true).help(wrap(
            "How: smooth (velocity and acceleration stay continuous), linear, exponential, sinh, trigonometric",
        )))
        .arg(number("stiffness", "NUMBER", "Stiffness of the last three, at least 0; above ln 2 (exponential) and π/2 (trigonometric) the share of the first leaves 0 to 1 [default: 1, exponential: ln 2]").visible_alias("k"))
        .arg(
            Arg::new("window")
                .long("window")
                .value_name("START:END")
                .required(true)
                .allow_hyphen_values(true)
                .value_parser(ValueParser::new(parse_window))
                .help("When, in s: 0.5:1.5"),
        )
        .arg(choice("leaving", LEAVING.map(|(name, _)| name).to_vec()).help(wrap(
            "Where the share of the first leaves 0 to 1 (trigonometric beyond π/2): refuse, clamp, allow [default: refuse]",
        )))
        .next_help_heading(None)
        .args(common())
}

/// A window of time.
fn parse_window(text: &str) -> Result<(f64, f64), String> {
    let (start, end) = text.split_once(':').ok_or("it must be START:END, such as 0.5:1.5")?;
    Ok((parse_number(start.trim())?, parse_number(end.trim())?))
}

/// What all curves can be asked.
fn common() -> [Arg; 8] {
    [
        path("output").short('o').action(ArgAction::Append).help(wrap(
            "Write the curve: .svg picture, .html page, .csv table, .ron text; several -o are allowed \
             [default: none, a table is printed]",
        )),
        Arg::new("json").long("json").action(ArgAction::SetTrue).help(wrap(
            "Print the table and the answers as JSON; null is a number that is not finite",
        )),
        Arg::new("samples")
            .long("samples")
            .value_name("N")
            .value_parser(clap::value_parser!(u32).range(2..=1_000_000))
            .help("Rows of the table, evenly in time [default: 11]"),
        number("rate", "ROWS/S", &format!("Rows a second of the table, in place of their number [default: {} for .csv]", RATE.0))
            .conflicts_with("samples"),
        Arg::new("unit").long("unit").value_name("UNIT").help("Unit of positions, only a label: rad, m [default: none]"),
        Arg::new("title").long("title").value_name("TEXT").help("Title of the picture [default: the kind's name]"),
        Arg::new("free").long("free").value_name("PARAMETER").action(ArgAction::Append).help(wrap(
            "Print with which values of this parameter (v0, v1, s, vm, T1) the motion neither turns round nor stands still \
             inside; of vm and T1: with which there is an arc. Its own value may be left out",
        )),
        Arg::new("monotone").long("monotone").action(ArgAction::SetTrue).help("Exit with 1 if the motion turns round"),
    ]
}

/// A command line that works, without its first two words.
pub(crate) fn example(kind: &Kind) -> String {
    let mut words = kind.name.to_owned();
    if kind.has_keys() {
        words.push_str(" --keys '0:5, 1:7, 2:-9'");
    }
    for parameter in kind.required {
        let value = match parameter.symbol {
            "x0" => "0",
            "x1" => "1.2",
            "T" => "2",
            "s" | "T1" => "0.5",
            "T2" => "1.5",
            "vmax" => "1",
            "vm" => "0.6",
            "jmax" => "20",
            "amax" => "4",
            _ => "3",
        };
        words.extend([" --", &option(parameter), " ", value]);
    }
    for parameter in kind.optional.iter().filter(|parameter| parameter.symbol == "v1") {
        words.extend([" --", &option(parameter), " 0.5"]);
    }
    words
}
