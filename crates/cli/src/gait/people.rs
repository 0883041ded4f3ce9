//! `solaris gait people`: smooth walks beside people.

use super::table::written;
use crate::error::CliError;
use crate::print::print;
use crate::walk::person;
use clap::ArgMatches;
use solaris::gait::determinants::Determinants;
use solaris::gait::people::table;

/// Step frequencies that are compared (steps/min).
const STEP_FREQUENCIES: [f64; 7] = [80.0, 90.0, 95.0, 100.0, 110.0, 120.0, 130.0];

pub(super) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    let three = matches.get_one::<String>("determinants").is_some_and(|count| count == "3");
    let determinants = if three { Determinants::Three } else { Determinants::Five };
    let table = table(&person(matches)?, determinants, &STEP_FREQUENCIES);
    print(|out| out.write_all(written(&table, matches).as_bytes()))
}
