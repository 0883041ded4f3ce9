//! `solaris gait`: the thesis's walking models.

mod explain;
mod map;
mod people;
mod picture;
mod postures;
mod table;

use crate::error::CliError;
use clap::ArgMatches;

pub(crate) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    match matches.subcommand() {
        Some(("table", matches)) => table::run(matches),
        Some(("map", matches)) => map::run(matches),
        Some(("explain", matches)) => explain::run(matches),
        Some(("people", matches)) => people::run(matches),
        // clap asks for a subcommand.
        _ => Ok(()),
    }
}
