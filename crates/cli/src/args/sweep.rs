//! The options of `solaris sweep`, and of `solaris walk` those that can head its columns.

use super::{RATE, input, json, number, path, walk, wrap};
use clap::{Arg, Command};

const EXAMPLES: &str = "Examples:
  solaris sweep people.csv -o metrics.csv
      people.csv may be: height,mass,speed
                         1.60,55,1.2
                         1.85,,1.4
  solaris sweep people.csv -o metrics.csv --threads 1 --rate 60 --json
      on one core, half the samples; the file is the same with any number of threads";

/// Options of a walk that are no number of it: files, and how it is told.
const NO_COLUMNS: [&str; 6] = ["output", "report", "json", "rate", "root", "loop"];

pub(super) fn command() -> Command {
    Command::new("sweep")
        .about("Many walks: a table of people and paces in, a table of measures out")
        .after_help(EXAMPLES)
        .arg(input("params", "PARAMS.csv", &format!(
            "A walk a row; headings are options of `solaris walk`: {}. An empty field is an option that is left out",
            columns(&walk_options()).join(", ")
        )))
        .arg(path("output").short('o').required(true).value_name("METRICS.csv").help(wrap(
            "Write the same columns, the measures of each walk, and last why a row is refused",
        )))
        .arg(number(
            "rate",
            "FRAMES/S",
            &format!("Samples a second that are measured, {} to {} [default: {}]", RATE.1, RATE.2, RATE.0),
        ))
        .arg(
            Arg::new("threads")
                .long("threads")
                .value_name("N")
                .value_parser(clap::value_parser!(u16).range(1..=1024))
                .help(wrap("Walks at a time, 1 to 1024; the file does not depend on it [default: one a core]")),
        )
        .arg(json("Print the summary as JSON instead of a table"))
}

/// The options of a walk, each row of a sweep in the words of a command line.
pub(crate) fn walk_options() -> Command {
    walk::command().no_binary_name(true)
}

/// Which of them can head a column.
pub(crate) fn columns(walk: &Command) -> Vec<String> {
    let options = walk.get_arguments().filter(|option| option.get_action().takes_values());
    let names = options.filter_map(|option| option.get_long().map(str::to_owned));
    names.filter(|name| !NO_COLUMNS.contains(&name.as_str())).collect()
}
