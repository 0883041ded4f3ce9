//! The options of `solaris report`.

use super::{input, json, number, path, wrap};
use clap::{ArgAction, Command};

const EXAMPLES: &str = "Examples:
  solaris report governor.ron -o report.html
      the scene by every method, step and tolerance: a page with error against time, and which setting to take
  solaris report pendulum.ron --error 1e-9
      the cheapest setting for errors up to 1e-9, as a table
  solaris report arm.ron -o error.svg --json
      the picture alone, and all numbers as JSON";

pub(super) fn command() -> Command {
    Command::new("report")
        .about("How far a scene can be trusted: every method, step and tolerance against the finest there are")
        .after_help(EXAMPLES)
        .arg(input("scene", "SCENE", "A scene (.ron)"))
        .arg(path("output").short('o').action(ArgAction::Append).help(wrap(
            "Write a page (.html), or the picture of error against time (.svg); several are allowed. Stopped before its end, \
             what is finished stays [default: none]",
        )))
        .arg(number(
            "error",
            "E",
            "Error of positions that is wanted, in rad or m, 1e-13 to 0.1 [default: the scene's tolerance, or 1e-6]",
        ))
        .arg(json("Print all numbers as JSON instead of a table"))
}
