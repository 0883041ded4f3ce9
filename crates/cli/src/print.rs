//! Standard output.

mod seen;

use crate::error::CliError;
use seen::Seen;
use serde::Serialize;
use std::io::{ErrorKind, Write};

/// Writes a value as JSON that people can read, and that commands no terminal.
pub(crate) fn write_json(out: &mut dyn Write, value: &impl Serialize) -> std::io::Result<()> {
    let mut out = Seen::json(out);
    serde_json::to_writer_pretty(&mut out, value).map_err(std::io::Error::from)?;
    writeln!(out)?;
    out.flush()
}

/// Prints what `write` writes; whoever reads may have read enough before its end. Names are the files': what would not be seen in
/// them, or would command the terminal, is written out.
pub(crate) fn print(write: impl FnOnce(&mut dyn Write) -> std::io::Result<()>) -> Result<(), CliError> {
    let mut stdout = Seen::text(anstream::stdout().lock());
    match write(&mut stdout).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        other => other.map_err(CliError::Stdout),
    }
}
