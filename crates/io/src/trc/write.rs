//! A TRC file from a trial.

use super::header::bare_name;
use crate::error::IoError;
use crate::markers::LengthUnit;
use solaris_model::MarkerTrial;
use std::io::Write;

/// Writes a trial as TRC, with `title` as its file's name and lengths in `unit` to a thousandth of a micrometre. Times have nine
/// decimals, or all of their digits where frames are nearer to each other than that. A marker that was hidden has blank cells.
///
/// # Errors
///
/// [`IoError::Heading`] for a marker's name that would not be read as it is written, and the errors of the writer.
///
/// # Examples
///
/// ```
/// use solaris_io::{markers::LengthUnit, trc};
/// use solaris_model::{MarkerTrial, Vector3};
/// let trial = MarkerTrial::new(vec!["heel".into()], vec![0.0], vec![Vector3::new(0.1, 0.2, 0.3)])?;
/// let mut text = Vec::new();
/// trc::write(&trial, "walk.trc", LengthUnit::Millimetres, &mut text)?;
/// assert!(String::from_utf8(text)?.ends_with("1\t0\t100\t200\t300\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(trial: &MarkerTrial, title: &str, unit: LengthUnit, mut out: impl Write) -> Result<(), IoError> {
    for name in trial.names() {
        if name.is_empty() || bare_name(name) != name || name.contains(['\t', '\n', '\r']) {
            return Err(IoError::Heading { name: name.clone(), format: "TRC" });
        }
    }
    let rate = number(trial.rate().unwrap_or(1.0), 6);
    let (frames, markers) = (trial.len(), trial.names().len());
    writeln!(out, "PathFileType\t4\t(X/Y/Z)\t{}", plain(title))?;
    writeln!(
        out,
        "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\tOrigNumFrames"
    )?;
    writeln!(out, "{rate}\t{rate}\t{frames}\t{markers}\t{unit}\t{rate}\t1\t{frames}")?;
    write!(out, "Frame#\tTime")?;
    for name in trial.names() {
        write!(out, "\t{name}\t\t")?;
    }
    write!(out, "\n\t")?;
    for marker in 1..=markers {
        write!(out, "\tX{marker}\tY{marker}\tZ{marker}")?;
    }
    write!(out, "\n\n")?;
    let decimals = (9.0 + unit.metres().log10().floor()) as usize;
    for (frame, time) in times(trial.time()).iter().enumerate() {
        write!(out, "{}\t{time}", frame + 1)?;
        for point in trial.frame(frame) {
            if point.x.is_nan() {
                write!(out, "\t\t\t")?;
                continue;
            }
            for value in point.iter() {
                write!(out, "\t{}", number(value / unit.metres(), decimals))?;
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

/// Times (s) that grow as they are read again.
fn times(time: &[f64]) -> Vec<String> {
    let rounded: Vec<String> = time.iter().map(|time| number(*time, 9)).collect();
    let grow = rounded.windows(2).all(|pair| pair[0] != pair[1]);
    if grow { rounded } else { time.iter().map(f64::to_string).collect() }
}

/// A text that fits in a cell.
fn plain(text: &str) -> String {
    text.replace(['\t', '\n', '\r'], " ")
}

/// A number with so many decimals at most.
fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
