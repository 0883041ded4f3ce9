//! The commands and their options.

mod figure;
mod gait;
mod given;
mod ground;
mod inverse;
mod metrics;
mod profile;
mod report;
mod run;
mod sweep;
mod walk;

pub(crate) use given::{BASES, Gravity};
pub(crate) use ground::{AskedBelt, AskedPlate};
pub(crate) use metrics::AskedLevel;
pub(crate) use profile::{FADES, Keys, LEAVING, amplitude, example, option};
pub(crate) use sweep::{columns, walk_options};
pub(crate) use walk::{Then, check, key_options};

use clap::builder::{Str, ValueParser};
use clap::{Arg, ArgAction, Command};
use std::path::PathBuf;

/// Height of the person when none is given (m).
pub(crate) const HEIGHT: f64 = 1.75;
/// Mass over the squared height when no mass is given (kg/m²).
pub(crate) const BODY_MASS_INDEX: f64 = 23.8;
/// Number of steps when neither steps nor a distance are given.
pub(crate) const DEFAULT_STEPS: i64 = 10;
/// Samples a second of the motion (1/s): default and range.
pub(crate) const RATE: (f64, f64, f64) = (120.0, 10.0, 1000.0);

pub(crate) fn command() -> Command {
    Command::new("solaris")
        .version(env!("CARGO_PKG_VERSION"))
        .about("Motion of articulated figures that obeys physics")
        .after_help(
            "Examples:
  solaris walk --height 1.75 --mass 73 --step-frequency 110 --steps 10 -o walk.html
  solaris run scene.ron -o motion.html
  solaris inverse subject.osim walk.mot --external grf.mot --plate calcn_r= --plate calcn_l=1_ -o moments.sto
  solaris check robot.urdf
  solaris profile minimum-jerk --from 0 --to 1.2 --duration 2 -o curve.svg",
        )
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommands([
            walk::command(),
            sweep::command(),
            run::command(),
            inverse::command(),
            ground::command(),
        ])
        .subcommand(metrics::command())
        .subcommands(figure::commands())
        .subcommand(gait::command())
        .subcommand(profile::command())
        .subcommand(report::command())
}

/// An option that takes a number; it may begin with a hyphen: -1 and -inf are numbers, and out of range.
fn number(name: impl Into<Str>, value: &'static str, help: &str) -> Arg {
    let (parser, name) = (ValueParser::new(parse_number), name.into());
    Arg::new(name.clone())
        .long(name)
        .value_name(value)
        .allow_hyphen_values(true)
        .value_parser(parser)
        .help(wrap(help))
}

/// An option that takes a file.
fn path(name: &'static str) -> Arg {
    Arg::new(name).long(name).value_name("FILE").value_parser(clap::value_parser!(PathBuf))
}

/// The file that a command reads.
fn input(name: &'static str, value: &'static str, help: &str) -> Arg {
    Arg::new(name)
        .value_name(value)
        .required(true)
        .value_parser(clap::value_parser!(PathBuf))
        .help(wrap(help))
}

/// The option that asks for JSON instead of a table.
fn json(help: &'static str) -> Arg {
    Arg::new("json").long("json").action(ArgAction::SetTrue).help(help)
}

/// The options that make a figure of a person's size, or change one.
fn size() -> [Arg; 3] {
    [
        number("height", "M", "Standing height in m"),
        number("mass", "KG", "Total mass in kg, met exactly"),
        Arg::new("segment")
            .long("segment")
            .value_name("NAME=LENGTH")
            .action(ArgAction::Append)
            .value_parser(ValueParser::new(parse_segment))
            .help(wrap("A segment's own length in m; several are allowed")),
    ]
}

/// Columns of a help text; with the widest option before it a line has 110.
const HELP_WIDTH: usize = 72;

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

/// A segment and its length.
fn parse_segment(text: &str) -> Result<(String, f64), String> {
    let (name, length) = text.split_once('=').ok_or("it must be NAME=LENGTH, such as left_thigh=0.44")?;
    Ok((name.trim().to_owned(), parse_number(length.trim()).map_err(|why| format!("the length: {why}"))?))
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
