//! `solaris gait people`: smooth walks beside people.

use super::table::written;
use crate::args::PeopleArgs;
use crate::error::CliError;
use crate::print::print;
use crate::walk::person;
use solaris::gait::people::table;

/// Step frequencies that are compared (steps/min).
const STEP_FREQUENCIES: [f64; 7] = [80.0, 90.0, 95.0, 100.0, 110.0, 120.0, 130.0];

pub(super) fn run(args: &PeopleArgs) -> Result<(), CliError> {
    let table = table(&person(&args.person)?, args.determinants.count.into(), &STEP_FREQUENCIES);
    print(|out| out.write_all(written(&table, args.format.format).as_bytes()))
}
