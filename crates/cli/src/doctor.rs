//! `solaris doctor`: what a report of a fault should say, and no more: the program, the machine, and what is found of files without
//! what stands in them.

mod file;
mod machine;
mod veil;

use crate::args::DoctorArgs;
use crate::error::CliError;
use crate::print::{print, write_json};
use file::Told;
use machine::Machine;
use serde::Serialize;

/// All that is told.
#[derive(Serialize)]
struct Doctor {
    machine: Machine,
    files: Vec<Told>,
}

/// Tells it. A file that cannot be used is no failure here: how it is refused is what was asked for.
pub(crate) fn run(args: &DoctorArgs) -> Result<(), CliError> {
    let files = args.files.iter().map(|path| Told::of(path)).collect();
    let doctor = Doctor { machine: Machine::here(), files };
    print(|out| {
        if args.json {
            return write_json(out, &doctor);
        }
        doctor.machine.write(out)?;
        for (i, file) in doctor.files.iter().enumerate() {
            file.write(out, i + 1)?;
        }
        if !doctor.files.is_empty() {
            writeln!(
                out,
                "\nOf files neither paths nor names, numbers or texts are told: … and # stand for them. Read it before you send it."
            )?;
        }
        Ok(())
    })
}
