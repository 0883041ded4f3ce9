//! `solaris gait`: the thesis's walking models, walks beside people, sets of clips.

mod explain;
mod map;
mod people;
mod picture;
mod postures;
mod set;
mod table;

use crate::args::GaitCommand;
use crate::error::CliError;

pub(crate) fn run(command: &GaitCommand) -> Result<(), CliError> {
    match command {
        GaitCommand::Table(args) => table::run(args),
        GaitCommand::Map(args) => map::run(args),
        GaitCommand::Explain(args) => explain::run(args),
        GaitCommand::People(args) => people::run(args),
        GaitCommand::Set(args) => set::run(args),
    }
}
