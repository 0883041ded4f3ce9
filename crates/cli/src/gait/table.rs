//! `solaris gait table`: tables of the thesis, computed anew.

use crate::error::CliError;
use crate::print::print;
use clap::ArgMatches;
use solaris::gait::determinants::{GaitTable, TABLES, table};

pub(super) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    let asked = matches.get_one::<String>("number");
    let tables = TABLES.iter().filter(|number| asked.is_none_or(|asked| asked == *number));
    let texts = tables.filter_map(|number| table(number)).map(|table| written(&table, matches));
    let text = texts.collect::<Vec<_>>().join("\n");
    print(|out| out.write_all(text.as_bytes()))
}

/// A table in the format that is asked for.
pub(super) fn written(table: &GaitTable, matches: &ArgMatches) -> String {
    match matches.get_one::<String>("format").map_or("text", String::as_str) {
        "csv" => table.csv(),
        "markdown" => table.markdown(),
        _ => table.text(),
    }
}
