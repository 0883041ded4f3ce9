//! A curve as rows of numbers.

use crate::args::{CurveArgs, RATE};
use crate::error::{CliError, Refusal};
use crate::words::short;
use solaris::profiles::{Curve, ProfileCurve, Sample};
use solaris::view::profile::{number, unit};
use std::io::Write;

/// Rows of the printed table when none are asked for.
const ROWS: u32 = 11;
/// The most rows of a table.
const MOST_ROWS: f64 = 1e7;
/// Digits of a printed number.
const DIGITS: usize = 6;
/// What is this much smaller than the rest is not shown.
const ROUNDING: f64 = 1e-14;

/// The columns, as files and JSON name them.
pub(super) const NAMES: [&str; 5] = ["time", "position", "velocity", "acceleration", "jerk"];

/// The times of a table.
#[derive(Clone, Copy, Debug)]
pub(super) struct Times {
    duration: f64,
    spacing: Spacing,
}

#[derive(Clone, Copy, Debug)]
enum Spacing {
    /// So many, both ends among them.
    Count(u32),
    /// So many a second, and the end.
    Rate(f64),
}

impl Times {
    /// Of the table that is printed.
    pub(super) fn of_table(curve: &ProfileCurve, args: &CurveArgs) -> Result<Self, CliError> {
        Self::new(curve, args, Spacing::Count(ROWS))
    }

    /// Of the table in a file.
    pub(super) fn of_file(curve: &ProfileCurve, args: &CurveArgs) -> Result<Self, CliError> {
        Self::new(curve, args, Spacing::Rate(RATE.0))
    }

    fn new(curve: &ProfileCurve, args: &CurveArgs, default: Spacing) -> Result<Self, CliError> {
        let duration = curve.duration();
        if let Some(count) = args.samples {
            return Ok(Self { duration, spacing: Spacing::Count(count) });
        }
        let Some(rate) = &args.rate else { return Ok(Self { duration, spacing: default }) };
        let refuse = |why: Refusal| Err(CliError::option("rate", &rate.typed, why));
        if !(rate.value > 0.0 && rate.value.is_finite()) {
            return refuse("it must be a finite number above zero".into());
        }
        let rows = duration * rate.value;
        if rows > MOST_ROWS {
            return refuse(
                format!("{} s make {rows:.0} rows, more than {MOST_ROWS:.0}", short(duration)).into(),
            );
        }
        Ok(Self { duration, spacing: Spacing::Rate(rate.value) })
    }

    fn iter(self) -> impl Iterator<Item = f64> {
        let duration = self.duration;
        let (whole, step) = match self.spacing {
            Spacing::Count(count) => (u64::from(count) - 1, duration / f64::from(count - 1)),
            // An end that is a row but for rounding is not one more.
            Spacing::Rate(rate) => ((duration * rate - 1e-9).ceil().max(1.0) as u64, 1.0 / rate),
        };
        (0..=whole).map(move |i| if i == whole { duration } else { i as f64 * step })
    }
}

/// Time and the four of each row.
pub(super) fn rows(curve: &ProfileCurve, times: Times) -> impl Iterator<Item = [f64; 5]> {
    times.iter().map(|t| {
        let Sample { position, velocity, acceleration, jerk } = curve.at(t);
        [t, position, velocity, acceleration, jerk]
    })
}

/// The table of a file: all digits; `inf` where something has no bound.
pub(super) fn csv(writer: &mut dyn Write, curve: &ProfileCurve, times: Times) -> Result<(), CliError> {
    writeln!(writer, "{}", NAMES.join(",")).map_err(CliError::other)?;
    for [t, position, velocity, acceleration, jerk] in rows(curve, times) {
        writeln!(writer, "{t},{position},{velocity},{acceleration},{jerk}").map_err(CliError::other)?;
    }
    Ok(())
}

/// The table for people.
pub(super) fn print(
    out: &mut dyn Write,
    curve: &ProfileCurve,
    label: &str,
    times: Times,
) -> std::io::Result<()> {
    let units: [String; 5] =
        std::array::from_fn(|i| if i == 0 { "s".to_owned() } else { unit(label, i - 1) });
    let rows: Vec<[f64; 5]> = rows(curve, times).collect();
    let most: [f64; 5] = std::array::from_fn(|i| {
        rows.iter().map(|row| row[i].abs()).filter(|x| x.is_finite()).fold(0.0, f64::max)
    });
    let cell = |row: &[f64; 5], i: usize| {
        // What is nothing but rounding beside the rest of its column is zero.
        let x = if row[i].abs() <= ROUNDING * most[i] { 0.0 } else { row[i] };
        number(x, DIGITS)
    };
    let cells: Vec<[String; 5]> = rows.iter().map(|row| std::array::from_fn(|i| cell(row, i))).collect();
    let widths: [usize; 5] = std::array::from_fn(|i| {
        let cells = cells.iter().map(|row| row[i].len());
        cells.chain([NAMES[i].len(), units[i].chars().count()]).max().unwrap_or(0) + 2
    });
    let mut line = |row: &dyn Fn(usize) -> String| {
        let cells = (0..NAMES.len()).map(|i| format!("{:>width$}", row(i), width = widths[i]));
        writeln!(out, "{}", cells.collect::<String>().trim_end())
    };
    line(&|i| NAMES[i].to_owned())?;
    line(&|i| units[i].clone())?;
    cells.iter().try_for_each(|row| line(&|i| row[i].clone()))?;
    writeln!(out)
}
