//! Markers as comma-separated values.

use crate::error::IoError;
use crate::table::check_name;
use solaris_model::MarkerTrial;
use std::io::Write;

/// Writes a trial as CSV: `time` (s) and `NAME.x`, `NAME.y`, `NAME.z` (m) of each marker; cells of hidden ones are blank.
///
/// # Errors
///
/// [`IoError::Heading`] for a marker's name that would not be read as it is written, and the errors of the writer.
pub fn write_csv(trial: &MarkerTrial, mut out: impl Write) -> Result<(), IoError> {
    trial.names().iter().try_for_each(|name| check_name(name, "CSV"))?;
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
