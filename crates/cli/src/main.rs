//! The command line of Solaris. The only crate that reads files, prints, shows progress and exits.
//!
//! Exit codes: 0 done; 1 understood but not possible; 2 the command line cannot be understood.

mod args;
mod check;
mod convert;
mod error;
mod figure;
mod findings;
mod gait;
mod given;
mod ground;
mod input;
mod inverse;
mod limbs;
mod metrics;
mod output;
mod print;
mod profile;
mod progress;
mod report;
mod run;
mod sweep;
mod underline;
mod walk;
mod words;

use std::process::ExitCode;

fn main() -> ExitCode {
    let matches = args::command().get_matches();
    let result = match matches.subcommand() {
        Some(("walk", matches)) => walk::run(matches),
        Some(("sweep", matches)) => sweep::run(matches),
        Some(("run", matches)) => run::run(matches),
        Some(("inverse", matches)) => inverse::run(matches),
        Some(("ground", matches)) => ground::run(matches),
        Some(("metrics", matches)) => metrics::run(matches),
        Some(("check", matches)) => check::run(matches),
        Some(("figure", matches)) => figure::run(matches),
        Some(("convert", matches)) => convert::run(matches),
        Some(("gait", matches)) => gait::run(matches),
        Some(("profile", matches)) => profile::run(matches),
        Some(("report", matches)) => report::run(matches),
        // clap asks for a subcommand.
        _ => Ok(()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            error::show(&error, &command(&matches));
            error.exit_code()
        }
    }
}

/// The words of the command that was typed.
fn command(matches: &clap::ArgMatches) -> String {
    let mut words = Vec::new();
    let mut at = matches.subcommand();
    while let Some((name, inner)) = at {
        words.push(name);
        at = inner.subcommand();
    }
    words.join(" ")
}
