//! `solaris gait table`: tables of the thesis, computed anew.

use crate::error::CliError;
use crate::print::print;
use clap::ArgMatches;
use solaris::gait::determinants::{TABLES, table};

pub(super) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    let asked = matches.get_one::<String>("number");
    let format = matches.get_one::<String>("format").map_or("text", String::as_str);
    let tables = TABLES.iter().filter(|number| asked.is_none_or(|asked| asked == *number));
    let texts = tables.filter_map(|number| table(number)).map(|table| match format {
        "csv" => table.csv(),
        "markdown" => table.markdown(),
        _ => table.text(),
    });
    let text = texts.collect::<Vec<_>>().join("\n");
    print(|out| out.write_all(text.as_bytes()))
}
