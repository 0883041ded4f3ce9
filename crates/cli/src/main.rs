//! The command line of Solaris. The only crate that reads files, prints, shows progress and exits.
//!
//! Exit codes: 0 done; 1 understood but not possible; 2 the command line cannot be understood.

mod args;
mod error;
mod output;
mod progress;
mod walk;

use std::process::ExitCode;

fn main() -> ExitCode {
    let matches = args::command().get_matches();
    let result = match matches.subcommand() {
        Some(("walk", matches)) => walk::run(matches),
        // clap asks for a subcommand.
        _ => Ok(()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            error::show(&error);
            error.exit_code()
        }
    }
}
