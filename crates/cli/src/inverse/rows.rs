//! Many motions as a table of one row each: to read, and as CSV.

use super::batch::Done;
use super::report::Report;
use crate::words::{counted, row, short};
use solaris::analysis::DofLoad;
use solaris::io::csv::{number_text, write_row};
use std::io::{Result, Write};

/// The first column: the file.
const MOTION: &str = "motion";
/// The last column: why there is nothing.
const REFUSAL: &str = "refusal";

/// How many motions have a report.
pub(super) fn done(all: &[Done]) -> usize {
    all.iter().filter(|done| done.report.is_some()).count()
}

/// The summary for people.
pub(super) fn write(all: &[Done], out: &mut dyn Write) -> Result<()> {
    let (good, of) = (done(all), all.len());
    row(out, "motions", &format!("{of}: {good} done, {} failed", of - good))?;
    let width = all.iter().map(|done| done.motion.chars().count()).max().unwrap_or(0).max(8);
    writeln!(
        out,
        "\n  {:<width$}{:>8}  {:>18}  {:>18}  {:<30}findings",
        "motion", "rows", "residual N", "residual N m", "greatest moment"
    )?;
    writeln!(out, "  {:<width$}{:>8}  {:>18}  {:>18}", "", "", "rms, greatest", "rms, greatest")?;
    for Done { motion, report, refusal } in all {
        let Some(report) = report else {
            let why = refusal.as_deref().unwrap_or_default();
            writeln!(out, "  {motion:<width$}  failed: {why}")?;
            continue;
        };
        let two = |rms: f64, greatest: f64| format!("{}, {}", short(rms), short(greatest));
        let [force, moment] = report.residual.map_or([(); 2].map(|()| "-".to_owned()), |r| {
            [two(r.force_rms, r.force), two(r.moment_rms, r.moment)]
        });
        let greatest = greatest(report).map_or_else(
            || "-".to_owned(),
            |load| format!("{} {} {}", short(load.greatest), load.unit, load.dof),
        );
        let (rows, findings) = (report.given.rows, report.findings().len());
        writeln!(out, "  {motion:<width$}{rows:>8}  {force:>18}  {moment:>18}  {greatest:<30}{findings:>8}")?;
    }
    let mut findings: Vec<(String, usize)> = Vec::new();
    for finding in all.iter().filter_map(|done| done.report.as_ref()).flat_map(Report::findings) {
        match findings.iter_mut().find(|(known, _)| *known == finding) {
            Some((_, count)) => *count += 1,
            None => findings.push((finding, 1)),
        }
    }
    if !findings.is_empty() {
        writeln!(out, "\n  Look at")?;
    }
    for (finding, count) in findings.iter().take(SHOWN) {
        writeln!(out, "  - in {}: {finding}", counted(*count, "motion", "motions"))?;
    }
    if findings.len() > SHOWN {
        writeln!(
            out,
            "  … and {} more; solaris inverse of one motion tells its own",
            findings.len() - SHOWN
        )?;
    }
    Ok(())
}

/// Findings that a person reads.
const SHOWN: usize = 8;

/// The joint that needs the greatest moment.
fn greatest(report: &Report) -> Option<&DofLoad> {
    let joints = report.joints.iter().filter(|load| !load.is_residual && load.unit == "N m");
    joints.max_by(|a, b| a.greatest.abs().total_cmp(&b.greatest.abs()))
}

/// What a table of many motions is written as.
#[derive(Clone, Copy, Debug)]
pub(super) enum RowsFormat {
    Csv,
    #[cfg(feature = "parquet")]
    Parquet,
}

/// The same as a file: the residuals, the greatest force of each joint, and why there are none.
pub(super) fn write_table(
    all: &[Done],
    format: RowsFormat,
    mut out: &mut dyn Write,
) -> std::result::Result<(), solaris::io::IoError> {
    let (heads, rows) = fields(all);
    match format {
        RowsFormat::Csv => {
            std::iter::once(heads).chain(rows).try_for_each(|fields| write_row(fields, &mut out))
        }
        #[cfg(feature = "parquet")]
        RowsFormat::Parquet => {
            use solaris::io::parquet::{self, Column};
            let of = |(column, heading): (usize, String)| {
                let fields = rows.iter().map(|row| row[column].as_str());
                let values = if [MOTION, REFUSAL].contains(&heading.as_str()) {
                    Column::Texts(fields.map(str::to_owned).collect())
                } else {
                    Column::Numbers(fields.map(|field| field.parse().ok()).collect())
                };
                (heading, values)
            };
            let columns: Vec<_> = heads.into_iter().enumerate().map(of).collect();
            parquet::write(&columns, &mut out)
        }
    }
}

/// Headings, and the fields of each motion.
fn fields(all: &[Done]) -> (Vec<String>, Vec<Vec<String>>) {
    let mut dofs: Vec<&str> = Vec::new();
    if let Some(report) = all.iter().find_map(|done| done.report.as_ref()) {
        dofs.extend(report.joints.iter().filter(|load| !load.is_residual).map(|load| load.dof.as_str()));
    }
    let heads = [MOTION, "rows", "from_s", "to_s"].map(str::to_owned).into_iter();
    let residuals = ["force_rms_n", "force_greatest_n", "moment_rms_nm", "moment_greatest_nm"]
        .map(|r| format!("residual_{r}"));
    let joints = dofs.iter().map(|dof| format!("{dof}.tau_greatest"));
    let last = ["findings", REFUSAL].map(str::to_owned);
    let heads: Vec<String> = heads.chain(residuals).chain(joints).chain(last).collect();
    let columns = heads.len();
    let row = |Done { motion, report, refusal }: &Done| {
        let mut fields = vec![motion.clone()];
        if let Some(report) = report {
            let given = &report.given;
            fields.extend([given.rows.to_string(), number_text(given.from_s), number_text(given.to_s)]);
            let left =
                report.residual.map(|r| [r.force_rms, r.force, r.moment_rms, r.moment].map(number_text));
            fields.extend(left.unwrap_or_default());
            let of = |dof: &&str| report.joints.iter().find(|load| load.dof == **dof);
            let greatest = |dof| of(dof).map_or_else(String::new, |load| number_text(load.greatest));
            fields.extend(dofs.iter().map(greatest));
            fields.push(report.findings().len().to_string());
        }
        fields.resize(columns - 1, String::new());
        fields.push(refusal.clone().unwrap_or_default());
        fields
    };
    (heads, all.iter().map(row).collect())
}
