//! `solaris gait table`: tables of the thesis, computed anew.

use crate::args::{TableArgs, TableFormat};
use crate::error::CliError;
use crate::print::print;
use solaris::gait::determinants::{GaitTable, TABLES, table};

pub(super) fn run(args: &TableArgs) -> Result<(), CliError> {
    let tables = TABLES.iter().filter(|number| args.number.as_ref().is_none_or(|asked| asked == *number));
    let texts = tables.filter_map(|number| table(number)).map(|table| written(&table, args.format.format));
    let text = texts.collect::<Vec<_>>().join("\n");
    print(|out| out.write_all(text.as_bytes()))
}

/// A table in the format that is asked for.
pub(super) fn written(table: &GaitTable, format: TableFormat) -> String {
    match format {
        TableFormat::Text => table.text(),
        TableFormat::Csv => table.csv(),
        TableFormat::Markdown => table.markdown(),
    }
}
