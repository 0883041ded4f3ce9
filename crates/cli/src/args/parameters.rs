//! Options that the gait library's tables of parameters make: of walks and of key postures.

use super::{Number, wrap};
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use solaris::gait::determinants::{KeyParameter, five, three};
use solaris::gait::{PARAMETERS, Parameter, Unit};

/// Values of parameters, by the parameters' names.
#[derive(Clone, Debug, Default)]
pub(crate) struct Parameters(Vec<(&'static str, Number)>);

impl Parameters {
    /// The value that was given to a parameter.
    pub(crate) fn get(&self, name: &str) -> Option<&Number> {
        self.0.iter().find(|(known, _)| *known == name).map(|(_, value)| value)
    }

    /// The parameters that were given values, with these.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (&'static str, &Number)> {
        self.0.iter().map(|(name, value)| (*name, value))
    }

    fn read(matches: &ArgMatches, names: impl Iterator<Item = &'static str>) -> Self {
        Self(names.filter_map(|name| Some((name, matches.get_one::<Number>(name)?.clone()))).collect())
    }
}

/// The numbers of a walk's style, and those of key postures.
#[derive(Clone, Debug, Default)]
pub(crate) struct StyleArgs(pub(crate) Parameters);

/// The numbers of key postures alone.
#[derive(Clone, Debug, Default)]
pub(crate) struct KeyArgs(pub(crate) Parameters);

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

/// An option of a parameter; a number may begin with a hyphen: -1 and -inf are numbers, and out of range.
fn number(name: &'static str, value: &'static str, help: &str) -> Arg {
    Arg::new(name)
        .long(name)
        .value_name(value)
        .allow_hyphen_values(true)
        .value_parser(|text: &str| text.parse::<Number>())
        .help(wrap(help))
}

/// Parameters of key postures that no other option of a walk has.
fn own(parameters: &'static [KeyParameter]) -> impl Iterator<Item = &'static KeyParameter> {
    let own = |parameter: &&KeyParameter| {
        parameter.name != "step-length" && Parameter::named(parameter.name).is_none()
    };
    parameters.iter().filter(own)
}

impl Args for StyleArgs {
    fn augment_args(command: Command) -> Command {
        command
            .next_help_heading("Its style (people's: what people do at this frequency and step length)")
            .args(PARAMETERS.iter().map(of_style))
            .next_help_heading("Key postures of five determinants (--style thesis)")
            .args(own(five::PARAMETERS).map(of_posture))
            .next_help_heading("Key postures of three determinants (--style thesis --determinants 3)")
            .args(own(three::PARAMETERS).map(of_posture))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for StyleArgs {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let keys = own(five::PARAMETERS).chain(own(three::PARAMETERS)).map(|parameter| parameter.name);
        let names = PARAMETERS.iter().map(|parameter| parameter.name).chain(keys);
        Ok(Self(Parameters::read(matches, names)))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
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

fn of_posture(parameter: &'static KeyParameter) -> Arg {
    let (lower, upper) = parameter.range;
    let (symbol, unit, what) = (parameter.symbol, parameter.unit, parameter.help);
    let help = format!("{symbol}: {what}, {lower} to {upper}{unit} [default: chosen inside its bounds]");
    number(parameter.name, value_name(parameter), &help)
}

fn value_name(parameter: &KeyParameter) -> &'static str {
    if parameter.unit == "°" { "DEGREES" } else { "M" }
}

impl Args for KeyArgs {
    fn augment_args(command: Command) -> Command {
        command.next_help_heading("Parameters of the postures").args(KeyArgs::names().filter_map(of_either))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for KeyArgs {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        Ok(Self(Parameters::read(matches, Self::names())))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

impl KeyArgs {
    /// All parameters of both models; the step's length is an option of its own.
    fn names() -> impl Iterator<Item = &'static str> {
        key_options().into_iter().filter(|name| *name != "step-length")
    }
}

/// A parameter of either model, or of both.
fn of_either(name: &'static str) -> Option<Arg> {
    let of = |parameters: &'static [KeyParameter]| parameters.iter().find(|p| p.name == name);
    let (five, three) = (of(five::PARAMETERS), of(three::PARAMETERS));
    let any = five.or(three)?;
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
        (None, None) => return None,
    };
    Some(number(
        name,
        value_name(any),
        &format!("{}: {text} [default: chosen inside its bounds]", any.symbol),
    ))
}
