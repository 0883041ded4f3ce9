//! The command line of Solaris. The only crate that reads files, prints, shows progress and exits.
//!
//! Exit codes: 0 done; 1 understood but not possible; 2 the command line cannot be understood.

mod animation;
mod args;
mod chair;
mod check;
mod convert;
mod crowd;
mod cycles;
mod doctor;
#[cfg(target_os = "linux")]
mod elementary;
mod error;
mod figure;
mod findings;
mod gait;
mod given;
mod ground;
mod ik;
mod input;
mod inverse;
mod limbs;
mod manual;
mod markers;
mod metrics;
mod output;
mod planned_files;
mod plausible;
mod pool;
mod print;
mod profile;
mod progress;
mod recording;
mod report;
mod retarget;
mod run;
mod scale;
mod shown;
mod studio;
mod subject;
mod sweep;
mod table;
mod underline;
mod walk;
mod words;

use args::{Cli, Command};
use clap::Parser;
use error::CliError;
use std::process::ExitCode;

fn main() -> ExitCode {
    let result = match Cli::try_parse() {
        Ok(cli) => run(&cli.command),
        // Help and the version come this way, too.
        Err(error) => Err(CliError::of_clap(error).unwrap_or_else(|error| error::end(&error))),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            error::show(&error, &args::command_words(std::env::args_os()));
            error.exit_code()
        }
    }
}

fn run(command: &Command) -> Result<(), CliError> {
    match command {
        Command::Walk(args) => walk::run(args),
        Command::Chair(args) => chair::run(args),
        Command::Sweep(args) => sweep::run(args),
        Command::Crowd(args) => crowd::run(args),
        Command::Run(args) => run::run(args),
        Command::Inverse(args) => inverse::run(args),
        Command::Ik(args) => ik::run(args),
        Command::Scale(args) => scale::run(args),
        Command::Ground(args) => ground::run(args),
        Command::Metrics(args) => metrics::run(args),
        Command::Figure(command) => figure::run(command),
        Command::Check(args) => check::run(args),
        Command::Convert(args) => convert::run(args),
        Command::Retarget(args) => retarget::run(args),
        Command::Gait(command) => gait::run(command),
        Command::Profile(command) => profile::run(command),
        Command::Report(args) => report::run(args),
        Command::Studio(args) => studio::run(args),
        Command::Doctor(args) => doctor::run(args),
        Command::Completions(args) => manual::completions(args),
        Command::Man(args) => manual::man(args),
    }
}
