//! Markers as comma-separated values.

use solaris_model::MarkerTrial;
use std::io::{self, Write};

/// Writes a trial as CSV: `time` (s) and `NAME.x`, `NAME.y`, `NAME.z` (m) of each marker; cells of hidden ones are blank.
///
/// # Errors
///
/// Those of the writer.
pub fn write_csv(trial: &MarkerTrial, mut out: impl Write) -> io::Result<()> {
    write!(out, "time")?;
    for name in trial.names() {
        for axis in ["x", "y", "z"] {
            write!(out, ",{}", quoted(&format!("{name}.{axis}")))?;
        }
    }
    writeln!(out)?;
    for (frame, time) in trial.time().iter().enumerate() {
        write!(out, "{time}")?;
        for point in trial.frame(frame) {
            if point.x.is_nan() {
                write!(out, ",,,")?;
            } else {
                write!(out, ",{},{},{}", point.x, point.y, point.z)?;
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

/// A heading, between quotes where it has to be.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
