//! A command for each kind of curve, made from the table of kinds.

use super::CurveArgs;
use crate::args::value::number;
use crate::args::{Number, wrap};
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches, Subcommand};
use solaris::profiles::{Family, Kind, Measure, Parameter, Profile};
use std::path::PathBuf;

/// A kind of curve, and the values of its parameters.
#[derive(Debug)]
pub(crate) struct KindArgs {
    pub(crate) kind: &'static Kind,
    /// By the parameters' names.
    values: Vec<(&'static str, Number)>,
    /// Where the motion ends, in place of the parameter that follows from it.
    pub(crate) to: Option<Number>,
    pub(crate) keys: Option<Keys>,
    pub(crate) curve: CurveArgs,
}

impl KindArgs {
    /// The value that was given to a parameter of this name.
    pub(crate) fn value(&self, name: &str) -> Option<&Number> {
        self.values.iter().find(|(known, _)| *known == name).map(|(_, value)| value)
    }
}

/// Keys as they were given.
#[derive(Clone, Debug)]
pub(crate) struct Keys {
    pub(crate) source: KeySource,
    pub(crate) typed: String,
}

#[derive(Clone, Debug)]
pub(crate) enum KeySource {
    /// Times and positions.
    Given(Vec<(f64, f64)>),
    /// A table that has them.
    File(PathBuf),
}

/// The kinds as commands.
#[derive(Debug)]
pub(crate) struct KindCommand(pub(crate) Box<KindArgs>);

impl Subcommand for KindCommand {
    fn augment_subcommands(command: Command) -> Command {
        command.subcommands(Profile::KINDS.iter().map(self::command))
    }

    fn augment_subcommands_for_update(command: Command) -> Command {
        Self::augment_subcommands(command)
    }

    fn has_subcommand(name: &str) -> bool {
        Kind::named(name).is_some()
    }
}

impl FromArgMatches for KindCommand {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let missing = || clap::Error::new(clap::error::ErrorKind::MissingSubcommand);
        let (name, matches) = matches.subcommand().ok_or_else(missing)?;
        let kind = Kind::named(name).ok_or_else(missing)?;
        let read = |option: &str| matches.get_one::<Number>(option).cloned();
        let values = kind.parameters().filter_map(|p| Some((p.name, read(&option(p))?))).collect();
        Ok(Self(Box::new(KindArgs {
            kind,
            values,
            to: amplitude(kind).and_then(|_| read("to")),
            keys: if kind.has_keys() { matches.get_one::<Keys>("keys").cloned() } else { None },
            curve: CurveArgs::from_arg_matches(matches)?,
        })))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The command of one kind.
fn command(kind: &'static Kind) -> Command {
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
        let text = format!("--{} <{}>", option(parameter), value_name(parameter));
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
        let to = number_option("to".to_owned(), "X", &help).visible_alias(Parameter::TO.symbol);
        args.push(to.conflicts_with(option(amplitude)).conflicts_with("free"));
    }
    let command = Command::new(kind.name)
        .override_usage(usage + " [OPTIONS]")
        .after_help(format!("Example:\n  solaris profile {}", example(kind)))
        .next_help_heading("Parameters (x: the unit of positions)")
        .args(args)
        .next_help_heading(None);
    // What is flattened says what it is itself, too.
    CurveArgs::augment_args(command).about(kind.summary)
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

fn value_name(parameter: &Parameter) -> &'static str {
    match parameter.measure {
        Measure::Position => "X",
        Measure::Velocity => "X/S",
        Measure::Acceleration => "X/S²",
        Measure::Jerk => "X/S³",
        Measure::Time => "S",
        Measure::Number => "NUMBER",
    }
}

/// An option that takes a number; it may begin with a hyphen.
fn number_option(name: String, value: &'static str, help: &str) -> Arg {
    Arg::new(name.clone())
        .long(name)
        .value_name(value)
        .allow_hyphen_values(true)
        .value_parser(|text: &str| text.parse::<Number>())
        .help(wrap(help))
}

fn parameter(kind: &Kind, parameter: &'static Parameter, required: bool) -> Arg {
    let unit = parameter.measure.to_string();
    let unit = if unit.is_empty() { unit } else { format!(" in {unit}") };
    let range = parameter.range.to_string();
    let range = if range == "any number" { String::new() } else { format!(", {range}") };
    let default = if required { "" } else { " [default: 0]" };
    let help = format!("{}{unit}{range}{default}", parameter.summary);
    let arg = number_option(option(parameter), value_name(parameter), &help);
    let taken = kind.parameters().any(|other| option(other) == parameter.symbol);
    if taken { arg } else { arg.visible_alias(parameter.symbol) }
}

fn keys() -> Arg {
    Arg::new("keys")
        .long("keys")
        .value_name("KEYS")
        .required(true)
        .allow_hyphen_values(true)
        .value_parser(parse_keys)
        .help(wrap(
            "Times in s, rising, and positions, such as '0:5, 1:7, 2:-9'; or a table FILE.csv of two columns, whose first line names them",
        ))
}

fn parse_keys(text: &str) -> Result<Keys, String> {
    let typed = text.to_owned();
    let path = PathBuf::from(text);
    if crate::input::extension(&path) == "csv" {
        return Ok(Keys { source: KeySource::File(path), typed });
    }
    let key = |text: &str| {
        let (time, position) = text.split_once(':')?;
        Some((number(time.trim()).ok()?, number(position.trim()).ok()?))
    };
    let pieces = text.split([',', ';']).map(str::trim).filter(|piece| !piece.is_empty());
    let keys = pieces
        .map(|piece| key(piece).ok_or_else(|| format!("'{piece}' is no TIME:POSITION, such as 0.5:-9")))
        .collect::<Result<Vec<_>, _>>()?;
    if keys.is_empty() {
        return Err("it must be TIME:POSITION, …".to_owned());
    }
    Ok(Keys { source: KeySource::Given(keys), typed })
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
