//! `solaris gait people`: smooth walks beside people.

use super::table::written;
use crate::args::PeopleArgs;
use crate::error::CliError;
use crate::print::print;
use crate::walk::person;
use solaris::gait::people::{compare, curve_table, table};

/// Step frequencies that are compared (steps/min).
const STEP_FREQUENCIES: [f64; 7] = [80.0, 90.0, 95.0, 100.0, 110.0, 120.0, 130.0];

pub(super) fn run(args: &PeopleArgs) -> Result<(), CliError> {
    let determinants = args.determinants.count.into();
    let compared = compare(&person(&args.person)?, determinants, &STEP_FREQUENCIES);
    let tables = [table(determinants, &compared), curve_table(&compared)];
    let text = tables.map(|table| written(&table, args.format.format)).join("\n");
    print(|out| out.write_all(text.as_bytes()))
}
